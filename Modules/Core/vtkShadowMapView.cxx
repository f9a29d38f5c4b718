// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapView.h"

#include "vtkMatrix4x4.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// Emitter coordinates to homogeneous map coordinates.
std::array<double, 16> EmitterToMap(const vtkShadowMapView& view)
{
  const double width = view.Window[1] - view.Window[0];
  const double height = view.Window[3] - view.Window[2];
  const std::array<double, 2> linear = view.GetDepthToLinear();
  std::array<double, 16> matrix = { {} };
  matrix[0] = 1.0 / width;
  matrix[5] = 1.0 / height;
  if (view.Emitter.Directional)
  {
    matrix[3] = -view.Window[0] / width;
    matrix[7] = -view.Window[2] / height;
    matrix[10] = 1.0 / linear[1];
    matrix[11] = -linear[0] / linear[1];
    matrix[15] = 1.0;
  }
  else
  {
    // w = z, and d w = (1 / z - a) / b * z.
    matrix[2] = -view.Window[0] / width;
    matrix[6] = -view.Window[2] / height;
    matrix[10] = -linear[0] / linear[1];
    matrix[11] = 1.0 / linear[1];
    matrix[14] = 1.0;
  }
  return matrix;
}

} // namespace

//------------------------------------------------------------------------------
std::array<double, 2> vtkShadowMapView::GetDepthToLinear() const
{
  if (this->Emitter.Directional)
  {
    return { { this->Far, this->Far - this->Near } };
  }
  return { { 1.0 / this->Far, 1.0 / this->Far - 1.0 / this->Near } };
}

//------------------------------------------------------------------------------
double vtkShadowMapView::LinearDepth(double d) const
{
  const std::array<double, 2> linear = this->GetDepthToLinear();
  const double value = linear[0] + linear[1] * d;
  return this->Emitter.Directional ? value : 1.0 / value;
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkShadowMapView::GetKernelScale() const
{
  // Positional: offset in x / z is h (1 / z_o - 1 / z_q) = -h b (d_q - d_o).
  // Directional: offset in x is h (z_q - z_o) = h b (d_q - d_o).
  const double perDepth = (this->Emitter.Directional ? 1.0 : -1.0) * this->GetDepthToLinear()[1];
  return { { this->Emitter.HalfSize[0] * perDepth / (this->Window[1] - this->Window[0]),
    this->Emitter.HalfSize[1] * perDepth / (this->Window[3] - this->Window[2]) } };
}

//------------------------------------------------------------------------------
std::array<double, 16> vtkShadowMapView::WorldToMap() const
{
  const std::array<double, 16> toEmitter = this->Emitter.WorldToEmitter();
  const std::array<double, 16> toMap = EmitterToMap(*this);
  std::array<double, 16> matrix;
  vtkMatrix4x4::Multiply4x4(toMap.data(), toEmitter.data(), matrix.data());
  return matrix;
}

//------------------------------------------------------------------------------
std::array<double, 16> vtkShadowMapView::WorldToClip(bool zeroToOne) const
{
  std::array<double, 16> matrix = this->WorldToMap();
  for (int column = 0; column < 4; ++column)
  {
    const double w = matrix[12 + column];
    matrix[column] = 2.0 * matrix[column] - w;
    matrix[4 + column] = 2.0 * matrix[4 + column] - w;
    // What a depth buffer holds is -d.
    matrix[8 + column] = zeroToOne ? -matrix[8 + column] : -2.0 * matrix[8 + column] - w;
  }
  return matrix;
}

//------------------------------------------------------------------------------
bool vtkShadowMapView::operator==(const vtkShadowMapView& other) const
{
  return this->Emitter == other.Emitter && this->Window == other.Window &&
    this->Near == other.Near && this->Far == other.Far;
}
VTK_ABI_NAMESPACE_END
