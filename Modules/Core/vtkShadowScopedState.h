// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkShadowScopedState.h
 * @brief   OpenGL state that vtkOpenGLState does not know: while one of these lives it is OpenGL's
 * default, whatever an application left; afterwards it is again what it was.
 */

#ifndef vtkShadowScopedState_h
#define vtkShadowScopedState_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <array> // For values

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLState;

/// How triangles become pixels: filled, the front counterclockwise, without stencil and offset, added by
/// blending.
class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowScopedRaster
{
public:
  explicit vtkShadowScopedRaster(vtkOpenGLState* state);
  ~vtkShadowScopedRaster();
  vtkShadowScopedRaster(const vtkShadowScopedRaster&) = delete;
  vtkShadowScopedRaster& operator=(const vtkShadowScopedRaster&) = delete;

private:
  vtkOpenGLState* State;
  int PolygonMode[2] = { 0, 0 };
  int FrontFace = 0;
  bool HadStencil = false;
  bool HadPolygonOffset = false;
  int BlendEquations[2] = { 0, 0 };
};

/// How pixels lie in memory: in rows one behind the other, and not in a buffer of OpenGL's.
class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowScopedPixelStore
{
public:
  vtkShadowScopedPixelStore();
  ~vtkShadowScopedPixelStore();
  vtkShadowScopedPixelStore(const vtkShadowScopedPixelStore&) = delete;
  vtkShadowScopedPixelStore& operator=(const vtkShadowScopedPixelStore&) = delete;

private:
  std::array<int, 14> Values;
  int PackBuffer = 0;
  int UnpackBuffer = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowScopedState.h
