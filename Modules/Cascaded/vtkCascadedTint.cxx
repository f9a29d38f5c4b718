// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedTint.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowScopedState.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkCascadedTintFS.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int MaximumCount = 4;     // of cascades, as in the shader
constexpr int MaximumEmitters = 32; // as in the shader; further ones tint nothing
} // namespace

//------------------------------------------------------------------------------
vtkCascadedTint::vtkCascadedTint()
  : Shader(vtkCascadedTintFS)
{
}

//------------------------------------------------------------------------------
void vtkCascadedTint::Draw(vtkOpenGLRenderWindow* window, vtkShadowReceivers* receivers,
  const std::vector<std::vector<vtkShadowCascades::Cascade>>& emitters)
{
  if (emitters.empty() || !this->Shader.Use(window))
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkShadowScopedRaster raster(state);
  const vtkOpenGLState::ScopedglActiveTexture activeTexture(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ZERO, GL_SRC_COLOR);
  vtkShaderProgram* program = this->Shader.GetProgram();
  std::vector<float> fades;
  std::vector<int> counts;
  for (size_t e = 0; e < std::min<size_t>(emitters.size(), MaximumEmitters); ++e)
  {
    counts.push_back(static_cast<int>(emitters[e].size()));
    for (int i = 0; i < MaximumCount; ++i)
    {
      const vtkShadowCascades::Cascade cascade =
        i < counts.back() ? emitters[e][i] : vtkShadowCascades::Cascade();
      for (const double depth : { cascade.FadeIn.first, cascade.FadeIn.second,
             cascade.FadeOut.first, cascade.FadeOut.second })
      {
        fades.push_back(static_cast<float>(depth));
      }
    }
  }
  const auto count = static_cast<int>(counts.size());
  program->SetUniform4fv(
    "fades", MaximumCount * count, reinterpret_cast<const float(*)[4]>(fades.data()));
  program->SetUniform1iv("cascadeCounts", count, counts.data());
  program->SetUniformi("emitterCount", count);
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  program->SetUniform2f("origin", origin);
  receivers->Activate(program);
  this->Shader.Draw();
  receivers->Deactivate();
}
VTK_ABI_NAMESPACE_END
