// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBilateralSoftShadowPass.h"

#include "vtkBilateralLattice.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowScreenFilter.h"
#include "vtkSoftShadowServices.h"

#include "vtkBilateralMeanFS.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkBilateralSoftShadowPass);

namespace
{
constexpr size_t MapsPerDraw = VTK_SOFT_SHADOW_SAMPLES_PER_DRAW;
} // namespace

//------------------------------------------------------------------------------
class vtkBilateralSoftShadowPass::Internals
{
public:
  // The points of one emitter with their views, and the maps that hold a batch of them.
  struct EmitterSamples
  {
    vtkShadowEmitter Emitter;
    vtkMTimeType CastersTime = 0;
    vtkMTimeType SettingsTime = 0;
    vtkSoftShadowSamples Samples;
    std::array<std::array<double, 2>, 2> Cell = { {} };
    vtkNew<vtkShadowDepthMaps> Maps;
  };

  std::map<std::pair<int, int>, EmitterSamples> Emitters; // by light and part
  EmitterSamples* Current = nullptr;
  vtkShadowShader MeanShader{ vtkBilateralMeanFS };
  vtkSoftShadowScreenFilter Filter;

  void DrawBatch(
    const vtkSoftShadowServices& services, size_t first, size_t last, size_t layer, bool isFirst);
};

//------------------------------------------------------------------------------
vtkBilateralSoftShadowPass::vtkBilateralSoftShadowPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkBilateralSoftShadowPass::~vtkBilateralSoftShadowPass() = default;

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkBilateralSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.EmitterMap = false;
  // A proof would take one more map, of the whole light, beside those of few points.
  requirements.Proof = vtkSoftShadowRequirements::PROVES_NOTHING;
  requirements.GaussianWeights = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  return requirements;
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  Internals::EmitterSamples& emitter =
    this->Impl->Emitters[std::make_pair(services.Light, services.Part)];
  this->Impl->Current = &emitter;
  if (emitter.Emitter != services.Emitter || emitter.SettingsTime != this->GetMTime() ||
    emitter.CastersTime != services.Casters->GetCastersTime())
  {
    emitter.Emitter = services.Emitter;
    emitter.SettingsTime = this->GetMTime();
    emitter.CastersTime = services.Casters->GetCastersTime();
    const vtkBilateralLattice lattice(
      services.Emitter, this->NumberOfSamples, this->Weights, this->Filter == ADAPTIVE);
    emitter.Samples = services.FitSamples(lattice.GetSamples());
    emitter.Cell = lattice.GetCell();
  }
  const bool isDrawn = this->Impl->Filter.BeginSums(services) && this->DrawMean(services);
  this->Impl->Filter.EndSums();
  // Of a light's many parts only the first ones keep their maps.
  vtkTypeInt64 bytes = 0;
  for (auto& other : this->Impl->Emitters)
  {
    bytes += other.first.first == services.Light ? other.second.Maps->GetTexture()->GetBytes() : 0;
  }
  if (services.ExceedsMapMemory(bytes))
  {
    emitter.Maps->ReleaseGraphicsResources(services.Window);
  }
  if (!isDrawn)
  {
    return;
  }
  services.BeginStep("bilateral filter");
  this->DrawFilter(services);
  services.BeginStep("visibility");
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::DrawFilter(const vtkSoftShadowServices& services)
{
  using Screen = vtkSoftShadowScreenFilter;
  Screen::Settings settings;
  switch (this->Filter)
  {
    case NONE:
      settings.Domain = Screen::NONE;
      break;
    case FULL:
      settings.Domain = Screen::SQUARE;
      break;
    case ADAPTIVE:
      settings.Domain = Screen::CELL;
      break;
    default:
      settings.Domain = Screen::SEPARABLE;
  }
  settings.RangeDeviation = this->RangeDeviation;
  if (this->Filter == ADAPTIVE)
  {
    // The more points, the smaller the steps between bands: what differs by more is a shadow's
    // edge. The root of the root lies between what suits scenes (the root) and single ramps (none).
    constexpr double Points = 3.0;
    settings.RangeDeviation *= std::sqrt(std::sqrt(std::min(Points / this->NumberOfSamples, 1.0)));
  }
  settings.SecondAxisFirst = this->SecondAxisFirst;
  settings.Cells.resize(1);
  settings.Cells[0].Edges = this->Impl->Current->Cell;
  settings.MaximumWidth = this->MaximumWidth;
  settings.WeightedByPoints = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  settings.HalfTaps = this->FilterWidth / 2;
  settings.DomainDeviation = this->DomainDeviation;
  settings.Iterations = this->Filter == ATROUS ? this->Iterations : 1;
  this->Impl->Filter.Draw(services, settings);
}

//------------------------------------------------------------------------------
bool vtkBilateralSoftShadowPass::DrawMean(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  Internals::EmitterSamples& emitter = *impl.Current;
  const size_t layers =
    static_cast<size_t>(vtkShadowTextureArray::GetMaximumLayers(services.Window));
  const size_t batch = std::min(services.GetMapsPerBatch(services.MapSize), layers);
  const size_t count = emitter.Samples.Views.size();
  bool isFirst = true;
  for (size_t first = 0; first == 0 || first < count; first += batch)
  {
    const size_t last = std::min(first + batch, count);
    if (last > first)
    {
      services.BeginStep("sample maps");
      const std::vector<vtkShadowMapView> views(
        emitter.Samples.Views.begin() + first, emitter.Samples.Views.begin() + last);
      const int baked =
        emitter.Maps->Bake(services.Renderer, services.Casters, views, services.MapSize);
      if (baked < 0)
      {
        return false;
      }
      services.CountBakes(baked, services.MapSize);
    }
    services.BeginStep("mean");
    for (size_t i = first; i == first || i < last; i += MapsPerDraw)
    {
      impl.DrawBatch(services, i, std::min(i + MapsPerDraw, last), i - first, isFirst);
      isFirst = false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::Internals::DrawBatch(
  const vtkSoftShadowServices& services, size_t first, size_t last, size_t layer, bool isFirst)
{
  if (!this->MeanShader.Use(services.Window))
  {
    return;
  }
  const vtkSoftShadowSamples& samples = this->Current->Samples;
  vtkShaderProgram* program = this->MeanShader.GetProgram();
  services.SetReceiverUniforms(program);
  std::vector<float> weights;
  for (size_t i = first; i < last; ++i)
  {
    weights.push_back(samples.Weights[i] / static_cast<float>(services.Emitter.Weight));
  }
  services.SetSampleUniforms(program, samples.Views.data() + first, weights.data(), last - first,
    layer, services.MapSize, 1);
  // The texture starts at -1, no value.
  program->SetUniformf("madeUp", isFirst ? 1.0f : 0.0f);
  program->SetUniformf(
    "litWeight", isFirst ? samples.LitWeight / static_cast<float>(services.Emitter.Weight) : 0.0f);
  vtkShadowTextureArray* texture = this->Current->Maps->GetTexture();
  program->SetUniformi("depthMaps", texture->Activate(services.Window));
  services.DrawMarked(this->MeanShader);
  texture->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  Internals& impl = *this->Impl;
  statistics.BytesHeld += impl.Filter.GetBytes();
  statistics.ShaderBuilds +=
    impl.MeanShader.GetNumberOfBuilds() + impl.Filter.GetNumberOfShaderBuilds();
  for (auto& emitter : impl.Emitters)
  {
    statistics.BytesHeld += emitter.second.Maps->GetTexture()->GetBytes();
    statistics.DrawCalls += emitter.second.Maps->GetNumberOfDrawCalls();
  }
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  impl.MeanShader.ReleaseGraphicsResources(window);
  impl.Filter.ReleaseGraphicsResources(window);
  for (auto& emitter : impl.Emitters)
  {
    emitter.second.Maps->ReleaseGraphicsResources(window);
  }
  impl.Emitters.clear();
  impl.Current = nullptr;
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const filters[] = { "none", "paper", "full", "atrous", "adaptive" };
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent
     << "Weights: " << (this->Weights == vtkShadowLightSampling::GAUSSIAN ? "gaussian" : "mean")
     << "\n";
  os << indent << "Filter: " << filters[this->Filter] << "\n";
  os << indent << "FilterWidth: " << this->FilterWidth << "\n";
  os << indent << "DomainDeviation: " << this->DomainDeviation << "\n";
  os << indent << "RangeDeviation: " << this->RangeDeviation << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "MaximumWidth: " << this->MaximumWidth << "\n";
  os << indent << "SecondAxisFirst: " << (this->SecondAxisFirst ? "on" : "off") << "\n";
}
VTK_ABI_NAMESPACE_END
