// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the mean of neighbours and more rays leave of the error of few rays: closed form.
#include "TracedStage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace SoftShadowsTesting;

namespace
{
/// Of a picture of the scene so many pixels wide.
double Measure(
  const Scene& scene, const std::function<void(vtkTracedSoftShadowPass*)>& change, int width = 200)
{
  const int height = 3 * width / 4;
  TracedStage stage(scene, width, height);
  change(stage.Pass);
  const Picture visibility = stage.Render();
  double squares = 0.0;
  const auto pixels = GetPlanePixels(scene, width, height);
  for (const PlanePixel& pixel : pixels)
  {
    squares += std::pow(visibility.At(pixel.X, pixel.Y) - pixel.Expected, 2.0) / pixels.size();
  }
  return std::sqrt(squares);
}
}

//------------------------------------------------------------------------------
TEST(TracedFilter, NeighboursMakeUpForFewRays)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  const double plain = Measure(scene,
    [](vtkTracedSoftShadowPass* pass)
    {
      pass->FilterOff();
      pass->AdaptiveOff();
    });
  const double filtered = Measure(scene, [](vtkTracedSoftShadowPass*) {});
  RecordProperty("Plain", std::to_string(plain));
  RecordProperty("Filtered", std::to_string(filtered));
  EXPECT_LT(filtered, 0.35 * plain);
  EXPECT_LT(filtered, 0.02);
}

//------------------------------------------------------------------------------
// Rays alone, without filter, tend to the closed form as their number grows.
TEST(TracedFilter, UnfilteredRaysConverge)
{
  const Scene scene = MakeDiskScene();
  double last = 1.0;
  for (const int rays : { 4, 16, 64, 256 })
  {
    const double error = Measure(scene,
      [rays](vtkTracedSoftShadowPass* pass)
      {
        pass->SetRays(rays);
        pass->FilterOff();
        pass->AdaptiveOff();
      });
    EXPECT_LT(error, 0.7 * last) << rays << " rays";
    last = error;
  }
  EXPECT_LT(last, 0.004);
}

//------------------------------------------------------------------------------
// A narrow penumbra is not blurred: it gets the rays that it needs.
TEST(TracedFilter, NarrowPenumbraeGetRaysInPlaceOfAMean)
{
  constexpr int width = 16;
  const Scene scene = MakeSunScene(5.0, true);
  const double error = Measure(
    scene, [](vtkTracedSoftShadowPass*) {}, width);
  const double few = Measure(
    scene, [](vtkTracedSoftShadowPass* pass) { pass->AdaptiveOff(); }, width);
  RecordProperty("Error", std::to_string(error));
  RecordProperty("Few", std::to_string(few));
  EXPECT_LT(error, 0.7 * few);
  EXPECT_LT(error, 0.035);
}
