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
#include "vtkShadowScopedTarget.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"
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
vtkMarchedSoftShadowPass::~vtkMarchedSoftShadowPass() = default;

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkMarchedSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.Pyramid = true;
  requirements.Proof = vtkSoftShadowRequirements::PROVES_LIT;
  requirements.GaussianWeights = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  return requirements;
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  const int pattern = services.Emitter.HasExtent() ? this->Pattern : 1;
  if (pattern == 1)
  {
    this->DrawRays(services, pattern, services.Emitter.Weight);
    return;
  }
  {
    vtkOpenGLState* state = services.Window->GetState();
    const vtkShadowScopedTarget target(state);
    state->vtkglDisable(GL_BLEND);
    if (this->BeginUnfiltered(services))
    {
      this->DrawRays(services, pattern, 1.0);
    }
    else
    {
      return;
    }
  }
  services.BeginStep("pattern filter");
  this->DrawFilter(services, pattern);
  services.BeginStep("visibility");
}

//------------------------------------------------------------------------------
bool vtkMarchedSoftShadowPass::BeginUnfiltered(const vtkSoftShadowServices& services)
{
  const int width = services.Receivers->GetWidth();
  const int height = services.Receivers->GetHeight();
  vtkShadowTextureArray* texture = this->Impl->Unfiltered;
  if (!texture->Allocate(services.Window, vtkShadowTextureArray::RG32F, width, height, 1))
  {
    return false;
  }
  this->Impl->Framebuffer.Bind(services.Window);
  vtkShadowFramebuffer::AttachDepthBuffer(services.Marks);
  texture->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(services.Window, 1);
  if (!vtkShadowFramebuffer::IsComplete())
  {
    return false;
  }
  services.Window->GetState()->vtkglViewport(0, 0, width, height);
  const float none[4] = { -1.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, none);
  return true;
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::DrawRays(
  const vtkSoftShadowServices& services, int pattern, double weight)
{
  vtkShadowShader& shader = this->Impl->Shader;
  if (!shader.Use(services.Window))
  {
    return;
  }
  vtkShaderProgram* program = shader.GetProgram();
  // First: VTK takes a texture unit of its own to make their texture.
  vtkMarchedRays& rays = this->Impl->Rays;
  program->SetUniformi(
    "rays", rays.Activate(services.Window, services.Emitter, this->Rays, pattern, this->Weights));
  services.SetReceiverUniforms(program);
  services.SetMapUniforms(program);
  program->SetUniformi("rayCount", rays.GetCount());
  program->SetUniformi("firstRays", rays.GetFirstCount());
  program->SetUniformi("pattern", pattern);
  program->SetUniformi("stepCount", this->Steps);
  program->SetUniformf("thickness", static_cast<float>(this->Thickness));
  program->SetUniformf("mapLayer", static_cast<float>(services.Layer));
  program->SetUniformf("weight", static_cast<float>(weight));
  vtkShadowTextureArray* maps = services.Maps->GetTexture();
  vtkShadowTextureArray* pyramid = services.Pyramid->GetTexture();
  program->SetUniformi("depthMaps", maps->Activate());
  program->SetUniformi("depthPyramid", pyramid->Activate());
  // A ray takes two taps where a step finds something.
  services.DrawMarked(shader, 2.0 * rays.GetCount() * this->Steps);
  pyramid->Deactivate();
  maps->Deactivate();
  rays.Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::DrawFilter(const vtkSoftShadowServices& services, int pattern)
{
  vtkShadowShader& shader = this->Impl->FilterShader;
  if (!shader.Use(services.Window))
  {
    return;
  }
  vtkShaderProgram* program = shader.GetProgram();
  services.SetReceiverUniforms(program);
  program->SetUniformi("pattern", pattern);
  program->SetUniformf("tolerance", TolerancePerRay / static_cast<float>(this->Rays));
  program->SetUniformf("weight", static_cast<float>(services.Emitter.Weight));
  vtkShadowTextureArray* source = this->Impl->Unfiltered;
  program->SetUniformi("source", source->Activate());
  shader.Draw(4.0 * pattern * pattern);
  source->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkMarchedSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  const Internals& impl = *this->Impl;
  statistics.BytesHeld += impl.Unfiltered->GetBytes() + impl.Rays.GetBytes();
  statistics.ShaderBuilds +=
    impl.Shader.GetNumberOfBuilds() + impl.FilterShader.GetNumberOfBuilds();
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
  os << indent
     << "Weights: " << (this->Weights == vtkShadowLightSampling::GAUSSIAN ? "gaussian" : "mean")
     << "\n";
}
VTK_ABI_NAMESPACE_END
