// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Several lights in one frame: every one is planned from its own pixels.

#include "OffscreenWindow.h"
#include "Picture.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVirtualSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

vtkSmartPointer<vtkAreaLight> MakeLight(double x, double y, double size)
{
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetShapeToRectangle();
  light->SetPosition(x, y, 4.0);
  light->SetFocalPoint(0, 0, 0);
  light->SetViewUp(0, 1, 0);
  light->SetSize(size, size);
  return light;
}

struct Result
{
  std::vector<Picture> Visibilities;
  std::vector<std::string> Tiles; // per light, without its number
};

// A line per light starts a paragraph of lines per tile.
std::vector<std::string> SplitReport(const std::string& report)
{
  std::vector<std::string> parts;
  size_t begin = report.find("part 0: ");
  while (begin != std::string::npos)
  {
    const size_t end = report.find("light ", begin);
    parts.push_back(report.substr(begin, end == std::string::npos ? end : end - begin));
    begin = end == std::string::npos ? end : report.find("part 0: ", end);
  }
  return parts;
}

Result Draw(const std::vector<vtkSmartPointer<vtkAreaLight>>& lights,
  int debugView = vtkVirtualSoftShadowPass::DEBUG_NONE, int split = 1, double quality = 8.0)
{
  vtkNew<vtkRenderer> renderer;
  renderer->AutomaticLightCreationOff();
  renderer->AddActor(
    MakeQuadActor({ Quad{ { { -4, -4, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } } } }));
  for (int i = 0; i < 3; ++i)
  {
    const Quad quad{ { { i - 1.5, 0.3 * i - 0.8, 0.5 } }, { { 0.6, 0, 0 } }, { { 0, 0.6, 0 } } };
    renderer->AddActor(MakeQuadActor({ quad }));
  }
  for (const auto& light : lights)
  {
    renderer->AddLight(light);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, -6, 5);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(30);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkVirtualSoftShadowPass> pass;
  pass->SetQuality(quality); // tiles of more than the least cost
  pass->SetDebugView(debugView);
  pass->SetSplit(split);
  OffscreenWindow window(Width, Height);
  window.Add(renderer);
  UsePass(renderer, pass);
  window.Render();
  Result result;
  for (size_t i = 0; i < lights.size(); ++i)
  {
    result.Visibilities.push_back(PictureOf(pass->GetVisibilityImage(static_cast<int>(i))));
  }
  result.Tiles = SplitReport(pass->GetTileReport());
  pass->ReleaseGraphicsResources(window.Get());
  UsePass(renderer, nullptr);
  window.Remove(renderer);
  return result;
}

std::vector<vtkSmartPointer<vtkAreaLight>> ThreeLights()
{
  return { MakeLight(1.5, 1.0, 0.02), MakeLight(-3.0, 0.5, 1.0), MakeLight(0.0, -2.0, 0.1) };
}

double Largest(const Picture& picture, const Picture& expected)
{
  double largest = 0.0;
  for (size_t p = 0; p < expected.Values.size(); ++p)
  {
    if (!std::isnan(expected.Values[p]))
    {
      largest = std::max<double>(largest, std::abs(picture.Values[p] - expected.Values[p]));
    }
  }
  return largest;
}

// Of the pixels that both pictures show darker than a lit one.
double MeanDifference(const Picture& picture, const Picture& other)
{
  double sum = 0.0;
  int pixels = 0;
  for (size_t p = 0; p < other.Values.size(); ++p)
  {
    if (picture.Values[p] < 0.999 && other.Values[p] < 0.999)
    {
      sum += picture.Values[p] - other.Values[p];
      ++pixels;
    }
  }
  return sum / std::max(pixels, 1);
}
} // namespace

TEST(VirtualLights, EveryLightHasTilesAndShadowsOfItsOwn)
{
  const std::vector<vtkSmartPointer<vtkAreaLight>> lights = ThreeLights();
  const Result together = Draw(lights);
  ASSERT_EQ(together.Tiles.size(), lights.size());
  for (size_t i = 0; i < lights.size(); ++i)
  {
    const Result alone = Draw({ lights[i] });
    ASSERT_EQ(alone.Tiles.size(), 1u);
    EXPECT_EQ(together.Tiles[i], alone.Tiles[0]) << "light " << i;
    EXPECT_LE(Largest(together.Visibilities[i], alone.Visibilities[0]), 1e-6) << "light " << i;
  }
  EXPECT_NE(together.Tiles[0], together.Tiles[1]) << "nothing to mix up";
}

TEST(VirtualLights, DebugViewsShowEveryLightItsOwn)
{
  using Pass = vtkVirtualSoftShadowPass;
  const std::vector<vtkSmartPointer<vtkAreaLight>> lights = ThreeLights();
  for (const int view : { Pass::DEBUG_TILES, Pass::DEBUG_RESOLUTION, Pass::DEBUG_KERNEL })
  {
    const Result together = Draw(lights, view);
    for (size_t i = 0; i < lights.size(); ++i)
    {
      const Picture alone = Draw({ lights[i] }, view).Visibilities[0];
      EXPECT_LE(Largest(together.Visibilities[i], alone), 1e-6)
        << "view " << view << " light " << i;
    }
    // Light 1 is fifty times as wide as light 0.
    const double brighter = MeanDifference(together.Visibilities[1], together.Visibilities[0]);
    EXPECT_TRUE(view != Pass::DEBUG_KERNEL || brighter > 0.05) << brighter;
  }
}

TEST(VirtualLights, TheDebugViewOfResolutionsIsLogarithmic)
{
  // Half the texels along an edge: sizes of twice, a sixteenth brighter.
  using Pass = vtkVirtualSoftShadowPass;
  const Picture fine = Draw({ ThreeLights()[1] }, Pass::DEBUG_RESOLUTION).Visibilities[0];
  const Picture half = Draw({ ThreeLights()[1] }, Pass::DEBUG_RESOLUTION, 1, 4.0).Visibilities[0];
  EXPECT_NEAR(MeanDifference(half, fine), 0.0625, 1e-4);
}

TEST(VirtualLights, TheTilesOfADebugViewAreThoseOfTheReport)
{
  using Pass = vtkVirtualSoftShadowPass;
  const Result shown = Draw({ ThreeLights()[0] }, Pass::DEBUG_TILES);
  const auto tiles = std::count(shown.Tiles[0].begin(), shown.Tiles[0].end(), '\n') - 1;
  ASSERT_GT(tiles, 1);
  int pixels = 0;
  int found = 0;
  for (const float value : shown.Visibilities[0].Values)
  {
    bool isShade = false;
    for (int tile = 0; tile < tiles; ++tile)
    {
      const double shade = std::fmod(0.2 + 0.618033988 * tile, 0.9) + 0.05;
      isShade = isShade || std::abs(value - shade) < 1e-4;
    }
    pixels += value < 0.999 ? 1 : 0;
    found += value < 0.999 && isShade ? 1 : 0;
  }
  // Kernels over a border show the mean of two tiles.
  EXPECT_GT(pixels, 100);
  EXPECT_GT(found, 0.8 * pixels) << tiles << " tiles";
}

TEST(VirtualLights, ASplitLightShowsTheMeanOfItsParts)
{
  // Against four lights of half the size in the places of the parts.
  using Pass = vtkVirtualSoftShadowPass;
  const vtkSmartPointer<vtkAreaLight> whole = MakeLight(0.5, 0.25, 1.0);
  whole->SetFocalPoint(0.5, 0.25, 0.0); // its plane is parallel to the floor
  const Picture split = Draw({ whole }, Pass::DEBUG_KERNEL, 2).Visibilities[0];
  std::vector<vtkSmartPointer<vtkAreaLight>> quarters;
  for (int i = 0; i < 4; ++i)
  {
    const double x = 0.5 + (i % 2 ? 0.25 : -0.25);
    const double y = 0.25 + (i / 2 ? 0.25 : -0.25);
    quarters.push_back(MakeLight(x, y, 0.5));
    quarters.back()->SetFocalPoint(x, y, 0.0);
  }
  const std::vector<Picture> parts = Draw(quarters, Pass::DEBUG_KERNEL).Visibilities;
  Picture mean = parts[0];
  int pixels = 0;
  for (size_t p = 0; p < mean.Values.size(); ++p)
  {
    mean.Values[p] =
      0.25f * (parts[0].Values[p] + parts[1].Values[p] + parts[2].Values[p] + parts[3].Values[p]);
    pixels += mean.Values[p] < 0.999 ? 1 : 0;
  }
  EXPECT_GT(pixels, 100);
  EXPECT_LT(std::abs(MeanDifference(split, mean)), 0.005);
}
