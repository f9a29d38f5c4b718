// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CascadedStage.h
 * @brief A window that shows scenes through the cascaded pass, and a scene with shadows in all depths.
 */

#ifndef CascadedStage_h
#define CascadedStage_h

#include "OffscreenWindow.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCascadedSoftShadowPass.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <cmath>
#include <vector>

namespace SoftShadowsTesting
{
constexpr int Width = 200;
constexpr int Height = 150;

// A window that shows a renderer through the pass; releases it before the window goes.
class Stage
{
public:
  explicit Stage(vtkRenderer* renderer, int width = Width, int height = Height)
    : Window(width, height)
    , Renderer(renderer)
  {
    this->Window.Add(renderer);
    UsePass(renderer, this->Pass);
    this->Pass->SetMapSize(512);
    this->Pass->EarlyOutOff(); // the proofs' own map would be counted too
  }
  ~Stage()
  {
    UsePass(this->Renderer, nullptr);
    this->Pass->ReleaseGraphicsResources(this->Window.Get());
  }

  Picture Render()
  {
    this->Window.Render();
    return PictureOf(this->Pass->GetVisibilityImage(0));
  }
  Picture Read() { return this->Window.Read(); }

  OffscreenWindow Window;
  vtkNew<vtkCascadedSoftShadowPass> Pass;
  vtkRenderer* Renderer;
};

inline void AddQuad(
  vtkRenderer* renderer, const Point& origin, const Point& edge1, const Point& edge2)
{
  renderer->AddActor(MakeQuadActor({ { origin, edge1, edge2 } }));
}

// A sun over a ground that reaches far, and posts that stand on it: shadows in all cascades.
inline vtkSmartPointer<vtkRenderer> MakeAvenue(double sunDegrees)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -60, -10, 0 } }, { { 120, 0, 0 } }, { { 0, 170, 0 } });
  for (int i = 0; i < 30; ++i)
  {
    AddQuad(renderer, { { -2.0, 1.0 + 4.0 * i, 0 } }, { { 1.2, 0, 0 } }, { { 0, 0.3, 3.0 } });
    AddQuad(renderer, { { 2.0, 2.0 + 4.0 * i, 0 } }, { { 0.5, 0.4, 0 } }, { { 0, 0, 4.0 } });
  }
  vtkNew<vtkAreaLight> sun;
  sun->PositionalOff();
  sun->SetPosition(-3.0, -1.0, 5.0);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetAngularDiameter(sunDegrees);
  renderer->AddLight(sun);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.3, -8.0, 2.5);
  camera->SetFocalPoint(0.3, 20.0, 0.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(40.0);
  renderer->ResetCameraClippingRange();
  return renderer;
}

inline double RootMeanSquare(const std::vector<double>& errors)
{
  double sum = 0.0;
  for (const double error : errors)
  {
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(errors.size()));
}

}

#endif
