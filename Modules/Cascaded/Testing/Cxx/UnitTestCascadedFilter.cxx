// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The filter over the cascades' maps: no steps, no lines on facets, the same on every path.
#include "CascadedStage.h"

#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace SoftShadowsTesting;

namespace
{
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

// The numbers at the default settings are published. Boxes as wide as a cell's penumbra leave no steps.
TEST(CascadedFilter, CellsLeaveNoSteps)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Stage stage(scene.Renderer);
  stage.Pass->SetMapSize(vtkNew<vtkCascadedSoftShadowPass>()->GetMapSize());
  const double usual = Banding(scene, stage.Render());
  stage.Pass->SetFilter(vtkCascadedSoftShadowPass::WIDE);
  const double spread = Banding(scene, stage.Render());
  SetFilterSizes(stage.Pass, 1);
  const double unfiltered = Banding(scene, stage.Render());
  stage.Pass->SetMapSize(512);
  SetFilterSizes(stage.Pass, 15);
  const double wide = Banding(scene, stage.Render());
  RecordProperty("Banding", std::to_string(usual));
  RecordProperty("BandingSpread", std::to_string(spread));
  RecordProperty("BandingUnfiltered", std::to_string(unfiltered));
  RecordProperty("BandingWide", std::to_string(wide));
  EXPECT_LT(usual, unfiltered);
  EXPECT_LT(spread, usual);
  EXPECT_LT(wide, 1.0 / 255.0);
}

// More points, less banding.
TEST(CascadedFilter, BandingShrinksWithThePoints)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  Stage stage(scene.Renderer);
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
  lamp->PositionalOn();
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
    for (const int filter : { vtkCascadedSoftShadowPass::CELL, vtkCascadedSoftShadowPass::FIXED })
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
