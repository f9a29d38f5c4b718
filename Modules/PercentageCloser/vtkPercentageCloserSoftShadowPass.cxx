// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPercentageCloserSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"

#include "vtkPercentageCloserSoftShadowFS.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPercentageCloserSoftShadowPass);

//------------------------------------------------------------------------------
vtkPercentageCloserSoftShadowPass::vtkPercentageCloserSoftShadowPass()
  : Shader(vtkPercentageCloserSoftShadowFS)
{
}

//------------------------------------------------------------------------------
vtkPercentageCloserSoftShadowPass::~vtkPercentageCloserSoftShadowPass() = default;

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkPercentageCloserSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.Pyramid = this->Footprint;
  requirements.GaussianWeights = this->HasGaussianWeights();
  return requirements;
}

//------------------------------------------------------------------------------
void vtkPercentageCloserSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  if (!this->Shader.Use(services.Window))
  {
    return;
  }
  vtkShaderProgram* program = this->Shader.GetProgram();
  services.SetReceiverUniforms(program);
  services.SetMapUniforms(program);
  vtkShadowTextureArray* texture = services.Maps->GetTexture();
  const int mapsUnit = texture->Activate();
  program->SetUniformi("depthMaps", mapsUnit);
  program->SetUniformf("mapLayer", static_cast<float>(services.Layer));
  program->SetUniformf("weight", static_cast<float>(services.Emitter.Weight));
  // All taps of a light without extent are the same one.
  const bool hasExtent = services.Emitter.HasExtent();
  const int searchWidth = hasExtent ? this->SearchWidth : 1;
  const int filterWidth = hasExtent ? this->FilterWidth : 1;
  program->SetUniformi("searchWidth", searchWidth);
  program->SetUniformi("filterWidth", filterWidth);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  // Not read without footprint: any texture of its kind will do.
  vtkShadowTextureArray* pyramid = this->Footprint ? services.Pyramid->GetTexture() : nullptr;
  program->SetUniformi("depthPyramid", pyramid ? pyramid->Activate() : mapsUnit);
  program->SetUniformi("footprint", this->Footprint ? 1 : 0);
  services.DrawMarked(this->Shader, searchWidth * searchWidth + filterWidth * filterWidth);
  if (pyramid)
  {
    pyramid->Deactivate();
  }
  texture->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkPercentageCloserSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  statistics.ShaderBuilds += this->Shader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkPercentageCloserSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Shader.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkPercentageCloserSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchWidth: " << this->SearchWidth << "\n";
  os << indent << "FilterWidth: " << this->FilterWidth << "\n";
  os << indent << "Footprint: " << (this->Footprint ? "on" : "off") << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
}
VTK_ABI_NAMESPACE_END
