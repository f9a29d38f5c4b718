// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceSnapshot.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderer.h>

#include <mutex>   // For the caster that is built once
#include <string>  // For the reason why a light casts nothing
#include <utility> // For std::move

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
struct ReferenceSnapshot::Surfaces
{
  explicit Surfaces(vtkRenderer* renderer)
    : Geometry(renderer)
  {
  }

  ReferenceGeometry Geometry;
  std::once_flag Built;
  std::unique_ptr<ReferenceRayCaster> Caster;
};

//--------------------------------------------------------------------------------------------------
ReferenceSnapshot::ReferenceSnapshot(vtkRenderer* renderer, int width, int height, bool gaussian)
  : ReferenceSnapshot(renderer, width, height, gaussian, std::make_shared<Surfaces>(renderer))
{
}

//--------------------------------------------------------------------------------------------------
ReferenceSnapshot::ReferenceSnapshot(vtkRenderer* renderer, int width, int height, bool gaussian,
  const ReferenceSnapshot& sameSurfaces)
  : ReferenceSnapshot(renderer, width, height, gaussian, sameSurfaces.Shared)
{
}

//--------------------------------------------------------------------------------------------------
ReferenceSnapshot::ReferenceSnapshot(
  vtkRenderer* renderer, int width, int height, bool gaussian, std::shared_ptr<Surfaces> surfaces)
  : Width(width)
  , Height(height)
  , Shared(std::move(surfaces))
  , Camera(renderer->GetActiveCamera(), width, height, this->Shared->Geometry)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    vtkShadowEmitter emitter;
    std::string reason;
    this->CastsShadow.push_back(vtkShadowEmitter::FromLight(light, emitter, reason));
    this->Lights.emplace_back(emitter, this->Shared->Geometry, gaussian);
  }
}

//--------------------------------------------------------------------------------------------------
const ReferenceGeometry& ReferenceSnapshot::GetGeometry() const
{
  return this->Shared->Geometry;
}

//--------------------------------------------------------------------------------------------------
const ReferenceRayCaster& ReferenceSnapshot::GetCaster() const
{
  std::call_once(this->Shared->Built,
    [this]
    { this->Shared->Caster = std::make_unique<ReferenceRayCaster>(this->Shared->Geometry); });
  return *this->Shared->Caster;
}

}
