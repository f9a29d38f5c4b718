// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BakingScene.h"

#include "vtkShadowDepthPyramid.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
// (minimum, maximum) over the map's texels that a texel of the pyramid stands for.
std::pair<float, float> Expected(
  const std::vector<float>& held, int resolution, int x, int y, int edge)
{
  std::pair<float, float> range(2.0f, -1.0f);
  for (int j = y * edge; j < (y + 1) * edge; ++j)
  {
    for (int i = x * edge; i < (x + 1) * edge; ++i)
    {
      const float depth =
        i < resolution && j < resolution ? -held[static_cast<size_t>(j) * resolution + i] : 0.0f;
      range.first = std::min(range.first, depth);
      range.second = std::max(range.second, depth);
    }
  }
  return range;
}

class ShadowDepthPyramid : public testing::TestWithParam<int>
{
};
}

//------------------------------------------------------------------------------
TEST_P(ShadowDepthPyramid, HoldsMinimumAndMaximumOfEveryLevelAndLayer)
{
  const int resolution = GetParam();
  BakingScene scene;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  scene.AddActor(sphere);
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.2, 0.1, 3.0, false);
  view.Window = { { -0.4, 0.2, -0.3, 0.2 } };
  view.Near = 2.0;
  view.Far = 4.0;
  vtkShadowMapView other = view;
  other.Emitter.Center[0] = -0.3;
  scene.Bake({ view, other }, resolution);

  vtkNew<vtkShadowDepthPyramid> pyramid;
  vtkOpenGLRenderWindow* window = scene.Window.GetOpenGL();
  EXPECT_TRUE(pyramid->Update(window, scene.Maps));
  EXPECT_FALSE(pyramid->Update(window, scene.Maps)) << "nothing was baked since";

  vtkShadowTextureArray* texture = pyramid->GetTexture();
  ASSERT_EQ(texture->GetLayers(), 2);
  ASSERT_GE(2 * pyramid->GetLevelSize(0), resolution);
  const int levels = pyramid->GetNumberOfLevels();
  EXPECT_EQ(pyramid->GetLevelSize(levels - 1), 1) << "the last level is one texel";
  for (int layer = 0; layer < 2; ++layer)
  {
    const std::vector<float> held = scene.Maps->GetTexture()->ReadLayer(layer);
    const std::vector<float> ranges = texture->ReadLayer(layer);
    for (int level = 0; level < levels; ++level)
    {
      const std::array<int, 2> corner = pyramid->GetLevelCorner(level);
      const int size = pyramid->GetLevelSize(level);
      for (int y = 0; y < size; ++y)
      {
        for (int x = 0; x < size; ++x)
        {
          const auto expected = Expected(held, resolution, x, y, 2 << level);
          const size_t row = static_cast<size_t>(corner[1] + y) * texture->GetWidth();
          const size_t at = 2 * (row + corner[0] + x);
          ASSERT_EQ(ranges[at], expected.first) << level << ": " << x << ", " << y;
          ASSERT_EQ(ranges[at + 1], expected.second) << level << ": " << x << ", " << y;
        }
      }
    }
  }

  view.Emitter.Center[0] = 0.25;
  scene.Bake({ view, other }, resolution);
  EXPECT_TRUE(pyramid->Update(window, scene.Maps)) << "a map is new";
  pyramid->ReleaseGraphicsResources(window);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, ShadowDepthPyramid, testing::Values(1, 2, 31, 64, 100));
