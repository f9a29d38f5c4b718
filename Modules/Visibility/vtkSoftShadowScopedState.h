// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowScopedState
 * @brief   Keeps the OpenGL state that maps, receivers and visibility change, and puts it back.
 *
 * While one lives, a texture unit is set aside that no texture of a mapper gets.
 */

#ifndef vtkSoftShadowScopedState_h
#define vtkSoftShadowScopedState_h

#include "vtkOpenGLState.h"        // For scopes
#include "vtkSoftShadowsABI.h"     // For the ABI namespace
#include "vtkSoftShadowsOpenGL.h"  // For constants
#include "vtkTextureUnitManager.h" // For the unit

VTK_ABI_NAMESPACE_BEGIN

class vtkSoftShadowScopedState
{
public:
  explicit vtkSoftShadowScopedState(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Scissor(state)
    , ClearColor(state)
    , ColorMask(state)
    , DepthMask(state)
    , DepthFunction(state)
    , BlendFunction(state)
    , ActiveTexture(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , FreeUnit(state->GetTextureUnitManager()->Allocate())
  {
    glGetDoublev(GL_DEPTH_CLEAR_VALUE, &this->ClearDepth);
  }
  ~vtkSoftShadowScopedState()
  {
    this->State->GetTextureUnitManager()->Free(this->FreeUnit);
    this->State->vtkglClearDepth(this->ClearDepth);
  }
  vtkSoftShadowScopedState(const vtkSoftShadowScopedState&) = delete;
  vtkSoftShadowScopedState& operator=(const vtkSoftShadowScopedState&) = delete;

  /// The unit; nothing is bound to it.
  int GetFreeUnit() const { return this->FreeUnit; }

private:
  vtkOpenGLState* State;
  double ClearDepth = 1.0;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunction;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunction;
  vtkOpenGLState::ScopedglActiveTexture ActiveTexture;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  int FreeUnit;
};

VTK_ABI_NAMESPACE_END
#endif
