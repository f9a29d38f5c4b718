// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The filter: tiles of the screen, the steps and their uniforms.
#include "vtkBilateralSoftShadowPass.h"

#include "vtkBilateralSoftShadowPassInternals.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <cmath>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Screen = vtkBilateralScreen;

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
std::vector<vtkBilateralSoftShadowPass::Internals::Step>
vtkBilateralSoftShadowPass::Internals::PlanSteps(const vtkBilateralSoftShadowPass* self)
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
// The more points, the smaller the steps between bands: what differs by more is a shadow's edge. The
// root of the root lies between what suits scenes (the root) and single ramps (none).
double vtkBilateralSoftShadowPass::Internals::GetRangeDeviation(
  const vtkBilateralSoftShadowPass* self)
{
  constexpr double Points = 3.0;
  const double share = self->Filter == ADAPTIVE ? Points / self->NumberOfSamples : 1.0;
  return self->RangeDeviation * std::sqrt(std::sqrt(std::min(share, 1.0)));
}

//------------------------------------------------------------------------------
void vtkBilateralSoftShadowPass::DrawSteps(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  vtkShadowShader& shader = this->Filter == ADAPTIVE ? impl.AdaptiveShader : impl.FilterShader;
  const std::vector<Internals::Step> steps = Internals::PlanSteps(this);
  Screen::TextureName source = Screen::MEAN;
  for (size_t i = 0; i < steps.size() && shader.Use(context.Window); ++i)
  {
    const bool isLast = i + 1 == steps.size();
    vtkShaderProgram* program = shader.GetProgram();
    this->SetReceiverUniforms(program, context);
    program->SetUniformi("firstStep", i == 0 ? 1 : 0);
    program->SetUniformi("lastStep", isLast ? 1 : 0);
    program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
    program->SetUniformf("rangeDeviation", static_cast<float>(Internals::GetRangeDeviation(this)));
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
      const Internals::ScopedTarget target(context.Window->GetState());
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

VTK_ABI_NAMESPACE_END
