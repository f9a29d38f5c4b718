// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedSoftShadowPass.h"

#include "vtkCascadedPoints.h"
#include "vtkCascadedSoftShadowPassInternals.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCascadeWindow.h"
#include "vtkShadowCasters.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <numeric>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkCascadedSoftShadowPass);

namespace
{
// Of the viewport: what so few pixels need is not worth another level's maps.
constexpr double FewPixels = 5e-4;

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
void vtkCascadedSoftShadowPass::Internals::SetFade(
  vtkShaderProgram* program, const vtkShadowCascades::Cascade& cascade)
{
  const float fadeIn[2] = { static_cast<float>(cascade.FadeIn.first),
    static_cast<float>(cascade.FadeIn.second) };
  const float fadeOut[2] = { static_cast<float>(cascade.FadeOut.first),
    static_cast<float>(cascade.FadeOut.second) };
  program->SetUniform2f("fadeIn", fadeIn);
  program->SetUniform2f("fadeOut", fadeOut);
}

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
vtkCascadedSoftShadowPass::vtkCascadedSoftShadowPass()
  : Impl(new Internals)
{
  this->MapSize = 1024;
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowPass::~vtkCascadedSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
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
int vtkCascadedSoftShadowPass::GetNumberOfOccupiedCascades() const
{
  return static_cast<int>(this->Impl->Cascades.size());
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  impl.Receivers = context.Receivers;
  vtkShadowShader::Definitions definitions;
  if (!this->Gather)
  {
    definitions.emplace_back("SOFT_SHADOW_NO_GATHER", "1");
  }
  impl.Shader.SetDefinitions(definitions);
  impl.Refiner.SetDefinitions(definitions);
  Internals::EmitterMaps& emitter = impl.Emitters[std::make_pair(context.Light, context.Part)];
  if (emitter.Emitter != context.Emitter || emitter.SettingsTime != this->GetMTime() ||
    emitter.BodiesTime != context.Casters->GetBodiesTime())
  {
    emitter.Emitter = context.Emitter;
    emitter.SettingsTime = this->GetMTime();
    emitter.BodiesTime = context.Casters->GetBodiesTime();
    emitter.Fits.clear();
  }
  impl.FindCascades(this, context, emitter);
  emitter.Maps.Begin(this->MapSize);
  std::vector<std::vector<size_t>> sets; // per cascade
  for (size_t i = 0; i < impl.Cascades.size(); ++i)
  {
    sets.push_back(this->AddSets(context, i));
  }
  for (size_t i = 0; i < impl.Cascades.size(); ++i)
  {
    if (this->Adaptive)
    {
      impl.Refiner.Draw(this, context, emitter.Maps, sets[i], impl.Cascades[i], emitter.Plans[i]);
    }
    else
    {
      impl.DrawCascade(this, context, emitter.Maps, i);
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

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetFewPixels() const
{
  vtkShadowReceivers* receivers = this->Impl->Receivers;
  return receivers
    ? static_cast<vtkTypeInt64>(FewPixels * receivers->GetWidth() * receivers->GetHeight())
    : 0;
}

//------------------------------------------------------------------------------
bool vtkCascadedSoftShadowPass::WantsVisibilityAnew()
{
  if (!this->Adaptive)
  {
    return false;
  }
  bool anew = false;
  for (auto& emitter : this->Impl->Emitters)
  {
    for (Refinement::Plan& plan : emitter.second.Plans)
    {
      anew = plan.Collect(this->GetFewPixels(), this->MaximumLevel) || anew;
    }
  }
  return anew;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetNumberOfPixelSamples()
{
  vtkTypeInt64 samples = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    for (Refinement::Plan& plan : emitter.second.Plans)
    {
      plan.Collect(this->GetFewPixels(), this->MaximumLevel);
      vtkTypeInt64 before = 0;
      for (int level = 0; level <= vtkShadowBorderGrid::LargestLevel; ++level)
      {
        const vtkTypeInt64 edge = (1 << level) + 1;
        samples += plan.Counts[level] * (edge * edge - before);
        before = edge * edge;
      }
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Internals::DrawCascade(vtkCascadedSoftShadowPass* self,
  const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps, size_t cascade)
{
  const vtkCascadedSoftShadowMaps::Set& set = maps.GetSet(cascade);
  float litWeight = set.Samples.LitWeight;
  const size_t count = set.Samples.Views.size();
  for (size_t first = 0; first == 0 || first < count;)
  {
    vtkCascadedSoftShadowMaps::Run run;
    if (count > 0)
    {
      run = Internals::Bake(self, context, maps, cascade, first);
      if (run.Last == run.First)
      {
        return;
      }
    }
    if (!this->Shader.Use(context.Window))
    {
      return;
    }
    vtkShaderProgram* program = this->Shader.GetProgram();
    Internals::SetFade(program, this->Cascades[cascade]);
    program->SetUniformf("litWeight", litWeight);
    litWeight = 0.0f; // once
    self->SetReceiverUniforms(program, context);
    program->SetUniformf("depthMapSize", static_cast<float>(maps.GetMapSize(set.Resolution)));
    program->SetUniformf("firstLayer", static_cast<float>(run.Layer));
    program->SetUniformi("filterSize", set.FilterSize);
    program->SetUniformi("fixedFilter", self->Filter == FIXED ? 1 : 0);
    program->SetUniformi("wideFilter", self->Filter == WIDE ? 1 : 0);
    const vtkShadowMapView* views = set.Samples.Views.data() + run.First;
    const size_t pointCount = run.Last - run.First;
    if (pointCount > 0)
    {
      vtkSoftShadowPass::SetAffineMapUniforms(program, context, views, pointCount);
    }
    vtkCascadedPoints(context.Emitter, views, set.Samples.Weights.data() + run.First, pointCount)
      .SetUniforms(program, 1.0 / self->SampleEdges[cascade]);
    vtkShadowTextureArray* texture = maps.GetMaps(set.Resolution)->GetTexture();
    program->SetUniformi("depthMaps", texture->Activate(context.Window));
    self->DrawFiltered(this->Shader);
    texture->Deactivate();
    context.Receivers->Deactivate();
    first = std::max<size_t>(run.Last, 1);
  }
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowMaps::Run vtkCascadedSoftShadowPass::Internals::Bake(
  vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
  vtkCascadedSoftShadowMaps& maps, size_t set, size_t first)
{
  self->BeginStep("cascade maps");
  const size_t memory = static_cast<size_t>(self->MapMemory) << 20;
  std::array<int, vtkCascadedSoftShadowMaps::NumberOfResolutions> baked = { {} };
  const vtkCascadedSoftShadowMaps::Run run = maps.Bake(context, set, first, memory, baked);
  for (int resolution = 0; resolution < vtkCascadedSoftShadowMaps::NumberOfResolutions;
       ++resolution)
  {
    const vtkTypeInt64 size = maps.GetMapSize(resolution);
    self->ChangeStatistics().MapsBaked += baked[resolution];
    self->ChangeStatistics().TexelsDrawn += baked[resolution] * size * size;
  }
  self->BeginStep("visibility");
  return run;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Render(const vtkRenderState* s)
{
  this->Superclass::Render(s);
  if (this->Tint && this->Impl->Receivers && !s->GetRenderer()->GetSelector())
  {
    this->DrawTint(s);
  }
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::DrawTint(const vtkRenderState* s)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  Internals& impl = *this->Impl;
  if (!impl.TintShader.Use(window))
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ZERO, GL_SRC_COLOR);
  vtkShaderProgram* program = impl.TintShader.GetProgram();
  float fades[2][MaximumNumberOfCascades][2] = {};
  for (size_t i = 0; i < impl.Cascades.size(); ++i)
  {
    fades[0][i][0] = static_cast<float>(impl.Cascades[i].FadeIn.first);
    fades[0][i][1] = static_cast<float>(impl.Cascades[i].FadeIn.second);
    fades[1][i][0] = static_cast<float>(impl.Cascades[i].FadeOut.first);
    fades[1][i][1] = static_cast<float>(impl.Cascades[i].FadeOut.second);
  }
  program->SetUniform2fv("fadeIns", MaximumNumberOfCascades, fades[0]);
  program->SetUniform2fv("fadeOuts", MaximumNumberOfCascades, fades[1]);
  program->SetUniformi("cascadeCount", static_cast<int>(impl.Cascades.size()));
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  program->SetUniform2f("origin", origin);
  impl.Receivers->Activate(program);
  impl.TintShader.Draw();
  impl.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    bytes += emitter.second.Maps.GetBytes();
  }
  return bytes + this->Impl->Refiner.GetBytes();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowPass::GetTechniqueDrawCalls()
{
  vtkTypeInt64 calls = 0;
  for (auto& emitter : this->Impl->Emitters)
  {
    calls += emitter.second.Maps.GetNumberOfDrawCalls();
  }
  return calls;
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowPass::GetTechniqueShaderBuilds()
{
  return this->Impl->Shader.GetNumberOfBuilds() + this->Impl->TintShader.GetNumberOfBuilds() +
    this->Impl->Refiner.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Impl->Shader.ReleaseGraphicsResources(window);
  this->Impl->TintShader.ReleaseGraphicsResources(window);
  for (auto& emitter : this->Impl->Emitters)
  {
    emitter.second.Maps.ReleaseGraphicsResources(window);
    for (Refinement::Plan& plan : emitter.second.Plans)
    {
      plan.ReleaseGraphicsResources();
    }
  }
  this->Impl->Refiner.ReleaseGraphicsResources(window);
  this->Impl->Emitters.clear();
  this->Impl->Cascades.clear();
  this->Impl->Receivers = nullptr;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const patterns[] = { "grid", "stratified", "hammersley" };
  const char* const filters[] = { "cell", "fixed", "wide" };
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
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "FitToView: " << (this->FitToView ? "on" : "off") << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "on" : "off") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "Gather: " << (this->Gather ? "on" : "off") << "\n";
  os << indent << "Tint: " << (this->Tint ? "on" : "off") << "\n";
}
VTK_ABI_NAMESPACE_END
