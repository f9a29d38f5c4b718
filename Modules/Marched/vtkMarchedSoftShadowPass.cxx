// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarchedSoftShadowPass.h"

#include "vtkMarchedRays.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowFramebuffer.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkMarchedFilterFS.h"
#include "vtkMarchedSoftShadowFS.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkMarchedSoftShadowPass);

namespace
{
// A mean of n well-spread rays is off by a few times 1 / n.
constexpr float TolerancePerRay = 4.0f;
} // namespace

class vtkMarchedSoftShadowPass::Internals
{
public:
  Internals()
    : Shader(vtkMarchedSoftShadowFS)
    , FilterShader(vtkMarchedFilterFS)
  {
  }

  vtkShadowShader Shader;
  vtkShadowShader FilterShader;
  vtkMarchedRays Rays;
  vtkNew<vtkShadowTextureArray> Unfiltered; // RG32F: see the filter
  vtkShadowFramebuffer Framebuffer;
};

//------------------------------------------------------------------------------
vtkMarchedSoftShadowPass::vtkMarchedSoftShadowPass()
  : Impl(new Internals)
{
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
  const int pattern = context.Emitter.HasExtent() ? this->Pattern : 1;
  if (pattern == 1)
  {
    this->DrawRays(context, pattern, context.Emitter.Weight);
    return;
  }
  {
    vtkOpenGLState* state = context.Window->GetState();
    const vtkOpenGLState::ScopedglViewport viewport(state);
    const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    const vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->PushFramebufferBindings();
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_BLEND);
    const bool begun = this->BeginUnfiltered(context);
    if (begun)
    {
      this->DrawRays(context, pattern, 1.0);
    }
    state->PopFramebufferBindings();
    if (!begun)
    {
      return;
    }
  }
  this->BeginStep("pattern filter");
  this->DrawFilter(context, pattern);
  this->BeginStep("visibility");
}

//------------------------------------------------------------------------------
bool vtkMarchedSoftShadowPass::BeginUnfiltered(const vtkSoftShadowContext& context)
{
  const int width = context.Receivers->GetWidth();
  const int height = context.Receivers->GetHeight();
  vtkShadowTextureArray* texture = this->Impl->Unfiltered;
  if (!texture->Allocate(context.Window, vtkShadowTextureArray::RG32F, width, height, 1))
  {
    return false;
  }
  this->Impl->Framebuffer.Bind(context.Window);
  vtkShadowFramebuffer::AttachDepthBuffer(context.Marks);
  texture->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(context.Window, 1);
  if (!vtkShadowFramebuffer::IsComplete())
  {
    return false;
  }
  context.Window->GetState()->vtkglViewport(0, 0, width, height);
  const float none[4] = { -1.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, none);
  return true;
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::DrawRays(
  const vtkSoftShadowContext& context, int pattern, double weight)
{
  vtkShadowShader& shader = this->Impl->Shader;
  if (!shader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = shader.GetProgram();
  // First: VTK takes a texture unit of its own to make their texture.
  vtkMarchedRays& rays = this->Impl->Rays;
  program->SetUniformi(
    "rays", rays.Activate(context.Window, context.Emitter, this->Rays, pattern, this->Weights));
  this->SetReceiverUniforms(program, context);
  this->SetMapUniforms(
    program, context, context.Maps->GetViews()[context.Layer], context.Maps->GetResolution());
  program->SetUniformi("rayCount", rays.GetCount());
  program->SetUniformi("firstRays", rays.GetFirstCount());
  program->SetUniformi("pattern", pattern);
  program->SetUniformi("stepCount", this->Steps);
  program->SetUniformf("thickness", static_cast<float>(this->Thickness));
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  program->SetUniformf("weight", static_cast<float>(weight));
  vtkShadowTextureArray* maps = context.Maps->GetTexture();
  vtkShadowTextureArray* pyramid = context.Pyramid->GetTexture();
  program->SetUniformi("depthMaps", maps->Activate());
  program->SetUniformi("depthPyramid", pyramid->Activate());
  this->DrawFiltered(shader);
  pyramid->Deactivate();
  maps->Deactivate();
  rays.Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::DrawFilter(const vtkSoftShadowContext& context, int pattern)
{
  vtkShadowShader& shader = this->Impl->FilterShader;
  if (!shader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = shader.GetProgram();
  this->SetReceiverUniforms(program, context);
  program->SetUniformi("pattern", pattern);
  program->SetUniformf("tolerance", TolerancePerRay / static_cast<float>(this->Rays));
  program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
  vtkShadowTextureArray* source = this->Impl->Unfiltered;
  program->SetUniformi("source", source->Activate());
  shader.Draw();
  source->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMarchedSoftShadowPass::GetTechniqueBytes()
{
  return this->Impl->Unfiltered->GetBytes() + this->Impl->Rays.GetBytes();
}

//------------------------------------------------------------------------------
int vtkMarchedSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->Shader.GetNumberOfBuilds() + this->Impl->FilterShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  impl.Shader.ReleaseGraphicsResources(window);
  impl.FilterShader.ReleaseGraphicsResources(window);
  impl.Rays.ReleaseGraphicsResources(window);
  impl.Unfiltered->ReleaseGraphicsResources(window);
  impl.Framebuffer.Release();
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rays: " << this->Rays << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
}
VTK_ABI_NAMESPACE_END
