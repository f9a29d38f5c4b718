// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The pass on scenes: right values, nothing baked in vain, still shadows, no seams.
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

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
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

void AddQuad(vtkRenderer* renderer, const Point& origin, const Point& edge1, const Point& edge2)
{
  renderer->AddActor(MakeQuadActor({ origin, edge1, edge2 }));
}

// A sun over a ground that reaches far, and posts that stand on it: shadows in all cascades.
vtkSmartPointer<vtkRenderer> MakeAvenue(double sunDegrees)
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

double RootMeanSquare(const std::vector<double>& errors)
{
  double sum = 0.0;
  for (const double error : errors)
  {
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(errors.size()));
}
}

class CascadedClosedForm : public testing::TestWithParam<NamedScene>
{
};

// Many points, so that what is left is not the banding of few.
TEST_P(CascadedClosedForm, IsMet)
{
  const Scene scene = GetParam().Make(Placement());
  Stage stage(scene.Renderer);
  stage.Pass->SetMapSize(1024);
  for (int i = 0; i < 3; ++i)
  {
    stage.Pass->SetSampleEdge(i, 16);
    stage.Pass->SetResolution(i, vtkCascadedSoftShadowPass::HIGH);
    stage.Pass->SetFilterSize(i, 2);
  }
  const Picture visibility = stage.Render();
  std::vector<double> errors;
  for (const PlanePixel& pixel : GetPlanePixels(scene, Width, Height))
  {
    errors.push_back(visibility.At(pixel.X, pixel.Y) - pixel.Expected);
  }
  ASSERT_GT(errors.size(), 1000u);
  EXPECT_LT(RootMeanSquare(errors), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CascadedClosedForm, testing::ValuesIn(ClosedFormScenes()),
  [](const testing::TestParamInfo<NamedScene>& parameter) { return parameter.param.Name; });

// 16 + 9 + 4 points; a second frame, and one with the camera where it was, bake nothing.
TEST(CascadedPass, BakesNothingTwice)
{
  const auto renderer = MakeAvenue(3.0);
  Stage stage(renderer);
  stage.Render();
  EXPECT_EQ(stage.Pass->GetNumberOfOccupiedCascades(), 3);
  EXPECT_EQ(stage.Pass->GetStatistics().MapsBaked, 29);
  EXPECT_EQ(
    stage.Pass->GetStatistics().TexelsDrawn, 16 * 512 * 512 + 9 * 256 * 256 + 4 * 128 * 128);
  stage.Render();
  EXPECT_EQ(stage.Pass->GetStatistics().MapsBaked, 29);
  // Less than a texel's move keeps the snapped maps.
  renderer->GetActiveCamera()->SetPosition(0.3, -8.0 + 1e-6, 2.5);
  stage.Render();
  EXPECT_EQ(stage.Pass->GetStatistics().MapsBaked, 29);
}

// A wall across the view has one depth.
TEST(CascadedPass, ReceiversInOneCascadeBakeOneCascade)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -2, 10, -2 } }, { { 4, 0, 0 } }, { { 0, 0, 4 } });
  AddQuad(renderer, { { -1, 5, 20 } }, { { 2, 0, 0 } }, { { 0, 2, 0 } }); // out of view
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(0.0, -5.0, 60.0);
  lamp->SetFocalPoint(0.0, 10.0, 0.0);
  lamp->PositionalOn();
  lamp->SetConeAngle(60.0);
  renderer->AddLight(lamp);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 1.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(0.1, 100.0);
  Stage stage(renderer);
  stage.Render();
  EXPECT_EQ(stage.Pass->GetNumberOfOccupiedCascades(), 1);
  EXPECT_EQ(stage.Pass->GetStatistics().MapsBaked, 16);
}

// Few maps at a time give what all at once give.
TEST(CascadedPass, MemoryChangesNothing)
{
  const auto renderer = MakeAvenue(3.0);
  Stage stage(renderer);
  const Picture whole = stage.Render();
  stage.Pass->SetMapMemory(5);
  const Picture batched = stage.Render();
  for (size_t i = 0; i < whole.Values.size(); ++i)
  {
    ASSERT_TRUE(std::isnan(whole.Values[i]) || std::abs(whole.Values[i] - batched.Values[i]) < 1e-5)
      << "pixel " << i;
  }
  EXPECT_GT(stage.Pass->GetStatistics().MapsBaked, 29 + 16);
}

// With the same points and maps everywhere, cascades change nothing but the maps' resolution, and
// nothing at all where they blend.
TEST(CascadedPass, NoSeamIsSeen)
{
  const auto renderer = MakeAvenue(3.0);
  Stage stage(renderer);
  stage.Pass->SetMapSize(2048);
  for (int i = 0; i < 3; ++i)
  {
    stage.Pass->SetSampleEdge(i, 4);
    stage.Pass->SetResolution(i, vtkCascadedSoftShadowPass::HIGH);
    stage.Pass->SetFilterSize(i, 3);
  }
  const Picture cascaded = stage.Render();
  stage.Pass->SetNumberOfCascades(1);
  const Picture single = stage.Render();
  std::vector<double> differences;
  for (size_t i = 0; i < single.Values.size(); ++i)
  {
    if (!std::isnan(single.Values[i]))
    {
      differences.push_back(cascaded.Values[i] - single.Values[i]);
    }
  }
  EXPECT_LT(RootMeanSquare(differences), 0.03);
}

// Red near, blue far; a picture is as bright as its tints allow.
TEST(CascadedPass, TintShowsTheCascades)
{
  const auto renderer = MakeAvenue(3.0);
  Stage stage(renderer);
  stage.Render();
  const Picture plain = stage.Read();
  stage.Pass->TintOn();
  stage.Render();
  const Picture tinted = stage.Read();
  const int column = Width / 2;
  const auto ratio = [&](int y, int channel)
  { return tinted.At(column, y, channel) / plain.At(column, y, channel); };
  EXPECT_NEAR(ratio(1, 0), 1.0, 0.02);
  EXPECT_NEAR(ratio(1, 2), 0.55, 0.02);
  int horizon = Height - 1;
  while (std::isnan(PictureOf(stage.Pass->GetVisibilityImage(0)).At(column, horizon)))
  {
    --horizon;
  }
  EXPECT_NEAR(ratio(horizon, 2), 1.0, 0.02);
  EXPECT_NEAR(ratio(horizon, 0), 0.6, 0.02);
}

TEST(CascadedPass, RefusesCascadesThatDoNotExist)
{
  vtkNew<vtkCascadedSoftShadowPass> pass;
  pass->GlobalWarningDisplayOff();
  const vtkMTimeType time = pass->GetMTime();
  pass->SetSampleEdge(4, 7);
  pass->SetSampleEdge(-1, 7);
  pass->GlobalWarningDisplayOn();
  EXPECT_EQ(pass->GetMTime(), time);
  pass->SetSampleEdge(3, 99);
  EXPECT_EQ(pass->GetSampleEdge(3), 32);
}
