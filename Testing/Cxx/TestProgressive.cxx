// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A resting camera: every technique converges to the truth, says how far off it is, and starts again.
#include "GLObjectCounter.h"
#include "ImageComparison.h"
#include "Props.h"
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 96;
const int Height = 64;
const int Tile = 32;

class Progressive : public testing::TestWithParam<Technique>
{
protected:
  void SetUp() override
  {
    this->Pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    this->Pass->ProgressiveOn();
    this->Pass->SetProgressivePoints(64);
    this->Pass->SetMapMemory(16); // maps of at most 2048 texels
  }

  /// Frames until there is nothing to gain; the number of them.
  int Rest(Stage& stage)
  {
    int frames = 1;
    for (stage.Render(); this->Pass->GetRefining() && frames < 200; ++frames)
    {
      stage.Render();
    }
    return frames;
  }

  vtkSmartPointer<vtkSoftShadowPass> Pass;
};

//------------------------------------------------------------------------------
/// Root mean square over the worst tile, as the estimate has it.
double WorstTile(const Picture& estimate, const Picture& truth)
{
  double worst = 0.0;
  for (int y = 0; y < Height; y += Tile)
  {
    for (int x = 0; x < Width; x += Tile)
    {
      double squares = 0.0;
      int count = 0;
      for (int i = 0; i < Tile * Tile; ++i)
      {
        const double error =
          estimate.At(x + i % Tile, y + i / Tile) - truth.At(x + i % Tile, y + i / Tile);
        squares += std::isnan(error) ? 0.0 : error * error;
        count += std::isnan(error) ? 0 : 1;
      }
      worst = std::max(worst, squares / std::max(count, Tile * Tile / 4));
    }
  }
  return std::sqrt(worst);
}

//------------------------------------------------------------------------------
void CountEvent(vtkObject*, unsigned long, void* count, void*)
{
  ++*static_cast<int*>(count);
}

}

//------------------------------------------------------------------------------
TEST_P(Progressive, ConvergesToTheTruthAndKnowsItsError)
{
  for (const NamedScene& named : ClosedFormScenes())
  {
    const Scene drawn = named.Make(Placement());
    const Picture truth = ExpectedPicture(drawn, Width, Height);
    this->Pass->SetProgressiveTolerance(0.02);
    Stage stage(drawn.Renderer, this->Pass, Width, Height);
    this->Rest(stage);
    EXPECT_TRUE(this->Pass->GetConverged()) << named.Name;
    EXPECT_LE(this->Pass->GetEstimatedError(), 0.02) << named.Name;
    EXPECT_GT(this->Pass->GetEstimatedError(), 0.0) << named.Name;
    const double error = WorstTile(stage.RenderVisibility(drawn.Light), truth);
    EXPECT_LT(error, 2.0 * this->Pass->GetEstimatedError()) << named.Name;
  }
}

//------------------------------------------------------------------------------
TEST_P(Progressive, MeanDoesNotDependOnTheNumberOfFrames)
{
  const BallScene scene = MakeBallScene(0.8);
  this->Pass->SetProgressiveTolerance(0.0001);
  this->Pass->SetMapMemory(1);
  Picture means[2];
  for (const int points : { 24, 48 })
  {
    this->Pass->SetProgressivePoints(points);
    Stage stage(scene.Renderer, this->Pass, Width, Height);
    int frames = 0;
    stage.Render();
    const vtkTypeInt64 before = this->Pass->GetStatistics().ProgressiveFrames;
    for (; frames < 480 / points; ++frames)
    {
      means[points / 48] = stage.RenderVisibility(scene.Lamp);
    }
    EXPECT_EQ(this->Pass->GetStatistics().ProgressiveFrames - before, 480 / points);
    EXPECT_GT(this->Pass->GetStatistics().ProgressivePoints, 64);
  }
  EXPECT_LT(Compare(means[0], means[1], Identical).Maximum, 1e-6);
}

//------------------------------------------------------------------------------
TEST_P(Progressive, StartsAgainOnAnyChange)
{
  const BallScene scene = MakeBallScene(0.8);
  this->Pass->SetProgressiveTolerance(0.2);
  Stage stage(scene.Renderer, this->Pass, Width, Height);
  const Picture first = stage.RenderVisibility(scene.Lamp);
  const auto changes = { +[](const BallScene& s, Stage&)
                         { s.Lamp->SetPosition(s.Lamp->GetPosition()[0] + 0.1, 0.0, 4.0); },
    +[](const BallScene& s, Stage&) { s.Renderer->GetActiveCamera()->Azimuth(5.0); },
    +[](const BallScene& s, Stage&) { s.Ball->AddPosition(0.1, 0.0, 0.0); },
    +[](const BallScene& s, Stage&) { s.Ball->VisibilityOff(); },
    +[](const BallScene& s, Stage&) { s.Ball->VisibilityOn(); },
    +[](const BallScene&, Stage& shown) { shown.GetPass()->SetMapSize(256); },
    +[](const BallScene&, Stage& shown)
    { shown.GetWindow().Get()->SetSize(Width + 16, Height + 8); } };
  for (const auto& change : changes)
  {
    this->Rest(stage);
    EXPECT_TRUE(this->Pass->GetConverged());
    EXPECT_GT(this->Pass->GetStatistics().ProgressivePoints, 0);
    change(scene, stage);
    stage.Render();
    EXPECT_FALSE(this->Pass->GetConverged());
    EXPECT_TRUE(this->Pass->GetRefining());
    EXPECT_EQ(this->Pass->GetEstimatedError(), 1.0);
    EXPECT_EQ(this->Pass->GetStatistics().ProgressivePoints, 0);
  }
}

//------------------------------------------------------------------------------
TEST_P(Progressive, FirstFrameIsTheTechniquesOwn)
{
  const BallScene scene = MakeBallScene(0.8);
  Stage stage(scene.Renderer, this->Pass, Width, Height);
  const Picture first = stage.RenderVisibility(scene.Lamp);
  const auto still = this->GetParam().Make(Effort::Quick, Weights::Mean);
  stage.SetPass(still);
  EXPECT_TRUE(Matches(first, stage.RenderVisibility(scene.Lamp), SameToRounding));
  EXPECT_FALSE(still->GetConverged());
  EXPECT_FALSE(still->GetRefining());
}

//------------------------------------------------------------------------------
TEST_P(Progressive, RestsOnceConvergedAndSaysSoOnce)
{
  const BallScene scene = MakeBallScene(0.8);
  this->Pass->SetProgressiveTolerance(0.05);
  int events = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetCallback(CountEvent);
  counter->SetClientData(&events);
  this->Pass->AddObserver(vtkSoftShadowPass::ConvergedEvent, counter);
  Stage stage(scene.Renderer, this->Pass, Width, Height);
  this->Rest(stage);
  ASSERT_TRUE(this->Pass->GetConverged());
  const Picture converged = stage.RenderVisibility(scene.Lamp);
  const vtkSoftShadowStatistics before = this->Pass->GetStatistics();
  const GLObjectCounts objects = CountGLObjects(stage.GetWindow().GetOpenGL());
  EXPECT_TRUE(Matches(converged, stage.RenderVisibility(scene.Lamp), Identical));
  const vtkSoftShadowStatistics& after = this->Pass->GetStatistics();
  EXPECT_EQ(after.MapsBaked, before.MapsBaked);
  EXPECT_EQ(after.ProgressiveFrames, before.ProgressiveFrames);
  EXPECT_EQ(after.Allocations, before.Allocations);
  EXPECT_EQ(objects, CountGLObjects(stage.GetWindow().GetOpenGL()));
  EXPECT_EQ(events, 1);
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, Progressive, testing::ValuesIn(AllTechniques()), NameOfTechnique);
