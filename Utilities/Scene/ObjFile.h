// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the polygons of a Wavefront OBJ file.
 *
 * vtkOBJReader is not used: it rounds coordinates to float, and it loses the faces whose corners are
 * not numbered alike without a word.
 */

#ifndef ObjFile_h
#define ObjFile_h

#include "ModelFile.h"

#include <string>

namespace softshadows
{

/**
 * Points in double, normals if all faces have them, and faces of three corners and more in any
 * numbering: v, v/vt, v//vn, v/vt/vn, counted from the start or back from here. Throws
 * std::runtime_error with a message that names the line, but not the file.
 */
ModelFile ReadObj(const std::string& path);

}

#endif
