// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeparableTarget
 * @brief   A step before the last: textures of the viewport's size that a shader writes.
 */

#ifndef vtkSeparableTarget_h
#define vtkSeparableTarget_h

#include "vtkShadowFramebuffer.h" // For members
#include "vtkSoftShadowsABI.h"    // For the ABI namespace

#include <functional> // For a function
#include <vector>     // For lists

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

  /// Called before each part of the pixels is drawn: those that are filtered, or the proved ones.
  using PartSetter = std::function<void(bool proved)>;

  /**
   * Clears the outputs and draws the shader, whose program must be in use, into them: at the pixels
   * that are marked for the last step (see vtkSoftShadowContext::Marks), and, if setPart is given, at
   * all others after them. The viewport must be the textures' size. Framebuffers and state are
   * restored. By a pixel's taps the work is cut into several draws (vtkShadowBands).
   */
  void Draw(vtkOpenGLRenderWindow* window, vtkShadowShader& shader,
    const std::vector<Output>& outputs, unsigned int marks, double tapsPerPixel = 0.0,
    const PartSetter& setPart = PartSetter());

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Attach(
    vtkOpenGLRenderWindow* window, const std::vector<Output>& outputs, unsigned int marks);
  static void Detach(size_t outputs);

  vtkShadowFramebuffer Framebuffer;
};

VTK_ABI_NAMESPACE_END
#endif
