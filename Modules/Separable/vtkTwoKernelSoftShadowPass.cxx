// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTwoKernelSoftShadowPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSeparableStep.h"
#include "vtkSeparableTarget.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTwoKernelSoftShadowPass::vtkTwoKernelSoftShadowPass()
  : Target(new vtkSeparableTarget)
{
}

//------------------------------------------------------------------------------
vtkTwoKernelSoftShadowPass::~vtkTwoKernelSoftShadowPass() = default;

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkTwoKernelSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.Pyramid = true;
  requirements.GaussianWeights = this->HasGaussianWeights();
  return requirements;
}

//------------------------------------------------------------------------------
bool vtkTwoKernelSoftShadowPass::Allocate(const vtkSoftShadowServices& services, int format,
  const std::vector<vtkShadowTextureArray*>& textures)
{
  for (vtkShadowTextureArray* texture : textures)
  {
    if (!texture->Allocate(services.Window, format, services.Receivers->GetWidth(),
          services.Receivers->GetHeight(), 1))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTwoKernelSoftShadowPass::UseStep(
  vtkSeparableStep& step, const vtkSoftShadowServices& services)
{
  if (!step.GetShader().Use(services.Window))
  {
    return nullptr;
  }
  vtkShaderProgram* program = step.GetShader().GetProgram();
  services.SetReceiverUniforms(program);
  services.SetMapUniforms(program);
  program->SetUniformi("depthMaps", services.Maps->GetTexture()->Activate());
  program->SetUniformi("depthPyramid", services.Pyramid->GetTexture()->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(services.Layer));
  program->SetUniformi("searchWidth", this->GetSearchTaps(services));
  program->SetUniformi("filterWidth", this->GetFilterTaps(services));
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  return program;
}

//------------------------------------------------------------------------------
int vtkTwoKernelSoftShadowPass::GetSearchTaps(const vtkSoftShadowServices& services) const
{
  return services.Emitter.HasExtent() ? this->SearchWidth : 1;
}

//------------------------------------------------------------------------------
int vtkTwoKernelSoftShadowPass::GetFilterTaps(const vtkSoftShadowServices& services) const
{
  return services.Emitter.HasExtent() ? this->FilterWidth : 1;
}

//------------------------------------------------------------------------------
void vtkTwoKernelSoftShadowPass::EndStep(const vtkSoftShadowServices& services)
{
  services.Pyramid->GetTexture()->Deactivate();
  services.Maps->GetTexture()->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkTwoKernelSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  for (vtkShadowTextureArray* texture : this->GetTextures())
  {
    statistics.BytesHeld += texture->GetBytes();
  }
  for (vtkSeparableStep* step : this->GetSteps())
  {
    statistics.ShaderBuilds += step->GetShader().GetNumberOfBuilds();
  }
}

//------------------------------------------------------------------------------
void vtkTwoKernelSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (vtkSeparableStep* step : this->GetSteps())
  {
    step->GetShader().ReleaseGraphicsResources(window);
  }
  for (vtkShadowTextureArray* texture : this->GetTextures())
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Target->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTwoKernelSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchWidth: " << this->SearchWidth << "\n";
  os << indent << "FilterWidth: " << this->FilterWidth << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
}
VTK_ABI_NAMESPACE_END
