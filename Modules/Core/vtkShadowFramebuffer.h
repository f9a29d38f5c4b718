// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowFramebuffer
 * @brief   A framebuffer object for layers of array textures.
 *
 *     framebuffer.Bind(window);
 *     texture->AttachLayer(0);
 *     framebuffer.SetDrawBuffers(window, 1);
 *     if (framebuffer.IsComplete()) ...
 *
 * Whoever binds it puts the bindings before back (vtkOpenGLState::PushFramebufferBindings).
 */

#ifndef vtkShadowFramebuffer_h
#define vtkShadowFramebuffer_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkShadowContextWatch.h"             // For members
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowFramebuffer
{
public:
  vtkShadowFramebuffer();
  ~vtkShadowFramebuffer();
  vtkShadowFramebuffer(const vtkShadowFramebuffer&) = delete;
  vtkShadowFramebuffer& operator=(const vtkShadowFramebuffer&) = delete;

  /// Binds it for drawing and reading, made if need be.
  void Bind(vtkOpenGLRenderWindow* window);

  /// Attaches a depth renderbuffer to the bound framebuffer; 0 for none.
  static void AttachDepthBuffer(unsigned int renderbuffer);

  /// Draws into the bound framebuffer's first colour attachments; 0 for none.
  static void SetDrawBuffers(vtkOpenGLRenderWindow* window, int count);

  /// Whether the bound framebuffer can be drawn into; tells vtkShadowFailures if not.
  static bool IsComplete();

  /// Deletes it; what was attached to it lives no longer than others need it.
  void Release() { this->Watch.Free(); }

private:
  unsigned int Handle = 0;
  vtkShadowContextWatch Watch;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowFramebuffer.h
