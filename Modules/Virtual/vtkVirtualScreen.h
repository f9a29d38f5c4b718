// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualScreen
 * @brief   Textures of the screen's size: kernel shapes and predictions, or sums over tiles.
 *
 * An emitter's kernels are kept from the step that draws them to the one that filters; the sums serve
 * one emitter after the other.
 */

#ifndef vtkVirtualScreen_h
#define vtkVirtualScreen_h

#include "vtkNew.h"                               // For members
#include "vtkRenderingSoftShadowsVirtualModule.h" // For export macro
#include "vtkShadowFramebuffer.h"                 // For members
#include "vtkSoftShadowsABI.h"                    // For the ABI namespace
#include "vtkType.h"                              // For bytes

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkShadowTextureArray;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSVIRTUAL_EXPORT vtkVirtualScreen
{
public:
  enum TextureName
  {
    SHAPES = 0,      // RGBA32F: variance (ss, st, tt) of the kernel in (s, t); StateType
    PREDICTIONS = 1, // RGBA32F: (s, t) of the receiver, wanted texel sizes along s and t
    SUMS = 2,        // RGBA32F: V A, A, and the area under tiles, in squares of (s, t)
    NUMBER_OF_TEXTURES = 3
  };

  /// To which the share of the light in front of the receiver's plane is added, in [0, 1].
  enum StateType
  {
    UNSERVED = 0, // not for this emitter
    LIT = 2,      // nothing blocks but the plane itself
    PENUMBRA = 4  // to be filtered
  };

  vtkVirtualScreen();
  ~vtkVirtualScreen();
  vtkVirtualScreen(const vtkVirtualScreen&) = delete;
  vtkVirtualScreen& operator=(const vtkVirtualScreen&) = delete;

  ///@{
  /// Shapes and predictions, or the sums. False, with an error, if the textures cannot be had.
  bool AllocateShapes(vtkOpenGLRenderWindow* window, int width, int height);
  bool AllocateSums(vtkOpenGLRenderWindow* window, int width, int height);
  ///@}

  /// What AllocateShapes takes.
  static vtkTypeInt64 CountShapeBytes(int width, int height);

  ///@{
  /**
   * Binds for drawing: shapes and predictions, or the cleared sums with additive blending. Neither
   * depth test nor scissor. The caller restores framebuffer and state.
   */
  bool BeginShapes(vtkOpenGLRenderWindow* window);
  bool BeginSums(vtkOpenGLRenderWindow* window);
  ///@}

  ///@{
  /// Binds a texture and sets the sampler of that name, if the program has it; needs Deactivate.
  void Activate(vtkShaderProgram* program, TextureName texture);
  void Deactivate();
  ///@}

  vtkShadowTextureArray* GetTexture(TextureName texture) { return this->Textures[texture]; }

  vtkTypeInt64 GetBytes() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Bind(vtkOpenGLRenderWindow* window, TextureName first);

  vtkNew<vtkShadowTextureArray> Textures[NUMBER_OF_TEXTURES];
  vtkShadowFramebuffer Framebuffer;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualScreen.h
