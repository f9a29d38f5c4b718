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

#include "vtkSampledSoftShadowFS.h"

#include <algorithm>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSampledSoftShadowPass);

namespace
{
// Maps per draw; a matrix each must fit the least number of uniforms that OpenGL 3.2 guarantees.
constexpr size_t MapsPerDraw = 32;

// The points of one emitter with their views, and the maps that hold a batch of them.
struct EmitterSamples
{
  vtkShadowEmitter Emitter;
  vtkMTimeType CastersTime = 0;
  vtkMTimeType SettingsTime = 0;
  std::vector<vtkShadowMapView> Views;
  std::vector<float> Weights; // of the views
  float LitWeight = 0.0f;     // of the points in whose way nothing lies
  vtkNew<vtkShadowDepthMaps> Maps;
};
} // namespace

class vtkSampledSoftShadowPass::Internals
{
public:
  std::map<std::pair<int, int>, EmitterSamples> Emitters; // by light and part
  vtkShadowShader Shader{ vtkSampledSoftShadowFS };

  static void Fit(EmitterSamples& emitter, const vtkSoftShadowContext& context,
    const std::vector<vtkShadowLightSampling::Sample>& samples);
  void DrawBatch(const vtkSoftShadowContext& context, EmitterSamples& emitter, size_t first,
    size_t count, std::vector<float>& matrices);
};

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::Internals::Fit(EmitterSamples& emitter,
  const vtkSoftShadowContext& context, const std::vector<vtkShadowLightSampling::Sample>& samples)
{
  emitter.Views.clear();
  emitter.Weights.clear();
  emitter.LitWeight = 0.0f;
  for (const vtkShadowLightSampling::Sample& sample : samples)
  {
    const double weight = sample.Weight * context.Emitter.Weight;
    const vtkShadowEmitter point = context.Emitter.PointAt(sample.U, sample.V, weight);
    vtkShadowMapView view;
    if (context.Fitter->Fit(point, view))
    {
      emitter.Views.push_back(view);
      emitter.Weights.push_back(static_cast<float>(weight));
    }
    else
    {
      emitter.LitWeight += static_cast<float>(weight);
    }
  }
}

//------------------------------------------------------------------------------
vtkSampledSoftShadowPass::vtkSampledSoftShadowPass()
  : Impl(new Internals)
{
  const vtkShadowShader::Definitions definitions = { { "SAMPLED_BATCH",
    std::to_string(MapsPerDraw) } };
  this->Impl->Shader.SetDefinitions(definitions);
}

//------------------------------------------------------------------------------
vtkSampledSoftShadowPass::~vtkSampledSoftShadowPass() = default;

//------------------------------------------------------------------------------
int vtkSampledSoftShadowPass::GetProof() const
{
  // Few maps are cheaper to look at than a pyramid is to build; and only a true proof counts here:
  // a light whose centre is hidden everywhere may still peep past the first blocker.
  return this->NumberOfSamples < 16 ? PROVES_NOTHING : PROVES_LIT;
}

//------------------------------------------------------------------------------
bool vtkSampledSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  EmitterSamples& emitter = this->Impl->Emitters[std::make_pair(context.Light, context.Part)];
  if (emitter.Emitter != context.Emitter || emitter.SettingsTime != this->GetMTime() ||
    emitter.CastersTime != context.Casters->GetCastersTime())
  {
    emitter.Emitter = context.Emitter;
    emitter.SettingsTime = this->GetMTime();
    emitter.CastersTime = context.Casters->GetCastersTime();
    Internals::Fit(emitter, context,
      vtkShadowLightSampling::Generate(
        context.Emitter, this->NumberOfSamples, this->Pattern, this->Weights));
  }
  const size_t layers =
    static_cast<size_t>(vtkShadowTextureArray::GetMaximumLayers(context.Window));
  const size_t batch = std::min(this->GetMapsPerBatch(), layers);
  std::vector<float> matrices(16 * MapsPerDraw);
  float litWeight = emitter.LitWeight;
  for (size_t first = 0; first == 0 || first < emitter.Views.size(); first += batch)
  {
    const size_t last = std::min(first + batch, emitter.Views.size());
    if (last > first)
    {
      const std::vector<vtkShadowMapView> views(
        emitter.Views.begin() + first, emitter.Views.begin() + last);
      const int baked = emitter.Maps->Bake(context.Renderer, context.Casters, views, this->MapSize);
      if (baked < 0)
      {
        return;
      }
      this->CountBakes(baked);
    }
    for (size_t i = first; i == first || i < last; i += MapsPerDraw)
    {
      if (!this->Impl->Shader.Use(context.Window))
      {
        return;
      }
      vtkShaderProgram* program = this->Impl->Shader.GetProgram();
      program->SetUniformf("litWeight", litWeight);
      program->SetUniformi("filterSize", this->FilterSize);
      program->SetUniformf("depthMapSize", static_cast<float>(this->MapSize));
      program->SetUniformf("firstLayer", static_cast<float>(i - first));
      litWeight = 0.0f; // once
      this->SetReceiverUniforms(program, context);
      const size_t count = std::min(MapsPerDraw, last - i);
      this->Impl->DrawBatch(context, emitter, i, count, matrices);
      vtkShadowTextureArray* texture = emitter.Maps->GetTexture();
      const bool hasMaps = count > 0;
      if (hasMaps)
      {
        program->SetUniformi("depthMaps", texture->Activate());
      }
      this->DrawFiltered(this->Impl->Shader);
      texture->Deactivate();
      context.Receivers->Deactivate();
    }
  }
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::Internals::DrawBatch(const vtkSoftShadowContext& context,
  EmitterSamples& emitter, size_t first, size_t count, std::vector<float>& matrices)
{
  vtkShaderProgram* program = this->Shader.GetProgram();
  for (size_t i = 0; i < count; ++i)
  {
    vtkSoftShadowPass::ViewToMap(context, emitter.Views[first + i], &matrices[16 * i]);
  }
  program->SetUniformi("sampleCount", static_cast<int>(count));
  if (count > 0)
  {
    program->SetUniformMatrix4x4v("viewToMaps", static_cast<int>(count), matrices.data());
    program->SetUniform1fv("sampleWeights", static_cast<int>(count), &emitter.Weights[first]);
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSampledSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    bytes += emitter.second.Maps->GetTexture()->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSampledSoftShadowPass::GetTechniqueDrawCalls()
{
  vtkTypeInt64 calls = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    calls += emitter.second.Maps->GetNumberOfDrawCalls();
  }
  return calls;
}

//------------------------------------------------------------------------------
int vtkSampledSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->Shader.GetNumberOfBuilds();
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
  const char* const patterns[] = { "grid", "stratified", "hammersley" };
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Pattern: " << patterns[this->Pattern] << "\n";
  os << indent
     << "Weights: " << (this->Weights == vtkShadowLightSampling::GAUSSIAN ? "gaussian" : "mean")
     << "\n";
  os << indent << "FilterSize: " << this->FilterSize << "\n";
}
VTK_ABI_NAMESPACE_END
