// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Which points of the light a cascade takes, and the views of their maps.
#include "vtkCascadedSoftShadowPassInternals.h"
#include "vtkShadowBorderGrid.h"
#include "vtkShadowCascadeWindow.h"
#include "vtkShadowCasters.h"

#include <algorithm>
#include <numeric>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Cuts the fits to a cascade: points that see no caster in front of it need no map.
vtkSoftShadowSamples Cut(const vtkSoftShadowSamples& fits,
  const vtkShadowCascades::Cascade& cascade, int mapSize, int filterSize, bool fitToView)
{
  vtkSoftShadowSamples samples;
  samples.LitWeight = fits.LitWeight;
  if (!cascade.Occupied)
  {
    samples.LitWeight = std::accumulate(fits.Weights.begin(), fits.Weights.end(), fits.LitWeight);
    return samples;
  }
  for (size_t i = 0; i < fits.Views.size(); ++i)
  {
    vtkShadowMapView view = fits.Views[i];
    if (!fitToView ||
      vtkShadowCascadeWindow::Cut(
        cascade.Center, cascade.Radius, mapSize, filterSize / 2 + 1, view))
    {
      samples.Views.push_back(view);
      samples.Weights.push_back(fits.Weights[i]);
    }
    else
    {
      samples.LitWeight += fits.Weights[i];
    }
  }
  return samples;
}

} // namespace

//------------------------------------------------------------------------------
const vtkSoftShadowSamples& vtkCascadedSoftShadowPass::Internals::FitGrid(
  vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, EmitterMaps& emitter, int k)
{
  const auto fit = emitter.Fits.find(k);
  if (fit != emitter.Fits.end())
  {
    return fit->second;
  }
  return emitter.Fits[k] = self->FitSamples(context,
           vtkShadowLightSampling::Generate(context.Emitter, k * k, self->Pattern, self->Weights));
}

//------------------------------------------------------------------------------
const vtkSoftShadowSamples& vtkCascadedSoftShadowPass::Internals::FitLevel(
  vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, EmitterMaps& emitter,
  int level)
{
  const auto fit = emitter.Fits.find(-level);
  if (fit != emitter.Fits.end())
  {
    return fit->second;
  }
  return emitter.Fits[-level] = self->FitSamples(
           context, vtkShadowBorderGrid::Make(context.Emitter, level, self->Weights).Added);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Internals::FindCascades(
  vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, EmitterMaps& emitter)
{
  vtkShadowCascades::View view = vtkShadowCascades::View::Of(context.Renderer);
  const auto add = [&view](const vtkSoftShadowSamples& fits)
  { view.Points.insert(view.Points.end(), fits.Views.begin(), fits.Views.end()); };
  if (self->Adaptive)
  {
    for (int level = 0; level <= self->MaximumLevel; ++level)
    {
      add(this->FitLevel(self, context, emitter, level));
    }
  }
  else
  {
    const auto last = self->SampleEdges.begin() + self->NumberOfCascades;
    const std::set<int> edges(self->SampleEdges.begin(), last);
    std::for_each(edges.begin(), edges.end(),
      [&](int edge) { add(this->FitGrid(self, context, emitter, edge)); });
  }
  this->Cascades = vtkShadowCascades::Find(
    context.Casters->GetBodies(), view, self->NumberOfCascades, self->SplitLambda, self->BlendBand);
}

//------------------------------------------------------------------------------
std::vector<size_t> vtkCascadedSoftShadowPass::AddSets(
  const vtkSoftShadowContext& context, size_t cascade)
{
  Internals& impl = *this->Impl;
  Internals::EmitterMaps& emitter = impl.Emitters[std::make_pair(context.Light, context.Part)];
  const int resolution = this->Resolutions[cascade];
  const int filterSize = this->FilterSizes[cascade];
  const auto add = [&](const vtkSoftShadowSamples& fits)
  {
    return emitter.Maps.Add(resolution, filterSize,
      Cut(fits, impl.Cascades[cascade], emitter.Maps.GetMapSize(resolution), filterSize,
        this->FitToView));
  };
  if (!this->Adaptive)
  {
    return { add(impl.FitGrid(this, context, emitter, this->SampleEdges[cascade])) };
  }
  const int largest = context.Emitter.HasExtent() ? this->MaximumLevel : 0;
  Refinement::Plan& plan = emitter.Plans[cascade];
  plan.Collect(this->GetFewPixels(), largest);
  std::vector<size_t> sets;
  for (int level = 0; level <= plan.GetLastLevel(largest); ++level)
  {
    sets.push_back(add(impl.FitLevel(this, context, emitter, level)));
  }
  return sets;
}
VTK_ABI_NAMESPACE_END
