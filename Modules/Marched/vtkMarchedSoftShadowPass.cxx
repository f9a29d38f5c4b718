// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarchedSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"

#include "vtkMarchedSoftShadowFS.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkMarchedSoftShadowPass);

namespace
{
// A ray is four floats; OpenGL 3.2 guarantees 1024 floats of uniforms.
constexpr int MaximumRays = 240;

// Jitter of ray i's steps: the golden ratio's multiples are spread evenly for any prefix.
float StepJitter(int i)
{
  const double multiple = (i + 0.5) * 0.6180339887498949;
  return static_cast<float>(multiple - static_cast<int>(multiple));
}

// An edge of a shadow that crosses the light parts its rim: the outermost quarter of the samples, with
// half of the others against what is smaller than the light. Returns how many these are.
int PutDecisiveFirst(std::vector<vtkShadowLightSampling::Sample>& samples)
{
  const auto outside =
    [](const vtkShadowLightSampling::Sample& a, const vtkShadowLightSampling::Sample& b)
  { return a.U * a.U + a.V * a.V > b.U * b.U + b.V * b.V; };
  const std::size_t rim = (samples.size() + 3) / 4;
  std::vector<vtkShadowLightSampling::Sample> sorted = samples;
  std::nth_element(sorted.begin(), sorted.begin() + (rim - 1), sorted.end(), outside);
  const vtkShadowLightSampling::Sample last = sorted[rim - 1];
  std::stable_partition(samples.begin(), samples.end(),
    [&](const vtkShadowLightSampling::Sample& sample) { return !outside(last, sample); });
  return static_cast<int>(std::min(rim + (3 * samples.size() + 7) / 8, samples.size()));
}
} // namespace

//------------------------------------------------------------------------------
vtkMarchedSoftShadowPass::vtkMarchedSoftShadowPass()
  : Shader(vtkMarchedSoftShadowFS)
{
  const vtkShadowShader::Definitions definitions = { { "MARCHED_MAXIMUM_RAYS",
    std::to_string(MaximumRays) } };
  this->Shader.SetDefinitions(definitions);
}

//------------------------------------------------------------------------------
vtkMarchedSoftShadowPass::~vtkMarchedSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
bool vtkMarchedSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
int vtkMarchedSoftShadowPass::GetProof() const
{
  return PROVES_LIT;
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  if (!this->Shader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = this->Shader.GetProgram();
  this->SetReceiverUniforms(program, context);
  this->SetMapUniforms(
    program, context, context.Maps->GetViews()[context.Layer], context.Maps->GetResolution());
  std::vector<vtkShadowLightSampling::Sample> samples = vtkShadowLightSampling::Generate(
    context.Emitter, this->Rays, vtkShadowLightSampling::SOBOL, this->Weights);
  const int firstRays = PutDecisiveFirst(samples);
  std::vector<float> rays;
  for (size_t i = 0; i < samples.size(); ++i)
  {
    rays.insert(rays.end(),
      { static_cast<float>(samples[i].U), static_cast<float>(samples[i].V),
        static_cast<float>(samples[i].Weight), StepJitter(static_cast<int>(i)) });
  }
  const int rayCount = static_cast<int>(samples.size());
  program->SetUniform4fv("rays", rayCount, rays.data());
  program->SetUniformi("rayCount", rayCount);
  program->SetUniformi("firstRays", firstRays);
  program->SetUniformi("stepCount", this->Steps);
  program->SetUniformf("thickness", static_cast<float>(this->Thickness));
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
  vtkShadowTextureArray* maps = context.Maps->GetTexture();
  vtkShadowTextureArray* pyramid = context.Pyramid->GetTexture();
  program->SetUniformi("depthMaps", maps->Activate());
  program->SetUniformi("depthPyramid", pyramid->Activate());
  this->DrawFiltered(this->Shader);
  pyramid->Deactivate();
  maps->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
int vtkMarchedSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Shader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Shader.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rays: " << this->Rays << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
}
VTK_ABI_NAMESPACE_END
