// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What vtkBilateralSoftShadowPass holds, for its two sources: maps and their mean, and the filter.
 */

#ifndef vtkBilateralSoftShadowPassInternals_h
#define vtkBilateralSoftShadowPassInternals_h

#include "vtkBilateralScreen.h"
#include "vtkBilateralSoftShadowPass.h"
#include "vtkNew.h"
#include "vtkOpenGLState.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowShader.h"
#include "vtkSoftShadowsOpenGL.h"

#include <array>   // For cells
#include <map>     // For emitters
#include <utility> // For pairs
#include <vector>  // For steps

VTK_ABI_NAMESPACE_BEGIN
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

  Internals();

  std::map<std::pair<int, int>, EmitterSamples> Emitters; // by light and part
  EmitterSamples* Current = nullptr;
  vtkBilateralScreen Screen;
  vtkShadowShader MeanShader;
  vtkShadowShader TilesShader;
  vtkShadowShader FilterShader;
  vtkShadowShader AdaptiveShader;

  void DrawBatch(vtkBilateralSoftShadowPass* self, const vtkSoftShadowContext& context,
    size_t first, size_t last, size_t layer, bool isFirst);
  void SetAdaptiveUniforms(vtkShaderProgram* program, const vtkSoftShadowContext& context,
    const Step& step, const vtkBilateralSoftShadowPass* self);
  /// How far lit pixels look for a shadow: some more than most kernels reach.
  static int GetTileSize(const vtkBilateralSoftShadowPass* self)
  {
    return (self->MaximumWidth + 2) / 3;
  }
  static double GetRangeDeviation(const vtkBilateralSoftShadowPass* self);
  static std::vector<Step> PlanSteps(const vtkBilateralSoftShadowPass* self);
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkBilateralSoftShadowPassInternals.h
