// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedPoints.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
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
vtkCascadedPoints::vtkCascadedPoints(const vtkShadowEmitter& emitter,
  const std::array<double, 16>& viewToWorld, const vtkShadowMapView* views, const float* weights,
  size_t count)
{
  double mapToView[16] = {};
  for (size_t i = 0; i < count; ++i)
  {
    double viewToMap[16];
    vtkMatrix4x4::Multiply4x4(views[i].WorldToMap().data(), viewToWorld.data(), viewToMap);
    if (i == 0)
    {
      vtkMatrix4x4::Invert(viewToMap, mapToView);
      for (int row = 0; row < 4; ++row)
      {
        for (int column = 0; column < 4; ++column)
        {
          this->ViewToBase[4 * column + row] = static_cast<float>(viewToMap[4 * row + column]);
        }
      }
      vtkShadowMapView whole = views[0];
      whole.Emitter.HalfSize = emitter.HalfSize;
      this->CellScale = whole.GetKernelScale();
      const double edge = emitter.Shape == vtkShadowEmitter::DISK ? DiskEdge : 1.0;
      this->CellScale[0] *= edge;
      this->CellScale[1] *= edge;
    }
    double baseToMap[16];
    vtkMatrix4x4::Multiply4x4(viewToMap, mapToView, baseToMap);
    this->AddPoint(baseToMap, weights[i], emitter, views[i].Emitter);
  }
}

//------------------------------------------------------------------------------
void vtkCascadedPoints::AddPoint(const double baseToMap[16], float weight,
  const vtkShadowEmitter& light, const vtkShadowEmitter& point)
{
  for (int row = 0; row < 3; ++row)
  {
    Row affine;
    for (int column = 0; column < 4; ++column)
    {
      affine[column] = static_cast<float>(baseToMap[4 * row + column] / baseToMap[15]);
    }
    this->Rows.push_back(affine);
  }
  this->Points.push_back({ { weight, FindSide(FindOffset(light, point, 0)),
    FindSide(FindOffset(light, point, 1)), 0.0f } });
  this->Weight += weight;
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
  program->SetUniformMatrix4x4("viewToBase", const_cast<float*>(this->ViewToBase.data()));
  program->SetUniform4fv("baseToMaps", 3 * count, this->Rows.front().data());
  program->SetUniform4fv("points", count, this->Points.front().data());
}
VTK_ABI_NAMESPACE_END
