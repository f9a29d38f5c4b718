// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedRefinement.h"

#include "vtkCascadedSoftShadowPassInternals.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
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
} // namespace

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::Refinement::Plan::GetLastLevel() const
{
  return this->LastLevel < 0 ? this->LargestLevel : std::min(this->LastLevel, this->LargestLevel);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Refinement::Plan::Collect(
  vtkShadowQueryReader& reader, vtkTypeInt64 fewPixels)
{
  if (this->Pending == 0)
  {
    return;
  }
  for (int i = 0; i < this->Pending; ++i)
  {
    if (!reader.IsAvailable(this->Queries[i]))
    {
      return;
    }
  }
  this->Counts.fill(0);
  this->LastLevel = 0;
  for (int i = 0; i < this->Pending; ++i)
  {
    this->Counts[i] = reader.GetResult(this->Queries[i]);
    this->LastLevel = i > 0 && this->Counts[i] > fewPixels ? i : this->LastLevel;
  }
  this->Counted = this->Pending - 1;
  this->Pending = 0;
  this->WantsMore = this->GetLastLevel() >= this->Counted;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::Refinement::Plan::GetNumberOfPixelSamples() const
{
  vtkTypeInt64 samples = 0;
  vtkTypeInt64 before = 0;
  for (int level = 0; level < this->Counted; ++level)
  {
    const vtkTypeInt64 edge = this->IsHard ? 1 : (1 << level) + 1;
    samples += this->Counts[level] * (edge * edge - before);
    before = edge * edge;
  }
  return samples;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Refinement::Plan::ReleaseGraphicsResources()
{
  if (this->Queries[0])
  {
    glDeleteQueries(MaximumCounts, this->Queries.data());
    this->Queries.fill(0);
  }
  this->Pending = 0;
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowPass::Refinement::Refinement()
  : RefineShader(vtkCascadedRefineFS)
  , SettleShader(vtkCascadedSettleFS)
  , EmitShader(vtkCascadedEmitFS)
{
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::Refinement::Prepare(const vtkSoftShadowContext& context)
{
  const int width = context.Receivers->GetWidth();
  const int height = context.Receivers->GetHeight();
  return this->Added->Allocate(context.Window, vtkShadowTextureArray::RG32F, width, height, 1) &&
    this->States[0]->Allocate(context.Window, vtkShadowTextureArray::RG32F, width, height, 1) &&
    this->States[1]->Allocate(context.Window, vtkShadowTextureArray::RG32F, width, height, 1);
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::Refinement::Attach(
  const vtkSoftShadowContext& context, vtkShadowTextureArray* texture)
{
  this->Framebuffer.Bind(context.Window);
  vtkShadowFramebuffer::AttachDepthBuffer(context.Marks);
  texture->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(context.Window, 1);
  return vtkShadowFramebuffer::IsComplete();
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Refinement::Draw(vtkCascadedSoftShadowPass* self,
  const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps,
  const std::vector<size_t>& sets, const vtkShadowCascades::Cascade& cascade, Plan& plan)
{
  vtkOpenGLState* state = context.Window->GetState();
  state->PushFramebufferBindings();
  const bool count = plan.Pending == 0;
  plan.WantsMore = false;
  if (count && !plan.Queries[0])
  {
    glGenQueries(Plan::MaximumCounts, plan.Queries.data());
  }
  bool drawn = this->Prepare(context);
  const int levels = static_cast<int>(sets.size());
  for (int level = 0; level < levels && drawn; ++level)
  {
    const double keep = vtkShadowBorderGrid::Make(context.Emitter, level, self->GetWeights()).Keep;
    drawn = this->AddLevel(
              self, context, maps, sets[level], level, cascade, count ? plan.Queries[level] : 0) &&
      this->Settle(context, level, keep, self->GetTolerance());
  }
  if (drawn && count && this->CountLeft(self, context, levels, cascade, plan.Queries[levels]))
  {
    plan.Pending = levels + 1;
  }
  state->PopFramebufferBindings();
  if (!drawn || !this->EmitShader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = this->EmitShader.GetProgram();
  vtkShadowTextureArray* last = this->States[(levels - 1) % 2];
  Internals::SetFade(program, cascade);
  self->SetReceiverUniforms(program, context);
  program->SetUniformi("state", last->Activate(context.Window));
  self->DrawFiltered(this->EmitShader);
  last->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::Refinement::AddLevel(vtkCascadedSoftShadowPass* self,
  const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps, size_t set, int level,
  const vtkShadowCascades::Cascade& cascade, unsigned int query)
{
  if (!this->Attach(context, this->Added))
  {
    return false;
  }
  vtkOpenGLState* state = context.Window->GetState();
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
    vtkCascadedSoftShadowMaps::Run run;
    if (count > 0)
    {
      run = Internals::Bake(self, context, maps, set, first);
      if (run.Last == run.First)
      {
        return false;
      }
    }
    if (!this->RefineShader.Use(context.Window))
    {
      return false;
    }
    vtkShaderProgram* program = this->RefineShader.GetProgram();
    Internals::SetFade(program, cascade);
    program->SetUniformi("level", level);
    program->SetUniformf("litWeight", first == 0 ? points.Samples.LitWeight : 0.0f);
    self->SetReceiverUniforms(program, context);
    vtkSoftShadowPass::SetSampleUniforms(program, context, points.Samples.Views.data() + run.First,
      points.Samples.Weights.data() + run.First, run.Last - run.First, run.Layer,
      maps.GetMapSize(points.Resolution), points.FilterSize);
    vtkShadowTextureArray* texture = maps.GetMaps(points.Resolution)->GetTexture();
    program->SetUniformi("depthMaps", texture->Activate(context.Window));
    program->SetUniformi("state", before->Activate(context.Window));
    if (query && first == 0)
    {
      glBeginQuery(GL_SAMPLES_PASSED, query);
    }
    this->RefineShader.Draw();
    if (query && first == 0)
    {
      glEndQuery(GL_SAMPLES_PASSED);
    }
    before->Deactivate();
    texture->Deactivate();
    context.Receivers->Deactivate();
    first = std::max<size_t>(run.Last, 1);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::Refinement::Settle(
  const vtkSoftShadowContext& context, int level, double keep, double tolerance)
{
  if (!this->SettleShader.Use(context.Window) || !this->Attach(context, this->States[level % 2]))
  {
    return false;
  }
  vtkOpenGLState* state = context.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->vtkglDisable(GL_BLEND);
  vtkShadowTextureArray* before = this->States[(level + 1) % 2];
  vtkShaderProgram* program = this->SettleShader.GetProgram();
  program->SetUniformi("level", level);
  program->SetUniformf("keep", static_cast<float>(keep));
  program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
  program->SetUniformf("tolerance", static_cast<float>(tolerance));
  program->SetUniformi("reach", NeighbourDistance);
  program->SetUniformi("firstLevel", FirstLevel);
  program->SetUniformi("changeLevel", ChangeLevel);
  program->SetUniformi("state", before->Activate(context.Window));
  program->SetUniformi("added", this->Added->Activate(context.Window));
  this->SettleShader.Draw();
  this->Added->Deactivate();
  before->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
// Draws nothing but counts what has not settled: the refinement's shader with no points. Nothing
// reads what is added any more.
bool vtkCascadedSoftShadowPass::Refinement::CountLeft(vtkCascadedSoftShadowPass* self,
  const vtkSoftShadowContext& context, int levels, const vtkShadowCascades::Cascade& cascade,
  unsigned int query)
{
  if (!this->RefineShader.Use(context.Window) || !this->Attach(context, this->Added))
  {
    return false;
  }
  vtkShaderProgram* program = this->RefineShader.GetProgram();
  Internals::SetFade(program, cascade);
  program->SetUniformi("level", levels);
  program->SetUniformf("litWeight", 0.0f);
  program->SetUniformi("sampleCount", 0);
  self->SetReceiverUniforms(program, context);
  vtkShadowTextureArray* last = this->States[(levels - 1) % 2];
  const int unit = last->Activate(context.Window);
  program->SetUniformi("state", unit);
  program->SetUniformi("depthMaps", unit); // not read
  glBeginQuery(GL_SAMPLES_PASSED, query);
  this->RefineShader.Draw();
  glEndQuery(GL_SAMPLES_PASSED);
  last->Deactivate();
  context.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::Refinement::GetBytes() const
{
  return this->Added->GetBytes() + this->States[0]->GetBytes() + this->States[1]->GetBytes();
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::Refinement::GetNumberOfBuilds() const
{
  return this->RefineShader.GetNumberOfBuilds() + this->SettleShader.GetNumberOfBuilds() +
    this->EmitShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Refinement::ReleaseGraphicsResources(vtkWindow* window)
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
