// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedPoints
 * @brief   Points of a light as the cascades' shader takes them.
 */

#ifndef vtkCascadedPoints_h
#define vtkCascadedPoints_h

#include "vtkShadowEmitter.h"  // For the emitter
#include "vtkShadowMapView.h"  // For views
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array>   // For matrices
#include <cstddef> // For sizes
#include <vector>  // For rows

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;

class vtkCascadedPoints
{
public:
  /// count views of points of the emitter, with their weights.
  vtkCascadedPoints(const vtkShadowEmitter& emitter, const vtkShadowMapView* views,
    const float* weights, size_t count);

  /// cellEdge: of the square that a point stands for, as a part of the light's edge.
  void SetUniforms(vtkShaderProgram* program, double cellEdge) const;

private:
  /// Its weight, and on which side of the light's middle it lies (-1, 0, 1) along U and V.
  std::vector<std::array<float, 4>> Points;
  float Weight = 0.0f;
  std::array<double, 2> CellScale = { {} };
};

VTK_ABI_NAMESPACE_END
#endif
