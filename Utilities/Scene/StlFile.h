// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the triangles of an STL file, ASCII or binary.
 *
 * vtkSTLReader is not used: it takes fewer triangles than announced without a word, and it rounds
 * coordinates in text to float.
 */

#ifndef StlFile_h
#define StlFile_h

#include "ModelFile.h"

#include <string>

namespace softshadows
{

/**
 * Triangles whose equal corners are one point (double in text), of all solids in the file; its normals
 * are not used. Keywords may be in capitals and indented. Throws std::runtime_error with a message that
 * does not name the file.
 */
ModelFile ReadStl(const std::string& path);

}

#endif
