// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedSoftShadowPass.h"

#include "vtkCascadedDrawing.h"
#include "vtkCascadedEmitter.h"
#include "vtkCascadedRefinement.h"
#include "vtkCascadedSettings.h"
#include "vtkCascadedTint.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShadowQueryReader.h"
#include "vtkSoftShadowServices.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkCascadedSoftShadowPass);

//------------------------------------------------------------------------------
class vtkCascadedSoftShadowPass::Internals
{
public:
  std::map<std::pair<const vtkLight*, int>, vtkCascadedEmitter> Emitters; // by light and part
  vtkTypeInt64 Estimate = -1;                                             // the last one
  std::shared_ptr<vtkShadowQueryReader> Reader = std::make_shared<vtkShadowQueryReader>();
  vtkCascadedDrawing Drawing;
  vtkCascadedRefinement Refinement;
  vtkCascadedTint Tint;
  vtkShadowReceivers* Receivers = nullptr; // of the last estimate

  /// The cascades of every emitter of the last estimate, of one light or (-1) of all.
  std::vector<std::vector<vtkShadowCascades::Cascade>> GetCascades(int light) const
  {
    std::vector<std::vector<vtkShadowCascades::Cascade>> cascades;
    for (const auto& emitter : this->Emitters)
    {
      if (emitter.second.GetEstimate() == this->Estimate &&
        (light < 0 || emitter.second.GetLight() == light))
      {
        cascades.push_back(emitter.second.GetCascades());
      }
    }
    return cascades;
  }

  /// The adaptive plans of the last estimate, with what has come back of their counts.
  std::vector<vtkCascadedPlan*> CollectCounts()
  {
    std::vector<vtkCascadedPlan*> plans;
    for (auto& entry : this->Emitters)
    {
      // What was drawn before, a light that is off or a cascade more, is out of date.
      vtkCascadedEmitter& emitter = entry.second;
      const size_t count =
        emitter.GetEstimate() == this->Estimate ? emitter.GetCascades().size() : 0;
      for (size_t i = 0; i < count; ++i)
      {
        emitter.GetPlan(i).Collect(
          *this->Reader, vtkCascadedRefinement::GetFewPixels(this->Receivers));
        plans.push_back(&emitter.GetPlan(i));
      }
    }
    return plans;
  }
};

//------------------------------------------------------------------------------
vtkCascadedSoftShadowPass::vtkCascadedSoftShadowPass()
  : Impl(new Internals)
{
  this->MapSize = 1024;
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowPass::~vtkCascadedSoftShadowPass() = default;

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkCascadedSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.EmitterMap = false;
  // A map of the whole light is coarser than the cascades': what it proves is not their truth.
  requirements.Proof = vtkSoftShadowRequirements::PROVES_LIT;
  // It serves the proofs alone, and half the edge proves as much.
  requirements.EmitterMapSize = this->MapSize > 64 ? this->MapSize / 2 : 32;
  requirements.ConservativeMap = true;
  requirements.GaussianWeights = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  return requirements;
}

//------------------------------------------------------------------------------
vtkCascadedSettings vtkCascadedSoftShadowPass::GetSettings()
{
  vtkCascadedSettings settings;
  settings.Time = this->GetMTime();
  settings.NumberOfCascades = this->NumberOfCascades;
  settings.SplitLambda = this->SplitLambda;
  settings.BlendBand = this->BlendBand;
  settings.SampleEdges = this->SampleEdges;
  settings.Resolutions = this->Resolutions;
  settings.FilterSizes = this->FilterSizes;
  settings.FiltersMaps = this->Filter == FIXED;
  settings.Pattern = this->Pattern;
  settings.Weights = this->Weights;
  settings.Adaptive = this->Adaptive;
  settings.Tolerance = this->Tolerance;
  settings.MaximumLevel = this->MaximumLevel;
  settings.FitToView = this->FitToView;
  return settings;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Begin(const vtkSoftShadowServices& services)
{
  auto& emitters = this->Impl->Emitters;
  for (auto emitter = emitters.begin(); emitter != emitters.end();)
  {
    const bool isThere = vtkSoftShadowContext::HasLight(services.Renderer, emitter->first.first);
    emitter = isThere ? std::next(emitter) : emitters.erase(emitter);
  }
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  impl.Receivers = services.Receivers;
  impl.Estimate = services.Estimate;
  vtkShadowShader::Definitions definitions;
  if (!this->Gather)
  {
    definitions.emplace_back("SOFT_SHADOW_NO_GATHER", "1");
  }
  impl.Drawing.SetDefinitions(definitions);
  impl.Refinement.SetDefinitions(definitions);
  const vtkCascadedSettings settings = this->GetSettings();
  vtkCascadedEmitter& emitter = impl.Emitters[std::make_pair(services.Source, services.Part)];
  emitter.Begin(services, settings);
  const size_t cascades = emitter.GetCascades().size();
  std::vector<std::vector<size_t>> sets; // per cascade
  for (size_t i = 0; i < cascades; ++i)
  {
    sets.push_back(emitter.AddSets(services, settings, i, *impl.Reader));
  }
  if (!this->Adaptive && this->Filter == SCREEN)
  {
    impl.Drawing.DrawScreen(services, settings, emitter);
  }
  else
  {
    for (size_t i = 0; i < cascades; ++i)
    {
      if (this->Adaptive)
      {
        impl.Refinement.Draw(services, settings, emitter.GetMaps(), sets[i],
          emitter.GetCascades()[i], emitter.GetPlan(i));
      }
      else
      {
        impl.Drawing.DrawCascade(services, emitter, i);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Render(const vtkRenderState* s)
{
  this->Superclass::Render(s);
  if (this->Tint && this->Impl->Receivers && !s->GetRenderer()->GetSelector())
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
    this->Impl->Tint.Draw(window, this->Impl->Receivers, this->Impl->GetCascades(this->TintLight));
  }
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::WantsVisibilityAnew()
{
  if (!this->Adaptive)
  {
    return false;
  }
  const std::vector<vtkCascadedPlan*> plans = this->Impl->CollectCounts();
  return std::any_of(
    plans.begin(), plans.end(), [](const vtkCascadedPlan* plan) { return plan->WantsMore; });
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetQueryReader(std::shared_ptr<vtkShadowQueryReader> reader)
{
  this->Impl->Reader = reader ? std::move(reader) : std::make_shared<vtkShadowQueryReader>();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetNumberOfPixelSamples()
{
  vtkTypeInt64 samples = 0;
  for (const vtkCascadedPlan* plan : this->Impl->CollectCounts())
  {
    samples += plan->GetNumberOfPixelSamples();
  }
  return samples;
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetNumberOfOccupiedCascades() const
{
  size_t largest = 0;
  for (const auto& cascades : this->Impl->GetCascades(-1))
  {
    largest = std::max(largest, cascades.size());
  }
  return static_cast<int>(largest);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  Internals& impl = *this->Impl;
  statistics.BytesHeld += impl.Refinement.GetBytes() + impl.Drawing.GetBytes();
  statistics.ShaderBuilds += impl.Drawing.GetNumberOfBuilds() +
    impl.Refinement.GetNumberOfBuilds() + impl.Tint.GetNumberOfBuilds();
  if (this->Adaptive)
  {
    statistics.TechniqueCounts = { { "pixel_samples", this->GetNumberOfPixelSamples() } };
  }
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  impl.Drawing.ReleaseGraphicsResources(window);
  impl.Refinement.ReleaseGraphicsResources(window);
  impl.Tint.ReleaseGraphicsResources(window);
  for (auto& emitter : impl.Emitters)
  {
    emitter.second.ReleaseGraphicsResources();
  }
  impl.Emitters.clear();
  impl.Receivers = nullptr;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Change(
  std::array<int, MaximumNumberOfCascades>& values, int cascade, int value)
{
  if (cascade < 0 || cascade >= MaximumNumberOfCascades)
  {
    vtkErrorMacro("There is no cascade " << cascade << "; cascades are numbered 0 to "
                                         << MaximumNumberOfCascades - 1 << ".");
    return;
  }
  if (values[cascade] != value)
  {
    values[cascade] = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::Read(
  const std::array<int, MaximumNumberOfCascades>& values, int cascade) const
{
  return values[std::min(std::max(cascade, 0), MaximumNumberOfCascades - 1)];
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetSampleEdge(int cascade, int edge)
{
  this->Change(this->SampleEdges, cascade, std::min(std::max(edge, 1), 32));
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetSampleEdge(int cascade) const
{
  return this->Read(this->SampleEdges, cascade);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetResolution(int cascade, int resolution)
{
  this->Change(this->Resolutions, cascade, std::min<int>(std::max<int>(resolution, HIGH), LOW));
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetResolution(int cascade) const
{
  return this->Read(this->Resolutions, cascade);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::SetFilterSize(int cascade, int size)
{
  this->Change(this->FilterSizes, cascade, std::min(std::max(size, 1), 15));
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetFilterSize(int cascade) const
{
  return this->Read(this->FilterSizes, cascade);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const patterns[] = { "grid", "stratified", "hammersley" };
  const char* const filters[] = { "screen", "fixed" };
  const char* const resolutions[] = { "high", "medium", "low" };
  os << indent << "NumberOfCascades: " << this->NumberOfCascades << "\n";
  os << indent << "SplitLambda: " << this->SplitLambda << "\n";
  os << indent << "BlendBand: " << this->BlendBand << "\n";
  for (int i = 0; i < MaximumNumberOfCascades; ++i)
  {
    os << indent << "Cascade " << i << ": " << this->SampleEdges[i] << "^2 points, "
       << resolutions[this->Resolutions[i]] << " resolution, filter " << this->FilterSizes[i]
       << "\n";
  }
  os << indent << "Pattern: " << patterns[this->Pattern] << "\n";
  os << indent << "Filter: " << filters[this->Filter] << "\n";
  os << indent
     << "Weights: " << (this->Weights == vtkShadowLightSampling::GAUSSIAN ? "gaussian" : "mean")
     << "\n";
  os << indent << "FitToView: " << (this->FitToView ? "on" : "off") << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "on" : "off") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "Gather: " << (this->Gather ? "on" : "off") << "\n";
  os << indent << "Tint: " << (this->Tint ? "on" : "off") << "\n";
  os << indent << "TintLight: " << this->TintLight << "\n";
}
VTK_ABI_NAMESPACE_END
