// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Which points of the light a cascade takes, and the views of their maps.
#include "vtkCascadedSoftShadowPassInternals.h"
#include "vtkShadowBorderGrid.h"
#include "vtkShadowCascadeWindow.h"
#include "vtkShadowCasters.h"

#include <algorithm>
#include <map>
#include <numeric>

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
        cascade.Center, cascade.Radius, cascade.Corners, mapSize, filterSize / 2 + 1, view))
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

// Whether a cascade's maps show as much as the fits, which are all that can be shown.
bool ShowsAll(
  const vtkSoftShadowSamples& fits, const vtkShadowCascades::Cascade& cascade, int mapSize)
{
  return cascade.Occupied &&
    std::all_of(fits.Views.begin(), fits.Views.end(),
      [&cascade, mapSize](const vtkShadowMapView& fit)
      {
        vtkShadowMapView view = fit;
        return vtkShadowCascadeWindow::Cut(
                 cascade.Center, cascade.Radius, cascade.Corners, mapSize, 2, view) &&
          view.Window == fit.Window;
      });
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
int vtkCascadedSoftShadowPass::Internals::GetFilterTexels(
  const vtkCascadedSoftShadowPass& self, const vtkShadowEmitter& emitter, size_t cascade)
{
  if (self.Filter == FIXED)
  {
    return self.FilterSizes[cascade];
  }
  return self.Adaptive || !emitter.HasExtent() ? 1 : 2;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Internals::FindCascades(
  vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, EmitterMaps& emitter)
{
  vtkShadowCascades::View view = vtkShadowCascades::View::Of(context.Renderer);
  // A cell is looked at as a whole, however few points see it.
  const auto add = [&](const vtkSoftShadowSamples& fits, double cellEdge, int filterSize)
  {
    for (const vtkShadowMapView& fit : fits.Views)
    {
      vtkShadowCascades::LightPoint point;
      point.Map = fit;
      point.Border = (filterSize / 2 + 1.0) / self->MapSize;
      vtkShadowMapView cell = fit;
      cell.Emitter.HalfSize = { { cellEdge * context.Emitter.HalfSize[0],
        cellEdge * context.Emitter.HalfSize[1] } };
      point.CellScale = cell.GetKernelScale();
      view.Points.push_back(point);
    }
  };
  if (self->Adaptive)
  {
    for (int level = 0; level <= self->MaximumLevel; ++level)
    {
      add(this->FitLevel(self, context, emitter, level), 0.0, 1);
    }
  }
  else
  {
    std::map<int, int> filters; // the widest, by edge
    for (int i = 0; i < self->NumberOfCascades; ++i)
    {
      int& filter = filters[self->SampleEdges[i]];
      // The coarsest maps' texels, in those of the finest.
      filter = std::max(
        filter, Internals::GetFilterTexels(*self, context.Emitter, i) << self->Resolutions[i]);
    }
    for (const auto& filter : filters)
    {
      const double cellEdge = self->Filter == FIXED ? 0.0 : 1.0 / filter.first;
      add(this->FitGrid(self, context, emitter, filter.first), cellEdge, filter.second);
    }
  }
  this->Cascades = vtkShadowCascades::Find(
    context.Casters->GetBodies(), view, self->NumberOfCascades, self->SplitLambda, self->BlendBand);
  if (!self->Adaptive && self->FitToView)
  {
    this->JoinCascades(self, context, emitter);
  }
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Internals::JoinCascades(
  vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, EmitterMaps& emitter)
{
  for (size_t i = 0; i + 1 < this->Cascades.size(); ++i)
  {
    bool isFinest = true;
    for (size_t j = i + 1; j < this->Cascades.size(); ++j)
    {
      isFinest = isFinest && self->SampleEdges[j] <= self->SampleEdges[i] &&
        self->Resolutions[j] >= self->Resolutions[i];
    }
    const vtkSoftShadowSamples& fits = this->FitGrid(self, context, emitter, self->SampleEdges[i]);
    if (isFinest &&
      ShowsAll(fits, this->Cascades[i], emitter.Maps.GetMapSize(self->Resolutions[i])))
    {
      for (size_t j = i + 1; j < this->Cascades.size(); ++j)
      {
        vtkShadowCascades::Join(this->Cascades[i], this->Cascades[j]);
      }
      this->Cascades.resize(i + 1);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<size_t> vtkCascadedSoftShadowPass::AddSets(
  const vtkSoftShadowContext& context, size_t cascade)
{
  Internals& impl = *this->Impl;
  Internals::EmitterMaps& emitter = impl.Emitters[std::make_pair(context.Light, context.Part)];
  const int resolution = this->Resolutions[cascade];
  const int filterSize = Internals::GetFilterTexels(*this, context.Emitter, cascade);
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
  Refinement::Plan& plan = emitter.Plans[cascade];
  plan.Collect(*impl.Reader, this->GetFewPixels());
  plan.IsHard = !context.Emitter.HasExtent();
  plan.LargestLevel = plan.IsHard ? 0 : this->MaximumLevel;
  std::vector<size_t> sets;
  for (int level = 0; level <= plan.GetLastLevel(); ++level)
  {
    sets.push_back(add(impl.FitLevel(this, context, emitter, level)));
  }
  return sets;
}
VTK_ABI_NAMESPACE_END
