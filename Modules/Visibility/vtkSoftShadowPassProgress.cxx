// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSoftShadowPass does while nothing changes: a running mean of hard shadows from points of the
// lights.
#include "vtkSoftShadowPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowPassInternals.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// The largest map that memory and the driver allow; finer ones cost more than they gain.
int FindLargestMap(int memory)
{
  const int largest = std::min(vtkShadowLimits::GetTextureSize(), 8192);
  vtkTypeInt64 size = 32;
  while (
    2 * size <= largest && 4 * (2 * size) * (2 * size) <= static_cast<vtkTypeInt64>(memory) << 20)
  {
    size *= 2;
  }
  return static_cast<int>(size);
}

} // namespace

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::GetConverged() const
{
  return this->Progressive && this->Impl->Schedule.IsConverged();
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::GetRefining() const
{
  return this->Progressive && !this->Impl->Schedule.IsEnded();
}

//------------------------------------------------------------------------------
double vtkSoftShadowPass::GetEstimatedError() const
{
  return this->Impl->Schedule.GetEstimatedError();
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowPass::GetProgressReport() const
{
  return this->Progressive ? this->Impl->Schedule.Describe() : "progressive mode is off";
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::Refine(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  vtkSoftShadowSchedule& schedule = impl.Schedule;
  if (!this->Progressive || schedule.IsEnded())
  {
    return;
  }
  if (impl.Statistics.LightsCasting == 0 || impl.Losses.HasAny())
  {
    schedule.Finish(impl.Statistics.LightsCasting == 0);
    impl.HasNews = schedule.IsConverged();
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  const vtkShadowFailures failures;
  window->GetState()->PushFramebufferBindings();
  if (schedule.IsStarted() || this->BeginProgress(window))
  {
    this->AddPoints(s, window);
    for (int layer = 0; layer < impl.Statistics.LightsCasting; ++layer)
    {
      impl.Accumulator->Show(window, impl.Target->GetTexture(), layer, schedule.GetShare(),
        impl.GetMeanScale(layer), schedule.IsHeldShown());
    }
  }
  ++impl.Statistics.ProgressiveFrames;
  ++impl.Refinements;
  window->GetState()->PopFramebufferBindings();
  if (failures.HasAny())
  {
    vtkWarningMacro("The picture is not refined any further: " << failures.GetFirst() << ".");
    schedule.Finish(false);
  }
  if (schedule.IsEnded())
  {
    this->ReleaseProgress(window); // the mean stands in the visibilities
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::ReleaseProgress(vtkOpenGLRenderWindow* window)
{
  this->Impl->Accumulator->ReleaseTextures(window);
  this->Impl->PointMaps->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::BeginProgress(vtkOpenGLRenderWindow* window)
{
  Internals& impl = *this->Impl;
  const int made = impl.Accumulator->Begin(window, impl.Target->GetTexture());
  if (made < 0)
  {
    impl.Schedule.Finish(false);
    return false;
  }
  impl.Statistics.Allocations += made;
  impl.PointWeights.assign(impl.Statistics.LightsCasting, 0.0);
  impl.Schedule.Start(this->MapSize, FindLargestMap(this->MapMemory), this->ProgressiveTolerance);
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::AddPoints(const vtkRenderState* s, vtkOpenGLRenderWindow* window)
{
  Internals& impl = *this->Impl;
  vtkSoftShadowSchedule& schedule = impl.Schedule;
  const vtkShadowMapFitter fitter(impl.Casters->GetBodies());
  vtkSoftShadowContext context;
  context.Renderer = s->GetRenderer();
  context.Window = window;
  context.Casters = impl.Casters;
  context.Fitter = &fitter;
  context.Receivers = impl.Receivers;
  for (int left = this->ProgressivePoints; left > 0 && !schedule.IsEnded();)
  {
    const int run = schedule.GetRun(left);
    left -= run;
    const vtkShadowFailures failures;
    if (!this->AddRun(context, run) || failures.HasAny())
    {
      this->LoseMaps(window, failures.GetFirst());
    }
    else if (schedule.Advance(run))
    {
      this->LookAtMean(window);
    }
    else if (schedule.IsHalfway())
    {
      for (int layer = 0; layer < impl.Statistics.LightsCasting; ++layer)
      {
        impl.Accumulator->HoldHalf(window, layer, impl.GetMeanScale(layer));
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::AddRun(vtkSoftShadowContext& context, int run)
{
  Internals& impl = *this->Impl;
  for (const Internals::LitLight& light : impl.Lights)
  {
    for (int i = 0; light.Casts && i < run; ++i)
    {
      if (!this->AddPoint(context, light.Layer, impl.Schedule.GetCount() + i))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::AddPoint(vtkSoftShadowContext& context, int layer, int index)
{
  Internals& impl = *this->Impl;
  const std::vector<vtkSoftShadowLightMaps::Face>& faces = impl.Maps[layer]->GetFaces();
  const vtkShadowEmitter& light = faces.front().Emitter;
  if (index > 0 && !light.HasExtent())
  {
    return true; // all its points are the first
  }
  const int weights =
    this->HasGaussianWeights() ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN;
  for (size_t f = 0; f < faces.size(); ++f)
  {
    context.Emitter = faces[f].Emitter;
    context.FaceAxis = faces[f].Axis;
    const vtkShadowLightSampling::Sample point =
      vtkShadowLightSampling::PointOfSequence(context.Emitter, index, weights);
    if (!impl.Accumulator->BeginSum(context.Window, layer))
    {
      return false;
    }
    if (!this->AddPointVisibility(context, point) && !this->AddMappedPoint(context, layer, point))
    {
      return false;
    }
    if (f == 0)
    {
      impl.PointWeights[layer] += context.Emitter.Weight * point.Weight;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::AddMappedPoint(
  const vtkSoftShadowContext& context, int layer, const vtkShadowLightSampling::Sample& sample)
{
  Internals& impl = *this->Impl;
  const int mapSize = impl.Schedule.GetMapSize();
  vtkShadowDepthMaps* maps = impl.PointMaps;
  const vtkSoftShadowSamples point = vtkSoftShadowPass::FitSamples(context, { sample });
  if (!point.Views.empty())
  {
    const int baked = maps->Bake(context.Renderer, context.Casters, point.Views, mapSize);
    if (baked < 0)
    {
      return false;
    }
    impl.Statistics.MapsBaked += baked;
    impl.Statistics.TexelsDrawn += static_cast<vtkTypeInt64>(baked) * mapSize * mapSize;
  }
  if (!impl.Accumulator->BeginSum(context.Window, layer) || !impl.PointShader.Use(context.Window))
  {
    return false;
  }
  vtkShaderProgram* program = impl.PointShader.GetProgram();
  program->SetUniformf("litWeight", point.LitWeight);
  this->SetReceiverUniforms(program, context);
  vtkSoftShadowPass::SetSampleUniforms(
    program, context, point.Views.data(), point.Weights.data(), point.Views.size(), 0, mapSize, 1);
  program->SetUniformi("depthMaps", maps->GetTexture()->Activate(context.Window));
  impl.PointShader.Draw();
  maps->GetTexture()->Deactivate();
  context.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::LookAtMean(vtkOpenGLRenderWindow* window)
{
  Internals& impl = *this->Impl;
  const int layers = impl.Statistics.LightsCasting;
  const bool maps = impl.Schedule.ComparesMaps();
  std::vector<float> changes;
  for (int layer = 0; layer < layers && impl.Schedule.NeedsTiles(); ++layer)
  {
    std::vector<float> tiles =
      impl.Accumulator->ReadChanges(window, impl.Receivers, layer, impl.GetMeanScale(layer),
        maps ? vtkSoftShadowAccumulator::COMMON : vtkSoftShadowAccumulator::ALL);
    const bool hard = !impl.Maps[layer]->GetFaces().front().Emitter.HasExtent();
    std::transform(tiles.begin(), tiles.end(), tiles.begin(),
      [maps, hard](float tile)
      { return maps && hard ? vtkSoftShadowSchedule::HardShare * tile : tile; });
    changes.insert(changes.end(), tiles.begin(), tiles.end());
  }
  const vtkSoftShadowSchedule::NextType next = impl.Schedule.Look(changes);
  impl.HasNews = next == vtkSoftShadowSchedule::END && impl.Schedule.IsConverged();
  if (next == vtkSoftShadowSchedule::END)
  {
    return;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    impl.Accumulator->Hold(window, layer, impl.GetMeanScale(layer));
  }
  if (next == vtkSoftShadowSchedule::HOLD_AND_CLEAR)
  {
    impl.Accumulator->KeepHalves();
    this->ClearMean(window);
  }
  if (!impl.Schedule.ComparesMaps())
  {
    impl.Accumulator->ReleaseHalves(window);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::ClearMean(vtkOpenGLRenderWindow* window)
{
  this->Impl->Accumulator->Clear(window);
  this->Impl->PointWeights.assign(this->Impl->Statistics.LightsCasting, 0.0);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::LoseMaps(vtkOpenGLRenderWindow* window, const std::string& reason)
{
  Internals& impl = *this->Impl;
  const int size = impl.Schedule.GetMapSize();
  if (impl.Schedule.LoseMaps())
  {
    vtkWarningMacro("There is no depth map of " << size << " x " << size << " texels (" << reason
                                                << "): the mean goes on with "
                                                << impl.Schedule.GetMapSize() << ".");
  }
  else
  {
    vtkWarningMacro("There is no depth map of " << size << " x " << size << " texels (" << reason
                                                << "): the picture stays as it was before.");
  }
  this->ClearMean(window);
}
VTK_ABI_NAMESPACE_END
