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
#include "vtkSoftShadowServices.h"

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

  vtkNew<vtkShadowTextureArray> HardShadows; // R32F: 0 or 1, 1 where there is no receiver
  vtkNew<vtkShadowTextureArray> Penumbrae;   // RG32F: half extents on the screen, < 0: no blocker
  vtkNew<vtkShadowTextureArray> Blurred;     // R32F: blurred along x, < 0: proved
};

//------------------------------------------------------------------------------
vtkScreenSpaceSoftShadowPass::vtkScreenSpaceSoftShadowPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkScreenSpaceSoftShadowPass::~vtkScreenSpaceSoftShadowPass() = default;

//------------------------------------------------------------------------------
std::vector<vtkSeparableStep*> vtkScreenSpaceSoftShadowPass::GetSteps()
{
  return { &this->Impl->Hard, &this->Impl->Penumbra, &this->Impl->Blur };
}

//------------------------------------------------------------------------------
std::vector<vtkShadowTextureArray*> vtkScreenSpaceSoftShadowPass::GetTextures()
{
  return { this->Impl->HardShadows, this->Impl->Penumbrae, this->Impl->Blurred };
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  if (!vtkScreenSpaceSoftShadowPass::Allocate(
        services, vtkShadowTextureArray::R32F, { impl.HardShadows, impl.Blurred }) ||
    !vtkScreenSpaceSoftShadowPass::Allocate(
      services, vtkShadowTextureArray::RG32F, { impl.Penumbrae }))
  {
    return;
  }
  services.BeginStep("hard shadow");
  this->DrawHardShadow(services);
  services.BeginStep("search");
  this->DrawPenumbrae(services);
  services.BeginStep("blur");
  this->DrawBlur(services, false);
  this->DrawBlur(services, true);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::DrawHardShadow(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  if (this->UseStep(impl.Hard, services))
  {
    // Also where pixels were proved.
    this->GetTarget().Draw(services.Window, impl.Hard.GetShader(), { { impl.HardShadows, 1.0f } },
      services.Marks, 0.0, [](bool) {});
    vtkScreenSpaceSoftShadowPass::EndStep(services);
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::DrawPenumbrae(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  if (vtkShaderProgram* program = this->UseStep(impl.Penumbra, services))
  {
    program->SetUniformi("footprint", 1);
    const float s[2] = { 1.0f, 0.0f };
    const float t[2] = { 0.0f, 1.0f };
    program->SetUniform2f("rowAxis", s);
    program->SetUniform2f("columnAxis", t);
    float mapToScreen[16];
    vtkSeparableStep::MapToScreen(services, services.GetMapView(), mapToScreen);
    program->SetUniformMatrix4x4("mapToScreen", mapToScreen);
    const int taps = this->GetSearchTaps(services);
    this->GetTarget().Draw(services.Window, impl.Penumbra.GetShader(),
      { { impl.Penumbrae, -1.0f } }, services.Marks, taps * taps);
    vtkScreenSpaceSoftShadowPass::EndStep(services);
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::DrawBlur(const vtkSoftShadowServices& services, bool last)
{
  Internals& impl = *this->Impl;
  vtkShadowShader& shader = impl.Blur.GetShader();
  vtkShaderProgram* program = this->UseStep(impl.Blur, services);
  if (!program)
  {
    return;
  }
  program->SetUniformi("penumbrae", impl.Penumbrae->Activate());
  const int hardUnit = impl.HardShadows->Activate();
  program->SetUniformi("hardShadows", hardUnit);
  program->SetUniformi("blurred", last ? impl.Blurred->Activate() : hardUnit);
  program->SetUniformi("hasBlurred", last ? 1 : 0);
  const float axis[2] = { last ? 0.0f : 1.0f, last ? 1.0f : 0.0f };
  program->SetUniform2f("blurAxis", axis);
  const float texel[2] = { 1.0f / static_cast<float>(services.Receivers->GetWidth()),
    1.0f / static_cast<float>(services.Receivers->GetHeight()) };
  program->SetUniform2f("texel", texel);
  program->SetUniformf("beta", static_cast<float>(this->Beta));
  program->SetUniformf("weight", last ? static_cast<float>(services.Emitter.Weight) : 1.0f);
  if (last)
  {
    services.DrawMarked(shader);
    impl.Blurred->Deactivate();
  }
  else
  {
    this->GetTarget().Draw(services.Window, shader, { { impl.Blurred, -1.0f } }, services.Marks);
  }
  impl.HardShadows->Deactivate();
  impl.Penumbrae->Deactivate();
  vtkScreenSpaceSoftShadowPass::EndStep(services);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Beta: " << this->Beta << "\n";
}
VTK_ABI_NAMESPACE_END
