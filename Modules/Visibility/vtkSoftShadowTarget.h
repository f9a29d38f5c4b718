// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowTarget
 * @brief   Where visibility is accumulated: a layer per light, and the depth buffer that marks
 * pixels.
 *
 * Every layer starts at -1, no value. An emitter's pixels are marked in the depth buffer: 1 where a
 * technique has to add its part, 0 elsewhere. Techniques draw at depth 0.5 with the test LESS,
 * blending additively.
 */

#ifndef vtkSoftShadowTarget_h
#define vtkSoftShadowTarget_h

#include "vtkNew.h"               // For members
#include "vtkShadowFramebuffer.h" // For members
#include "vtkSoftShadowsABI.h"    // For the ABI namespace
#include "vtkType.h"              // For vtkTypeInt64

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowTextureArray;
class vtkWindow;

class vtkSoftShadowTarget
{
public:
  vtkSoftShadowTarget();
  ~vtkSoftShadowTarget();
  vtkSoftShadowTarget(const vtkSoftShadowTarget&) = delete;
  vtkSoftShadowTarget& operator=(const vtkSoftShadowTarget&) = delete;

  /**
   * Returns the number of allocations, -1 if there is no memory. The number of layers only grows.
   */
  int Allocate(vtkOpenGLRenderWindow* window, int width, int height, int layers);

  /// Binds the framebuffer with a light's layer and clears it to no value. False if it has none.
  bool BeginLight(vtkOpenGLRenderWindow* window, int layer);

  /// Clears the marks and lets them be drawn.
  void BeginMarks(vtkOpenGLRenderWindow* window);

  /// Lets techniques add to marked pixels.
  void BeginFilter(vtkOpenGLRenderWindow* window);

  vtkShadowTextureArray* GetTexture() { return this->Texture; }
  /// The OpenGL name of the depth renderbuffer that holds the marks.
  unsigned int GetMarks() const { return this->DepthBuffer; }
  vtkTypeInt64 GetBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkShadowTextureArray> Texture;
  vtkShadowFramebuffer Framebuffer;
  unsigned int DepthBuffer = 0;

  bool AllocateMarks(int width, int height);
};

VTK_ABI_NAMESPACE_END
#endif
