// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowRefinement.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowLights.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowServices.h"
#include "vtkSoftShadowTarget.h"

#include "vtkSoftShadowPointFS.h"

#include <algorithm>
#include <sstream>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// The largest map that memory and the driver allow; finer ones cost more than they gain.
int FindLargestMap(vtkTypeInt64 memory)
{
  const int largest = std::min(vtkShadowLimits::GetTextureSize(), 8192);
  vtkTypeInt64 size = 32;
  while (2 * size <= largest && 4 * (2 * size) * (2 * size) <= memory)
  {
    size *= 2;
  }
  return static_cast<int>(size);
}

} // namespace

//------------------------------------------------------------------------------
vtkSoftShadowRefinement::vtkSoftShadowRefinement()
  : Shader(vtkSoftShadowPointFS)
{
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::Reset()
{
  this->Schedule.Reset();
  this->Frames = 0;
  this->HasNews = false;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowRefinement::TakeNews()
{
  return std::exchange(this->HasNews, false);
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::Finish(bool converged)
{
  this->Schedule.Finish(converged);
  this->HasNews = converged;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkSoftShadowRefinement::Refine(
  const Job& job, vtkSoftShadowServices& services)
{
  this->Warnings.clear();
  const vtkShadowFailures failures;
  vtkOpenGLState* state = services.Window->GetState();
  state->PushFramebufferBindings();
  if (this->Schedule.IsStarted() || this->Begin(job, services))
  {
    this->AddPoints(job, services);
    for (int layer = 0; layer < this->GetLayers(); ++layer)
    {
      this->Accumulator.Show(services.Window, job.Target->GetTexture(), layer,
        this->Schedule.GetShare(), this->GetMeanScale(layer), this->Schedule.IsHeldShown());
    }
  }
  ++this->Frames;
  state->PopFramebufferBindings();
  if (failures.HasAny())
  {
    this->Warnings.push_back(
      "The picture is not refined any further: " + failures.GetFirst() + ".");
    this->Schedule.Finish(false);
  }
  if (this->Schedule.IsEnded())
  {
    this->ReleaseTextures(services.Window); // the mean stands in the visibilities
  }
  return this->Warnings;
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::ReleaseTextures(vtkWindow* window)
{
  this->Accumulator.ReleaseTextures(window);
  this->Maps->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowRefinement::Begin(const Job& job, const vtkSoftShadowServices& services)
{
  const int made = this->Accumulator.Begin(services.Window, job.Target->GetTexture());
  if (made < 0)
  {
    this->Schedule.Finish(false);
    return false;
  }
  services.CountAllocations(made);
  this->Weights.assign(job.Lights->GetNumberOfCasting(), 0.0);
  this->Schedule.Start(services.MapSize, FindLargestMap(services.MapMemory), job.Tolerance);
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::AddPoints(const Job& job, vtkSoftShadowServices& services)
{
  for (int left = job.Points; left > 0 && !this->Schedule.IsEnded();)
  {
    const int run = this->Schedule.GetRun(left);
    left -= run;
    const vtkShadowFailures failures;
    if (!this->AddRun(job, services, run) || failures.HasAny())
    {
      this->LoseMaps(services, failures.GetFirst());
    }
    else if (this->Schedule.Advance(run))
    {
      this->LookAtMean(job, services);
    }
    else if (this->Schedule.IsHalfway())
    {
      for (int layer = 0; layer < this->GetLayers(); ++layer)
      {
        this->Accumulator.HoldHalf(services.Window, layer, this->GetMeanScale(layer));
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowRefinement::AddRun(const Job& job, vtkSoftShadowServices& services, int run)
{
  for (const vtkSoftShadowLights::LitLight& light : *job.Lights)
  {
    for (int i = 0; light.Casts && i < run; ++i)
    {
      if (!this->AddPoint(job, services, light.Layer, this->Schedule.GetCount() + i))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowRefinement::AddPoint(
  const Job& job, vtkSoftShadowServices& services, int layer, int index)
{
  const std::vector<vtkSoftShadowLightFit::Face>& faces = job.Lights->GetFit(layer).GetFaces();
  if (index > 0 && !faces.front().Emitter.HasExtent())
  {
    return true; // all its points are the first
  }
  const int weights =
    job.GaussianWeights ? vtkShadowLightSampling::GAUSSIAN : vtkShadowLightSampling::MEAN;
  for (size_t f = 0; f < faces.size(); ++f)
  {
    services.Emitter = faces[f].Emitter;
    services.FaceAxis = faces[f].Axis;
    const vtkShadowLightSampling::Sample point =
      vtkShadowLightSampling::PointOfSequence(services.Emitter, index, weights);
    if (!this->Accumulator.BeginSum(services.Window, layer))
    {
      return false;
    }
    if (!job.Technique->AddPoint(services, point) && !this->AddMappedPoint(services, layer, point))
    {
      return false;
    }
    if (f == 0)
    {
      this->Weights[layer] += services.Emitter.Weight * point.Weight;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowRefinement::AddMappedPoint(
  const vtkSoftShadowServices& services, int layer, const vtkShadowLightSampling::Sample& sample)
{
  const int mapSize = this->Schedule.GetMapSize();
  const vtkSoftShadowSamples point = services.FitSamples({ sample });
  if (!point.Views.empty())
  {
    const int baked = this->Maps->Bake(services.Renderer, services.Casters, point.Views, mapSize);
    if (baked < 0)
    {
      return false;
    }
    services.CountBakes(baked, mapSize);
  }
  if (!this->Accumulator.BeginSum(services.Window, layer) || !this->Shader.Use(services.Window))
  {
    return false;
  }
  vtkShaderProgram* program = this->Shader.GetProgram();
  program->SetUniformf("litWeight", point.LitWeight);
  services.SetReceiverUniforms(program);
  services.SetSampleUniforms(
    program, point.Views.data(), point.Weights.data(), point.Views.size(), 0, mapSize, 1);
  program->SetUniformi("depthMaps", this->Maps->GetTexture()->Activate(services.Window));
  this->Shader.Draw();
  this->Maps->GetTexture()->Deactivate();
  services.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::LookAtMean(const Job& job, const vtkSoftShadowServices& services)
{
  const bool maps = this->Schedule.ComparesMaps();
  std::vector<float> changes;
  for (int layer = 0; layer < this->GetLayers() && this->Schedule.NeedsTiles(); ++layer)
  {
    std::vector<float> tiles = this->Accumulator.ReadChanges(services.Window, services.Receivers,
      layer, this->GetMeanScale(layer),
      maps ? vtkSoftShadowAccumulator::COMMON : vtkSoftShadowAccumulator::ALL);
    const bool hard = !job.Lights->GetFit(layer).GetFaces().front().Emitter.HasExtent();
    std::transform(tiles.begin(), tiles.end(), tiles.begin(),
      [maps, hard](float tile)
      { return maps && hard ? vtkSoftShadowSchedule::HardShare * tile : tile; });
    changes.insert(changes.end(), tiles.begin(), tiles.end());
  }
  const vtkSoftShadowSchedule::NextType next = this->Schedule.Look(changes);
  this->HasNews = next == vtkSoftShadowSchedule::END && this->Schedule.IsConverged();
  if (next == vtkSoftShadowSchedule::END)
  {
    return;
  }
  for (int layer = 0; layer < this->GetLayers(); ++layer)
  {
    this->Accumulator.Hold(services.Window, layer, this->GetMeanScale(layer));
  }
  if (next == vtkSoftShadowSchedule::HOLD_AND_CLEAR)
  {
    this->Accumulator.KeepHalves();
    this->ClearMean(services);
  }
  if (!this->Schedule.ComparesMaps())
  {
    this->Accumulator.ReleaseHalves(services.Window);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::ClearMean(const vtkSoftShadowServices& services)
{
  this->Accumulator.Clear(services.Window);
  this->Weights.assign(this->Weights.size(), 0.0);
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::LoseMaps(
  const vtkSoftShadowServices& services, const std::string& reason)
{
  const int size = this->Schedule.GetMapSize();
  std::ostringstream warning;
  warning << "There is no depth map of " << size << " x " << size << " texels (" << reason << "): ";
  if (this->Schedule.LoseMaps())
  {
    warning << "the mean goes on with " << this->Schedule.GetMapSize() << ".";
  }
  else
  {
    warning << "the picture stays as it was before.";
  }
  this->Warnings.push_back(warning.str());
  this->ClearMean(services);
}

//------------------------------------------------------------------------------
float vtkSoftShadowRefinement::GetMeanScale(int layer) const
{
  const double weight = this->Weights[layer];
  return weight > 0.0 ? static_cast<float>(1.0 / weight) : 0.0f;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowRefinement::GetBytes()
{
  return this->Accumulator.GetBytes() + this->Maps->GetTexture()->GetBytes();
}

//------------------------------------------------------------------------------
int vtkSoftShadowRefinement::GetNumberOfBuilds() const
{
  return this->Shader.GetNumberOfBuilds() + this->Accumulator.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkSoftShadowRefinement::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Accumulator.ReleaseGraphicsResources(window);
  this->Maps->ReleaseGraphicsResources(window);
  this->Shader.ReleaseGraphicsResources(window);
  this->Schedule.Reset();
}
VTK_ABI_NAMESPACE_END
