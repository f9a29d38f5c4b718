// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The shadow of a grid that runs to the horizon: antialiasing against supersampling of the screen.

#include "OffscreenWindow.h"
#include "Picture.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVirtualSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{
constexpr int Width = 60;
constexpr int Height = 40;

vtkSmartPointer<vtkRenderer> MakeGridScene()
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->AddActor(
    MakeQuadActor({ Quad{ { { -60, -60, 0 } }, { { 120, 0, 0 } }, { { 0, 120, 0 } } } }));
  std::vector<Quad> bars;
  for (int i = -30; i <= 30; ++i)
  {
    const double at = 0.5 * i - 0.06;
    bars.push_back({ { { at, -15, 6 } }, { { 0.12, 0, 0 } }, { { 0, 30, 0 } } });
    bars.push_back({ { { -15, at, 6 } }, { { 30, 0, 0 } }, { { 0, 0.12, 0 } } });
  }
  renderer->AddActor(MakeQuadActor(bars));
  vtkNew<vtkAreaLight> light;
  light->SetLightTypeToSceneLight();
  light->SetShapeToRectangle();
  light->SetPosition(1, 2, 30);
  light->SetFocalPoint(0, 0, 0);
  light->SetViewUp(0, 1, 0);
  light->SetSize(0.02, 0.02);
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(light);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, -24, 4.5);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(30);
  renderer->ResetCameraClippingRange();
  return renderer;
}

// The visibility of a window factor times as fine, averaged over factor x factor pixels.
Picture Draw(vtkRenderer* renderer, bool antialiasing, int factor)
{
  vtkNew<vtkVirtualSoftShadowPass> pass;
  pass->SetAdaptive(false);
  pass->SetMapSize(1024);
  pass->SetAntialiasing(antialiasing);
  OffscreenWindow window(Width * factor, Height * factor);
  window.Add(renderer);
  UsePass(renderer, pass);
  window.Render();
  const Picture fine = PictureOf(pass->GetVisibilityImage(0));
  pass->ReleaseGraphicsResources(window.Get());
  UsePass(renderer, nullptr);
  window.Remove(renderer);
  Picture picture(Width, Height, 1);
  for (int y = 0; y < fine.Height; ++y)
  {
    for (int x = 0; x < fine.Width; ++x)
    {
      picture.At(x / factor, y / factor) += fine.At(x, y) / static_cast<float>(factor * factor);
    }
  }
  return picture;
}

// Below the horizon, where all pixels show the floor.
double RootMeanSquare(const Picture& first, const Picture& second)
{
  double sum = 0.0;
  const int rows = Height / 2;
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const double error = first.At(x, y) - second.At(x, y);
      sum += error * error;
    }
  }
  return std::sqrt(sum / (rows * Width));
}
} // namespace

TEST(VirtualAntialiasing, IsBetterThanSupersamplingOfAHardShadow)
{
  const vtkSmartPointer<vtkRenderer> renderer = MakeGridScene();
  const Picture reference = Draw(renderer, false, 32);
  const double single = RootMeanSquare(Draw(renderer, false, 1), reference);
  const double supersampled = RootMeanSquare(Draw(renderer, false, 8), reference);
  const double antialiased = RootMeanSquare(Draw(renderer, true, 1), reference);
  RecordProperty("Single", std::to_string(single));
  RecordProperty("Supersampled8", std::to_string(supersampled));
  RecordProperty("Antialiased", std::to_string(antialiased));
  EXPECT_GT(single, 0.1) << "nothing to smooth";
  EXPECT_LT(antialiased, supersampled);
  EXPECT_LT(antialiased, 0.02);
}
