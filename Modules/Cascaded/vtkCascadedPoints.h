// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedPoints
 * @brief   Points of a light as the cascades' shader takes them.
 *
 * Points of one light lie in a plane and look at right angles to it, or are directions: their map
 * coordinates are affine images of each other. So a receiver is brought into one map, the base, and
 * from there into the others with a matrix of three rows each.
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
  using Row = std::array<float, 4>;

  /// count views of points of the emitter, with their weights; the first is the base.
  vtkCascadedPoints(const vtkShadowEmitter& emitter, const std::array<double, 16>& viewToWorld,
    const vtkShadowMapView* views, const float* weights, size_t count);

  /// cellEdge: of the square that a point stands for, as a part of the light's edge.
  void SetUniforms(vtkShaderProgram* program, double cellEdge) const;

  /// Three per point: from (s, t, d, 1) of the base to those of the point.
  const std::vector<Row>& GetRows() const { return this->Rows; }

  /// Per point: its weight, and on which side of the light's middle it lies (-1, 0, 1) along U and V.
  const std::vector<Row>& GetPoints() const { return this->Points; }

private:
  std::vector<Row> Rows;
  std::vector<Row> Points;
  float Weight = 0.0f;
  std::array<float, 16> ViewToBase = { {} };
  std::array<double, 2> CellScale = { {} };

  void AddPoint(const double baseToMap[16], float weight, const vtkShadowEmitter& light,
    const vtkShadowEmitter& point);
};

VTK_ABI_NAMESPACE_END
#endif
