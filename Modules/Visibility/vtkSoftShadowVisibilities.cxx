// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowVisibilities.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowBands.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowImages.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowSignature.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::Set::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Target.ReleaseGraphicsResources(window);
  this->Refinement.ReleaseGraphicsResources(window);
  this->Pixels.ReleaseGraphicsResources();
}

//------------------------------------------------------------------------------
vtkSoftShadowVisibilities::vtkSoftShadowVisibilities(vtkSoftShadowPass& technique)
  : Technique(technique)
{
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowVisibilities::Begin(vtkRenderer* renderer, const Settings& settings)
{
  this->Renderer = renderer;
  this->Given = settings;
  const int largest = vtkShadowLimits::GetTextureSize();
  this->Given.MapSize = std::min(settings.MapSize, largest);
  this->Given.MapMemory = settings.MapMemory > 0 ? settings.MapMemory : this->GetFreeMemory();
  if (settings.MapSize <= largest || this->ToldMapSize == settings.MapSize)
  {
    return {};
  }
  this->ToldMapSize = settings.MapSize;
  return "Depth maps have " + std::to_string(largest) + " texels along an edge, not " +
    std::to_string(settings.MapSize) + ": this OpenGL allows no more.";
}

//------------------------------------------------------------------------------
// Asked once: later what is held counts as used.
vtkTypeInt64 vtkSoftShadowVisibilities::GetFreeMemory()
{
  if (this->FreeMemory == 0)
  {
    const vtkTypeInt64 told = vtkShadowLimits::GetFreeMemory() / 4;
    this->FreeMemory = told > 0 ? told : static_cast<vtkTypeInt64>(1) << 30;
  }
  return this->FreeMemory;
}

//------------------------------------------------------------------------------
vtkSoftShadowServices vtkSoftShadowVisibilities::MakeServices(
  const vtkShadowMapFitter& fitter, Set& set)
{
  vtkSoftShadowServices::Tools tools;
  tools.Timers = &this->Timers;
  tools.Statistics = &this->Statistics;
  tools.Pixels = &set.Pixels;
  tools.Store = &this->Maps;
  tools.Fits = &this->Fits;
  vtkSoftShadowServices services(tools);
  services.Renderer = this->Renderer;
  services.Window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  services.Casters = this->Casters;
  services.Fitter = &fitter;
  services.Receivers = this->Receivers;
  services.Estimate = this->Estimates;
  services.IsData = &set == &this->Data;
  services.MapSize = this->Given.MapSize;
  services.MapMemory = this->Given.MapMemory;
  services.EarlyOut = this->Given.EarlyOut;
  return services;
}

//------------------------------------------------------------------------------
vtkSoftShadowEstimator::Job vtkSoftShadowVisibilities::MakeJob(Set& set)
{
  vtkSoftShadowEstimator::Job job;
  job.Technique = &this->Technique;
  job.Requirements = this->Technique.GetRequirements();
  job.Split = this->Given.Split;
  job.Lights = &this->Lights;
  job.Losses = &this->Losses;
  job.Target = &set.Target;
  job.Pixels = &set.Pixels;
  return job;
}

//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::Restart(vtkWindow* window)
{
  this->Picture.Refinement.Reset(); // with the news of a mean that is thrown away
  this->IsDataKnown = false;
  if (!this->IsDataWanted)
  {
    this->ReleaseData(window); // nobody reads it any more
  }
  this->IsDataWanted = false;
  if (!this->Given.Progressive)
  {
    this->Picture.Refinement.ReleaseTextures(window);
  }
  this->Losses.Begin(this->Lights.GetNumberOfCasting());
  this->Statistics.TechniqueCounts.clear();
}

//------------------------------------------------------------------------------
int vtkSoftShadowVisibilities::FitViews()
{
  const vtkShadowMapFitter fitter(this->Casters->GetBodies());
  return vtkSoftShadowEstimator::FitViews(
    this->MakeJob(this->Picture), this->MakeServices(fitter, this->Picture));
}

//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::Estimate(bool changed)
{
  this->Estimate(this->Picture, changed);
}

//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::Estimate(Set& set, bool changed)
{
  const vtkShadowMapFitter fitter(this->Casters->GetBodies());
  vtkSoftShadowServices services = this->MakeServices(fitter, set);
  services.Estimate = ++this->Estimates;
  services.Changed = changed || this->IsDataLast;
  this->IsDataLast = services.IsData;
  this->Maps.SetBudget(this->Given.MapMemory);
  this->Maps.Begin(this->Renderer);
  this->Fits.Begin(this->Renderer);
  vtkSoftShadowEstimator::FitViews(this->MakeJob(set), services);
  const vtkTypeInt64 draws = vtkShadowBands::GetNumberOfDraws();
  this->Estimator.Estimate(this->MakeJob(set), services);
  this->Statistics.VisibilityDraws += vtkShadowBands::GetNumberOfDraws() - draws;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkSoftShadowVisibilities::Refine(Set& set)
{
  if (this->Lights.GetNumberOfCasting() == 0 || this->Losses.HasAny())
  {
    set.Refinement.Finish(this->Lights.GetNumberOfCasting() == 0);
    return {};
  }
  vtkSoftShadowRefinement::Job job;
  job.Technique = &this->Technique;
  job.Lights = &this->Lights;
  job.Target = &set.Target;
  job.GaussianWeights = this->Technique.GetRequirements().GaussianWeights;
  job.Points = this->Given.Points;
  job.Tolerance = this->Given.Tolerance;
  const vtkShadowMapFitter fitter(this->Casters->GetBodies());
  vtkSoftShadowServices services = this->MakeServices(fitter, set);
  // A light may have taken another's place that is equal to it: nothing changed, and nothing is fitted.
  vtkSoftShadowEstimator::FitViews(this->MakeJob(set), services);
  this->Statistics.ProgressiveFrames += services.IsData ? 0 : 1;
  return set.Refinement.Refine(job, services);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowVisibilities::NeedsTriangles(vtkRenderWindow* window)
{
  return window && this->Renderer && this->Renderer->GetRenderWindow() == window &&
    !this->Losses.HasAny() && this->GetTexture()->GetHandle() && this->Receivers->HasSmooth();
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkSoftShadowVisibilities::UpdateTriangles()
{
  std::vector<std::string> warnings;
  const vtkSoftShadowStatistics statistics = this->Statistics;
  const vtkSoftShadowLosses losses = this->Losses;
  this->Receivers->SetSmooth(false);
  this->IsDataWanted = true;
  if (!this->IsDataKnown)
  {
    this->IsDataKnown = true;
    this->Data.Refinement.Reset();
    this->Estimate(this->Data, true);
    ++this->Statistics.DataFrames;
  }
  // As many points as the picture has, or as good a mean.
  const vtkSoftShadowRefinement& shown = this->Picture.Refinement;
  const vtkSoftShadowSchedule& schedule = this->Data.Refinement.GetSchedule();
  while (this->Given.Progressive && !schedule.IsEnded() &&
    (this->Data.Refinement.GetFrames() < shown.GetFrames() || shown.GetSchedule().IsEnded()))
  {
    const std::vector<std::string> news = this->Refine(this->Data);
    warnings.insert(warnings.end(), news.begin(), news.end());
  }
  this->Receivers->SetSmooth(true);
  if (this->Losses.HasAny())
  {
    this->ReleaseData(this->Renderer->GetRenderWindow());
  }
  this->Losses = losses; // the picture has lost nothing
  this->Statistics.TechniqueCounts = statistics.TechniqueCounts;
  return warnings;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowVisibilities::MakeImage(int layer, bool triangles)
{
  if (layer < 0)
  {
    vtkSmartPointer<vtkImageData> image = this->Receivers->ReadDepth();
    if (image)
    {
      vtkSoftShadowImages::MakeLit(image);
    }
    return image;
  }
  vtkShadowTextureArray* texture = triangles ? this->Data.Target.GetTexture() : this->GetTexture();
  return texture->GetHandle() ? vtkSoftShadowImages::MakeVisibility(texture->ReadLayer(layer),
                                  this->Receivers->GetWidth(), this->Receivers->GetHeight())
                              : nullptr;
}

//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::AddTo(vtkSoftShadowSignature& signature) const
{
  signature.Add(static_cast<vtkTypeUInt64>(this->Casters->GetBodiesTime()));
  signature.Add(static_cast<vtkTypeUInt64>(this->Casters->GetLooksTime()));
  this->Lights.AddTo(signature);
}

//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::UpdateStatistics()
{
  const vtkSoftShadowSchedule& schedule = this->GetSchedule();
  vtkSoftShadowStatistics& statistics = this->Statistics;
  statistics.PixelsFiltered = this->Picture.Pixels.GetPixels();
  statistics.ProgressivePoints = this->Given.Progressive ? schedule.GetCount() : 0;
  statistics.Casters = this->Casters->GetNumberOfCasters();
  statistics.MapperCasters = this->Casters->GetNumberOfMapperCasters();
  statistics.Triangles = this->Casters->GetNumberOfTriangles();
  statistics.BytesHeld =
    this->Casters->GetBytes() + this->Receivers->GetBytes() + this->Maps.GetBytes();
  for (Set* set : { &this->Picture, &this->Data })
  {
    statistics.BytesHeld += set->Target.GetBytes() + set->Refinement.GetBytes();
  }
  statistics.DrawCalls =
    this->Picture.Refinement.GetNumberOfDrawCalls() + this->Maps.GetNumberOfDrawCalls();
  statistics.ShaderBuilds =
    this->Estimator.GetNumberOfBuilds() + this->Picture.Refinement.GetNumberOfBuilds();
  this->Technique.AddStatistics(statistics);
  statistics.Milliseconds = this->Timers.Collect();
}

//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::ReleaseData(vtkWindow* window)
{
  this->Data.ReleaseGraphicsResources(window);
  this->IsDataKnown = false;
}

//------------------------------------------------------------------------------
void vtkSoftShadowVisibilities::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Casters->ReleaseGraphicsResources(window);
  this->Receivers->ReleaseGraphicsResources(window);
  this->Maps.ReleaseGraphicsResources(window);
  this->Estimator.ReleaseGraphicsResources(window);
  this->Picture.ReleaseGraphicsResources(window);
  this->ReleaseData(window);
  this->Timers.ReleaseGraphicsResources();
  this->Losses.Clear();
  this->FreeMemory = 0;
}
VTK_ABI_NAMESPACE_END
