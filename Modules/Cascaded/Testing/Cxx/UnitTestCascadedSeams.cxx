// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where cascades of different points and maps meet: no seam beside the truth.
#include "CascadedStage.h"
#include "WorldPositions.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace SoftShadowsTesting;

namespace
{
constexpr double Pi = 3.14159265358979;
constexpr double FarthestRow = 1.2; // beyond the first transition
constexpr double BoardHeight = 3.0;
constexpr double HalfBoard = 0.8;
constexpr double Grey = 1.0 / 255.0; // what an eight-bit picture can show
constexpr double SunRadius = 8.0;    // degrees

// A vertical sun, and a board above the ground that runs from the camera to the horizon: the visibility
// does not depend on the depth, but the cascades do.
vtkSmartPointer<vtkRenderer> MakeArcade()
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -30, -20, 0 } }, { { 60, 0, 0 } }, { { 0, 28, 0 } });
  AddQuad(renderer, { { -HalfBoard, -20, BoardHeight } }, { { 2.0 * HalfBoard, 0, 0 } },
    { { 0, 28, 0 } });
  vtkNew<vtkAreaLight> sun;
  sun->SetPosition(0.0, 0.0, 5.0);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetAngularDiameter(2.0 * SunRadius);
  renderer->AddLight(sun);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -8.0, 2.5);
  camera->SetFocalPoint(0.0, 6.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
  renderer->ResetCameraClippingRange();
  return renderer;
}

// The part of a disk beyond a straight edge at t radii from its middle.
double Beyond(double t)
{
  t = std::min(std::max(t, -1.0), 1.0);
  return (std::acos(t) - t * std::sqrt(1.0 - t * t)) / Pi;
}

double Truth(double x)
{
  const double radius = BoardHeight * std::tan(vtkMath::RadiansFromDegrees(SunRadius));
  return Beyond((HalfBoard - x) / radius) + Beyond((HalfBoard + x) / radius);
}

// How much the error changes from a row of pixels to the next one, at most: in the mean over the row's
// penumbrae, what the eye takes for a seam, and in root mean square.
struct Jumps
{
  double Mean = 0.0;
  double RootMeanSquare = 0.0;
};

Jumps FindJumps(vtkRenderer* renderer, const Picture& visibility)
{
  const std::vector<Point> points =
    PlanePositions(renderer, Width, Height, { { { 0, 0, 0 } }, { { 0, 0, 1 } } });
  Jumps worst;
  int rows = 0;
  for (int y = 0; y + 1 < Height; ++y)
  {
    std::vector<double> jumps;
    for (int x = 0; x < Width; ++x)
    {
      const size_t here = static_cast<size_t>(y) * Width + x;
      const double truth[2] = { Truth(points[here][0]), Truth(points[here + Width][0]) };
      const double jump =
        (visibility.Values[here + Width] - truth[1]) - (visibility.Values[here] - truth[0]);
      if (truth[0] > 0.0 && truth[0] < 1.0 && points[here + Width][1] < FarthestRow &&
        !std::isnan(jump))
      {
        jumps.push_back(jump);
      }
    }
    if (jumps.size() > 8)
    {
      const double sum = std::accumulate(jumps.begin(), jumps.end(), 0.0);
      worst.Mean = std::max(worst.Mean, std::abs(sum / static_cast<double>(jumps.size())));
      worst.RootMeanSquare = std::max(worst.RootMeanSquare, RootMeanSquare(jumps));
      ++rows;
    }
  }
  EXPECT_GT(rows, 40);
  return worst;
}
}

// At the default settings, sixteen points meet nine among these rows: no row stands out from the one
// before by more than with one cascade. With the paper's filter some do.
TEST(CascadedSeams, TransitionsAreNotSeen)
{
  const auto renderer = MakeArcade();
  Stage stage(renderer);
  stage.Pass->SetMapSize(vtkNew<vtkCascadedSoftShadowPass>()->GetMapSize());
  const auto find = [&](int filter, int cascades)
  {
    stage.Pass->SetFilter(filter);
    stage.Pass->SetNumberOfCascades(cascades);
    const Picture visibility = stage.Render();
    EXPECT_EQ(stage.Pass->GetNumberOfOccupiedCascades(), cascades);
    return FindJumps(renderer, visibility);
  };
  const Jumps single = find(vtkCascadedSoftShadowPass::SCREEN, 1);
  const Jumps usual = find(vtkCascadedSoftShadowPass::SCREEN, 3);
  RecordProperty("Mean", std::to_string(usual.Mean));
  RecordProperty("RootMeanSquare", std::to_string(usual.RootMeanSquare));
  RecordProperty("MeanOfOneCascade", std::to_string(single.Mean));
  EXPECT_LT(usual.Mean, single.Mean + 0.5 * Grey);
  EXPECT_LT(usual.RootMeanSquare, single.RootMeanSquare + Grey);
  EXPECT_LT(usual.Mean, 1.5 * Grey);
  const Jumps singleFixed = find(vtkCascadedSoftShadowPass::FIXED, 1);
  const Jumps fixed = find(vtkCascadedSoftShadowPass::FIXED, 3);
  EXPECT_GT(fixed.Mean, singleFixed.Mean + Grey); // or nothing is measured
}
