// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowScreenFilter.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowScopedTarget.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowContext.h"
#include "vtkSoftShadowScreen.h"

#include "vtkSoftShadowScreenFilterFS.h"
#include "vtkSoftShadowScreenTilesFS.h"

#include <algorithm>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Screen = vtkSoftShadowScreen;
using Settings = vtkSoftShadowScreenFilter::Settings;

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

// A vector of the emitter's window, whose half extents are 1, in the world.
std::array<double, 3> ExtentAlong(const vtkShadowEmitter& emitter, const double window[2])
{
  std::array<double, 3> extent;
  for (int i = 0; i < 3; ++i)
  {
    extent[i] = window[0] * emitter.HalfSize[0] * emitter.AxisU[i] +
      window[1] * emitter.HalfSize[1] * emitter.AxisV[i];
  }
  return extent;
}

// One step: its taps in pixels, or which edge of the cell it goes along.
struct Step
{
  int Edge = 0;
  int Tap[2] = { 1, 0 };
  int Row[2] = { 0, 1 };
  int HalfTaps = 0;
  int HalfRows = 0;
};

// How far lit pixels look for a shadow: some more than most kernels reach.
int GetTileSize(const Settings& settings)
{
  return (settings.MaximumWidth + 2) / 3;
}

std::vector<Step> PlanSteps(const Settings& settings)
{
  std::vector<Step> steps;
  if (settings.Domain == vtkSoftShadowScreenFilter::NONE ||
    settings.Domain == vtkSoftShadowScreenFilter::SQUARE)
  {
    Step step;
    step.HalfTaps = step.HalfRows =
      settings.Domain == vtkSoftShadowScreenFilter::SQUARE ? settings.HalfTaps : 0;
    steps.push_back(step);
    return steps;
  }
  const int iterations =
    settings.Domain == vtkSoftShadowScreenFilter::SEPARABLE ? settings.Iterations : 1;
  for (int i = 0; i < iterations; ++i)
  {
    for (int k = 0; k < 2; ++k)
    {
      Step step;
      step.Edge = settings.SecondAxisFirst ? 1 - k : k;
      step.Tap[step.Edge] = 1 << i;
      step.Tap[1 - step.Edge] = 0;
      step.HalfTaps = settings.HalfTaps;
      steps.push_back(step);
    }
  }
  return steps;
}

double CountTaps(const Step& step)
{
  return (2.0 * step.HalfTaps + 1.0) * (2.0 * step.HalfRows + 1.0);
}

void SetTapUniforms(vtkShaderProgram* program, const Settings& settings, const Step& step)
{
  program->SetUniform2i("stepAxis", step.Tap);
  program->SetUniform2i("rowAxis", step.Row);
  program->SetUniformi("halfTaps", step.HalfTaps);
  program->SetUniformi("halfRows", step.HalfRows);
  program->SetUniformf("domainDeviation", static_cast<float>(settings.DomainDeviation));
}

// The emitter in view coordinates, for the share of it in front of a plane and for how shadows move.
void SetLightUniforms(vtkShaderProgram* program, const vtkShadowEmitter& emitter,
  const ViewFrame& frame, bool weightedByPoints)
{
  // Towards the emitter: its centre, or against the direction of its light.
  float light[3];
  if (emitter.Directional)
  {
    frame.Transform(emitter.Direction.data(), 0.0, light);
    std::transform(light, light + 3, light, std::negate<>());
  }
  else
  {
    frame.Transform(emitter.Center.data(), 1.0, light);
  }
  const double windowAxes[2][2] = { { 1.0, 0.0 }, { 0.0, 1.0 } };
  float axes[2][3];
  for (int i = 0; i < 2; ++i)
  {
    frame.Transform(ExtentAlong(emitter, windowAxes[i]).data(), 0.0, axes[i]);
  }
  program->SetUniform3f("lightVs", light);
  program->SetUniformf("positional", emitter.Directional ? 0.0f : 1.0f);
  program->SetUniform3fv("lightAxesVs", 2, axes);
  const int shape = emitter.Shape == vtkShadowEmitter::DISK ? 1 : 0;
  program->SetUniformi("lightKind", weightedByPoints || !emitter.HasExtent() ? 2 : shape);
}

// One edge of each cell, and where the cells are.
void SetEdgeUniforms(vtkShaderProgram* program, const vtkShadowEmitter& emitter,
  const ViewFrame& frame, const std::vector<vtkSoftShadowScreenFilter::Cell>& all, int edge)
{
  float edges[vtkSoftShadowScreenFilter::MaximumNumberOfCells][3];
  float bandSteps[vtkSoftShadowScreenFilter::MaximumNumberOfCells];
  float fadeIns[vtkSoftShadowScreenFilter::MaximumNumberOfCells][2];
  float fadeOuts[vtkSoftShadowScreenFilter::MaximumNumberOfCells][2];
  const int cells = std::min(static_cast<int>(all.size()),
    static_cast<int>(vtkSoftShadowScreenFilter::MaximumNumberOfCells));
  for (int cell = 0; cell < cells; ++cell)
  {
    const vtkSoftShadowScreenFilter::Cell& at = all[cell];
    frame.Transform(ExtentAlong(emitter, at.Edges[edge].data()).data(), 0.0, edges[cell]);
    bandSteps[cell] = static_cast<float>(at.BandStep);
    for (int i = 0; i < 2; ++i)
    {
      fadeIns[cell][i] = static_cast<float>(at.FadeIn[i]);
      fadeOuts[cell][i] = static_cast<float>(at.FadeOut[i]);
    }
  }
  program->SetUniformi("cellCount", cells);
  program->SetUniform3fv("cellAxesVs", cells, edges);
  program->SetUniform1fv("bandSteps", cells, bandSteps);
  program->SetUniform2fv("fadeIns", cells, fadeIns);
  program->SetUniform2fv("fadeOuts", cells, fadeOuts);
}

void SetCellUniforms(vtkShaderProgram* program, const vtkSoftShadowContext& context,
  const Settings& settings, const Step& step)
{
  const ViewFrame frame(context.Receivers->GetViewToWorld());
  SetLightUniforms(program, context.Emitter, frame, settings.WeightedByPoints);
  SetEdgeUniforms(program, context.Emitter, frame, settings.Cells, step.Edge);
  const vtkMatrix4x4* projection =
    context.Renderer->GetActiveCamera()->GetProjectionTransformMatrix(
      context.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  float viewToClip[16];
  for (int i = 0; i < 16; ++i)
  {
    viewToClip[4 * (i % 4) + i / 4] = static_cast<float>(projection->GetData()[i]);
  }
  program->SetUniformMatrix4x4("viewToClip", viewToClip);
  program->SetUniformf("maximumWidth", static_cast<float>(settings.MaximumWidth));
  program->SetUniformi("tileSize", GetTileSize(settings));
}
} // namespace

//------------------------------------------------------------------------------
class vtkSoftShadowScreenFilter::Internals
{
public:
  Internals() { this->CellShader.SetDefinitions({ { "SOFT_SHADOW_CELL", "1" } }); }

  bool DrawTiles(const vtkSoftShadowContext& context, const Settings& settings);
  void DrawStep(const vtkSoftShadowContext& context, const Settings& settings, const Step& step,
    Screen::TextureName& source, bool isLast);

  Screen Textures;
  vtkShadowShader TilesShader{ vtkSoftShadowScreenTilesFS };
  vtkShadowShader TapsShader{ vtkSoftShadowScreenFilterFS };
  vtkShadowShader CellShader{ vtkSoftShadowScreenFilterFS };
  std::unique_ptr<vtkShadowScopedTarget> SumsTarget; // between BeginSums and EndSums
};

//------------------------------------------------------------------------------
vtkSoftShadowScreenFilter::vtkSoftShadowScreenFilter()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSoftShadowScreenFilter::~vtkSoftShadowScreenFilter() = default;

//------------------------------------------------------------------------------
bool vtkSoftShadowScreenFilter::BeginSums(const vtkSoftShadowContext& context)
{
  const bool isKept = this->Impl->Textures.Copy(
    context.Window, context.Receivers->GetWidth(), context.Receivers->GetHeight());
  this->Impl->SumsTarget = std::make_unique<vtkShadowScopedTarget>(context.Window->GetState());
  if (isKept &&
    this->Impl->Textures.Begin(context.Window, Screen::SUMS, context.Receivers->GetWidth(),
      context.Receivers->GetHeight(), context.Marks))
  {
    return true;
  }
  this->EndSums();
  return false;
}

//------------------------------------------------------------------------------
void vtkSoftShadowScreenFilter::EndSums()
{
  this->Impl->SumsTarget.reset();
}

//------------------------------------------------------------------------------
void vtkSoftShadowScreenFilter::Draw(const vtkSoftShadowContext& context, const Settings& settings)
{
  if (settings.Domain == CELL && !this->Impl->DrawTiles(context, settings))
  {
    return;
  }
  const std::vector<Step> steps = PlanSteps(settings);
  Screen::TextureName source = Screen::SUMS;
  for (size_t i = 0; i < steps.size(); ++i)
  {
    this->Impl->DrawStep(context, settings, steps[i], source, i + 1 == steps.size());
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowScreenFilter::Internals::DrawTiles(
  const vtkSoftShadowContext& context, const Settings& settings)
{
  const int size = GetTileSize(settings);
  vtkOpenGLState* state = context.Window->GetState();
  const vtkShadowScopedTarget target(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  if (!this->TilesShader.Use(context.Window) ||
    !this->Textures.Begin(context.Window, Screen::TILES,
      (context.Receivers->GetWidth() + size - 1) / size,
      (context.Receivers->GetHeight() + size - 1) / size, 0))
  {
    return false;
  }
  vtkShaderProgram* program = this->TilesShader.GetProgram();
  program->SetUniformi("tileSize", size);
  vtkShadowTextureArray* source = this->Textures.GetTexture(Screen::SUMS);
  vtkShadowTextureArray* known = this->Textures.GetTexture(Screen::KNOWN);
  program->SetUniformi("source", source->Activate());
  program->SetUniformi("known", known->Activate());
  this->TilesShader.Draw();
  known->Deactivate();
  source->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowScreenFilter::Internals::DrawStep(const vtkSoftShadowContext& context,
  const Settings& settings, const Step& step, Screen::TextureName& source, bool isLast)
{
  const bool isCell = settings.Domain == CELL;
  vtkShadowShader& shader = isCell ? this->CellShader : this->TapsShader;
  if (!shader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = shader.GetProgram();
  context.Receivers->Activate(program);
  program->SetUniformi("firstStep", source == Screen::SUMS ? 1 : 0);
  program->SetUniformi("lastStep", isLast ? 1 : 0);
  program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
  program->SetUniformf("rangeDeviation", static_cast<float>(settings.RangeDeviation));
  if (isCell)
  {
    SetCellUniforms(program, context, settings, step);
  }
  else
  {
    SetTapUniforms(program, settings, step);
  }
  vtkShadowTextureArray* texture = this->Textures.GetTexture(source);
  vtkShadowTextureArray* tiles = this->Textures.GetTexture(Screen::TILES);
  vtkShadowTextureArray* known = this->Textures.GetTexture(Screen::KNOWN);
  program->SetUniformi("source", texture->Activate());
  program->SetUniformi("known", known->Activate());
  if (isCell)
  {
    program->SetUniformi("tiles", tiles->Activate());
  }
  const double taps = isCell ? settings.MaximumWidth : CountTaps(step);
  if (isLast)
  {
    shader.Draw(taps);
  }
  else
  {
    const vtkShadowScopedTarget target(context.Window->GetState());
    context.Window->GetState()->vtkglDisable(GL_BLEND);
    const Screen::TextureName next = source == Screen::BLURRED ? Screen::AGAIN : Screen::BLURRED;
    if (this->Textures.Begin(context.Window, next, context.Receivers->GetWidth(),
          context.Receivers->GetHeight(), context.Marks))
    {
      shader.Draw(taps);
    }
    source = next;
  }
  tiles->Deactivate();
  known->Deactivate();
  texture->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowScreenFilter::GetBytes() const
{
  return this->Impl->Textures.GetBytes();
}

//------------------------------------------------------------------------------
int vtkSoftShadowScreenFilter::GetNumberOfShaderBuilds() const
{
  return this->Impl->TilesShader.GetNumberOfBuilds() + this->Impl->TapsShader.GetNumberOfBuilds() +
    this->Impl->CellShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkSoftShadowScreenFilter::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkShadowShader* shader :
    { &this->Impl->TilesShader, &this->Impl->TapsShader, &this->Impl->CellShader })
  {
    shader->ReleaseGraphicsResources(window);
  }
  this->Impl->Textures.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
