// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedPoints.h"

#include "vtkMath.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// A disk of the same area as the square has an edge of sqrt(pi) radii, not two.
constexpr double DiskEdge = 0.886226925452758;

// Of a cell's half edges: nearer to the middle a point has no side.
constexpr double Middle = 1e-6;

float FindSide(double offset)
{
  return std::abs(offset) < Middle ? 0.0f : (offset < 0.0 ? -1.0f : 1.0f);
}

// Where a point of the light lies along an axis of it, in [-1, 1].
double FindOffset(const vtkShadowEmitter& light, const vtkShadowEmitter& point, int axis)
{
  const auto& direction = axis == 0 ? light.AxisU : light.AxisV;
  double offset = 0.0;
  double along = 1.0;
  if (light.Directional)
  {
    // Tangents of angles, against the direction of the light.
    offset = -vtkMath::Dot(point.Direction.data(), direction.data());
    along = vtkMath::Dot(point.Direction.data(), light.Direction.data());
  }
  else
  {
    const double way[3] = { point.Center[0] - light.Center[0], point.Center[1] - light.Center[1],
      point.Center[2] - light.Center[2] };
    offset = vtkMath::Dot(way, direction.data());
  }
  return light.HalfSize[axis] > 0.0 ? offset / (along * light.HalfSize[axis]) : 0.0;
}
} // namespace

//------------------------------------------------------------------------------
vtkCascadedPoints::vtkCascadedPoints(const vtkShadowEmitter& emitter, const vtkShadowMapView* views,
  const float* weights, size_t count)
{
  for (size_t i = 0; i < count; ++i)
  {
    this->Points.push_back({ { weights[i], FindSide(FindOffset(emitter, views[i].Emitter, 0)),
      FindSide(FindOffset(emitter, views[i].Emitter, 1)), 0.0f } });
    this->Weight += weights[i];
  }
  if (count > 0)
  {
    vtkShadowMapView whole = views[0];
    whole.Emitter.HalfSize = emitter.HalfSize;
    this->CellScale = whole.GetKernelScale();
    const double edge = emitter.Shape == vtkShadowEmitter::DISK ? DiskEdge : 1.0;
    this->CellScale[0] *= edge;
    this->CellScale[1] *= edge;
  }
}

//------------------------------------------------------------------------------
void vtkCascadedPoints::SetUniforms(vtkShaderProgram* program, double cellEdge) const
{
  const auto count = static_cast<int>(this->Points.size());
  program->SetUniformi("sampleCount", count);
  if (count == 0)
  {
    return;
  }
  program->SetUniformf("totalWeight", this->Weight);
  const float scale[2] = { static_cast<float>(cellEdge * this->CellScale[0]),
    static_cast<float>(cellEdge * this->CellScale[1]) };
  program->SetUniform2f("cellScale", scale);
  program->SetUniform4fv("points", count, this->Points.front().data());
}
VTK_ABI_NAMESPACE_END
