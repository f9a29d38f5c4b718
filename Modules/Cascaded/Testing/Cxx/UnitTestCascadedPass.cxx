// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The pass on scenes: right values, nothing baked in vain, still shadows, no seams.
#include "CascadedStage.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

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
    stage.Pass->GetStatistics().TexelsDrawn, 16 * 512 * 512 + 9 * 512 * 512 + 4 * 256 * 256);
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

// Ground that is seen, but that no shadow can reach, is lit without a map; where a shadow reaches it,
// only those depths are split.
TEST(CascadedPass, ReceiversWithoutCastersBakeNothing)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -500, 0, 0 } }, { { 1000, 0, 0 } }, { { 0, 1000, 0 } });
  AddQuad(renderer, { { -1, 40, 0 } }, { { 2, 0, 0 } }, { { 0, 0, 2 } });
  vtkNew<vtkAreaLight> sun;
  sun->SetPosition(0.0, 1.0, 1.0);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetAngularDiameter(2.0);
  renderer->AddLight(sun);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 60.0, 2.0);
  camera->SetFocalPoint(0.0, 90.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(0.1, 2000.0);
  Stage stage(renderer);
  const Picture visibility = stage.Render();
  EXPECT_EQ(stage.Pass->GetStatistics().MapsBaked, 0);
  EXPECT_EQ(visibility.At(Width / 2, 1), 1.0f);
  camera->SetPosition(0.0, 30.0, 2.0);
  camera->SetFocalPoint(0.0, 40.0, 0.0);
  stage.Render();
  EXPECT_GE(stage.Pass->GetStatistics().MapsBaked, 16);
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
    // The sums are added in another order, and the weights of taps fall within a twentieth: 2e-5 in ten
    // pixels.
    ASSERT_TRUE(std::isnan(whole.Values[i]) || std::abs(whole.Values[i] - batched.Values[i]) < 5e-5)
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

// A parallel camera that moves by whole pixels shows every point again, one pixel on: only what the
// maps do can change the picture.
TEST(CascadedPass, AMovingCameraDoesNotStirTheShadows)
{
  const auto renderer = MakeAvenue(0.5);
  Stage stage(renderer);
  stage.Pass->SetMapSize(256);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.0);
  const double pixel = 2.0 * 2.0 / Height;
  const auto render = [&](int step)
  {
    camera->SetPosition(0.3 + pixel * step, -10.0, 8.0);
    camera->SetFocalPoint(0.3 + pixel * step, 4.0, 0.0);
    renderer->ResetCameraClippingRange();
    return stage.Render();
  };
  Picture before = render(0);
  const vtkTypeInt64 baked = stage.Pass->GetStatistics().MapsBaked;
  double worst = 0.0;
  for (int step = 1; step <= 12; ++step)
  {
    const Picture after = render(step);
    std::vector<double> differences;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 1; x < Width; ++x)
      {
        const double difference = before.At(x, y) - after.At(x - 1, y);
        if (!std::isnan(difference))
        {
          differences.push_back(difference);
        }
      }
    }
    ASSERT_GT(differences.size(), 10000u);
    worst = std::max(worst, RootMeanSquare(differences));
    before = after;
  }
  RecordProperty("WorstRootMeanSquare", std::to_string(worst));
  EXPECT_LT(worst, 1.0 / 255.0);
  EXPECT_GT(stage.Pass->GetStatistics().MapsBaked, baked); // or nothing was tested
}

// Steps of a fraction of a texel keep most maps.
TEST(CascadedPass, SnappedMapsBakeSeldom)
{
  const auto renderer = MakeAvenue(3.0);
  Stage stage(renderer);
  stage.Render();
  const vtkTypeInt64 before = stage.Pass->GetStatistics().MapsBaked;
  vtkCamera* camera = renderer->GetActiveCamera();
  for (int i = 1; i <= 10; ++i)
  {
    camera->SetPosition(0.3, -8.0 + 1e-3 * i, 2.5);
    camera->SetFocalPoint(0.3, 20.0 + 1e-3 * i, 0.5);
    stage.Render();
  }
  EXPECT_LT(stage.Pass->GetStatistics().MapsBaked - before, 3 * 29);
}

// The right half of a penumbra under a sheet's edge, with nothing else in view: the points see no blocker,
// and the depths that count are not where they see the light hidden. Shadow of the edge at x = 0,
// z = 1 in the light of a square of 1 at z = 3: penumbra from -1/4 to 1/4.
TEST(CascadedPass, TheOuterHalfOfAPenumbraIsNotLit)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -4, -4, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } });
  AddQuad(renderer, { { -0.5, -0.5, 1 } }, { { 0.5, 0, 0 } }, { { 0, 1, 0 } });
  vtkNew<vtkAreaLight> lamp;
  lamp->SetConeAngle(80.0);
  lamp->SetPosition(0.0, 0.0, 3.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(1.0, 1.0);
  renderer->AddLight(lamp);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.125, 0.0, 2.0);
  camera->SetFocalPoint(0.125, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.06); // x from 0.045 to 0.205
  camera->SetClippingRange(0.5, 3.0);
  Stage stage(renderer);
  for (int i = 0; i < 3; ++i)
  {
    stage.Pass->SetSampleEdge(i, 2);
  }
  const Picture visibility = stage.Render();
  for (const int column : { 5, Width / 2, Width - 5 })
  {
    const double x = 0.125 + 0.12 * (column + 0.5 - 0.5 * Width) / Height;
    // Half a step of two points.
    EXPECT_NEAR(visibility.At(column, Height / 2), 0.5 + 2.0 * x, 0.13) << "x " << x;
  }
}
