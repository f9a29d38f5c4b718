// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The ray tracer against closed forms, and unmoved by where and how large the scene is.
#include "ReferenceTracer.h"
#include "Scenes.h"

#include "vtkAreaLight.h"

#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace SoftShadowsTesting;
using softshadows::ReferenceVisibility;

namespace
{

constexpr int Width = 64;
constexpr int Height = 48;
constexpr int SamplesPerAxis = 64; // 4096 samples
constexpr double LargestRms = 2e-3;

//--------------------------------------------------------------------------------------------------
size_t IndexOf(const PlanePixel& pixel)
{
  return static_cast<size_t>(Height - 1 - pixel.Y) * Width + pixel.X;
}

//--------------------------------------------------------------------------------------------------
void ExpectClosedForm(const Scene& scene)
{
  const ReferenceVisibility result = softshadows::Trace(
    scene.Renderer, Width, Height, SamplesPerAxis, scene.LightWeights == Weights::Gaussian);
  ASSERT_EQ(result.Visibility.size(), 1U);
  const std::vector<PlanePixel> pixels = GetPlanePixels(scene, Width, Height);
  double sum = 0.0;
  double worst = 0.0;
  int penumbra = 0;
  for (const PlanePixel& pixel : pixels)
  {
    const double error = result.Visibility[0][IndexOf(pixel)] - pixel.Expected;
    sum += error * error;
    worst = std::max(worst, std::abs(error));
    penumbra += pixel.Expected > 0.02 && pixel.Expected < 0.98 ? 1 : 0;
  }
  const double rms = std::sqrt(sum / pixels.size());
  testing::Test::RecordProperty("rms", std::to_string(rms));
  EXPECT_GT(penumbra, 100) << scene.Description << ": too few pixels in the penumbra to judge by";
  EXPECT_LT(rms, LargestRms) << scene.Description << ", " << pixels.size() << " pixels, "
                             << penumbra << " in the penumbra, largest error " << worst;
}

//--------------------------------------------------------------------------------------------------
class ReferenceClosedForm : public testing::TestWithParam<size_t>
{
};

TEST_P(ReferenceClosedForm, IsReached)
{
  ExpectClosedForm(ClosedFormScenes()[GetParam()].Make(Placement()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReferenceClosedForm, testing::Range<size_t>(0, 6),
  [](const testing::TestParamInfo<size_t>& scene) { return ClosedFormScenes()[scene.param].Name; });

TEST(ReferenceTracer, ReachesTheClosedFormOfGaussianWeights)
{
  ExpectClosedForm(MakeRectangleScene(Weights::Gaussian));
}

//--------------------------------------------------------------------------------------------------
struct NamedPlacement
{
  const char* Name;
  Placement Where;
};

class ReferencePlacement : public testing::TestWithParam<NamedPlacement>
{
};

TEST_P(ReferencePlacement, ChangesNothing)
{
  constexpr int perAxis = 16;
  for (const NamedScene& scene : ClosedFormScenes())
  {
    const Scene home = scene.Make(Placement());
    const Scene away = scene.Make(GetParam().Where);
    const ReferenceVisibility expected = softshadows::Trace(home.Renderer, Width, Height, perAxis);
    const ReferenceVisibility found = softshadows::Trace(away.Renderer, Width, Height, perAxis);
    // Rounding may turn single samples, and the first hit at silhouettes.
    int different = 0;
    for (size_t i = 0; i < expected.Depth.size(); ++i)
    {
      const float a = expected.Visibility[0][i];
      const float b = found.Visibility[0][i];
      const bool same = std::isnan(a) ? std::isnan(b) : std::abs(a - b) <= 1.0F / 256.0F;
      const double depth = expected.Depth[i] * GetParam().Where.Scale;
      const bool sameDepth = std::isnan(depth) ? std::isnan(found.Depth[i])
                                               : std::abs(found.Depth[i] / depth - 1) < 1e-5;
      different += same && sameDepth ? 0 : 1;
    }
    EXPECT_LE(different, Width * Height / 1000) << scene.Name << " " << GetParam().Name;
  }
}

INSTANTIATE_TEST_SUITE_P(Placements, ReferencePlacement,
  testing::Values(NamedPlacement{ "Moved", { 1.0, { { 1e7, -1e7, 1e7 } } } },
    NamedPlacement{ "Small", { 1e-4, { { 0.0, 0.0, 0.0 } } } },
    NamedPlacement{ "Large", { 1e4, { { 0.0, 0.0, 0.0 } } } },
    NamedPlacement{ "LargeAndMoved", { 1e4, { { 1e7, 1e7, 1e7 } } } }),
  [](const testing::TestParamInfo<NamedPlacement>& placement) { return placement.param.Name; });

//--------------------------------------------------------------------------------------------------
TEST(ReferenceTracer, GivesTheSameNumbersOnAnyNumberOfThreads)
{
  const Scene scene = MakeDiskScene();
  softshadows::ReferenceTracer tracer(Width, Height, 4);
  tracer.SetNumberOfThreads(1);
  const ReferenceVisibility one = tracer.Trace(scene.Renderer);
  tracer.SetNumberOfThreads(3);
  const ReferenceVisibility three = tracer.Trace(scene.Renderer);
  EXPECT_EQ(one.ShadowRays, three.ShadowRays);
  EXPECT_GT(one.ShadowRays, 0);
  for (size_t i = 0; i < one.Depth.size(); ++i)
  {
    const float a = one.Visibility[0][i];
    const float b = three.Visibility[0][i];
    ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
      << "pixel " << i << ": " << a << ", " << b;
  }
}

//--------------------------------------------------------------------------------------------------
TEST(ReferenceTracer, PilotSendsFewerRaysAndFindsTheSameEdges)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  softshadows::ReferenceTracer tracer(Width, Height, 32);
  const ReferenceVisibility full = tracer.Trace(scene.Renderer);
  tracer.SetPilotSamplesPerAxis(8);
  const ReferenceVisibility pilot = tracer.Trace(scene.Renderer);
  EXPECT_LT(pilot.ShadowRays, full.ShadowRays / 2);
  for (const PlanePixel& pixel : GetPlanePixels(scene, Width, Height))
  {
    // At most a corner between the pilot's samples is missed.
    const size_t i = IndexOf(pixel);
    EXPECT_NEAR(pilot.Visibility[0][i], full.Visibility[0][i], 1.0 / 16.0);
  }
}

//--------------------------------------------------------------------------------------------------
TEST(ReferenceTracer, ReportsProgressUpToTheEnd)
{
  const Scene scene = MakeDiskScene();
  softshadows::ReferenceTracer tracer(Width, Height, 1);
  tracer.SetNumberOfThreads(1);
  double last = 0.0;
  tracer.SetProgress(
    [&last](double share)
    {
      EXPECT_GE(share, last);
      last = share;
    });
  tracer.Trace(scene.Renderer);
  EXPECT_EQ(last, 1.0);
}

//--------------------------------------------------------------------------------------------------
TEST(ReferenceTracer, RefusesEmptyImagesAndNoSamples)
{
  using softshadows::ReferenceTracer;
  EXPECT_THROW(ReferenceTracer(0, 1, 1), std::invalid_argument);
  EXPECT_THROW(ReferenceTracer(1, 0, 1), std::invalid_argument);
  EXPECT_THROW(ReferenceTracer(1, 1, 0), std::invalid_argument);
}

}
