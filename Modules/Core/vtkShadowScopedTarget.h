// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowScopedTarget
 * @brief   Lets a step draw into a framebuffer of its own: puts back what was bound, and how.
 *
 * While one lives, framebuffer, viewport, blending, depth test and scissor test may be changed; it begins
 * without a scissor test.
 */

#ifndef vtkShadowScopedTarget_h
#define vtkShadowScopedTarget_h

#include "vtkOpenGLState.h"       // For scopes
#include "vtkSoftShadowsABI.h"    // For the ABI namespace
#include "vtkSoftShadowsOpenGL.h" // For names of states

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowScopedTarget
{
public:
  explicit vtkShadowScopedTarget(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , DepthFunction(state)
    , ScissorTest(state, GL_SCISSOR_TEST)
  {
    state->PushFramebufferBindings();
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
  ~vtkShadowScopedTarget() { this->State->PopFramebufferBindings(); }
  vtkShadowScopedTarget(const vtkShadowScopedTarget&) = delete;
  vtkShadowScopedTarget& operator=(const vtkShadowScopedTarget&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglDepthFunc DepthFunction;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowScopedTarget.h
