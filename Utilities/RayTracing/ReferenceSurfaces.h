// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceSurfaces.h
 * @brief Walks through a renderer's props down to the surfaces that are drawn.
 */

#ifndef SoftShadowsRayTracing_ReferenceSurfaces_h
#define SoftShadowsRayTracing_ReferenceSurfaces_h

#include <vtkSmartPointer.h>

#include <array>  // For the matrix
#include <vector> // For the list

class vtkPolyData;
class vtkProp;
class vtkRenderer;

namespace softshadows
{

/// Triangles alone, with the matrix that takes them to world coordinates.
struct ReferenceSurface
{
  vtkSmartPointer<vtkPolyData> Triangles;
  std::array<double, 16> ToWorld; ///< Row-major.
  vtkProp* Prop = nullptr;        ///< The prop in the renderer's list that it belongs to.
  bool Lit = true;                ///< Drawn with lighting.
  unsigned int Object = 0;        ///< Counts actors and parts of assemblies.
};

/// All surfaces that the renderer draws opaquely. Brings the props' pipelines up to date.
std::vector<ReferenceSurface> CollectSurfaces(vtkRenderer* renderer);

}

#endif
