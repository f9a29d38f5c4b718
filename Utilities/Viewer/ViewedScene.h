// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The renderer of the viewer's scene, kept as the ViewerState says.
 */

#ifndef ViewedScene_h
#define ViewedScene_h

#include "SceneBuilder.h"
#include "ViewerState.h"

#include "vtkNew.h"
#include "vtkRenderStepsPass.h"
#include "vtkSmartPointer.h"
#include "vtkSoftShadowPass.h"

#include <vector>

class vtkWindow;

namespace softshadows
{

class ViewedScene
{
public:
  /// Throws SceneError for models.
  ViewedScene(const ViewerState& state, ModelStore& models);
  ~ViewedScene();
  ViewedScene(const ViewedScene&) = delete;
  ViewedScene& operator=(const ViewedScene&) = delete;

  vtkRenderer* GetRenderer() const { return this->Built.Renderer; }
  vtkSoftShadowPass* GetPass() const { return this->Pass; }
  vtkAreaLight* GetLight(int place) const { return this->Built.Lights[place]; }
  int GetNumberOfLights() const { return static_cast<int>(this->Built.Lights.size()); }

  /**
   * Brings the renderer up to date. A pass is made only for another technique; the window frees
   * what the old one held.
   */
  void Update(const ViewerState& state, vtkWindow* window);

  /**
   * Opens the first camera's view until an image of another shape, width over height, shows all that
   * the scene's own image shows. Called once, before anything moves.
   */
  void OpenView(double aspect);

  ///@{
  /// The camera in the terms of a scene file, and back to where it began.
  CameraDescription GetCamera() const;
  void ResetCamera();
  ///@}

  /// Near and far planes that fit the view. Width over height of the image.
  void FitClipping(double aspect);

  /// Frees what is held in the window, which must still live.
  void Release(vtkWindow* window);

private:
  BuiltScene Built;
  CameraDescription FirstCamera;
  double FirstAspect;
  vtkSmartPointer<vtkSoftShadowPass> Pass;
  vtkNew<vtkRenderStepsPass> Steps;
  int TechniquePlace = -1;
};

}

#endif
