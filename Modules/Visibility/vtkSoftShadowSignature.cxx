// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowSignature.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkShadowCasters.h"
#include "vtkShadowEmitter.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowSignature::AddState(const vtkRenderState* s)
{
  this->Add(static_cast<vtkTypeUInt64>(reinterpret_cast<std::uintptr_t>(s->GetRenderer())));
  this->AddCamera(s->GetRenderer());
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    this->AddProp(s->GetPropArray()[i]);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowSignature::AddCamera(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Add(camera->GetModelViewTransformMatrix()->GetData(), 16);
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  this->Add(projection->GetData(), 16);
}

//------------------------------------------------------------------------------
void vtkSoftShadowSignature::AddProp(vtkProp* prop)
{
  this->Add(static_cast<vtkTypeUInt64>(reinterpret_cast<std::uintptr_t>(prop)));
  // An assembly changes the matrices of its parts, and so its own time, whenever it is drawn. Its parts
  // are among the casters' bodies, which look at each leaf's geometry.
  const bool hasParts = prop->IsA("vtkAssembly") || prop->IsA("vtkPropAssembly");
  this->Add(static_cast<vtkTypeUInt64>(hasParts ? 0 : prop->GetRedrawMTime()));
  this->Add(static_cast<vtkTypeUInt64>(vtkShadowCasters::GetReceivesShadow(prop)));
  this->Add(static_cast<vtkTypeUInt64>(prop->GetShaderProperty()->GetMTime()));
}

//------------------------------------------------------------------------------
void vtkSoftShadowSignature::AddEmitter(const vtkShadowEmitter& emitter)
{
  this->Add(static_cast<vtkTypeUInt64>(emitter.Shape));
  this->Add(static_cast<vtkTypeUInt64>(emitter.Directional));
  this->Add(static_cast<vtkTypeUInt64>(emitter.Omni));
  this->Add(emitter.Center.data(), 3);
  this->Add(emitter.AxisU.data(), 3);
  this->Add(emitter.AxisV.data(), 3);
  this->Add(emitter.Direction.data(), 3);
  this->Add(emitter.HalfSize.data(), 2);
  this->Add(emitter.ConeAngle);
}
VTK_ABI_NAMESPACE_END
