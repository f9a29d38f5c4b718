// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBilateralSoftShadowPass.h"

#include "vtkBilateralLattice.h"
#include "vtkBilateralScreen.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkBilateralFilterFS.h"
#include "vtkBilateralMeanFS.h"
#include "vtkBilateralTilesFS.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkBilateralSoftShadowPass);

namespace
{
using Screen = vtkBilateralScreen;
constexpr size_t MapsPerDraw = VTK_SOFT_SHADOW_SAMPLES_PER_DRAW;

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

// One step of a filter: its taps in pixels, or which edge of the cell it goes along.
struct Step
{
  int Edge = 0;
  int Tap[2] = { 1, 0 };
  int Row[2] = { 0, 1 };
  int HalfTaps = 0;
  int HalfRows = 0;
};

// What the steps before the last change and put back.
struct ScopedTarget
{
  explicit ScopedTarget(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , ScissorTest(state, GL_SCISSOR_TEST)
  {
    state->PushFramebufferBindings();
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
  ~ScopedTarget() { this->State->PopFramebufferBindings(); }
  ScopedTarget(const ScopedTarget&) = delete;
  void operator=(const ScopedTarget&) = delete;

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
};

// The directions and points of the world in view coordinates, as floats.
class ViewFrame
{
public:
  explicit ViewFrame(const std::array<double, 16>& viewToWorld)
  {
    vtkMatrix4x4::Invert(viewToWorld.data(), this->WorldToView);
  }

  void Transform(const double vector[3], double w, float result[3]) const
  {
    const double* m = this->WorldToView;
    for (int i = 0; i < 3; ++i)
    {
      result[i] = static_cast<float>(m[4 * i] * vector[0] + m[4 * i + 1] * vector[1] +
        m[4 * i + 2] * vector[2] + m[4 * i + 3] * w);
    }
  }

private:
  double WorldToView[16];
};
} // namespace

class vtkBilateralSoftShadowPass::Internals
{
public:
  std::map<std::pair<int, int>, EmitterSamples> Emitters; // by light and part
  EmitterSamples* Current = nullptr;
  vtkBilateralScreen Screen;
  vtkShadowShader MeanShader{ vtkBilateralMeanFS };
  vtkShadowShader TilesShader{ vtkBilateralTilesFS };
  vtkShadowShader FilterShader{ vtkBilateralFilterFS };
  vtkShadowShader AdaptiveShader{ vtkBilateralFilterFS };

  void DrawBatch(vtkBilateralSoftShadowPass* self, const vtkSoftShadowContext& context,
    size_t first, size_t last, size_t layer, bool isFirst);
  void SetAdaptiveUniforms(vtkShaderProgram* program, const vtkSoftShadowContext& context,
    const Step& step, const vtkBilateralSoftShadowPass* self);
  /// How far lit pixels look for a shadow: some more than most kernels reach.
  static int GetTileSize(const vtkBilateralSoftShadowPass* self)
  {
    return (self->MaximumWidth + 2) / 3;
  }
  static std::vector<Step> PlanSteps(const vtkBilateralSoftShadowPass* self);
};

//------------------------------------------------------------------------------
vtkBilateralSoftShadowPass::vtkBilateralSoftShadowPass()
  : Impl(new Internals)
{
  this->Impl->AdaptiveShader.SetDefinitions({ { "BILATERAL_ADAPTIVE", "1" } });
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
  EmitterSamples& emitter = this->Impl->Emitters[std::make_pair(context.Light, context.Part)];
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
  {
    const ScopedTarget target(context.Window->GetState());
    if (!this->DrawMean(context) || (this->Filter == ADAPTIVE && !this->DrawTiles(context)))
    {
      return;
    }
  }
  this->BeginStep("bilateral filter");
  this->DrawSteps(context);
  this->BeginStep("visibility");
}

//------------------------------------------------------------------------------
bool vtkBilateralSoftShadowPass::DrawMean(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  EmitterSamples& emitter = *impl.Current;
  const size_t layers =
    static_cast<size_t>(vtkShadowTextureArray::GetMaximumLayers(context.Window));
  const size_t batch = std::min(this->GetMapsPerBatch(), layers);
  const size_t count = emitter.Samples.Views.size();
  bool isFirst = true;
  if (!impl.Screen.Begin(context.Window, Screen::MEAN, context.Receivers->GetWidth(),
        context.Receivers->GetHeight(), context.Marks))
  {
    return false;
  }
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
  std::vector<float> depths;
  for (size_t i = first; i < last; ++i)
  {
    weights.push_back(samples.Weights[i] / static_cast<float>(context.Emitter.Weight));
    for (const double number : samples.Views[i].GetDepthToLinear())
    {
      depths.push_back(static_cast<float>(number));
    }
  }
  vtkSoftShadowPass::SetSampleUniforms(program, context, samples.Views.data() + first,
    weights.data(), last - first, layer, self->MapSize, 1);
  if (last > first)
  {
    program->SetUniform2fv("depthToLinears", static_cast<int>(last - first),
      reinterpret_cast<float(*)[2]>(depths.data()));
  }
  program->SetUniformi("mapDirectional", context.Emitter.Directional ? 1 : 0);
  // The texture starts at -1, no value.
  program->SetUniformf("base", isFirst ? 1.0f : 0.0f);
  program->SetUniformf(
    "litWeight", isFirst ? samples.LitWeight / static_cast<float>(context.Emitter.Weight) : 0.0f);
  vtkShadowTextureArray* texture = this->Current->Maps->GetTexture();
  program->SetUniformi("depthMaps", texture->Activate(context.Window));
  self->DrawFiltered(this->MeanShader);
  texture->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
bool vtkBilateralSoftShadowPass::DrawTiles(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  const int size = Internals::GetTileSize(this);
  vtkOpenGLState* state = context.Window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  if (!impl.TilesShader.Use(context.Window) ||
    !impl.Screen.Begin(context.Window, Screen::TILES,
      (context.Receivers->GetWidth() + size - 1) / size,
      (context.Receivers->GetHeight() + size - 1) / size, 0))
  {
    return false;
  }
  vtkShaderProgram* program = impl.TilesShader.GetProgram();
  program->SetUniformi("tileSize", size);
  vtkShadowTextureArray* source = impl.Screen.GetTexture(Screen::MEAN);
  program->SetUniformi("source", source->Activate());
  impl.TilesShader.Draw();
  source->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
std::vector<Step> vtkBilateralSoftShadowPass::Internals::PlanSteps(
  const vtkBilateralSoftShadowPass* self)
{
  std::vector<Step> steps;
  const int half = self->FilterWidth / 2;
  if (self->Filter == NONE || self->Filter == FULL)
  {
    Step step;
    step.HalfTaps = step.HalfRows = self->Filter == FULL ? half : 0;
    steps.push_back(step);
    return steps;
  }
  const int iterations = self->Filter == ATROUS ? self->Iterations : 1;
  for (int i = 0; i < iterations; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      Step step;
      step.Edge = self->SecondAxisFirst ? 1 - k : k;
      step.Tap[step.Edge] = 1 << i;
      step.Tap[1 - step.Edge] = 0;
      step.HalfTaps = half;
      steps.push_back(step);
    }
  }
  return steps;
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::DrawSteps(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  vtkShadowShader& shader = this->Filter == ADAPTIVE ? impl.AdaptiveShader : impl.FilterShader;
  const std::vector<Step> steps = Internals::PlanSteps(this);
  Screen::TextureName source = Screen::MEAN;
  for (size_t i = 0; i < steps.size() && shader.Use(context.Window); ++i)
  {
    const bool isLast = i + 1 == steps.size();
    vtkShaderProgram* program = shader.GetProgram();
    this->SetReceiverUniforms(program, context);
    program->SetUniformi("firstStep", i == 0 ? 1 : 0);
    program->SetUniformi("lastStep", isLast ? 1 : 0);
    program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
    program->SetUniformf("rangeDeviation", static_cast<float>(this->RangeDeviation));
    if (this->Filter == ADAPTIVE)
    {
      impl.SetAdaptiveUniforms(program, context, steps[i], this);
    }
    else
    {
      program->SetUniform2i("stepAxis", steps[i].Tap);
      program->SetUniform2i("rowAxis", steps[i].Row);
      program->SetUniformi("halfTaps", steps[i].HalfTaps);
      program->SetUniformi("halfRows", steps[i].HalfRows);
      program->SetUniformf("domainDeviation", static_cast<float>(this->DomainDeviation));
    }
    vtkShadowTextureArray* texture = impl.Screen.GetTexture(source);
    vtkShadowTextureArray* tiles = impl.Screen.GetTexture(Screen::TILES);
    program->SetUniformi("source", texture->Activate());
    if (this->Filter == ADAPTIVE)
    {
      program->SetUniformi("tiles", tiles->Activate());
    }
    if (isLast)
    {
      shader.Draw();
    }
    else
    {
      const ScopedTarget target(context.Window->GetState());
      context.Window->GetState()->vtkglDisable(GL_BLEND);
      const Screen::TextureName next = source == Screen::BLURRED ? Screen::AGAIN : Screen::BLURRED;
      if (impl.Screen.Begin(context.Window, next, context.Receivers->GetWidth(),
            context.Receivers->GetHeight(), context.Marks))
      {
        shader.Draw();
      }
      source = next;
    }
    tiles->Deactivate();
    texture->Deactivate();
    context.Receivers->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::Internals::SetAdaptiveUniforms(vtkShaderProgram* program,
  const vtkSoftShadowContext& context, const Step& step, const vtkBilateralSoftShadowPass* self)
{
  const vtkShadowEmitter& emitter = context.Emitter;
  const ViewFrame frame(context.Receivers->GetViewToWorld());
  // Towards the emitter: its centre, or against the direction of its light.
  float direction[3];
  float light[3];
  float axes[2][3];
  frame.Transform(emitter.Direction.data(), 0.0, direction);
  if (emitter.Directional)
  {
    std::transform(direction, direction + 3, light, std::negate<>());
  }
  else
  {
    frame.Transform(emitter.Center.data(), 1.0, light);
  }
  double halfExtents[2][3];
  for (int i = 0; i < 3; ++i)
  {
    halfExtents[0][i] = emitter.HalfSize[0] * emitter.AxisU[i];
    halfExtents[1][i] = emitter.HalfSize[1] * emitter.AxisV[i];
  }
  frame.Transform(halfExtents[0], 0.0, axes[0]);
  frame.Transform(halfExtents[1], 0.0, axes[1]);
  double edge[3];
  const std::array<double, 2>& cell = this->Current->Cell[step.Edge];
  for (int i = 0; i < 3; ++i)
  {
    edge[i] = cell[0] * halfExtents[0][i] + cell[1] * halfExtents[1][i];
  }
  float axis[3];
  frame.Transform(edge, 0.0, axis);
  const vtkMatrix4x4* projection =
    context.Renderer->GetActiveCamera()->GetProjectionTransformMatrix(
      context.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  float viewToClip[16];
  for (int i = 0; i < 16; ++i)
  {
    viewToClip[4 * (i % 4) + i / 4] = static_cast<float>(projection->GetData()[i]);
  }
  program->SetUniformMatrix4x4("viewToClip", viewToClip);
  program->SetUniform3f("lightVs", light);
  program->SetUniformf("positional", emitter.Directional ? 0.0f : 1.0f);
  program->SetUniform3fv("lightAxesVs", 2, axes);
  const int shape = emitter.Shape == vtkShadowEmitter::DISK ? 1 : 0;
  program->SetUniformi("lightKind", self->HasGaussianWeights() || !emitter.HasExtent() ? 2 : shape);
  program->SetUniform3f("cellAxisVs", axis);
  program->SetUniformf("maximumWidth", static_cast<float>(self->MaximumWidth));
  program->SetUniformi("tileSize", Internals::GetTileSize(self));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkBilateralSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = this->Impl->Screen.GetBytes();
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
  const Internals& impl = *this->Impl;
  return impl.MeanShader.GetNumberOfBuilds() + impl.TilesShader.GetNumberOfBuilds() +
    impl.FilterShader.GetNumberOfBuilds() + impl.AdaptiveShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  for (vtkShadowShader* shader :
    { &impl.MeanShader, &impl.TilesShader, &impl.FilterShader, &impl.AdaptiveShader })
  {
    shader->ReleaseGraphicsResources(window);
  }
  impl.Screen.ReleaseGraphicsResources(window);
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
