// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedSoftShadowPass.h"

#include "vtkCascadedSoftShadowMaps.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCascadeWindow.h"
#include "vtkShadowCascades.h"
#include "vtkShadowCasters.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkCascadedSoftShadowFS.h"
#include "vtkCascadedTintFS.h"

#include <algorithm>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkCascadedSoftShadowPass);

namespace
{
// One emitter's points and their maps.
struct EmitterMaps
{
  vtkShadowEmitter Emitter;
  vtkMTimeType BodiesTime = 0;
  vtkMTimeType SettingsTime = 0;
  /// The fits of k x k points over all effective casters, by k: the same for every camera.
  std::map<int, vtkSoftShadowSamples> Fits;
  vtkCascadedSoftShadowMaps Maps;
};

void SetFade(vtkShaderProgram* program, const vtkShadowCascades::Cascade& cascade)
{
  const float fadeIn[2] = { static_cast<float>(cascade.FadeIn.first),
    static_cast<float>(cascade.FadeIn.second) };
  const float fadeOut[2] = { static_cast<float>(cascade.FadeOut.first),
    static_cast<float>(cascade.FadeOut.second) };
  program->SetUniform2f("fadeIn", fadeIn);
  program->SetUniform2f("fadeOut", fadeOut);
}

} // namespace

class vtkCascadedSoftShadowPass::Internals
{
public:
  std::map<std::pair<int, int>, EmitterMaps> Emitters; // by light and part
  std::vector<vtkShadowCascades::Cascade> Cascades;
  vtkShadowShader Shader{ vtkCascadedSoftShadowFS };
  vtkShadowShader TintShader{ vtkCascadedTintFS };
  vtkShadowReceivers* Receivers = nullptr; // the base class's

  void DrawCascade(vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
    vtkCascadedSoftShadowMaps& maps, size_t cascade);
  static vtkCascadedSoftShadowMaps::Run Bake(vtkCascadedSoftShadowPass* self,
    const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps, size_t set, size_t first);

  /// Cuts the fits to a cascade: points that see no caster in front of it need no map.
  static vtkSoftShadowSamples Cut(const vtkSoftShadowSamples& fits,
    const vtkShadowCascades::Cascade& cascade, int mapSize, int filterSize);
};

//------------------------------------------------------------------------------
vtkSoftShadowSamples vtkCascadedSoftShadowPass::Internals::Cut(const vtkSoftShadowSamples& fits,
  const vtkShadowCascades::Cascade& cascade, int mapSize, int filterSize)
{
  vtkSoftShadowSamples samples;
  samples.LitWeight = fits.LitWeight;
  for (size_t i = 0; i < fits.Views.size(); ++i)
  {
    vtkShadowMapView view = fits.Views[i];
    if (vtkShadowCascadeWindow::Cut(
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
  impl.Cascades = vtkShadowCascades::Find(context.Casters->GetBodies(),
    vtkShadowCascades::View::Of(context.Renderer), this->NumberOfCascades, this->SplitLambda,
    this->BlendBand);
  EmitterMaps& emitter = impl.Emitters[std::make_pair(context.Light, context.Part)];
  if (emitter.Emitter != context.Emitter || emitter.SettingsTime != this->GetMTime() ||
    emitter.BodiesTime != context.Casters->GetBodiesTime())
  {
    emitter.Emitter = context.Emitter;
    emitter.SettingsTime = this->GetMTime();
    emitter.BodiesTime = context.Casters->GetBodiesTime();
    emitter.Fits.clear();
  }
  emitter.Maps.Begin(this->MapSize);
  for (size_t i = 0; i < impl.Cascades.size(); ++i)
  {
    const int edge = this->SampleEdges[i];
    if (emitter.Fits.count(edge) == 0)
    {
      emitter.Fits[edge] = vtkSoftShadowPass::FitSamples(context,
        vtkShadowLightSampling::Generate(
          context.Emitter, edge * edge, this->Pattern, this->Weights));
    }
    const int resolution = this->Resolutions[i];
    emitter.Maps.Add(resolution, this->FilterSizes[i],
      Internals::Cut(emitter.Fits[edge], impl.Cascades[i], emitter.Maps.GetMapSize(resolution),
        this->FilterSizes[i]));
  }
  for (size_t i = 0; i < impl.Cascades.size(); ++i)
  {
    impl.DrawCascade(this, context, emitter.Maps, i);
  }
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
    SetFade(program, this->Cascades[cascade]);
    program->SetUniformf("litWeight", litWeight);
    litWeight = 0.0f; // once
    self->SetReceiverUniforms(program, context);
    vtkSoftShadowPass::SetSampleUniforms(program, context, set.Samples.Views.data() + run.First,
      set.Samples.Weights.data() + run.First, run.Last - run.First, run.Layer,
      maps.GetMapSize(set.Resolution), set.FilterSize);
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
  return bytes;
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
  return this->Impl->Shader.GetNumberOfBuilds() + this->Impl->TintShader.GetNumberOfBuilds();
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
  }
  this->Impl->Emitters.clear();
  this->Impl->Cascades.clear();
  this->Impl->Receivers = nullptr;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const patterns[] = { "grid", "stratified", "hammersley" };
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
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "Tint: " << (this->Tint ? "on" : "off") << "\n";
}
VTK_ABI_NAMESPACE_END
