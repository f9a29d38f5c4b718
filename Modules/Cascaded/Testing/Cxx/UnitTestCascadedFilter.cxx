// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What smooths the points: no steps, no leaks, no lines on facets, the same on every path.
#include "CascadedStage.h"
#include "Room.h"

#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace SoftShadowsTesting;

namespace
{
constexpr double Grey = 1.0 / 255.0; // what an eight-bit picture can show

// The root mean square of the second differences along the rows of the error, where the scene knows
// the truth: what is neither in the truth nor smooth.
double Banding(const Scene& scene, const Picture& picture)
{
  const Picture truth = ExpectedPicture(scene, Width, Height);
  const auto error = [&](int x, int y) { return picture.At(x, y) - truth.At(x, y); };
  std::vector<double> seconds;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 1; x + 1 < Width; ++x)
    {
      const double second = error(x - 1, y) - 2.0 * error(x, y) + error(x + 1, y);
      if (!std::isnan(second))
      {
        seconds.push_back(second);
      }
    }
  }
  EXPECT_GT(seconds.size(), 1000u);
  return RootMeanSquare(seconds);
}

void SetFilterSizes(vtkCascadedSoftShadowPass* pass, int size)
{
  for (int i = 0; i < vtkCascadedSoftShadowPass::MaximumNumberOfCascades; ++i)
  {
    pass->SetFilterSize(i, size);
  }
}

void SetSampleEdges(vtkCascadedSoftShadowPass* pass, int edge)
{
  for (int i = 0; i < vtkCascadedSoftShadowPass::MaximumNumberOfCascades; ++i)
  {
    pass->SetSampleEdge(i, edge);
  }
}

double LargestDifference(const Picture& a, const Picture& b)
{
  double largest = 0.0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    if (!std::isnan(a.Values[i]))
    {
      largest = std::max(largest, std::abs(static_cast<double>(a.Values[i]) - b.Values[i]));
    }
  }
  return largest;
}
}

// At the default settings, and what is left of it without the filter. The number is published.
TEST(CascadedFilter, CellsLeaveNoSteps)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Stage stage(scene.Renderer);
  stage.Pass->SetMapSize(vtkNew<vtkCascadedSoftShadowPass>()->GetMapSize());
  const double usual = Banding(scene, stage.Render());
  stage.Pass->SetFilter(vtkCascadedSoftShadowPass::FIXED);
  const double fixed = Banding(scene, stage.Render());
  SetFilterSizes(stage.Pass, 1);
  const double unfiltered = Banding(scene, stage.Render());
  RecordProperty("Banding", std::to_string(usual));
  RecordProperty("BandingFixed", std::to_string(fixed));
  RecordProperty("BandingUnfiltered", std::to_string(unfiltered));
  EXPECT_LT(usual, Grey);
  EXPECT_GT(fixed, 8.0 * Grey);
  EXPECT_GT(unfiltered, 15.0 * Grey);
}

// The same on a disk, whose cells are no squares, under a sun, and with weights that differ.
class CascadedFilteredForm : public testing::TestWithParam<NamedScene>
{
};

TEST_P(CascadedFilteredForm, HasLessErrorThanItsPoints)
{
  const Scene scene = GetParam().Make(Placement());
  Stage stage(scene.Renderer);
  stage.Pass->SetMapSize(1024);
  const auto error = [&]
  {
    const Picture visibility = stage.Render();
    std::vector<double> errors;
    for (const PlanePixel& pixel : GetPlanePixels(scene, Width, Height))
    {
      if (pixel.Expected > 0.0 && pixel.Expected < 1.0)
      {
        errors.push_back(visibility.At(pixel.X, pixel.Y) - pixel.Expected);
      }
    }
    return RootMeanSquare(errors);
  };
  const double filtered = error();
  stage.Pass->SetFilter(vtkCascadedSoftShadowPass::FIXED);
  SetFilterSizes(stage.Pass, 1);
  const double points = error();
  RecordProperty("Filtered", std::to_string(filtered));
  RecordProperty("Points", std::to_string(points));
  EXPECT_LT(filtered, 0.5 * points) << "unfiltered " << points;
}

INSTANTIATE_TEST_SUITE_P(Scenes, CascadedFilteredForm, testing::ValuesIn(ClosedFormScenes()),
  [](const testing::TestParamInfo<NamedScene>& parameter) { return parameter.param.Name; });

TEST(CascadedFilter, UmbraAndLightStayAsTheyAre)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  const Picture expected = ExpectedPicture(scene, Width, Height);
  Stage stage(scene.Renderer);
  const Picture picture = stage.Render();
  int lit = 0;
  int dark = 0;
  double worst = 0.0;
  for (int y = 2; y < Height - 2; ++y)
  {
    for (int x = 2; x < Width - 2; ++x)
    {
      const float value = expected.At(x, y);
      // Two pixels off the penumbra: more than a texel, within which edges are ramps.
      bool isConstant = value == 0.0f || value == 1.0f;
      for (int i = 0; i < 25 && isConstant; ++i)
      {
        isConstant = expected.At(x + i % 5 - 2, y + i / 5 - 2) == value;
      }
      if (isConstant)
      {
        ++(value > 0.5f ? lit : dark);
        worst = std::max<double>(worst, std::abs(picture.At(x, y) - value));
      }
    }
  }
  EXPECT_GT(lit, 100);
  EXPECT_GT(dark, 100);
  EXPECT_LT(worst, 1e-5);
}

// Pixels whose own surface has one visibility all around keep it, whatever lies beside it.
TEST(CascadedFilter, NothingLeaksOverSilhouettesAndCreases)
{
  constexpr int Reach = 9; // more than the widest kernel there
  const auto renderer = MakeRoom(2.0);
  Stage stage(renderer);
  stage.Pass->SetMapSize(1024);
  SetSampleEdges(stage.Pass, 2);
  const Picture filtered = stage.Render();
  stage.Pass->SetFilter(vtkCascadedSoftShadowPass::FIXED);
  SetFilterSizes(stage.Pass, 3);
  const Picture banded = stage.Render();
  SetFilterSizes(stage.Pass, 1);
  const Picture points = stage.Render();
  const std::vector<int> surfaces = RoomSurfaces(renderer, PictureOf(stage.Pass->GetDepthImage()));
  int tested = 0;
  double worst = 0.0;
  for (int y = Reach; y < Height - Reach; ++y)
  {
    for (int x = Reach; x < Width - Reach; ++x)
    {
      const size_t center = static_cast<size_t>(y) * Width + x;
      // Where texels of another surface lie in front of a pixel's own plane, no filter is at fault.
      bool isConstant =
        surfaces[center] >= 0 && std::abs(points.Values[center] - banded.Values[center]) < 1e-3;
      bool hasOther = false;
      for (int i = 0; i < (2 * Reach + 1) * (2 * Reach + 1) && isConstant; ++i)
      {
        const size_t tap = center + static_cast<size_t>(i / (2 * Reach + 1)) * Width +
          static_cast<size_t>(i % (2 * Reach + 1)) - static_cast<size_t>(Reach) * Width - Reach;
        const bool differs = std::abs(points.Values[tap] - points.Values[center]) > 0.2;
        isConstant = surfaces[tap] != surfaces[center] || !differs;
        hasOther = hasOther || (surfaces[tap] != surfaces[center] && differs);
      }
      if (isConstant && hasOther)
      {
        ++tested;
        worst = std::max<double>(worst, std::abs(filtered.At(x, y) - points.At(x, y)));
      }
    }
  }
  EXPECT_GT(tested, 200);
  EXPECT_LT(worst, Grey);
}

// Pixels that a proof leaves out are taps of their neighbours all the same.
TEST(CascadedFilter, ProofsChangeNothing)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Stage stage(scene.Renderer);
  const Picture all = stage.Render();
  const vtkTypeInt64 pixels = stage.Pass->GetStatistics().PixelsFiltered;
  stage.Pass->EarlyOutOn();
  EXPECT_LT(LargestDifference(all, stage.Render()), 1e-4);
  EXPECT_LT(stage.Pass->GetStatistics().PixelsFiltered, pixels);
}

// More points, less banding.
TEST(CascadedFilter, BandingShrinksWithThePoints)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Stage stage(scene.Renderer);
  stage.Pass->SetFilter(vtkCascadedSoftShadowPass::FIXED);
  SetFilterSizes(stage.Pass, 2);
  const double coarse = Banding(scene, stage.Render());
  for (int i = 0; i < 3; ++i)
  {
    stage.Pass->SetSampleEdge(i, 12);
  }
  const double fine = Banding(scene, stage.Render());
  EXPECT_LT(fine, 0.6 * coarse);
}

// A shallow bowl under a lamp, all of which every facet sees: neighbours that rise over a facet's plane
// hide nothing.
TEST(CascadedFilter, FacetsThrowNoLines)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(8);
  sphere->SetStartPhi(120.0);
  sphere->SetEndPhi(180.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  AddQuad(renderer, { { -3, -3, -1 } }, { { 6, 0, 0 } }, { { 0, 6, 0 } });
  vtkNew<vtkAreaLight> lamp;
  lamp->SetConeAngle(60.0);
  lamp->SetPosition(0.3, 0.2, 4.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(1.0, 1.0);
  renderer->AddLight(lamp);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 4.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelProjection(1);
  camera->SetParallelScale(0.6);
  renderer->ResetCameraClippingRange();
  Stage stage(renderer);
  stage.Pass->SetMapSize(256);
  const auto darkest = [&]
  {
    const Picture visibility = stage.Render();
    double least = 1.0;
    // The bowl's radius is 0.43.
    const int reach = static_cast<int>(0.3 / 1.2 * Height);
    for (int y = Height / 2 - reach; y <= Height / 2 + reach; ++y)
    {
      for (int x = Width / 2 - reach; x <= Width / 2 + reach; ++x)
      {
        least = std::min(least, static_cast<double>(visibility.At(x, y)));
      }
    }
    return least;
  };
  // But for the texel under a fold.
  EXPECT_GT(darkest(), 0.98);
  stage.Pass->SetFilter(vtkCascadedSoftShadowPass::FIXED);
  EXPECT_LT(darkest(), 0.9); // or nothing was tested
}

// Without textureGather the same texels are read one by one.
TEST(CascadedFilter, GatherChangesNothing)
{
  const auto renderer = MakeAvenue(3.0);
  Stage stage(renderer);
  for (const bool adaptive : { false, true })
  {
    stage.Pass->SetAdaptive(adaptive);
    for (const int filter : { vtkCascadedSoftShadowPass::SCREEN, vtkCascadedSoftShadowPass::FIXED })
    {
      stage.Pass->SetFilter(filter);
      stage.Pass->GatherOn();
      const Picture gathered = stage.Render();
      stage.Pass->GatherOff();
      // What is within rounding of the tolerance settles on another level.
      EXPECT_LT(LargestDifference(gathered, stage.Render()), adaptive ? 0.125 : 1e-4)
        << "adaptive " << adaptive << ", filter " << filter;
    }
  }
}
