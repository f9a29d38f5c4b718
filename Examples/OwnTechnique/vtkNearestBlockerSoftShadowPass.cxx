// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNearestBlockerSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"

#include "vtkNearestBlockerSoftShadowFS.h"

vtkStandardNewMacro(vtkNearestBlockerSoftShadowPass);

//------------------------------------------------------------------------------
vtkNearestBlockerSoftShadowPass::vtkNearestBlockerSoftShadowPass()
  : Shader(vtkNearestBlockerSoftShadowFS)
{
}

//------------------------------------------------------------------------------
vtkNearestBlockerSoftShadowPass::~vtkNearestBlockerSoftShadowPass() = default;

//------------------------------------------------------------------------------
void vtkNearestBlockerSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  if (!this->Shader.Use(services.Window)) // builds the program when first used
  {
    return;
  }
  vtkShaderProgram* program = this->Shader.GetProgram();
  services.SetReceiverUniforms(program); // binds the receivers
  services.SetMapUniforms(program);
  vtkShadowTextureArray* texture = services.Maps->GetTexture();
  program->SetUniformi("depthMaps", texture->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(services.Layer));
  program->SetUniformf("weight", static_cast<float>(services.Emitter.Weight));
  program->SetUniformi("kernelGaussian", 0);
  const int taps = services.Emitter.HasExtent() ? this->FilterWidth : 1;
  program->SetUniformi("filterWidth", taps);
  services.DrawMarked(this->Shader, taps * taps); // only pixels not proved lit or blocked
  texture->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkNearestBlockerSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  statistics.ShaderBuilds += this->Shader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkNearestBlockerSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Shader.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkNearestBlockerSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FilterWidth: " << this->FilterWidth << "\n";
}
