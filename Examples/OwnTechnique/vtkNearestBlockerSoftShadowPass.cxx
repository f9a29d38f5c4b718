// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNearestBlockerSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"

#include "vtkNearestBlockerSoftShadowFS.h"

vtkStandardNewMacro(vtkNearestBlockerSoftShadowPass);

//------------------------------------------------------------------------------
vtkNearestBlockerSoftShadowPass::vtkNearestBlockerSoftShadowPass()
  : Shader(vtkNearestBlockerSoftShadowFS)
{
}

//------------------------------------------------------------------------------
vtkNearestBlockerSoftShadowPass::~vtkNearestBlockerSoftShadowPass()
{
  this->ReleaseBeforeDestruction(); // while this class's part can still be reached
}

//------------------------------------------------------------------------------
void vtkNearestBlockerSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  if (!this->Shader.Use(context.Window)) // builds the program when first used
  {
    return;
  }
  vtkShaderProgram* program = this->Shader.GetProgram();
  this->SetReceiverUniforms(program, context); // binds the receivers
  this->SetMapUniforms(
    program, context, context.Maps->GetViews()[context.Layer], context.Maps->GetResolution());
  vtkShadowTextureArray* texture = context.Maps->GetTexture();
  program->SetUniformi("depthMaps", texture->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
  program->SetUniformi("kernelGaussian", 0);
  program->SetUniformi("filterWidth", context.Emitter.HasExtent() ? this->FilterWidth : 1);
  this->DrawFiltered(this->Shader); // only pixels that are not proved lit or blocked
  texture->Deactivate();
  context.Receivers->Deactivate();
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
