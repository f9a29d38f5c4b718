// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What must not change the visibility: where the scene stands, how large it is, and the window.
#include "ImageComparison.h"
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

class Invariance : public testing::TestWithParam<Technique>
{
protected:
  vtkSmartPointer<vtkSoftShadowPass> MakePass() const
  {
    return this->GetParam().Make(Effort::Quick, Weights::Mean);
  }
};

//------------------------------------------------------------------------------
/// Changes the view angle so that a picture of newHeight rows has the pixels that one of 480 had.
void KeepPixelSize(vtkCamera* camera, int newHeight)
{
  const double half =
    std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) * newHeight / 480.0;
  camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(half)));
}

//------------------------------------------------------------------------------
/// Only a known shadow makes the comparison mean something.
void ExpectShadow(const Picture& visibility)
{
  const int shadowed = CountShadowed(visibility);
  EXPECT_GT(shadowed, visibility.Width * visibility.Height / 20);
  EXPECT_LT(shadowed, visibility.Width * visibility.Height * 19 / 20);
}

}

//------------------------------------------------------------------------------
TEST_P(Invariance, ScaleAndTranslation)
{
  const Placement placements[] = { { 1e-6, { { 0.0, 0.0, 0.0 } } },
    { 1e-3, { { 1.0, -2.0, 3.0 } } }, { 1.0, { { 1e7, -1e7, 1e7 } } },
    { 1e6, { { 0.0, 0.0, 0.0 } } } };
  for (const NamedScene& named : ClosedFormScenes())
  {
    if (named.Name != "Rectangle" && named.Name != "Sun5Inclined")
    {
      continue; // one positional, one directional
    }
    const Scene original = named.Make(Placement());
    Stage stage(original.Renderer, this->MakePass());
    const Picture expected = stage.RenderVisibility(original.Light);
    ExpectShadow(expected);
    for (const Placement& placement : placements)
    {
      SCOPED_TRACE(named.Name + " scaled by " + std::to_string(placement.Scale) + ", moved by " +
        testing::PrintToString(placement.Translation));
      const Scene moved = named.Make(placement);
      Stage movedStage(moved.Renderer, this->MakePass());
      EXPECT_TRUE(Matches(expected, movedStage.RenderVisibility(moved.Light), SameButForEdges));
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(Invariance, WindowShape)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Picture expected;
  {
    Stage stage(scene.Renderer, this->MakePass(), 640, 480);
    expected = stage.RenderVisibility(scene.Light);
    ExpectShadow(expected);
  }
  KeepPixelSize(scene.Renderer->GetActiveCamera(), 400);
  Stage stage(scene.Renderer, this->MakePass(), 960, 400);
  const Picture wide = stage.RenderVisibility(scene.Light);
  EXPECT_TRUE(
    Matches(expected.Part(0, 40, 640, 400), wide.Part(160, 0, 640, 400), SameButForFlips));
}

//------------------------------------------------------------------------------
TEST_P(Invariance, HalfOfAWindow)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Picture expected;
  Picture expectedColors;
  {
    Stage stage(scene.Renderer, this->MakePass(), 640, 480);
    expected = stage.RenderVisibility(scene.Light);
    expectedColors = stage.GetWindow().Read();
  }
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  Stage stage(scene.Renderer, this->MakePass(), 1280, 480);
  const Picture half = stage.RenderVisibility(scene.Light);
  EXPECT_TRUE(Matches(expected, half, SameButForFlips));
  EXPECT_TRUE(
    Matches(expectedColors, stage.GetWindow().Read().Part(640, 0, 640, 480), SameButForFlips));
}

//------------------------------------------------------------------------------
// A resized window shows what a window of that size always showed.
TEST_P(Invariance, Resize)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Picture expected;
  {
    Stage stage(scene.Renderer, this->MakePass(), 200, 90);
    expected = stage.RenderVisibility(scene.Light);
  }
  Stage stage(scene.Renderer, this->MakePass(), 120, 160);
  stage.Render();
  stage.GetWindow().Resize(200, 90);
  EXPECT_TRUE(Matches(expected, stage.RenderVisibility(scene.Light), Identical));
}

//------------------------------------------------------------------------------
// The same frame again, and again after other scenes went through the same pass.
TEST_P(Invariance, History)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Picture expected;
  {
    Stage stage(scene.Renderer, this->MakePass());
    expected = stage.RenderVisibility(scene.Light);
    EXPECT_TRUE(Matches(expected, stage.RenderVisibility(scene.Light), Identical));
  }
  const auto pass = this->MakePass();
  const Scene other = MakeSunScene(5.0, true);
  {
    Stage stage(other.Renderer, pass);
    stage.RenderVisibility(other.Light);
  }
  Stage stage(scene.Renderer, pass);
  const Tolerance& same = this->GetParam().IsContinuous ? SameToRounding : Identical;
  EXPECT_TRUE(Matches(expected, stage.RenderVisibility(scene.Light), same));
}

//------------------------------------------------------------------------------
// Proofs from the pyramid save time and change nothing.
TEST_P(Invariance, EarlyOut)
{
  for (const NamedScene& named : ClosedFormScenes())
  {
    SCOPED_TRACE(named.Name);
    const Scene scene = named.Make(Placement());
    const auto pass = this->MakePass();
    Stage stage(scene.Renderer, pass);
    pass->EarlyOutOff();
    const Picture all = stage.RenderVisibility(scene.Light);
    const vtkTypeInt64 filtered = pass->GetStatistics().PixelsFiltered;
    pass->EarlyOutOn();
    EXPECT_TRUE(Matches(all, stage.RenderVisibility(scene.Light), SameToRounding));
    EXPECT_TRUE(!GetParam().HasProof || pass->GetStatistics().PixelsFiltered < filtered)
      << pass->GetStatistics().PixelsFiltered << " of " << filtered;
    ExpectShadow(all);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, Invariance, testing::ValuesIn(AllTechniques()), NameOfTechnique);
