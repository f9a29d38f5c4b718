// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowFits.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkSoftShadowContext.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowFits::Begin(vtkRenderer* renderer)
{
  for (auto emitter = this->Emitters.begin(); emitter != this->Emitters.end();)
  {
    const bool isThere = vtkSoftShadowContext::HasLight(renderer, emitter->first.first);
    emitter = isThere ? std::next(emitter) : this->Emitters.erase(emitter);
  }
}

//------------------------------------------------------------------------------
const vtkSoftShadowSamples& vtkSoftShadowFits::Get(
  const vtkSoftShadowContext& context, int set, vtkMTimeType settings, const MakePoints& points)
{
  EmitterFits& fits = this->Emitters[std::make_pair(context.Source, context.Part)];
  const vtkMTimeType bodies = context.Casters->GetBodiesTime();
  if (fits.Emitter != context.Emitter || fits.SettingsTime != settings || fits.BodiesTime != bodies)
  {
    fits.Emitter = context.Emitter;
    fits.SettingsTime = settings;
    fits.BodiesTime = bodies;
    fits.Sets.clear();
  }
  const auto known = fits.Sets.find(set);
  return known != fits.Sets.end()
    ? known->second
    : fits.Sets.emplace(set, vtkSoftShadowSamples::Fit(*context.Fitter, context.Emitter, points()))
        .first->second;
}
VTK_ABI_NAMESPACE_END
