// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedSoftShadowPass.h"

#include "vtkCascadedSoftShadowPassInternals.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkCascadedSoftShadowPass);

//------------------------------------------------------------------------------
vtkCascadedSoftShadowPass::vtkCascadedSoftShadowPass()
  : Impl(new Internals)
{
  this->MapSize = 1024;
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowPass::~vtkCascadedSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  impl.Receivers = context.Receivers;
  vtkShadowShader::Definitions definitions;
  if (!this->Gather)
  {
    definitions.emplace_back("SOFT_SHADOW_NO_GATHER", "1");
  }
  impl.Shader.SetDefinitions(definitions);
  impl.SumsShader.SetDefinitions(definitions);
  impl.Refiner.SetDefinitions(definitions);
  Internals::EmitterMaps& emitter = impl.Emitters[std::make_pair(context.Light, context.Part)];
  if (emitter.Emitter != context.Emitter || emitter.SettingsTime != this->GetMTime() ||
    emitter.BodiesTime != context.Casters->GetBodiesTime())
  {
    emitter.Emitter = context.Emitter;
    emitter.SettingsTime = this->GetMTime();
    emitter.BodiesTime = context.Casters->GetBodiesTime();
    emitter.Fits.clear();
  }
  emitter.Maps.Begin(this->MapSize);
  impl.FindCascades(this, context, emitter);
  emitter.Cascades = impl.Cascades;
  emitter.Frame = impl.Frame = this->ChangeStatistics().VisibilityFrames;
  std::vector<std::vector<size_t>> sets; // per cascade
  for (size_t i = 0; i < impl.Cascades.size(); ++i)
  {
    sets.push_back(this->AddSets(context, i));
  }
  if (!this->Adaptive && this->Filter == SCREEN)
  {
    impl.DrawScreen(this, context, emitter.Maps);
  }
  else
  {
    for (size_t i = 0; i < impl.Cascades.size(); ++i)
    {
      if (this->Adaptive)
      {
        impl.Refiner.Draw(this, context, emitter.Maps, sets[i], impl.Cascades[i], emitter.Plans[i]);
      }
      else
      {
        impl.DrawCascade(this, context, emitter.Maps, i);
      }
    }
  }
  // Of a light's many parts only the first ones keep their maps.
  vtkTypeInt64 bytes = 0;
  for (auto& other : impl.Emitters)
  {
    bytes += other.first.first == context.Light ? other.second.Maps.GetBytes() : 0;
  }
  if (this->ExceedsMapMemory(bytes))
  {
    emitter.Maps.ReleaseGraphicsResources(context.Window);
  }
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Render(const vtkRenderState* s)
{
  this->Superclass::Render(s);
  if (this->Adaptive)
  {
    this->ChangeStatistics().TechniqueCounts = { { "pixel_samples",
      this->GetNumberOfPixelSamples() } };
  }
  if (this->Tint && this->Impl->Receivers && !s->GetRenderer()->GetSelector())
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
    this->Impl->Tint.Draw(window, this->Impl->Receivers, this->Impl->GetCascades(this->TintLight));
  }
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkShadowCascades::Cascade>>
vtkCascadedSoftShadowPass::Internals::GetCascades(int light) const
{
  std::vector<std::vector<vtkShadowCascades::Cascade>> cascades;
  for (const auto& emitter : this->Emitters)
  {
    if (emitter.second.Frame == this->Frame && (light < 0 || emitter.first.first == light))
    {
      cascades.push_back(emitter.second.Cascades);
    }
  }
  return cascades;
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetNumberOfOccupiedCascades() const
{
  size_t largest = 0;
  for (const auto& cascades : this->Impl->GetCascades(-1))
  {
    largest = std::max(largest, cascades.size());
  }
  return static_cast<int>(largest);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    bytes += emitter.second.Maps.GetBytes();
  }
  return bytes + this->Impl->Refiner.GetBytes() + this->Impl->ScreenFilter.GetBytes();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetTechniqueDrawCalls()
{
  vtkTypeInt64 calls = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    calls += emitter.second.Maps.GetNumberOfDrawCalls();
  }
  return calls;
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->Shader.GetNumberOfBuilds() + this->Impl->SumsShader.GetNumberOfBuilds() +
    this->Impl->ScreenFilter.GetNumberOfShaderBuilds() + this->Impl->Tint.GetNumberOfBuilds() +
    this->Impl->Refiner.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Impl->Shader.ReleaseGraphicsResources(window);
  this->Impl->SumsShader.ReleaseGraphicsResources(window);
  this->Impl->ScreenFilter.ReleaseGraphicsResources(window);
  this->Impl->Tint.ReleaseGraphicsResources(window);
  for (auto& emitter : this->Impl->Emitters)
  {
    emitter.second.Maps.ReleaseGraphicsResources(window);
    for (Refinement::Plan& plan : emitter.second.Plans)
    {
      plan.ReleaseGraphicsResources();
    }
  }
  this->Impl->Refiner.ReleaseGraphicsResources(window);
  this->Impl->Emitters.clear();
  this->Impl->Receivers = nullptr;
}
VTK_ABI_NAMESPACE_END
