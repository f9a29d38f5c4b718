// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedSoftShadowPass.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkTracedLight.h"
#include "vtkTracedPicture.h"
#include "vtkTracedReceivers.h"
#include "vtkTracedScene.h"
#include "vtkTracedWorkers.h"

#include "vtkTracedSoftShadowFS.h"

#include <set>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTracedSoftShadowPass);

class vtkTracedSoftShadowPass::Internals
{
public:
  vtkTracedScene Scene;
  vtkTracedReceivers Receivers;
  vtkTracedWorkers Workers;
  vtkTracedPicture Picture{ Scene, Receivers, Workers };
  bool HasFrame = false;      // scene and receivers are those of the frame at hand
  bool IsSmooth = false;      // receivers are those of the smooth surface
  std::set<std::string> Told; // reasons why props cast nothing
  vtkTypeInt64 Reads = 0;
  vtkTypeInt64 Rays = 0; // of the frame

  vtkShadowShader Shader{ vtkTracedSoftShadowFS };
  vtkNew<vtkShadowTextureArray> Visibilities; // R32F, of one emitter
};

//------------------------------------------------------------------------------
vtkTracedSoftShadowPass::vtkTracedSoftShadowPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkTracedSoftShadowPass::~vtkTracedSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::BeginVisibility(const vtkSoftShadowContext&)
{
  this->Impl->HasFrame = false;
  this->Impl->Rays = 0;
  return false;
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::ReadFrame(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  const bool smooth = context.Receivers->GetSmooth();
  if (impl.HasFrame && impl.IsSmooth == smooth)
  {
    return true;
  }
  impl.IsSmooth = smooth;
  this->BeginStep("scene", true);
  if (!impl.Scene.Update(context.Casters))
  {
    return false;
  }
  this->WarnOfUntraced();
  this->BeginStep("reading", true);
  impl.Receivers.Read(context.Receivers);
  impl.Receivers.SetScene(impl.Scene);
  ++impl.Reads;
  impl.HasFrame = true;
  return true;
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::WarnOfUntraced()
{
  for (const std::string& reason : this->Impl->Scene.GetReasons())
  {
    if (this->Impl->Told.insert(reason).second)
    {
      vtkWarningMacro("A prop casts no shadow here, because " << reason << ".");
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkTracedSoftShadowPass::GetCasterReport() const
{
  std::string report;
  for (const std::string& reason : this->Impl->Scene.GetReasons())
  {
    report += "a prop casts nothing: " + reason + "\n";
  }
  return report;
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!this->ReadFrame(context))
  {
    return;
  }
  this->BeginStep("rays", true);
  const vtkTracedLight light(
    context.Emitter, context.FaceAxis, this->Weights, this->Rays, this->MostRays, impl.Scene);
  const bool soft = context.Emitter.HasExtent();
  impl.Picture.Trace(light, { this->Adaptive && soft, this->Filter && soft, this->EarlyOut });
  impl.Rays += impl.Picture.GetRays();
  this->BeginStep("upload");
  this->Draw(context, context.Emitter.Weight);
  this->BeginStep("visibility");
  this->Count();
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::AddPointVisibility(
  const vtkSoftShadowContext& context, const vtkShadowLightSampling::Sample& sample)
{
  Internals& impl = *this->Impl;
  if (!this->ReadFrame(context))
  {
    return false;
  }
  const vtkTracedLight point(context.Emitter.PointAt(sample.U, sample.V, 1.0), context.FaceAxis,
    vtkShadowLightSampling::MEAN, 1, 1, impl.Scene);
  impl.Picture.Trace(point, { false, false, this->EarlyOut });
  impl.Rays += impl.Picture.GetRays();
  this->Count();
  return this->Draw(context, context.Emitter.Weight * sample.Weight);
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::Count()
{
  const Internals& impl = *this->Impl;
  const vtkTracedScene::Counts& counts = impl.Scene.GetCounts();
  this->ChangeStatistics().TechniqueCounts = { { "rays", impl.Rays },
    { "receivers_read", impl.Reads }, { "bodies_built", counts.BodiesBuilt },
    { "bodies_refitted", counts.BodiesRefitted }, { "scenes_built", counts.ScenesBuilt } };
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::Draw(const vtkSoftShadowContext& context, double weight)
{
  Internals& impl = *this->Impl;
  vtkShadowTextureArray* texture = impl.Visibilities;
  if (!texture->Allocate(context.Window, vtkShadowTextureArray::R32F, impl.Receivers.GetWidth(),
        impl.Receivers.GetHeight(), 1) ||
    !impl.Shader.Use(context.Window))
  {
    return false;
  }
  texture->WriteLayer(0, impl.Picture.GetVisibilities().data());
  vtkShaderProgram* program = impl.Shader.GetProgram();
  this->SetReceiverUniforms(program, context);
  program->SetUniformf("weight", static_cast<float>(weight));
  program->SetUniformi("visibilities", texture->Activate());
  this->DrawFiltered(impl.Shader);
  texture->Deactivate();
  context.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTracedSoftShadowPass::GetTechniqueBytes()
{
  return this->Impl->Visibilities->GetBytes() + this->Impl->Scene.GetBytes();
}

//------------------------------------------------------------------------------
int vtkTracedSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->Shader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Impl->Shader.ReleaseGraphicsResources(window);
  this->Impl->Visibilities->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rays: " << this->Rays << "\n";
  os << indent << "Filter: " << (this->Filter ? "on" : "off") << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "on" : "off") << "\n";
  os << indent << "MostRays: " << this->MostRays << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
}
VTK_ABI_NAMESPACE_END
