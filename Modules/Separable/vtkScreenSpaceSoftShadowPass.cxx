// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScreenSpaceSoftShadowPass.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSeparableStep.h"
#include "vtkSeparableTarget.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"

#include "vtkScreenSpaceBlurFS.h"
#include "vtkScreenSpaceHardFS.h"
#include "vtkScreenSpacePenumbraFS.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkScreenSpaceSoftShadowPass);

class vtkScreenSpaceSoftShadowPass::Internals
{
public:
  vtkSeparableStep Hard{ vtkScreenSpaceHardFS };
  vtkSeparableStep Penumbra{ vtkScreenSpacePenumbraFS };
  vtkSeparableStep Blur{ vtkScreenSpaceBlurFS };
  vtkSeparableTarget Target;

  vtkNew<vtkShadowTextureArray> HardShadows; // R32F: 0 or 1, 1 where there is no receiver
  vtkNew<vtkShadowTextureArray> Penumbrae;   // RG32F: half extents on the screen, < 0: no blocker
  vtkNew<vtkShadowTextureArray> Blurred;     // R32F: blurred along x, < 0: proved

  std::vector<vtkShadowTextureArray*> GetTextures()
  {
    return { this->HardShadows, this->Penumbrae, this->Blurred };
  }
};

//------------------------------------------------------------------------------
vtkScreenSpaceSoftShadowPass::vtkScreenSpaceSoftShadowPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkScreenSpaceSoftShadowPass::~vtkScreenSpaceSoftShadowPass() = default;

//------------------------------------------------------------------------------
bool vtkScreenSpaceSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  const int width = context.Receivers->GetWidth();
  const int height = context.Receivers->GetHeight();
  for (vtkShadowTextureArray* texture : impl.GetTextures())
  {
    const int format =
      texture == impl.Penumbrae.Get() ? vtkShadowTextureArray::RG32F : vtkShadowTextureArray::R32F;
    if (!texture->Allocate(context.Window, format, width, height, 1))
    {
      return;
    }
  }
  this->BeginStep("hard shadow");
  this->DrawHardShadow(context);
  this->BeginStep("search");
  this->DrawPenumbrae(context);
  this->BeginStep("blur");
  this->DrawBlur(context, false);
  this->DrawBlur(context, true);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::DrawHardShadow(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!impl.Hard.GetShader().Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = impl.Hard.GetShader().GetProgram();
  this->SetReceiverUniforms(program, context);
  this->SetMapUniforms(
    program, context, context.Maps->GetViews()[context.Layer], context.Maps->GetResolution());
  program->SetUniformi("depthMaps", context.Maps->GetTexture()->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  impl.Target.Draw(context.Window, impl.Hard.GetShader(), { { impl.HardShadows, 1.0f } }, 0);
  context.Maps->GetTexture()->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::DrawPenumbrae(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!impl.Penumbra.GetShader().Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = impl.Penumbra.GetShader().GetProgram();
  const vtkShadowMapView& view = context.Maps->GetViews()[context.Layer];
  this->SetReceiverUniforms(program, context);
  this->SetMapUniforms(program, context, view, context.Maps->GetResolution());
  program->SetUniformi("depthMaps", context.Maps->GetTexture()->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  program->SetUniformi("searchWidth", context.Emitter.HasExtent() ? this->SearchWidth : 1);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  program->SetUniformi("footprint", 1);
  const float s[2] = { 1.0f, 0.0f };
  const float t[2] = { 0.0f, 1.0f };
  program->SetUniform2f("rowAxis", s);
  program->SetUniform2f("columnAxis", t);
  float mapToScreen[16];
  vtkSeparableStep::MapToScreen(context, view, mapToScreen);
  program->SetUniformMatrix4x4("mapToScreen", mapToScreen);
  impl.Target.Draw(
    context.Window, impl.Penumbra.GetShader(), { { impl.Penumbrae, -1.0f } }, context.Marks);
  context.Maps->GetTexture()->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::DrawBlur(const vtkSoftShadowContext& context, bool last)
{
  Internals& impl = *this->Impl;
  vtkShadowShader& shader = impl.Blur.GetShader();
  if (!shader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = shader.GetProgram();
  this->SetReceiverUniforms(program, context);
  program->SetUniformi("penumbrae", impl.Penumbrae->Activate());
  const int hardUnit = impl.HardShadows->Activate();
  program->SetUniformi("hardShadows", hardUnit);
  program->SetUniformi("blurred", last ? impl.Blurred->Activate() : hardUnit);
  program->SetUniformi("hasBlurred", last ? 1 : 0);
  const float axis[2] = { last ? 0.0f : 1.0f, last ? 1.0f : 0.0f };
  program->SetUniform2f("blurAxis", axis);
  const float texel[2] = { 1.0f / static_cast<float>(context.Receivers->GetWidth()),
    1.0f / static_cast<float>(context.Receivers->GetHeight()) };
  program->SetUniform2f("texel", texel);
  program->SetUniformi("filterWidth", context.Emitter.HasExtent() ? this->FilterWidth : 1);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  program->SetUniformf("beta", static_cast<float>(this->Beta));
  program->SetUniformf("weight", last ? static_cast<float>(context.Emitter.Weight) : 1.0f);
  if (last)
  {
    this->DrawFiltered(shader);
    impl.Blurred->Deactivate();
  }
  else
  {
    impl.Target.Draw(context.Window, shader, { { impl.Blurred, -1.0f } }, context.Marks);
  }
  impl.HardShadows->Deactivate();
  impl.Penumbrae->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkScreenSpaceSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = 0;
  for (vtkShadowTextureArray* texture : this->Impl->GetTextures())
  {
    bytes += texture->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
int vtkScreenSpaceSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->Hard.GetShader().GetNumberOfBuilds() +
    this->Impl->Penumbra.GetShader().GetNumberOfBuilds() +
    this->Impl->Blur.GetShader().GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  for (vtkSeparableStep* step : { &impl.Hard, &impl.Penumbra, &impl.Blur })
  {
    step->GetShader().ReleaseGraphicsResources(window);
  }
  for (vtkShadowTextureArray* texture : impl.GetTextures())
  {
    texture->ReleaseGraphicsResources(window);
  }
  impl.Target.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchWidth: " << this->SearchWidth << "\n";
  os << indent << "FilterWidth: " << this->FilterWidth << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "Beta: " << this->Beta << "\n";
}
VTK_ABI_NAMESPACE_END
