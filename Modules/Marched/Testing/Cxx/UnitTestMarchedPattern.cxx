// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The pattern of rays and its filter: no bands, nothing over edges, the same in every frame.
#include "OffscreenWindow.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMarchedSoftShadowPass.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace SoftShadowsTesting;

namespace
{
constexpr int Width = 160;
constexpr int Height = 48;
constexpr double LightSize = 0.5;

// A window that shows a renderer through the pass; releases it before the window goes.
class Stage
{
public:
  explicit Stage(vtkRenderer* renderer)
    : Window(Width, Height)
    , Renderer(renderer)
  {
    this->Window.Add(renderer);
    UsePass(renderer, this->Pass);
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

  OffscreenWindow Window;
  vtkNew<vtkMarchedSoftShadowPass> Pass;
  vtkRenderer* Renderer;
};

// A square light at height 2 that shines down, and a parallel camera that looks along direction at the
// origin: pixels are pixelSize wide, rows go along x as far as they can.
vtkSmartPointer<vtkRenderer> MakeRenderer(double lightX, const Point& direction, double pixelSize)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  vtkNew<vtkAreaLight> light;
  light->SetConeAngle(80.0);
  light->SetPosition(lightX, 0.0, 2.0);
  light->SetFocalPoint(lightX, 0.0, 0.0);
  light->SetShapeToRectangle();
  light->SetSize(LightSize, LightSize);
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(light);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(-4.0 * direction[0], -4.0 * direction[1], -4.0 * direction[2]);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * Height * pixelSize);
  return renderer;
}

void AddQuad(vtkRenderer* renderer, const Point& origin, const Point& edge1, const Point& edge2)
{
  renderer->AddActor(MakeQuadActor({ { origin, edge1, edge2 } }));
}

// A half plane half way between light and ground; its edge is turned by an angle against the light's.
// The penumbra is 108 pixels wide if it is not turned.
vtkSmartPointer<vtkRenderer> MakeRamp(double degrees)
{
  const double pixelSize = LightSize / 108.0 / std::sqrt(2.0);
  auto renderer = MakeRenderer(0.0, { { -1.0, 0.0, -1.0 } }, pixelSize);
  AddQuad(renderer, { { -3.0, -3.0, 0.0 } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } });
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  AddQuad(renderer, { { 2.0 * s, -2.0 * c, 1.0 } }, { { -4.0 * s, 4.0 * c, 0.0 } },
    { { -2.0 * c, -2.0 * s, 0.0 } });
  renderer->ResetCameraClippingRange();
  return renderer;
}

// Root mean square of the second differences along the rows.
double Banding(const Picture& picture)
{
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 1; x + 1 < picture.Width; ++x)
    {
      const double middle = picture.At(x, y);
      const double second = picture.At(x - 1, y) - 2.0 * middle + picture.At(x + 1, y);
      if (middle > 0.01 && middle < 0.99)
      {
        sum += second * second;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 4000);
  return std::sqrt(sum / std::max(count, 1));
}

class Turned : public testing::TestWithParam<double>
{
};
}

TEST_P(Turned, LeavesNoBands)
{
  Stage stage(MakeRamp(this->GetParam()));
  const double filtered = Banding(stage.Render());
  stage.Pass->SetPattern(1);
  const double unfiltered = Banding(stage.Render());
  RecordProperty("Banding", std::to_string(255.0 * filtered));
  RecordProperty("BandingUnfiltered", std::to_string(255.0 * unfiltered));
  EXPECT_LT(filtered, 1.0 / 255.0);
  EXPECT_GT(unfiltered, 2.0 / 255.0);
}

INSTANTIATE_TEST_SUITE_P(MarchedPattern, Turned, testing::Values(0.0, 20.0, 45.0));

// A plate hides the start of its own penumbra: beside its edge the ground has a visibility of 0.9.
TEST(MarchedPattern, StopsAtSilhouettes)
{
  const double lightX = 0.2;
  const double pixelSize = 0.002;
  auto renderer = MakeRenderer(lightX, { { 0.0, 0.0, -1.0 } }, pixelSize);
  AddQuad(renderer, { { -3.0, -3.0, 0.0 } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } });
  AddQuad(renderer, { { -2.0, -2.0, 1.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } });
  renderer->ResetCameraClippingRange();
  Stage stage(renderer);
  stage.Pass->EarlyOutOff(); // proved pixels are not filtered
  const Picture visibility = stage.Render();
  for (int y = 4; y < Height - 4; ++y)
  {
    for (int x = 4; x < Width - 4; ++x)
    {
      const double position = (x + 0.5 - 0.5 * Width) * pixelSize;
      const double truth =
        position < 0.0 ? 1.0 : std::min((position + lightX) / LightSize + 0.5, 1.0);
      ASSERT_NEAR(visibility.At(x, y), truth, position < 0.0 ? 1e-6 : 0.015) << x << ", " << y;
    }
  }
}

// A step seen along its edge: the light is all in front of the tread, nine tenths of it of the riser.
TEST(MarchedPattern, StopsAtCreases)
{
  auto renderer = MakeRenderer(0.2, { { -1.0, 0.0, -1.0 } }, 0.002);
  AddQuad(renderer, { { -2.0, -2.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } });
  AddQuad(renderer, { { 0.0, -2.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }, { { 0.0, 0.0, -1.0 } });
  renderer->ResetCameraClippingRange();
  Stage stage(renderer);
  stage.Pass->EarlyOutOff();
  const Picture visibility = stage.Render();
  for (int y = 4; y < Height - 4; ++y)
  {
    for (int x = 4; x < Width - 4; ++x)
    {
      const bool isTread = x < Width / 2;
      ASSERT_NEAR(visibility.At(x, y), isTread ? 1.0 : 0.9, isTread ? 1e-6 : 0.015)
        << x << ", " << y;
    }
  }
}

// Proved pixels are not drawn; the filter knows them all the same.
TEST(MarchedPattern, KnowsProvedPixels)
{
  Stage stage(MakeRamp(0.0));
  const Picture proved = stage.Render();
  stage.Pass->EarlyOutOff();
  const Picture all = stage.Render();
  double largest = 0.0;
  for (size_t i = 0; i < all.Values.size(); ++i)
  {
    largest = std::max(largest, std::abs(static_cast<double>(all.Values[i]) - proved.Values[i]));
  }
  EXPECT_LT(largest, 0.005);
}

TEST(MarchedPattern, IsTheSameInEveryFrame)
{
  Stage stage(MakeRamp(20.0));
  const Picture first = stage.Render();
  stage.Pass->SetRays(stage.Pass->GetRays() + 1);
  EXPECT_NE(first.Values, stage.Render().Values);
  stage.Pass->SetRays(stage.Pass->GetRays() - 1);
  EXPECT_EQ(first.Values, stage.Render().Values);
}
