// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tiles that are proved lit shoot no rays, and look as if they had.
#include "TracedStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"

#include <gtest/gtest.h>

#include <random>

using namespace SoftShadowsTesting;

namespace
{
struct Outcome
{
  Picture Visibility;
  vtkTypeInt64 Rays = 0;
};

Outcome Render(const Scene& scene, bool proves)
{
  TracedStage stage(scene, 160, 120);
  stage.Pass->AdaptiveOff();
  stage.Pass->SetEarlyOut(proves);
  Outcome outcome;
  outcome.Visibility = stage.Render();
  outcome.Rays = stage.Count("rays");
  return outcome;
}

int CountDifferent(const Picture& a, const Picture& b)
{
  int different = 0;
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    different += !std::isnan(a.Values[i]) && a.Values[i] != b.Values[i] ? 1 : 0;
  }
  return different;
}

/// Boxes in any places, turned in any way, over the plane of the scene.
Scene MakeRandomScene(unsigned int seed, bool sun)
{
  Scene scene = sun ? MakeSunScene(4.0, true) : MakeRectangleScene(Weights::Mean);
  std::mt19937 random(seed);
  const auto between = [&random](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int i = 0; i < 6; ++i)
  {
    const double size = between(0.02, 0.15);
    const double z = between(0.0, 0.8);
    const auto actor = MakeQuadActor(BoxQuads({ { -size, size, -size, size, -0.5 * size, size } }));
    actor->SetPosition(between(-0.9, 0.9), between(-0.9, 0.9), z);
    actor->SetOrientation(between(0.0, 90.0), between(0.0, 90.0), between(0.0, 90.0));
    scene.Renderer->AddActor(actor);
  }
  return scene;
}

class TracedProofs : public testing::TestWithParam<int>
{
};
}

//------------------------------------------------------------------------------
TEST_P(TracedProofs, ChangeNoPixel)
{
  for (const bool sun : { false, true })
  {
    const Scene scene = MakeRandomScene(static_cast<unsigned int>(this->GetParam()), sun);
    const Outcome proved = Render(scene, true);
    const Outcome shot = Render(scene, false);
    EXPECT_EQ(CountDifferent(proved.Visibility, shot.Visibility), 0) << "sun: " << sun;
    EXPECT_LE(proved.Rays, shot.Rays) << "sun: " << sun;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TracedProofs, testing::Range(1, 9));

//------------------------------------------------------------------------------
TEST(TracedProof, OpenGroundShootsFewRays)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  EXPECT_LT(Render(scene, true).Rays, Render(scene, false).Rays * 3 / 5);
}

//------------------------------------------------------------------------------
// A ground ten thousand times as large as what stands on it is still no blocker of its own.
TEST(TracedProof, HoldsOnVastGrounds)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  const vtkTypeInt64 small = Render(scene, true).Rays;
  const auto vast =
    MakeQuadActor({ { { { -1e4, -1e4, 0.0 } }, { { 2e4, 0.0, 0.0 } }, { { 0.0, 2e4, 0.0 } } } });
  scene.ReceiverActor->VisibilityOff();
  scene.Renderer->AddActor(vast);
  const Outcome shot = Render(scene, false);
  const Outcome proved = Render(scene, true);
  EXPECT_LT(proved.Rays, small * 11 / 10);
  EXPECT_EQ(CountDifferent(proved.Visibility, shot.Visibility), 0);
  for (const PlanePixel& pixel : GetPlanePixels(scene, 160, 120))
  {
    EXPECT_NEAR(proved.Visibility.At(pixel.X, pixel.Y), pixel.Expected, 0.3);
  }
}
