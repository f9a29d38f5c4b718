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

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTwoKernelSoftShadowPass::vtkTwoKernelSoftShadowPass()
  : Target(new vtkSeparableTarget)
{
}

//------------------------------------------------------------------------------
vtkTwoKernelSoftShadowPass::~vtkTwoKernelSoftShadowPass() = default;

//------------------------------------------------------------------------------
bool vtkTwoKernelSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
bool vtkTwoKernelSoftShadowPass::Allocate(const vtkSoftShadowContext& context, int format,
  const std::vector<vtkShadowTextureArray*>& textures)
{
  for (vtkShadowTextureArray* texture : textures)
  {
    if (!texture->Allocate(
          context.Window, format, context.Receivers->GetWidth(), context.Receivers->GetHeight(), 1))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkTwoKernelSoftShadowPass::UseStep(
  vtkSeparableStep& step, const vtkSoftShadowContext& context)
{
  if (!step.GetShader().Use(context.Window))
  {
    return nullptr;
  }
  vtkShaderProgram* program = step.GetShader().GetProgram();
  this->SetReceiverUniforms(program, context);
  this->SetMapUniforms(
    program, context, context.Maps->GetViews()[context.Layer], context.Maps->GetResolution());
  program->SetUniformi("depthMaps", context.Maps->GetTexture()->Activate());
  program->SetUniformi("depthPyramid", context.Pyramid->GetTexture()->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  // All taps of a light without extent are the same one.
  const bool hasExtent = context.Emitter.HasExtent();
  program->SetUniformi("searchWidth", hasExtent ? this->SearchWidth : 1);
  program->SetUniformi("filterWidth", hasExtent ? this->FilterWidth : 1);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  return program;
}

//------------------------------------------------------------------------------
void vtkTwoKernelSoftShadowPass::EndStep(const vtkSoftShadowContext& context)
{
  context.Pyramid->GetTexture()->Deactivate();
  context.Maps->GetTexture()->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTwoKernelSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = 0;
  for (vtkShadowTextureArray* texture : this->GetTextures())
  {
    bytes += texture->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
int vtkTwoKernelSoftShadowPass::GetTechniqueShaderBuilds()
{
  int builds = 0;
  for (vtkSeparableStep* step : this->GetSteps())
  {
    builds += step->GetShader().GetNumberOfBuilds();
  }
  return builds;
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
