// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One frame of a scene, off-screen, with soft shadows.
 */

#ifndef SceneFrame_h
#define SceneFrame_h

#include "SceneBuilder.h"
#include "VisibilityFile.h"

#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkSoftShadowPass.h"

#include <string>
#include <vector>

namespace softshadows
{

class SceneFrame
{
public:
  SceneFrame(const BuiltScene& scene, vtkSoftShadowPass* pass, int width, int height);
  ~SceneFrame();
  SceneFrame(const SceneFrame&) = delete;
  SceneFrame& operator=(const SceneFrame&) = delete;

  /// Throws std::runtime_error if there is no usable OpenGL.
  void Render();

  /**
   * Renders frames in progressive mode until the pass has converged to the tolerance or cannot any
   * more, at most so many.
   */
  void Converge(double tolerance, int frames);

  ///@{
  /// Of the last frame, top row first.
  std::vector<unsigned char> GetPicture() const; ///< RGB
  VisibilityImage GetVisibility() const;
  ///@}

  /// From the call of Render to the last pixel, in milliseconds.
  double GetMilliseconds() const { return this->Milliseconds; }

  /// Of OpenGL: what the driver calls itself, and its version.
  std::string GetDriver() const;

  vtkSoftShadowPass* GetPass() const { return this->Pass; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

private:
  BuiltScene Scene;
  vtkSmartPointer<vtkSoftShadowPass> Pass;
  vtkSmartPointer<vtkRenderWindow> Window;
  int Width;
  int Height;
  double Milliseconds = 0.0;
};

}

#endif
