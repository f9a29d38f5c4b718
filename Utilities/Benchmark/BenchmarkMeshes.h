// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkMeshes.h
 * @brief The benchmark's larger meshes, made by rule instead of kept in files.
 *
 * Fixed seeds and arithmetic of this project's own: the same points on every machine, but for the
 * rounding of sines and cosines.
 */

#ifndef SoftShadowsBenchmark_BenchmarkMeshes_h
#define SoftShadowsBenchmark_BenchmarkMeshes_h

#include <vtkSmartPointer.h>

#include <string> // For the folder

class vtkPolyData;

namespace softshadows
{

/// A plant of about 2 units: bent leaves, 4 triangles each, around a crown of stems over z = 0.
vtkSmartPointer<vtkPolyData> MakeFoliage(int leaves);

/// Mountains of 8 x 8 units, 2 cells^2 triangles, heights by fractal noise.
vtkSmartPointer<vtkPolyData> MakeTerrain(int cells);

/// Writes foliage.vtp and terrain.vtp (a million triangles) to the folder, if they are not there.
/// Throws std::runtime_error.
void WriteBenchmarkMeshes(const std::string& folder);

}

#endif
