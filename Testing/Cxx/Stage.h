// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stage.h
 * @brief A renderer in an off-screen window, drawn by a soft-shadow pass, and what came of it.
 */

#ifndef SoftShadowsTesting_Stage_h
#define SoftShadowsTesting_Stage_h

#include "OffscreenWindow.h"
#include "Picture.h"

#include "vtkSmartPointer.h" // For members

class vtkLight;
class vtkRenderer;
class vtkSoftShadowPass;

namespace SoftShadowsTesting
{

class Stage
{
public:
  /// A null pass is VTK's own frame.
  Stage(vtkRenderer* renderer, vtkSoftShadowPass* pass, int width = 160, int height = 120);
  ~Stage();

  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void Render();

  /// Renders, and returns the light's visibility: one channel, NaN where there is no value.
  Picture RenderVisibility(vtkLight* light);

  /// Renders, and returns the colours: three channels.
  Picture RenderColors();

  OffscreenWindow& GetWindow() { return this->Window; }
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkSoftShadowPass* GetPass() { return this->Pass; }

  /// Exchanges the pass, as an application does that lets its user choose.
  void SetPass(vtkSoftShadowPass* pass);

private:
  OffscreenWindow Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkSoftShadowPass> Pass;
};

/// Pixels whose visibility is below 0.5: the area of a shadow in the picture.
int CountShadowed(const Picture& visibility);

/// Pixels that have no visibility.
int CountWithoutValue(const Picture& visibility);

}

#endif
