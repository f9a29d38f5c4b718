// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the polygons of a PLY file, ASCII or binary of either byte order.
 *
 * vtkPLYReader is not used: on a truncated file it goes on with what is in memory, it rounds double
 * coordinates to float, and it cuts the corners of polygons beyond the 255th.
 */

#ifndef PlyFile_h
#define PlyFile_h

#include "ModelFile.h"

#include <string>

namespace softshadows
{

/**
 * Points (double where the file says so), point normals if there are any, and faces of three corners
 * and more, wherever they stand in the file, and triangle strips. Throws std::runtime_error with a message that does
 * not name the file: no PLY, truncated, a face whose corner does not exist.
 */
ModelFile ReadPly(const std::string& path);

}

#endif
