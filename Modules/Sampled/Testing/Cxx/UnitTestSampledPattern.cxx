// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What few points leave of a penumbra whose edge runs along the light's axes: closed form.
#include "OffscreenWindow.h"
#include "Scenes.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSampledSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>

using namespace SoftShadowsTesting;

namespace
{
constexpr int Width = 200;
constexpr int Height = 150;

struct Result
{
  double Rmse = 0.0;
  size_t Steps = 0; // different visibilities
};

Result Measure(const std::function<void(vtkSampledSoftShadowPass*)>& change)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkSampledSoftShadowPass> pass;
  change(pass);
  UsePass(scene.Renderer, pass);
  window.Render();
  const Picture visibility = PictureOf(pass->GetVisibilityImage(0));
  UsePass(scene.Renderer, nullptr);
  pass->ReleaseGraphicsResources(window.Get());
  Result result;
  std::set<int> steps;
  const auto pixels = GetPlanePixels(scene, Width, Height);
  for (const PlanePixel& pixel : pixels)
  {
    const double value = visibility.At(pixel.X, pixel.Y);
    steps.insert(static_cast<int>(std::lround(1000.0 * value)));
    result.Rmse += std::pow(value - pixel.Expected, 2.0) / pixels.size();
  }
  result.Rmse = std::sqrt(result.Rmse);
  result.Steps = steps.size();
  return result;
}
}

//------------------------------------------------------------------------------
// As constructed: 16 points make 16 steps of 1 / 16, whose error is a quarter of that of a grid's four.
TEST(SampledPattern, SixteenPointsHaveSixteenSteps)
{
  const Result own = Measure([](vtkSampledSoftShadowPass*) {});
  const Result grid = Measure([](vtkSampledSoftShadowPass* pass) { pass->SetPatternToGrid(); });
  RecordProperty("Rmse", std::to_string(own.Rmse));
  RecordProperty("GridRmse", std::to_string(grid.Rmse));
  EXPECT_GE(own.Steps, 16u);
  EXPECT_LT(own.Rmse, 0.02);
  EXPECT_GT(grid.Rmse, 2.0 * own.Rmse);
}

//------------------------------------------------------------------------------
TEST(SampledPattern, AnyOfTheWellSpreadPatternsConverges)
{
  for (const int pattern : { int(vtkShadowLightSampling::HAMMERSLEY),
         int(vtkShadowLightSampling::SOBOL), int(vtkShadowLightSampling::LATTICE) })
  {
    const Result result = Measure(
      [pattern](vtkSampledSoftShadowPass* pass)
      {
        pass->SetPattern(pattern);
        pass->SetNumberOfSamples(64);
        pass->SetMapSize(512);
      });
    EXPECT_LT(result.Rmse, 0.015) << "pattern " << pattern;
  }
}
