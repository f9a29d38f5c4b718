// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeparableTarget
 * @brief   A step before the last: textures of the viewport's size that a shader writes.
 */

#ifndef vtkSeparableTarget_h
#define vtkSeparableTarget_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowShader;
class vtkShadowTextureArray;
class vtkWindow;

class vtkSeparableTarget
{
public:
  vtkSeparableTarget() = default;
  ~vtkSeparableTarget() = default;
  vtkSeparableTarget(const vtkSeparableTarget&) = delete;
  vtkSeparableTarget& operator=(const vtkSeparableTarget&) = delete;

  struct Output
  {
    vtkShadowTextureArray* Texture; // null: this output of the shader is dropped
    float ClearValue;               // of all components
  };

  /**
   * Clears the outputs and draws the shader, whose program must be in use, into them. Only marked
   * pixels are touched if marks (see vtkSoftShadowContext::Marks) is not 0. The viewport must be
   * the textures' size. Framebuffers and state are restored.
   */
  void Draw(vtkOpenGLRenderWindow* window, vtkShadowShader& shader,
    const std::vector<Output>& outputs, unsigned int marks);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  unsigned int Framebuffer = 0;
};

VTK_ABI_NAMESPACE_END
#endif
