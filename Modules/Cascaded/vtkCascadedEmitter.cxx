// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedEmitter.h"

#include "vtkCascadedRefinement.h"
#include "vtkShadowBorderGrid.h"
#include "vtkShadowCascadeWindow.h"
#include "vtkShadowCasters.h"
#include "vtkSoftShadowServices.h"

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

// Texels along an edge that a look into a map of the cascade takes in. On the screen edges are a texel
// wide; a hard light's, and those of adaptive points, are sharp.
int GetFilterTexels(
  const vtkCascadedSettings& settings, const vtkShadowEmitter& emitter, size_t cascade)
{
  if (settings.FiltersMaps)
  {
    return settings.FilterSizes[cascade];
  }
  return settings.Adaptive || !emitter.HasExtent() ? 1 : 2;
}

} // namespace

//------------------------------------------------------------------------------
void vtkCascadedEmitter::Begin(
  const vtkSoftShadowServices& services, const vtkCascadedSettings& settings)
{
  this->Estimate = services.Estimate;
  this->Light = services.Light;
  this->Maps.Begin(services.MapSize);
  this->FindCascades(services, settings);
}

//------------------------------------------------------------------------------
const vtkSoftShadowSamples& vtkCascadedEmitter::FitGrid(
  const vtkSoftShadowServices& services, const vtkCascadedSettings& settings, int k)
{
  return services.FitSamples(k, settings.Time,
    [&]
    {
      return vtkShadowLightSampling::Generate(
        services.Emitter, k * k, settings.Pattern, settings.Weights);
    });
}

//------------------------------------------------------------------------------
// Numbers of sets from 0 down: those of grids are above.
const vtkSoftShadowSamples& vtkCascadedEmitter::FitLevel(
  const vtkSoftShadowServices& services, const vtkCascadedSettings& settings, int level)
{
  return services.FitSamples(-level, settings.Time,
    [&] { return vtkShadowBorderGrid::Make(services.Emitter, level, settings.Weights).Added; });
}

//------------------------------------------------------------------------------
void vtkCascadedEmitter::FindCascades(
  const vtkSoftShadowServices& services, const vtkCascadedSettings& settings)
{
  vtkShadowCascades::View view = vtkShadowCascades::View::Of(services.Renderer);
  // A cell is looked at as a whole, however few points see it.
  const auto add = [&](const vtkSoftShadowSamples& fits, double cellEdge, int filterSize)
  {
    for (const vtkShadowMapView& fit : fits.Views)
    {
      vtkShadowCascades::LightPoint point;
      point.Map = fit;
      point.Border = (filterSize / 2 + 1.0) / services.MapSize;
      vtkShadowMapView cell = fit;
      cell.Emitter.HalfSize = { { cellEdge * services.Emitter.HalfSize[0],
        cellEdge * services.Emitter.HalfSize[1] } };
      point.CellScale = cell.GetKernelScale();
      view.Points.push_back(point);
    }
  };
  if (settings.Adaptive)
  {
    for (int level = 0; level <= settings.MaximumLevel; ++level)
    {
      add(this->FitLevel(services, settings, level), 0.0, 1);
    }
  }
  else
  {
    std::map<int, int> filters; // the widest, by edge
    for (int i = 0; i < settings.NumberOfCascades; ++i)
    {
      int& filter = filters[settings.SampleEdges[i]];
      // The coarsest maps' texels, in those of the finest.
      filter =
        std::max(filter, GetFilterTexels(settings, services.Emitter, i) << settings.Resolutions[i]);
    }
    for (const auto& filter : filters)
    {
      const double cellEdge = settings.FiltersMaps ? 0.0 : 1.0 / filter.first;
      add(this->FitGrid(services, settings, filter.first), cellEdge, filter.second);
    }
  }
  this->Cascades = vtkShadowCascades::Find(services.Casters->GetBodies(), view,
    settings.NumberOfCascades, settings.SplitLambda, settings.BlendBand);
  if (!settings.Adaptive && settings.FitToView)
  {
    this->JoinCascades(services, settings);
  }
}

//------------------------------------------------------------------------------
void vtkCascadedEmitter::JoinCascades(
  const vtkSoftShadowServices& services, const vtkCascadedSettings& settings)
{
  for (size_t i = 0; i + 1 < this->Cascades.size(); ++i)
  {
    bool isFinest = true;
    for (size_t j = i + 1; j < this->Cascades.size(); ++j)
    {
      isFinest = isFinest && settings.SampleEdges[j] <= settings.SampleEdges[i] &&
        settings.Resolutions[j] >= settings.Resolutions[i];
    }
    const vtkSoftShadowSamples& fits = this->FitGrid(services, settings, settings.SampleEdges[i]);
    if (isFinest &&
      ShowsAll(fits, this->Cascades[i], this->Maps.GetMapSize(settings.Resolutions[i])))
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
std::vector<size_t> vtkCascadedEmitter::AddSets(const vtkSoftShadowServices& services,
  const vtkCascadedSettings& settings, size_t cascade, vtkShadowQueryReader& reader)
{
  const int resolution = settings.Resolutions[cascade];
  const int filterSize = GetFilterTexels(settings, services.Emitter, cascade);
  const auto add = [&](const vtkSoftShadowSamples& fits)
  {
    return this->Maps.Add(resolution, filterSize,
      Cut(fits, this->Cascades[cascade], this->Maps.GetMapSize(resolution), filterSize,
        settings.FitToView));
  };
  if (!settings.Adaptive)
  {
    return { add(this->FitGrid(services, settings, settings.SampleEdges[cascade])) };
  }
  vtkCascadedPlan& plan = this->Plans[cascade];
  plan.Collect(reader, vtkCascadedRefinement::GetFewPixels(services.Receivers));
  plan.IsHard = !services.Emitter.HasExtent();
  plan.LargestLevel = plan.IsHard ? 0 : settings.MaximumLevel;
  std::vector<size_t> sets;
  for (int level = 0; level <= plan.GetLastLevel(); ++level)
  {
    sets.push_back(add(this->FitLevel(services, settings, level)));
  }
  return sets;
}

//------------------------------------------------------------------------------
void vtkCascadedEmitter::ReleaseGraphicsResources()
{
  for (vtkCascadedPlan& plan : this->Plans)
  {
    plan.ReleaseGraphicsResources();
  }
}
VTK_ABI_NAMESPACE_END
