// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the triangles of a glTF 2.0 file (.glb or .gltf), placed by its nodes, in its base colours.
 *
 * Debian's tinygltf is not used: it refuses a whole file for one compressed primitive, so that the rest could not be
 * shown, nor what is left out be counted and named.
 */

#ifndef GltfFile_h
#define GltfFile_h

#include "ModelFile.h"

#include <string>

namespace softshadows
{

/**
 * The default scene, else the first, else all nodes without a parent, as one mesh: double points in
 * the file's own axes (y is up), normals if any primitive has them, those of primitives without are
 * the triangles' own. Where the file has materials or colours of vertices, the point array
 * `ModelColors` holds them as sRGB bytes. Throws std::runtime_error with a message that does not
 * name the file: no glTF 2, truncated, a buffer that is missing, anything that points to what is
 * not there, a node that is its own ancestor.
 */
ModelFile ReadGltf(const std::string& path);

}

#endif
