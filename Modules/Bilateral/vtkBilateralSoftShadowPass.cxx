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

  void DrawBatch(vtkBilateralSoftShadowPass* self, const vtkSoftShadowContext& context,
    size_t first, size_t last, size_t layer, bool isFirst);
};

//------------------------------------------------------------------------------
vtkBilateralSoftShadowPass::vtkBilateralSoftShadowPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkBilateralSoftShadowPass::~vtkBilateralSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
bool vtkBilateralSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals::EmitterSamples& emitter =
    this->Impl->Emitters[std::make_pair(context.Light, context.Part)];
  this->Impl->Current = &emitter;
  if (emitter.Emitter != context.Emitter || emitter.SettingsTime != this->GetMTime() ||
    emitter.CastersTime != context.Casters->GetCastersTime())
  {
    emitter.Emitter = context.Emitter;
    emitter.SettingsTime = this->GetMTime();
    emitter.CastersTime = context.Casters->GetCastersTime();
    const vtkBilateralLattice lattice(
      context.Emitter, this->NumberOfSamples, this->Weights, this->Filter == ADAPTIVE);
    emitter.Samples = vtkSoftShadowPass::FitSamples(context, lattice.GetSamples());
    emitter.Cell = lattice.GetCell();
  }
  const bool isDrawn = this->Impl->Filter.BeginSums(context) && this->DrawMean(context);
  this->Impl->Filter.EndSums();
  // Of a light's many parts only the first ones keep their maps.
  vtkTypeInt64 bytes = 0;
  for (auto& other : this->Impl->Emitters)
  {
    bytes += other.first.first == context.Light ? other.second.Maps->GetTexture()->GetBytes() : 0;
  }
  if (this->ExceedsMapMemory(bytes))
  {
    emitter.Maps->ReleaseGraphicsResources(context.Window);
  }
  if (!isDrawn)
  {
    return;
  }
  this->BeginStep("bilateral filter");
  this->DrawFilter(context);
  this->BeginStep("visibility");
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::DrawFilter(const vtkSoftShadowContext& context)
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
  settings.WeightedByPoints = this->HasGaussianWeights();
  settings.HalfTaps = this->FilterWidth / 2;
  settings.DomainDeviation = this->DomainDeviation;
  settings.Iterations = this->Filter == ATROUS ? this->Iterations : 1;
  this->Impl->Filter.Draw(context, settings);
}

//------------------------------------------------------------------------------
bool vtkBilateralSoftShadowPass::DrawMean(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  Internals::EmitterSamples& emitter = *impl.Current;
  const size_t layers =
    static_cast<size_t>(vtkShadowTextureArray::GetMaximumLayers(context.Window));
  const size_t batch = std::min(this->GetMapsPerBatch(), layers);
  const size_t count = emitter.Samples.Views.size();
  bool isFirst = true;
  for (size_t first = 0; first == 0 || first < count; first += batch)
  {
    const size_t last = std::min(first + batch, count);
    if (last > first)
    {
      this->BeginStep("sample maps");
      const std::vector<vtkShadowMapView> views(
        emitter.Samples.Views.begin() + first, emitter.Samples.Views.begin() + last);
      const int baked = emitter.Maps->Bake(context.Renderer, context.Casters, views, this->MapSize);
      if (baked < 0)
      {
        return false;
      }
      this->CountBakes(baked);
    }
    this->BeginStep("mean");
    for (size_t i = first; i == first || i < last; i += MapsPerDraw)
    {
      impl.DrawBatch(this, context, i, std::min(i + MapsPerDraw, last), i - first, isFirst);
      isFirst = false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::Internals::DrawBatch(vtkBilateralSoftShadowPass* self,
  const vtkSoftShadowContext& context, size_t first, size_t last, size_t layer, bool isFirst)
{
  if (!this->MeanShader.Use(context.Window))
  {
    return;
  }
  const vtkSoftShadowSamples& samples = this->Current->Samples;
  vtkShaderProgram* program = this->MeanShader.GetProgram();
  self->SetReceiverUniforms(program, context);
  std::vector<float> weights;
  for (size_t i = first; i < last; ++i)
  {
    weights.push_back(samples.Weights[i] / static_cast<float>(context.Emitter.Weight));
  }
  vtkSoftShadowPass::SetSampleUniforms(program, context, samples.Views.data() + first,
    weights.data(), last - first, layer, self->MapSize, 1);
  // The texture starts at -1, no value.
  program->SetUniformf("madeUp", isFirst ? 1.0f : 0.0f);
  program->SetUniformf(
    "litWeight", isFirst ? samples.LitWeight / static_cast<float>(context.Emitter.Weight) : 0.0f);
  vtkShadowTextureArray* texture = this->Current->Maps->GetTexture();
  program->SetUniformi("depthMaps", texture->Activate(context.Window));
  self->DrawFiltered(this->MeanShader);
  texture->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkBilateralSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = this->Impl->Filter.GetBytes();
  for (auto& emitter : this->Impl->Emitters)
  {
    bytes += emitter.second.Maps->GetTexture()->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkBilateralSoftShadowPass::GetTechniqueDrawCalls()
{
  vtkTypeInt64 calls = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    calls += emitter.second.Maps->GetNumberOfDrawCalls();
  }
  return calls;
}

//------------------------------------------------------------------------------
int vtkBilateralSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->MeanShader.GetNumberOfBuilds() + this->Impl->Filter.GetNumberOfShaderBuilds();
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
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "Filter: " << filters[this->Filter] << "\n";
  os << indent << "FilterWidth: " << this->FilterWidth << "\n";
  os << indent << "DomainDeviation: " << this->DomainDeviation << "\n";
  os << indent << "RangeDeviation: " << this->RangeDeviation << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "MaximumWidth: " << this->MaximumWidth << "\n";
  os << indent << "SecondAxisFirst: " << (this->SecondAxisFirst ? "on" : "off") << "\n";
}
VTK_ABI_NAMESPACE_END
