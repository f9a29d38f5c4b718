// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBilateralSoftShadowPass.h"

#include "vtkBilateralLattice.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
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
  using Cell = std::array<std::array<double, 2>, 2>;

  std::map<std::pair<const vtkLight*, int>, Cell> Cells; // of a point, by light and part
  vtkShadowShader MeanShader{ vtkBilateralMeanFS };
  vtkSoftShadowScreenFilter Filter;
  vtkNew<vtkShadowTextureArray> NoMaps; // of an emitter that nothing blocks

  void DrawBatch(const vtkSoftShadowServices& services, const vtkSoftShadowSamples& samples,
    vtkShadowDepthMaps* maps, size_t first, size_t last, size_t layer, bool isFirst);
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
void vtkBilateralSoftShadowPass::Begin(const vtkSoftShadowServices& services)
{
  auto& cells = this->Impl->Cells;
  for (auto cell = cells.begin(); cell != cells.end();)
  {
    const bool isThere = vtkSoftShadowContext::HasLight(services.Renderer, cell->first.first);
    cell = isThere ? std::next(cell) : cells.erase(cell);
  }
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  Internals::Cell& cell = impl.Cells[std::make_pair(services.Source, services.Part)];
  const vtkSoftShadowSamples& samples = services.FitSamples(0, this->GetMTime(),
    [&]
    {
      const vtkBilateralLattice lattice(
        services.Emitter, this->NumberOfSamples, this->Weights, this->Filter == ADAPTIVE);
      cell = lattice.GetCell();
      return lattice.GetSamples();
    });
  const bool isDrawn = impl.Filter.BeginSums(services) && this->DrawMean(services, samples);
  impl.Filter.EndSums();
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
  settings.Cells[0].Edges = this->Impl->Cells[std::make_pair(services.Source, services.Part)];
  settings.MaximumWidth = this->MaximumWidth;
  settings.WeightedByPoints = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  settings.HalfTaps = this->FilterWidth / 2;
  settings.DomainDeviation = this->DomainDeviation;
  settings.Iterations = this->Filter == ATROUS ? this->Iterations : 1;
  this->Impl->Filter.Draw(services, settings);
}

//------------------------------------------------------------------------------
bool vtkBilateralSoftShadowPass::DrawMean(
  const vtkSoftShadowServices& services, const vtkSoftShadowSamples& samples)
{
  const size_t batch = services.GetMapsPerBatch(services.MapSize);
  const size_t count = samples.Views.size();
  bool isFirst = true;
  for (size_t first = 0; first == 0 || first < count; first += batch)
  {
    const size_t last = std::min(first + batch, count);
    vtkShadowDepthMaps* maps = nullptr;
    if (last > first)
    {
      services.BeginStep("sample maps");
      maps = services.BakeMaps(
        { samples.Views.begin() + first, samples.Views.begin() + last }, services.MapSize);
      if (!maps)
      {
        return false;
      }
    }
    services.BeginStep("mean");
    for (size_t i = first; i == first || i < last; i += MapsPerDraw)
    {
      this->Impl->DrawBatch(
        services, samples, maps, i, std::min(i + MapsPerDraw, last), i - first, isFirst);
      isFirst = false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::Internals::DrawBatch(const vtkSoftShadowServices& services,
  const vtkSoftShadowSamples& samples, vtkShadowDepthMaps* maps, size_t first, size_t last,
  size_t layer, bool isFirst)
{
  if (!this->MeanShader.Use(services.Window))
  {
    return;
  }
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
  vtkShadowTextureArray* texture = maps ? maps->GetTexture() : this->NoMaps.GetPointer();
  program->SetUniformi("depthMaps", texture->Activate(services.Window));
  services.DrawMarked(this->MeanShader, vtkSoftShadowServices::CountSampleTaps(last - first, 1));
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
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  impl.MeanShader.ReleaseGraphicsResources(window);
  impl.Filter.ReleaseGraphicsResources(window);
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
