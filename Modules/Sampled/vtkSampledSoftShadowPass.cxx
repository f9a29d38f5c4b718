// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSampledSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTextureUnit.h"
#include "vtkSoftShadowServices.h"

#include "vtkSampledSoftShadowFS.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSampledSoftShadowPass);

namespace
{
constexpr size_t MapsPerDraw = VTK_SOFT_SHADOW_SAMPLES_PER_DRAW;
} // namespace

class vtkSampledSoftShadowPass::Internals
{
public:
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
  const vtkSoftShadowSamples& samples = services.FitSamples(0, this->GetMTime(),
    [&]
    {
      return vtkShadowLightSampling::Generate(
        services.Emitter, this->NumberOfSamples, this->Pattern, this->Weights);
    });
  const size_t batch = services.GetMapsPerBatch(services.MapSize);
  const size_t count = samples.Views.size();
  float litWeight = samples.LitWeight;
  for (size_t first = 0; first == 0 || first < count; first += batch)
  {
    const size_t last = std::min(first + batch, count);
    vtkShadowTextureArray* texture = nullptr;
    if (last > first)
    {
      vtkShadowDepthMaps* maps = services.BakeMaps(
        { samples.Views.begin() + first, samples.Views.begin() + last }, services.MapSize);
      if (!maps)
      {
        return;
      }
      texture = maps->GetTexture();
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
      services.SetSampleUniforms(program, samples.Views.data() + i, samples.Weights.data() + i,
        std::min(MapsPerDraw, last - i), i - first, services.MapSize, this->FilterSize);
      // Without a map the sampler still needs a unit that no texture of another kind is bound to.
      vtkShadowTextureUnit none;
      program->SetUniformi(
        "depthMaps", texture ? texture->Activate() : none.Reserve(services.Window));
      services.DrawMarked(this->Impl->Shader,
        vtkSoftShadowServices::CountSampleTaps(std::min(MapsPerDraw, last - i), this->FilterSize));
      if (texture)
      {
        texture->Deactivate();
      }
      none.Release();
      services.Receivers->Deactivate();
    }
  }
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  statistics.ShaderBuilds += this->Impl->Shader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkSampledSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Impl->Shader.ReleaseGraphicsResources(window);
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
