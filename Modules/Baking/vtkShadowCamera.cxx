// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCamera.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkShadowMapView.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkShadowCamera);

//------------------------------------------------------------------------------
void vtkShadowCamera::SetView(const vtkShadowMapView& view)
{
  const vtkShadowEmitter& emitter = view.Emitter;
  // A directional emitter's depths may be negative; the eye goes before all of them.
  const double back = emitter.Directional ? view.Near - (view.Far - view.Near) : 0.0;
  double eye[3];
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = emitter.Center[i] + back * emitter.Direction[i];
  }
  this->SetParallelProjection(emitter.Directional);
  this->SetPosition(eye);
  this->SetFocalPoint(eye[0] + view.Far * emitter.Direction[0],
    eye[1] + view.Far * emitter.Direction[1], eye[2] + view.Far * emitter.Direction[2]);
  this->SetViewUp(emitter.AxisV.data());
  this->SetClippingRange(view.Near - back, view.Far - back);

  double toView[16] = { 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    toView[i] = emitter.AxisU[i];
    toView[4 + i] = emitter.AxisV[i];
    toView[8 + i] = -emitter.Direction[i];
  }
  for (int row = 0; row < 3; ++row)
  {
    toView[4 * row + 3] = -vtkMath::Dot(toView + 4 * row, eye);
    for (int column = 0; column < 3; ++column)
    {
      // The inverse of a rotation, which is what VTK keeps.
      this->Normals->SetElement(column, row, toView[4 * row + column]);
    }
  }
  toView[15] = 1.0;

  const auto toClip = view.WorldToClip();
  double fromView[16];
  double viewToClip[16];
  vtkMatrix4x4::Invert(toView, fromView);
  vtkMatrix4x4::Multiply4x4(toClip.data(), fromView, viewToClip);
  this->WorldToView->DeepCopy(toView);
  this->WorldToView->Transpose();
  this->ViewToClip->DeepCopy(viewToClip);
  this->ViewToClip->Transpose();
  this->WorldToClip->DeepCopy(toClip.data());
  this->WorldToClip->Transpose();
}

//------------------------------------------------------------------------------
void vtkShadowCamera::GetKeyMatrices(vtkRenderer*, vtkMatrix4x4*& worldToView,
  vtkMatrix3x3*& normals, vtkMatrix4x4*& viewToClip, vtkMatrix4x4*& worldToClip)
{
  worldToView = this->WorldToView;
  normals = this->Normals;
  viewToClip = this->ViewToClip;
  worldToClip = this->WorldToClip;
}

VTK_ABI_NAMESPACE_END
