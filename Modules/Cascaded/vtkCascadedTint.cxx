// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedTint.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowReceivers.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkCascadedTintFS.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int MaximumCount = 4; // of cascades, as in the shader
} // namespace

//------------------------------------------------------------------------------
vtkCascadedTint::vtkCascadedTint()
  : Shader(vtkCascadedTintFS)
{
}

//------------------------------------------------------------------------------
void vtkCascadedTint::Draw(vtkOpenGLRenderWindow* window, vtkShadowReceivers* receivers,
  const std::vector<vtkShadowCascades::Cascade>& cascades)
{
  if (!this->Shader.Use(window))
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
  vtkShaderProgram* program = this->Shader.GetProgram();
  float fades[2][MaximumCount][2] = {};
  for (size_t i = 0; i < cascades.size(); ++i)
  {
    fades[0][i][0] = static_cast<float>(cascades[i].FadeIn.first);
    fades[0][i][1] = static_cast<float>(cascades[i].FadeIn.second);
    fades[1][i][0] = static_cast<float>(cascades[i].FadeOut.first);
    fades[1][i][1] = static_cast<float>(cascades[i].FadeOut.second);
  }
  program->SetUniform2fv("fadeIns", MaximumCount, fades[0]);
  program->SetUniform2fv("fadeOuts", MaximumCount, fades[1]);
  program->SetUniformi("cascadeCount", static_cast<int>(cascades.size()));
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  program->SetUniform2f("origin", origin);
  receivers->Activate(program);
  this->Shader.Draw();
  receivers->Deactivate();
}
VTK_ABI_NAMESPACE_END
