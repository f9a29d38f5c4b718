// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The visibility in scenes whose answer is known, in all modes of the technique.

#include "ClosedForms.h"
#include "OffscreenWindow.h"
#include "Picture.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
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
constexpr int Width = 200;
constexpr int Height = 150;

struct Errors
{
  double RootMeanSquare = 0.0;
  double Maximum = 0.0;
};

// A scene in a window of its own.
class SceneWindow
{
public:
  explicit SceneWindow(const Scene& scene)
    : Window(Width, Height)
    , Shown(scene)
  {
    this->Window.Add(scene.Renderer);
    UsePass(scene.Renderer, this->Pass);
  }
  ~SceneWindow() { this->Window.Remove(this->Shown.Renderer); }

  Picture Visibility()
  {
    this->Window.Render();
    return PictureOf(this->Pass->GetVisibilityImage(0));
  }

  Errors AgainstClosedForm()
  {
    const Picture picture = this->Visibility();
    Errors errors;
    const std::vector<PlanePixel> pixels = GetPlanePixels(this->Shown, Width, Height);
    for (const PlanePixel& pixel : pixels)
    {
      const double error = picture.At(pixel.X, pixel.Y) - pixel.Expected;
      errors.Maximum = std::max(errors.Maximum, std::abs(error));
      errors.RootMeanSquare += error * error;
    }
    errors.RootMeanSquare = std::sqrt(errors.RootMeanSquare / pixels.size());
    return errors;
  }

  vtkNew<vtkVirtualSoftShadowPass> Pass;
  OffscreenWindow Window;

private:
  const Scene& Shown;
};
} // namespace

TEST(VirtualVisibility, IsTheClosedFormForOneBlockerDepth)
{
  for (const NamedScene& named : ClosedFormScenes())
  {
    const Scene scene = named.Make(Placement());
    SceneWindow window(scene);
    for (const bool adaptive : { false, true })
    {
      for (const bool antialiasing : { false, true })
      {
        window.Pass->SetMapSize(adaptive ? 2048 : 256);
        window.Pass->SetAdaptive(adaptive);
        window.Pass->SetAntialiasing(antialiasing);
        window.Pass->SetQuality(2.0); // how far an edge lies from a texel's depends on the tiles
        const Errors errors = window.AgainstClosedForm();
        // Predicted tiles hold no more texels than the eye asks for.
        EXPECT_LT(errors.RootMeanSquare, adaptive ? 0.002 : 0.001)
          << named.Name << " adaptive " << adaptive << " antialiasing " << antialiasing;
        EXPECT_LT(errors.Maximum, adaptive ? 0.01 : 0.006)
          << named.Name << " adaptive " << adaptive << " antialiasing " << antialiasing;
      }
    }
  }
}

TEST(VirtualVisibility, AWideKernelOverFineTexelsIsFilteredInFull)
{
  // Hundreds of texels along an edge of a kernel: more than a software rasteriser's loops allow.
  const Scene scene = MakeRectangleScene(Weights::Mean);
  SceneWindow window(scene);
  window.Pass->SetAdaptive(false);
  window.Pass->SetMapSize(4096);
  const Errors errors = window.AgainstClosedForm();
  EXPECT_LT(errors.RootMeanSquare, 0.001);
  EXPECT_LT(errors.Maximum, 0.01);
}

TEST(VirtualVisibility, TilesOfOneMapAreTheMap)
{
  // Kernels over the borders of 4 x 4 tiles against one map of the same texels.
  for (const NamedScene& named : ClosedFormScenes())
  {
    const Scene scene = named.Make(Placement());
    SceneWindow window(scene);
    window.Pass->SetAdaptive(false);
    window.Pass->SetMapSize(256);
    const Picture single = window.Visibility();
    window.Pass->SetFixedLevels(2);
    const Picture tiles = window.Visibility();
    EXPECT_EQ(window.Pass->GetNumberOfTiles(), 16);
    double largest = 0.0;
    for (size_t i = 0; i < single.Values.size(); ++i)
    {
      if (!std::isnan(single.Values[i]))
      {
        largest = std::max<double>(largest, std::abs(single.Values[i] - tiles.Values[i]));
      }
    }
    EXPECT_LE(largest, 1.0 / 255.0) << named.Name;
    EXPECT_GT(largest, 0.0) << named.Name << ": tiles were not used";
  }
}

TEST(VirtualVisibility, TheMemoryAllowedCoarsensEvenlyAndIsReported)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  scene.Light->SetSize(0.01, 0.01);
  SceneWindow window(scene);
  window.Pass->SetQuality(8.0);
  window.Visibility();
  const vtkTypeInt64 wanted = window.Pass->GetTileTexels();
  EXPECT_EQ(window.Pass->GetCoarsening(), 1.0) << window.Pass->GetTileReport();
  window.Pass->SetMapMemory(1); // MiB: 262144 texels
  const Picture picture = window.Visibility();
  ASSERT_GT(wanted, 262144) << "nothing to limit";
  EXPECT_LE(window.Pass->GetTileTexels(), 262144) << window.Pass->GetTileReport();
  EXPECT_GT(window.Pass->GetCoarsening(), 1.0);
  EXPECT_NE(window.Pass->GetTileReport().find("coarser"), std::string::npos);
  for (const PlanePixel& pixel : GetPlanePixels(scene, Width, Height))
  {
    ASSERT_TRUE(std::isfinite(picture.At(pixel.X, pixel.Y)));
  }
}

TEST(VirtualVisibility, TilesAreKeptWhileNothingThatTheyShowChanges)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  SceneWindow window(scene);
  window.Visibility();
  const vtkTypeInt64 baked = window.Pass->GetStatistics().MapsBaked;
  // A breath of the camera: other pixels, the same tiles.
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->Azimuth(0.01);
  window.Visibility();
  EXPECT_EQ(window.Pass->GetStatistics().MapsBaked, baked);
  // A caster moves: the search map and the tiles are drawn anew.
  scene.BlockerActors[0]->SetPosition(0.01, 0.0, 0.0);
  window.Visibility();
  EXPECT_GT(window.Pass->GetStatistics().MapsBaked, baked);
}

TEST(VirtualVisibility, RestingShadowsNeedFewerTexels)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  SceneWindow window(scene);
  window.Pass->SetQuality(4.0);
  window.Visibility();
  const vtkTypeInt64 moving = window.Pass->GetTileTexels();
  window.Pass->SetMetricToStatic();
  window.Visibility();
  const vtkTypeInt64 resting = window.Pass->GetTileTexels();
  EXPECT_LT(resting, moving);
  window.Pass->SetMetricToAutomatic();
  scene.BlockerActors[0]->SetPosition(0.001, 0.0, 0.0);
  window.Visibility();
  EXPECT_EQ(window.Pass->GetTileTexels(), moving);
  scene.Renderer->GetActiveCamera()->Azimuth(0.01);
  window.Visibility();
  EXPECT_EQ(window.Pass->GetTileTexels(), resting);
}

TEST(VirtualVisibility, ThinBarsKeepTheirShadow)
{
  // Bars half a texel of the search map wide, at every place within a texel, under a small light.
  Scene scene = MakeRectangleScene(Weights::Mean);
  const double texel = 1.1 / 64;
  std::vector<vtkSmartPointer<vtkActor>> bars;
  for (int i = 0; i < 7; ++i)
  {
    const double x = -0.42 + i * (0.12 + texel / 7.0);
    const Quad bar{ { { x, -0.45, 1.0 } }, { { 0.5 * texel, 0.0, 0.0 } }, { { 0.0, 0.9, 0.0 } } };
    bars.push_back(MakeQuadActor({ bar }));
    scene.Renderer->AddActor(bars.back());
  }
  scene.Renderer->RemoveActor(scene.BlockerActors[0]);
  scene.Light->SetSize(0.004, 0.004);
  SceneWindow window(scene);
  window.Pass->SetSearchMapSize(64);
  window.Pass->SetQuality(2.0);       // a bar is as wide as a pixel: tiles must be finer
  window.Pass->SetAntialiasing(true); // and its shadow may lie between two pixels' centres
  const Picture picture = window.Visibility();
  // Each bar's shadow, followed along the bar, must darken every row of the picture it crosses.
  const std::vector<Point> points = PlanePositions(scene.Renderer, Width, Height, Plane());
  for (size_t i = 0; i < bars.size(); ++i)
  {
    const double x = -0.42 + i * (0.12 + texel / 7.0) + 0.25 * texel;
    int rows = 0;
    int dark = 0;
    for (int row = 0; row < Height; ++row)
    {
      double least = 1.0;
      bool crossed = false;
      for (int column = 0; column < Width; ++column)
      {
        // The lamp is at (0.3, -0.2, 3), the bar at height 1: shadows are 1.5 times as far.
        const Point& point = points[static_cast<size_t>(row) * Width + column];
        const double across = point[0] - (0.3 + 1.5 * (x - 0.3));
        if (std::abs(across) < 0.04 && std::abs(point[1] - 0.1) < 0.5)
        {
          crossed = crossed || std::abs(across) < 0.008;
          least = std::min<double>(least, picture.At(column, row));
        }
      }
      rows += crossed ? 1 : 0;
      dark += crossed && least < 0.97 ? 1 : 0;
    }
    EXPECT_GT(rows, 10);
    EXPECT_EQ(dark, rows) << "bar " << i;
  }
}
