// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedRefinement.h"

#include "vtkCascadedFade.h"
#include "vtkCascadedPlan.h"
#include "vtkCascadedSettings.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowReceivers.h"
#include "vtkSoftShadowServices.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkCascadedEmitFS.h"
#include "vtkCascadedRefineFS.h"
#include "vtkCascadedSettleFS.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// In pixels. A blocker between the points changes nothing where it stands; it does a little farther on.
constexpr int NeighbourDistance = 4;

// The first level on which a pixel can settle: the light's corners alone miss what stands in its middle.
constexpr int FirstLevel = 1;

// The first level whose change is trusted: between 4 and 9 points it says too little of the error.
constexpr int ChangeLevel = 2;
// Of the viewport: what so few pixels need is not worth another level's maps.
constexpr double FewPixels = 5e-4;
} // namespace

//------------------------------------------------------------------------------
vtkCascadedRefinement::vtkCascadedRefinement()
  : RefineShader(vtkCascadedRefineFS)
  , SettleShader(vtkCascadedSettleFS)
  , EmitShader(vtkCascadedEmitFS)
{
}

//------------------------------------------------------------------------------
bool vtkCascadedRefinement::Prepare(const vtkSoftShadowServices& services)
{
  const int width = services.Receivers->GetWidth();
  const int height = services.Receivers->GetHeight();
  return this->Added->Allocate(services.Window, vtkShadowTextureArray::RG32F, width, height, 1) &&
    this->States[0]->Allocate(services.Window, vtkShadowTextureArray::RG32F, width, height, 1) &&
    this->States[1]->Allocate(services.Window, vtkShadowTextureArray::RG32F, width, height, 1);
}

//------------------------------------------------------------------------------
bool vtkCascadedRefinement::Attach(
  const vtkSoftShadowServices& services, vtkShadowTextureArray* texture)
{
  this->Framebuffer.Bind(services.Window);
  vtkShadowFramebuffer::AttachDepthBuffer(services.Marks);
  texture->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(services.Window, 1);
  return vtkShadowFramebuffer::IsComplete();
}

//------------------------------------------------------------------------------
void vtkCascadedRefinement::Draw(const vtkSoftShadowServices& services,
  const vtkCascadedSettings& settings, vtkCascadedSoftShadowMaps& maps,
  const std::vector<size_t>& sets, const vtkShadowCascades::Cascade& cascade, vtkCascadedPlan& plan)
{
  vtkOpenGLState* state = services.Window->GetState();
  state->PushFramebufferBindings();
  vtkShadowQueries* queries = plan.Pending == 0 ? &plan.Queries : nullptr;
  plan.WantsMore = false;
  bool drawn = this->Prepare(services);
  const int levels = static_cast<int>(sets.size());
  for (int level = 0; level < levels && drawn; ++level)
  {
    const double keep = vtkShadowBorderGrid::Make(services.Emitter, level, settings.Weights).Keep;
    drawn = this->AddLevel(services, maps, sets[level], level, cascade, queries) &&
      this->Settle(services, level, keep, settings.Tolerance);
  }
  if (drawn && queries && this->CountLeft(services, levels, cascade, *queries))
  {
    plan.Pending = levels + 1;
  }
  state->PopFramebufferBindings();
  if (!drawn || !this->EmitShader.Use(services.Window))
  {
    return;
  }
  vtkShaderProgram* program = this->EmitShader.GetProgram();
  vtkShadowTextureArray* last = this->States[(levels - 1) % 2];
  vtkCascadedFade::SetUniforms(program, cascade);
  services.SetReceiverUniforms(program);
  program->SetUniformi("state", last->Activate(services.Window));
  services.DrawMarked(this->EmitShader);
  last->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
bool vtkCascadedRefinement::AddLevel(const vtkSoftShadowServices& services,
  vtkCascadedSoftShadowMaps& maps, size_t set, int level, const vtkShadowCascades::Cascade& cascade,
  vtkShadowQueries* queries)
{
  if (!this->Attach(services, this->Added))
  {
    return false;
  }
  vtkOpenGLState* state = services.Window->GetState();
  {
    vtkOpenGLState::ScopedglClearColor clearColor(state);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  const vtkCascadedSoftShadowMaps::Set& points = maps.GetSet(set);
  const size_t count = points.Samples.Views.size();
  vtkShadowTextureArray* before = this->States[(level + 1) % 2];
  for (size_t first = 0; first == 0 || first < count;)
  {
    const vtkCascadedSoftShadowMaps::Run run = maps.Bake(services, set, first);
    if (count > 0 && run.Last == run.First)
    {
      return false;
    }
    if (!this->RefineShader.Use(services.Window))
    {
      return false;
    }
    vtkShaderProgram* program = this->RefineShader.GetProgram();
    vtkCascadedFade::SetUniforms(program, cascade);
    program->SetUniformi("level", level);
    program->SetUniformf("litWeight", first == 0 ? points.Samples.LitWeight : 0.0f);
    services.SetReceiverUniforms(program);
    services.SetSampleUniforms(program, points.Samples.Views.data() + run.First,
      points.Samples.Weights.data() + run.First, run.Last - run.First, run.Layer,
      maps.GetMapSize(points.Resolution), points.FilterSize);
    vtkShadowTextureArray* texture = run.Texture;
    program->SetUniformi("depthMaps", texture->Activate(services.Window));
    program->SetUniformi("state", before->Activate(services.Window));
    if (queries && first == 0)
    {
      queries->Begin(services.Window, static_cast<size_t>(level));
    }
    this->RefineShader.Draw(
      vtkSoftShadowServices::CountSampleTaps(run.Last - run.First, points.FilterSize));
    if (queries && first == 0)
    {
      queries->End();
    }
    before->Deactivate();
    texture->Deactivate();
    services.Receivers->Deactivate();
    first = std::max<size_t>(run.Last, 1);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkCascadedRefinement::Settle(
  const vtkSoftShadowServices& services, int level, double keep, double tolerance)
{
  if (!this->SettleShader.Use(services.Window) || !this->Attach(services, this->States[level % 2]))
  {
    return false;
  }
  vtkOpenGLState* state = services.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->vtkglDisable(GL_BLEND);
  vtkShadowTextureArray* before = this->States[(level + 1) % 2];
  vtkShaderProgram* program = this->SettleShader.GetProgram();
  program->SetUniformi("level", level);
  program->SetUniformf("keep", static_cast<float>(keep));
  program->SetUniformf("weight", static_cast<float>(services.Emitter.Weight));
  program->SetUniformf("tolerance", static_cast<float>(tolerance));
  program->SetUniformi("reach", NeighbourDistance);
  program->SetUniformi("firstLevel", FirstLevel);
  program->SetUniformi("changeLevel", ChangeLevel);
  program->SetUniformi("state", before->Activate(services.Window));
  program->SetUniformi("added", this->Added->Activate(services.Window));
  this->SettleShader.Draw();
  this->Added->Deactivate();
  before->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
// Draws nothing but counts what has not settled: the refinement's shader with no points. Nothing
// reads what is added any more.
bool vtkCascadedRefinement::CountLeft(const vtkSoftShadowServices& services, int levels,
  const vtkShadowCascades::Cascade& cascade, vtkShadowQueries& queries)
{
  if (!this->RefineShader.Use(services.Window) || !this->Attach(services, this->Added))
  {
    return false;
  }
  vtkShaderProgram* program = this->RefineShader.GetProgram();
  vtkCascadedFade::SetUniforms(program, cascade);
  program->SetUniformi("level", levels);
  program->SetUniformf("litWeight", 0.0f);
  program->SetUniformi("sampleCount", 0);
  services.SetReceiverUniforms(program);
  vtkShadowTextureArray* last = this->States[(levels - 1) % 2];
  const int unit = last->Activate(services.Window);
  program->SetUniformi("state", unit);
  program->SetUniformi("depthMaps", unit); // not read
  queries.Begin(services.Window, static_cast<size_t>(levels));
  this->RefineShader.Draw();
  queries.End();
  last->Deactivate();
  services.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedRefinement::GetFewPixels(vtkShadowReceivers* receivers)
{
  return static_cast<vtkTypeInt64>(FewPixels * receivers->GetWidth() * receivers->GetHeight());
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedRefinement::GetBytes() const
{
  return this->Added->GetBytes() + this->States[0]->GetBytes() + this->States[1]->GetBytes();
}

//------------------------------------------------------------------------------
int vtkCascadedRefinement::GetNumberOfBuilds() const
{
  return this->RefineShader.GetNumberOfBuilds() + this->SettleShader.GetNumberOfBuilds() +
    this->EmitShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkCascadedRefinement::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Added->ReleaseGraphicsResources(window);
  this->States[0]->ReleaseGraphicsResources(window);
  this->States[1]->ReleaseGraphicsResources(window);
  this->RefineShader.ReleaseGraphicsResources(window);
  this->SettleShader.ReleaseGraphicsResources(window);
  this->EmitShader.ReleaseGraphicsResources(window);
  this->Framebuffer.Release();
}
VTK_ABI_NAMESPACE_END
