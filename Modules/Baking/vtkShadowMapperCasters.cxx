// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapperCasters.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowCamera.h"
#include "vtkShadowMapView.h"
#include "vtkTimeStamp.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Protected members of VTK's classes whose Set functions would tell the world.
struct RendererAccess : public vtkRenderer
{
  static vtkCamera*& Camera(vtkRenderer* renderer)
  {
    return renderer->*(&RendererAccess::ActiveCamera);
  }
};

struct LightingAccess : public vtkOpenGLRenderer
{
  static vtkMTimeType& UpdateTime(vtkOpenGLRenderer* renderer)
  {
    return renderer->*(&LightingAccess::LightingUpdateTime);
  }
};

struct PropertyAccess : public vtkProperty
{
  static vtkTypeBool& Backface(vtkProperty* property)
  {
    return property->*(&PropertyAccess::BackfaceCulling);
  }
  static vtkTypeBool& Frontface(vtkProperty* property)
  {
    return property->*(&PropertyAccess::FrontfaceCulling);
  }
};
}

//------------------------------------------------------------------------------
vtkShadowMapperCasters::vtkShadowMapperCasters(
  vtkRenderer* renderer, vtkShadowCamera* camera, const vtkShadowMapView& view)
  : Renderer(renderer)
  , Camera(RendererAccess::Camera(renderer))
{
  camera->SetView(view);
  RendererAccess::Camera(renderer) = camera;
}

//------------------------------------------------------------------------------
vtkShadowMapperCasters::~vtkShadowMapperCasters()
{
  RendererAccess::Camera(this->Renderer) = this->Camera;
  // The mappers' programs now hold the lights as the map's camera, the newest, sees them, and take
  // nothing older. The renderer computes this time anew in every frame.
  if (auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Renderer))
  {
    vtkTimeStamp now;
    now.Modified();
    LightingAccess::UpdateTime(renderer) = now.GetMTime();
  }
}

//------------------------------------------------------------------------------
void vtkShadowMapperCasters::Draw(vtkProp3D* prop, vtkMatrix4x4* matrix)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkProperty* property = actor ? actor->GetProperty() : nullptr;
  const vtkTypeBool backface = property ? property->GetBackfaceCulling() : 0;
  const vtkTypeBool frontface = property ? property->GetFrontfaceCulling() : 0;
  const double renderTime = prop->GetEstimatedRenderTime();
  if (property)
  {
    PropertyAccess::Backface(property) = 0;
    PropertyAccess::Frontface(property) = 0;
  }
  if (matrix)
  {
    prop->PokeMatrix(matrix);
  }
  prop->RenderOpaqueGeometry(this->Renderer);
  if (matrix)
  {
    prop->PokeMatrix(nullptr);
  }
  if (property)
  {
    PropertyAccess::Backface(property) = backface;
    PropertyAccess::Frontface(property) = frontface;
  }
  prop->SetEstimatedRenderTime(renderTime); // levels of detail go by what the picture costs
}

VTK_ABI_NAMESPACE_END
