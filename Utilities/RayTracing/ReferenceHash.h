// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceHash.h
 * @brief A name for what a reference depends on, to keep references in files by.
 */

#ifndef SoftShadowsRayTracing_ReferenceHash_h
#define SoftShadowsRayTracing_ReferenceHash_h

#include <string> // For the result

class vtkRenderer;

namespace softshadows
{

/**
 * 32 hexadecimal digits (MD5) over the triangles, their matrices, the switches of casting and
 * receiving, the camera and the lights that are on: equal for equal references of one size and one
 * number of samples, whatever the files are called.
 */
std::string HashScene(vtkRenderer* renderer);

}

#endif
