// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSampledSoftShadowPass.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"

#include "vtkSampledSoftShadowFS.h"

#include <algorithm>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSampledSoftShadowPass);

namespace
{
constexpr size_t MapsPerDraw = VTK_SOFT_SHADOW_SAMPLES_PER_DRAW;

// The points of one emitter with their views, and the maps that hold a batch of them.
struct EmitterSamples
{
  vtkShadowEmitter Emitter;
  vtkMTimeType CastersTime = 0;
  vtkMTimeType SettingsTime = 0;
  vtkSoftShadowSamples Samples;
  vtkNew<vtkShadowDepthMaps> Maps;
};
} // namespace

class vtkSampledSoftShadowPass::Internals
{
public:
  std::map<std::pair<int, int>, EmitterSamples> Emitters; // by light and part
  vtkShadowShader Shader{ vtkSampledSoftShadowFS };
};

//------------------------------------------------------------------------------
vtkSampledSoftShadowPass::vtkSampledSoftShadowPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSampledSoftShadowPass::~vtkSampledSoftShadowPass() = default;

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkSampledSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.EmitterMap = false;
  // Few maps are cheaper to look at than a pyramid is to build; and only a true proof counts here:
  // a light whose centre is hidden everywhere may still peep past the first blocker.
  requirements.Proof = this->NumberOfSamples < 16 ? vtkSoftShadowRequirements::PROVES_NOTHING
                                                  : vtkSoftShadowRequirements::PROVES_LIT;
  requirements.GaussianWeights = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  return requirements;
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  EmitterSamples& emitter = this->Impl->Emitters[std::make_pair(services.Light, services.Part)];
  if (emitter.Emitter != services.Emitter || emitter.SettingsTime != this->GetMTime() ||
    emitter.CastersTime != services.Casters->GetCastersTime())
  {
    emitter.Emitter = services.Emitter;
    emitter.SettingsTime = this->GetMTime();
    emitter.CastersTime = services.Casters->GetCastersTime();
    emitter.Samples = services.FitSamples(vtkShadowLightSampling::Generate(
      services.Emitter, this->NumberOfSamples, this->Pattern, this->Weights));
  }
  const size_t layers =
    static_cast<size_t>(vtkShadowTextureArray::GetMaximumLayers(services.Window));
  const size_t batch = std::min(services.GetMapsPerBatch(services.MapSize), layers);
  float litWeight = emitter.Samples.LitWeight;
  for (size_t first = 0; first == 0 || first < emitter.Samples.Views.size(); first += batch)
  {
    const size_t last = std::min(first + batch, emitter.Samples.Views.size());
    if (last > first)
    {
      const std::vector<vtkShadowMapView> views(
        emitter.Samples.Views.begin() + first, emitter.Samples.Views.begin() + last);
      const int baked =
        emitter.Maps->Bake(services.Renderer, services.Casters, views, services.MapSize);
      if (baked < 0)
      {
        return;
      }
      services.CountBakes(baked, services.MapSize);
    }
    for (size_t i = first; i == first || i < last; i += MapsPerDraw)
    {
      if (!this->Impl->Shader.Use(services.Window))
      {
        return;
      }
      vtkShaderProgram* program = this->Impl->Shader.GetProgram();
      program->SetUniformf("litWeight", litWeight);
      litWeight = 0.0f; // once
      services.SetReceiverUniforms(program);
      const size_t count = std::min(MapsPerDraw, last - i);
      services.SetSampleUniforms(program, emitter.Samples.Views.data() + i,
        emitter.Samples.Weights.data() + i, count, i - first, services.MapSize, this->FilterSize);
      vtkShadowTextureArray* texture = emitter.Maps->GetTexture();
      const bool hasMaps = count > 0;
      if (hasMaps)
      {
        program->SetUniformi("depthMaps", texture->Activate());
      }
      services.DrawMarked(this->Impl->Shader);
      texture->Deactivate();
      services.Receivers->Deactivate();
    }
  }
  // Of a light's many parts only the first ones keep their maps.
  vtkTypeInt64 bytes = 0;
  for (auto& other : this->Impl->Emitters)
  {
    bytes += other.first.first == services.Light ? other.second.Maps->GetTexture()->GetBytes() : 0;
  }
  if (services.ExceedsMapMemory(bytes))
  {
    emitter.Maps->ReleaseGraphicsResources(services.Window);
  }
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  statistics.ShaderBuilds += this->Impl->Shader.GetNumberOfBuilds();
  for (auto& emitter : this->Impl->Emitters)
  {
    statistics.BytesHeld += emitter.second.Maps->GetTexture()->GetBytes();
    statistics.DrawCalls += emitter.second.Maps->GetNumberOfDrawCalls();
  }
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Impl->Shader.ReleaseGraphicsResources(window);
  for (auto& emitter : this->Impl->Emitters)
  {
    emitter.second.Maps->ReleaseGraphicsResources(window);
  }
  this->Impl->Emitters.clear();
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const patterns[] = { "grid", "stratified", "hammersley", "sobol", "lattice" };
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Pattern: " << patterns[this->Pattern] << "\n";
  os << indent
     << "Weights: " << (this->Weights == vtkShadowLightSampling::GAUSSIAN ? "gaussian" : "mean")
     << "\n";
  os << indent << "FilterSize: " << this->FilterSize << "\n";
}
VTK_ABI_NAMESPACE_END
