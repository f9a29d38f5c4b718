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
#include "vtkSoftShadowServices.h"
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
vtkTracedSoftShadowPass::~vtkTracedSoftShadowPass() = default;

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::Begin(const vtkSoftShadowServices&)
{
  this->Impl->HasFrame = false;
  this->Impl->Rays = 0;
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::ReadFrame(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  const bool smooth = services.Receivers->GetSmooth();
  if (impl.HasFrame && impl.IsSmooth == smooth)
  {
    return true;
  }
  impl.IsSmooth = smooth;
  services.BeginStep("scene", true);
  if (!impl.Scene.Update(services.Casters))
  {
    return false;
  }
  this->WarnOfUntraced();
  services.BeginStep("reading", true);
  impl.Receivers.Read(services.Receivers);
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
vtkSoftShadowRequirements vtkTracedSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.EmitterMap = false;
  requirements.CutLights = false;
  requirements.Proof = vtkSoftShadowRequirements::PROVES_NOTHING;
  requirements.GaussianWeights = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  return requirements;
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  if (!this->ReadFrame(services))
  {
    return;
  }
  services.BeginStep("rays", true);
  const vtkTracedLight light(
    services.Emitter, services.FaceAxis, this->Weights, this->Rays, this->MostRays, impl.Scene);
  const bool soft = services.Emitter.HasExtent();
  impl.Picture.Trace(light, { this->Adaptive && soft, this->Filter && soft, services.EarlyOut });
  impl.Rays += impl.Picture.GetRays();
  services.BeginStep("upload");
  this->Draw(services, services.Emitter.Weight);
  services.BeginStep("visibility");
  this->Count(services);
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::AddPoint(
  const vtkSoftShadowServices& services, const vtkShadowLightSampling::Sample& sample)
{
  Internals& impl = *this->Impl;
  if (!this->ReadFrame(services))
  {
    return false;
  }
  const vtkTracedLight point(services.Emitter.PointAt(sample.U, sample.V, 1.0), services.FaceAxis,
    vtkShadowLightSampling::MEAN, 1, 1, impl.Scene);
  impl.Picture.Trace(point, { false, false, services.EarlyOut });
  impl.Rays += impl.Picture.GetRays();
  this->Count(services);
  return this->Draw(services, services.Emitter.Weight * sample.Weight);
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::Count(const vtkSoftShadowServices& services) const
{
  const Internals& impl = *this->Impl;
  const vtkTracedScene::Counts& counts = impl.Scene.GetCounts();
  services.SetCounts({ { "rays", impl.Rays }, { "receivers_read", impl.Reads },
    { "bodies_built", counts.BodiesBuilt }, { "bodies_refitted", counts.BodiesRefitted },
    { "scenes_built", counts.ScenesBuilt } });
}

//------------------------------------------------------------------------------
bool vtkTracedSoftShadowPass::Draw(const vtkSoftShadowServices& services, double weight)
{
  Internals& impl = *this->Impl;
  vtkShadowTextureArray* texture = impl.Visibilities;
  if (!texture->Allocate(services.Window, vtkShadowTextureArray::R32F, impl.Receivers.GetWidth(),
        impl.Receivers.GetHeight(), 1) ||
    !impl.Shader.Use(services.Window))
  {
    return false;
  }
  texture->WriteLayer(0, impl.Picture.GetVisibilities().data());
  vtkShaderProgram* program = impl.Shader.GetProgram();
  services.SetReceiverUniforms(program);
  program->SetUniformf("weight", static_cast<float>(weight));
  program->SetUniformi("visibilities", texture->Activate());
  services.DrawMarked(impl.Shader);
  texture->Deactivate();
  services.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkTracedSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  statistics.BytesHeld += this->Impl->Visibilities->GetBytes() + this->Impl->Scene.GetBytes();
  statistics.ShaderBuilds += this->Impl->Shader.GetNumberOfBuilds();
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
  os << indent
     << "Weights: " << (this->Weights == vtkShadowLightSampling::GAUSSIAN ? "gaussian" : "mean")
     << "\n";
}
VTK_ABI_NAMESPACE_END
