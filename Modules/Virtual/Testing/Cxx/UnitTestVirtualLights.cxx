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
  light->PositionalOn();
  light->SetConeAngle(90.0);
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

Result Draw(const std::vector<vtkSmartPointer<vtkAreaLight>>& lights)
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
  pass->SetQuality(8.0); // tiles of more than the least cost
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
} // namespace

TEST(VirtualLights, EveryLightHasTilesAndShadowsOfItsOwn)
{
  const std::vector<vtkSmartPointer<vtkAreaLight>> lights = { MakeLight(1.5, 1.0, 0.02),
    MakeLight(-3.0, 0.5, 1.0), MakeLight(0.0, -2.0, 0.1) };
  const Result together = Draw(lights);
  ASSERT_EQ(together.Tiles.size(), lights.size());
  for (size_t i = 0; i < lights.size(); ++i)
  {
    const Result alone = Draw({ lights[i] });
    ASSERT_EQ(alone.Tiles.size(), 1u);
    EXPECT_EQ(together.Tiles[i], alone.Tiles[0]) << "light " << i;
    double largest = 0.0;
    for (size_t p = 0; p < alone.Visibilities[0].Values.size(); ++p)
    {
      const float expected = alone.Visibilities[0].Values[p];
      if (!std::isnan(expected))
      {
        largest =
          std::max<double>(largest, std::abs(together.Visibilities[i].Values[p] - expected));
      }
    }
    EXPECT_LE(largest, 1e-6) << "light " << i;
  }
  EXPECT_NE(together.Tiles[0], together.Tiles[1]) << "nothing to mix up";
}
