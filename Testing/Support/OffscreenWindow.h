// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OffscreenWindow.h
 * @brief A window without a screen, without multisampling, of an exact size.
 */

#ifndef SoftShadowsTesting_OffscreenWindow_h
#define SoftShadowsTesting_OffscreenWindow_h

#include "Picture.h"

#include "vtkRenderWindow.h" // For the window
#include "vtkSmartPointer.h" // For the window

class vtkOpenGLRenderWindow;
class vtkRenderPass;
class vtkRenderer;

namespace SoftShadowsTesting
{

class OffscreenWindow
{
public:
  /// Throws std::runtime_error if there is no display: VTK would end the whole program instead.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();

  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  vtkRenderWindow* Get() { return this->Window; }
  vtkOpenGLRenderWindow* GetOpenGL();

  void Add(vtkRenderer* renderer);
  void Remove(vtkRenderer* renderer);
  void Resize(int width, int height);
  void Render();

  /// What the last Render drew: RGB.
  Picture Read();

private:
  vtkSmartPointer<vtkRenderWindow> Window;
};

/// Makes the pass the opaque step of VTK's own frame; null takes the renderer's pass away.
void UsePass(vtkRenderer* renderer, vtkRenderPass* opaquePass);

}

#endif
