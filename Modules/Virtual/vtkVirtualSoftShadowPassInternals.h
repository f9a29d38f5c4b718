// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkVirtualSoftShadowPassInternals.h
 * @brief What vtkVirtualSoftShadowPass keeps from frame to frame; private to it.
 */

#ifndef vtkVirtualSoftShadowPassInternals_h
#define vtkVirtualSoftShadowPassInternals_h

#include "vtkOpenGLRenderWindow.h" // For the window that is used
#include "vtkOpenGLState.h"        // For scopes
#include "vtkShadowDepthMaps.h"    // For views
#include "vtkShadowShader.h"       // For members
#include "vtkSoftShadowsOpenGL.h"  // For names of states
#include "vtkVirtualBlocks.h"      // For members
#include "vtkVirtualGrid.h"        // For members
#include "vtkVirtualRequest.h"     // For members
#include "vtkVirtualScreen.h"      // For members
#include "vtkVirtualSoftShadowPass.h"
#include "vtkVirtualTileMaps.h" // For members
#include "vtkVirtualTileTree.h" // For members

#include <map>     // For emitters
#include <memory>  // For screens
#include <string>  // For shaders
#include <utility> // For keys
#include <vector>  // For lists

VTK_ABI_NAMESPACE_BEGIN

/// What is kept per light and part.
struct vtkVirtualEmitterState
{
  vtkVirtualTileMaps Maps;
  vtkVirtualTileTree Tree;
  vtkVirtualRequest Request;
  vtkShadowEmitter Emitter;
  vtkMTimeType CastersTime = 0;
  bool IsStatic = false; // nothing but the camera moved since the frame before
  bool IsShown = false;  // in the last frame that drew visibilities
  /// The screen that its kernels were drawn to, in which state; null before.
  vtkVirtualScreen* Screen = nullptr;
  vtkTypeInt64 ShapesState = -1;
  /// The last frame's tiles were planned by an older frame's request.
  bool IsLate = false;
};

class vtkVirtualSoftShadowPass::Internals
{
public:
  using Key = std::pair<int, int>; // light and part

  Internals();

  std::map<Key, vtkVirtualEmitterState> Emitters;
  vtkVirtualEmitterState* Current = nullptr; // of AddVisibility
  vtkTypeInt64 State = 0;                    // of all that a grid depends on; changes with it

  ///@{
  /// Of the emitters that are prepared before the first one is filtered.
  std::vector<vtkVirtualEmitterState*> Prepared;
  std::vector<vtkShadowMapView> PreparedViews;
  std::vector<std::unique_ptr<vtkVirtualScreen>> Screens;
  bool IsRequested = false; // their grids have been drawn in this frame
  ///@}
  vtkVirtualScreen Spare; // kernels of an emitter that was not prepared
  vtkVirtualScreen Sums;
  vtkVirtualGrid Grid;

  std::string ShapeText;
  std::string TileText;
  std::unique_ptr<vtkShadowShader> ShapeShader;
  std::unique_ptr<vtkVirtualBlocks> TileShader;
  std::unique_ptr<vtkShadowShader> ResolveShader;

  vtkTypeInt64 DrawCalls = 0;
  vtkTypeInt64 Waits = 0; // of this frame, of the CPU for grids
  vtkTypeInt64 Late = 0;  // emitters of this frame whose grid is not its own
  bool IsOwed = false;    // the picture is still late, data were asked for in between
  double Excess = 1.0;    // of late tiles, as of the newest request that told

  static const vtkShadowMapView& GetView(const vtkSoftShadowContext& context)
  {
    return context.Maps->GetViews()[context.Layer];
  }
  static int IsDisk(const vtkSoftShadowContext& context)
  {
    return context.Emitter.Shape == vtkShadowEmitter::DISK ? 1 : 0;
  }
  static void SetCamera(vtkShaderProgram* program, const vtkSoftShadowContext& context);
};

/// What steps of this technique change and the base class expects back.
struct vtkVirtualScopedTarget
{
  explicit vtkVirtualScopedTarget(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , ScissorTest(state, GL_SCISSOR_TEST)
  {
    state->PushFramebufferBindings();
  }
  ~vtkVirtualScopedTarget() { this->State->PopFramebufferBindings(); }
  vtkVirtualScopedTarget(const vtkVirtualScopedTarget&) = delete;
  void operator=(const vtkVirtualScopedTarget&) = delete;

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualSoftShadowPassInternals.h
