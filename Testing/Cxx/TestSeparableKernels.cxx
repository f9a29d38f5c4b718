// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Separable kernels that reuse nothing are the brute-force kernels of the percentage-closer pass.
#include "Scenes.h"
#include "Stage.h"

#include "vtkAreaLight.h"
#include "vtkNew.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkRenderer.h"
#include "vtkSeparableSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace SoftShadowsTesting;

namespace
{

//------------------------------------------------------------------------------
Picture Draw(const Scene& scene, vtkSoftShadowPass* pass)
{
  Stage stage(scene.Renderer, pass);
  return stage.RenderVisibility(scene.Light);
}

//------------------------------------------------------------------------------
/// The largest difference; 1 where one picture alone has a value.
double LargestDifference(const Picture& first, const Picture& second)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < first.Values.size(); ++i)
  {
    if (std::isnan(first.Values[i]) != std::isnan(second.Values[i]))
    {
      return 1.0;
    }
    if (!std::isnan(first.Values[i]))
    {
      largest =
        std::max(largest, std::abs(static_cast<double>(first.Values[i]) - second.Values[i]));
    }
  }
  return largest;
}

}

//------------------------------------------------------------------------------
TEST(SeparableKernels, WithoutReuseEqualThePercentageCloserOnes)
{
  const std::pair<int, int> widths[] = { { 7, 15 }, { 11, 21 }, { 29, 41 }, { 8, 6 } };
  for (const NamedScene& named : ClosedFormScenes())
  {
    const Scene scene = named.Make(Placement());
    for (const auto& width : widths)
    {
      for (const int weights : { vtkShadowLightSampling::MEAN, vtkShadowLightSampling::GAUSSIAN })
      {
        vtkNew<vtkPercentageCloserSoftShadowPass> expected;
        expected->SetMapSize(512);
        expected->SetSearchWidth(width.first);
        expected->SetFilterWidth(width.second);
        expected->SetWeights(weights);
        vtkNew<vtkSeparableSoftShadowPass> actual;
        actual->SetMapSize(512);
        actual->SetSearchWidth(width.first);
        actual->SetFilterWidth(width.second);
        actual->SetWeights(weights);
        actual->SetAlpha(0.0);
        actual->SetBeta(0.0);
        EXPECT_LE(LargestDifference(Draw(scene, expected), Draw(scene, actual)), 1.0 / 255.0)
          << scene.Description << ", " << width.first << "/" << width.second << " taps, weights "
          << weights;
      }
    }
  }
}
