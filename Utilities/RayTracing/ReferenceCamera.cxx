// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceCamera.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm> // For the copy of the matrix

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
ReferenceCamera::ReferenceCamera(
  vtkCamera* camera, int width, int height, const ReferenceGeometry& geometry)
  : Width(width)
  , Height(height)
  , Scale(geometry.Scale)
{
  vtkMatrix4x4* worldToView = camera->GetModelViewTransformMatrix();
  vtkNew<vtkMatrix4x4> viewToWorld;
  vtkMatrix4x4::Invert(worldToView, viewToWorld);
  for (int i = 0; i < 3; ++i)
  {
    this->DepthRow[i] = worldToView->GetElement(2, i);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Axes[axis][i] = viewToWorld->GetElement(i, axis);
    }
  }
  this->Origin = geometry.ToLocal({ { viewToWorld->GetElement(0, 3), viewToWorld->GetElement(1, 3),
    viewToWorld->GetElement(2, 3) } });

  // Two planes around the focal point stand for the clipping planes, which set nothing but the depth
  // of the points that a ray is laid through.
  vtkNew<vtkCamera> copy;
  copy->DeepCopy(camera);
  copy->SetClippingRange(0.5 * camera->GetDistance(), 2.0 * camera->GetDistance());
  vtkNew<vtkMatrix4x4> clipToView;
  vtkMatrix4x4::Invert(
    copy->GetProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0), clipToView);
  std::copy_n(clipToView->GetData(), 16, this->ClipToView.begin());
}

//--------------------------------------------------------------------------------------------------
Vector ReferenceCamera::ToView(double x, double y, double z) const
{
  const double* m = this->ClipToView.data();
  const double w = m[12] * x + m[13] * y + m[14] * z + m[15];
  Vector view;
  for (int row = 0; row < 3; ++row, m += 4)
  {
    view[row] = (m[0] * x + m[1] * y + m[2] * z + m[3]) / w;
  }
  return view;
}

//--------------------------------------------------------------------------------------------------
ReferenceRayCaster::Ray ReferenceCamera::GetRay(int column, int row) const
{
  const double x = 2.0 * (column + 0.5) / this->Width - 1.0;
  const double y = 1.0 - 2.0 * (row + 0.5) / this->Height;
  const Vector near = this->ToView(x, y, -1.0);
  const Vector step = this->ToView(x, y, 1.0) - near;
  const Vector start = near - (near[2] / step[2]) * step;
  const auto toLocal = [this](const Vector& v)
  { return v[0] * this->Axes[0] + v[1] * this->Axes[1] + v[2] * this->Axes[2]; };
  return { this->Origin + this->Scale * toLocal(start), Normalized(toLocal(step)) };
}

//--------------------------------------------------------------------------------------------------
double ReferenceCamera::GetDepth(const Vector& point) const
{
  return -Dot(this->DepthRow, point - this->Origin) / this->Scale;
}

}
