// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedReceivers.h"

#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkTracedScene.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Of a view distance: a few times what single precision leaves of a place that a varying has brought. It
// is about the hundredth part of a pixel.
constexpr double Precision = 4e-6;
}

//------------------------------------------------------------------------------
void vtkTracedReceivers::Read(vtkShadowReceivers* receivers)
{
  this->Width = receivers->GetWidth();
  this->Height = receivers->GetHeight();
  receivers->Read(this->Positions, this->Normals);
  this->ViewToWorld = receivers->GetViewToWorld();
}

//------------------------------------------------------------------------------
void vtkTracedReceivers::SetScene(const vtkTracedScene& scene)
{
  const std::array<double, 16>& m = this->ViewToWorld;
  this->Scale = scene.GetScale();
  for (int column = 0; column < 3; ++column)
  {
    this->ViewToLocal.Columns[column] =
      this->Scale * vtkTracedVector{ { m[column], m[4 + column], m[8 + column] } };
  }
  this->ViewToLocal.Offset = scene.ToLocal({ { m[3], m[7], m[11] } });
}

//------------------------------------------------------------------------------
bool vtkTracedReceivers::Receives(std::size_t pixel) const
{
  return this->Positions[4 * pixel + 3] == VTK_SOFT_SHADOW_RECEIVES;
}

//------------------------------------------------------------------------------
vtkTracedReceivers::Point vtkTracedReceivers::GetPoint(std::size_t pixel) const
{
  const float* p = this->GetPosition(pixel);
  const float* n = this->GetNormal(pixel);
  const vtkTracedVector position{ { p[0], p[1], p[2] } };
  Point point;
  point.Place = this->ViewToLocal(position);
  point.Normal = this->ViewToLocal.Turn({ { n[0], n[1], n[2] } });
  point.Normal = (1.0 / this->Scale) * point.Normal;
  point.Precision = Precision * this->Scale * vtkTraced::Length(position);
  return point;
}
VTK_ABI_NAMESPACE_END
