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

#include "vtkOpenGLRenderWindow.h" // For the state
#include "vtkOpenGLState.h"        // For scopes
#include "vtkShadowScopedState.h"  // For what vtkOpenGLState does not know
#include "vtkShadowTextureUnit.h"  // For the unit
#include "vtkSoftShadowsABI.h"     // For the ABI namespace
#include "vtkSoftShadowsOpenGL.h"  // For constants

VTK_ABI_NAMESPACE_BEGIN

class vtkSoftShadowScopedState
{
public:
  explicit vtkSoftShadowScopedState(vtkOpenGLRenderWindow* window)
    : vtkSoftShadowScopedState(window->GetState())
  {
    this->FreeUnit = this->Unit.Reserve(window);
  }
  ~vtkSoftShadowScopedState()
  {
    this->Unit.Release();
    this->State->vtkglClearDepth(this->ClearDepth);
  }
  vtkSoftShadowScopedState(const vtkSoftShadowScopedState&) = delete;
  vtkSoftShadowScopedState& operator=(const vtkSoftShadowScopedState&) = delete;

  /// The unit; nothing is bound to it.
  int GetFreeUnit() const { return this->FreeUnit; }

private:
  explicit vtkSoftShadowScopedState(vtkOpenGLState* state)
    : State(state)
    , Raster(state)
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
  {
    glGetDoublev(GL_DEPTH_CLEAR_VALUE, &this->ClearDepth);
  }

  vtkOpenGLState* State;
  double ClearDepth = 1.0;
  vtkShadowScopedRaster Raster;
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
  vtkShadowTextureUnit Unit;
  int FreeUnit = 0;
};

VTK_ABI_NAMESPACE_END
#endif
