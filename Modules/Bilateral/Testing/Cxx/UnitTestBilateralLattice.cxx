// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The points of the light: well spread, and with the light's own moments.

#include "vtkBilateralLattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
vtkShadowEmitter MakeEmitter(int shape)
{
  vtkShadowEmitter emitter;
  emitter.Shape = shape;
  emitter.HalfSize = { { 1.0, 1.0 } };
  return emitter;
}

// Coordinates in ascending order.
std::vector<double> Sorted(const vtkBilateralLattice& lattice, bool along)
{
  std::vector<double> coordinates;
  for (const vtkShadowLightSampling::Sample& sample : lattice.GetSamples())
  {
    coordinates.push_back(along ? sample.V : sample.U);
  }
  std::sort(coordinates.begin(), coordinates.end());
  return coordinates;
}
} // namespace

TEST(BilateralLattice, NoTwoPointsShareACoordinate)
{
  for (const int count : { 1, 2, 3, 5, 15, 25, 64 })
  {
    const vtkBilateralLattice lattice(MakeEmitter(vtkShadowEmitter::RECTANGLE), count, 0, false);
    ASSERT_EQ(lattice.GetSamples().size(), static_cast<size_t>(count));
    for (const bool along : { false, true })
    {
      const std::vector<double> coordinates = Sorted(lattice, along);
      for (int i = 0; i < count; ++i)
      {
        EXPECT_NEAR(coordinates[i], (2.0 * i + 1.0) / count - 1.0, 1e-12) << count;
      }
    }
  }
}

// Three points on a line would leave the bands of edges across it unsmoothed.
TEST(BilateralLattice, ThreePointsAreATriangleAndFiveAQuincunx)
{
  const vtkShadowEmitter emitter = MakeEmitter(vtkShadowEmitter::RECTANGLE);
  const vtkBilateralLattice three(emitter, 3, 0, false);
  const auto& t = three.GetSamples();
  const double area = (t[1].U - t[0].U) * (t[2].V - t[0].V) - (t[2].U - t[0].U) * (t[1].V - t[0].V);
  EXPECT_GT(std::abs(area), 1.0);

  const vtkBilateralLattice five(emitter, 5, 0, false);
  EXPECT_NEAR(five.GetSamples()[2].U, 0.0, 1e-12);
  EXPECT_NEAR(five.GetSamples()[2].V, 0.0, 1e-12);
  for (const int i : { 0, 1, 3, 4 })
  {
    EXPECT_NEAR(std::hypot(five.GetSamples()[i].U, five.GetSamples()[i].V), std::sqrt(0.8), 1e-12);
  }
}

TEST(BilateralLattice, CellsTileTheLight)
{
  for (const int count : { 1, 2, 3, 5, 15, 25 })
  {
    const vtkBilateralLattice lattice(MakeEmitter(vtkShadowEmitter::RECTANGLE), count, 0, false);
    const auto& cell = lattice.GetCell();
    const double area = std::abs(cell[0][0] * cell[1][1] - cell[0][1] * cell[1][0]);
    EXPECT_NEAR(area, 4.0 / count, 1e-12);
    const double longest =
      std::max(std::hypot(cell[0][0], cell[0][1]), std::hypot(cell[1][0], cell[1][1]));
    EXPECT_LT(longest * longest, 2.0 * area) << "a narrow cell for " << count;
  }
}

TEST(BilateralLattice, TiledPointsAndCellsHaveTheLightsVariance)
{
  for (const int shape : { vtkShadowEmitter::RECTANGLE, vtkShadowEmitter::DISK })
  {
    for (const int count : { 1, 3, 5, 15, 25 })
    {
      const vtkBilateralLattice lattice(MakeEmitter(shape), count, 0, true);
      double sum = 0.0;
      double weights = 0.0;
      for (const vtkShadowLightSampling::Sample& sample : lattice.GetSamples())
      {
        sum += sample.Weight * (sample.U * sample.U + sample.V * sample.V);
        weights += sample.Weight;
      }
      for (const auto& edge : lattice.GetCell())
      {
        sum += (edge[0] * edge[0] + edge[1] * edge[1]) / 12.0;
      }
      EXPECT_NEAR(weights, 1.0, 1e-12);
      EXPECT_NEAR(sum, shape == vtkShadowEmitter::DISK ? 1.0 / 2.0 : 2.0 / 3.0, 1e-12) << count;
    }
  }
}

TEST(BilateralLattice, ALightWithoutExtentHasOnePoint)
{
  vtkShadowEmitter emitter;
  const vtkBilateralLattice lattice(emitter, 15, 0, true);
  ASSERT_EQ(lattice.GetSamples().size(), 1u);
  EXPECT_EQ(lattice.GetSamples()[0].U, 0.0);
  EXPECT_EQ(lattice.GetSamples()[0].V, 0.0);
  EXPECT_EQ(lattice.GetSamples()[0].Weight, 1.0);
}
