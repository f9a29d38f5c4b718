// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowTextureUnit
 * @brief   A texture unit that a texture is bound to for a while.
 *
 * It is one of VTK's, or where an application has taken all of these one beyond, which OpenGL allows as
 * long as no program reads too many.
 */

#ifndef vtkShadowTextureUnit_h
#define vtkShadowTextureUnit_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowTextureUnit
{
public:
  vtkShadowTextureUnit() = default;
  ~vtkShadowTextureUnit() = default;
  vtkShadowTextureUnit(const vtkShadowTextureUnit&) = delete;
  vtkShadowTextureUnit& operator=(const vtkShadowTextureUnit&) = delete;

  /**
   * Takes a unit, binds the texture to it and returns it, for a sampler. Where none is left it tells
   * vtkShadowFailures, binds nothing and returns a unit that a sampler may be set to, but not read.
   */
  int Bind(vtkOpenGLRenderWindow* window, unsigned int target, unsigned int texture);

  /// Takes a unit and leaves it empty.
  int Reserve(vtkOpenGLRenderWindow* window);

  /// Unbinds the texture and gives the unit back, if there is one.
  void Release();

  /// Whether VTK has one left: it takes one of its own for a moment whenever it makes a texture.
  static bool IsAnyLeft(vtkOpenGLRenderWindow* window);

  bool IsBound() const { return this->Unit >= 0; }

private:
  vtkOpenGLRenderWindow* Window = nullptr; // not owned
  unsigned int Target = 0;                 // 0: nothing is bound
  int Unit = -1;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowTextureUnit.h
