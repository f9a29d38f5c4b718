// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Points of a lattice: their coordinates, their cells, and what edges in all directions make of them.

#include "vtkMath.h"
#include "vtkShadowEmitter.h"
#include "vtkShadowLattice.h"
#include "vtkShadowLightSampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace
{
using Sampling = vtkShadowLightSampling;

// What of a square [-1, 1]^2 or of its disk lies below the line x cos + y sin = offset.
double ShareBelow(bool disk, double angle, double offset)
{
  if (disk)
  {
    const double t = std::min(std::max(offset, -1.0), 1.0);
    return 1.0 - (std::acos(t) - t * std::sqrt(1.0 - t * t)) / vtkMath::Pi();
  }
  // A box filtered by a box: second differences of max(x, 0)^2.
  const double a = std::max(std::abs(std::cos(angle)), 1e-6);
  const double b = std::max(std::abs(std::sin(angle)), 1e-6);
  const auto square = [](double x) { return x > 0.0 ? x * x : 0.0; };
  return (square(offset + a + b) - square(offset + a - b) - square(offset - a + b) +
           square(offset - a - b)) /
    (8.0 * a * b);
}

// RMS over the places of a straight edge of what the points say the light shows beside it.
double ErrorAt(const std::vector<Sampling::Sample>& samples, bool disk, double angle)
{
  constexpr int places = 400;
  const double reach = disk ? 1.0 : std::abs(std::cos(angle)) + std::abs(std::sin(angle));
  double squares = 0.0;
  for (int k = 0; k < places; ++k)
  {
    const double offset = reach * ((2.0 * k + 1.0) / places - 1.0);
    double below = 0.0;
    for (const Sampling::Sample& sample : samples)
    {
      below +=
        sample.U * std::cos(angle) + sample.V * std::sin(angle) < offset ? sample.Weight : 0.0;
    }
    const double error = below - ShareBelow(disk, angle, offset);
    squares += error * error / places;
  }
  return std::sqrt(squares);
}

struct Errors
{
  double Axes = 0.0; // along the light's axes, the worse of both
  double All = 0.0;  // RMS over all directions
};

Errors ErrorsOf(int pattern, int count, bool disk)
{
  vtkShadowEmitter lamp;
  lamp.Shape = disk ? vtkShadowEmitter::DISK : vtkShadowEmitter::RECTANGLE;
  lamp.HalfSize = { { 0.5, 0.5 } };
  const auto samples = Sampling::Generate(lamp, count, pattern, Sampling::MEAN);
  constexpr int directions = 36;
  Errors errors;
  for (int k = 0; k < directions; ++k)
  {
    const double error = ErrorAt(samples, disk, vtkMath::Pi() * k / directions);
    errors.All += error * error / directions;
    errors.Axes = k % (directions / 2) == 0 ? std::max(errors.Axes, error) : errors.Axes;
  }
  errors.All = std::sqrt(errors.All);
  return errors;
}

double Length(const std::array<double, 2>& edge)
{
  return std::hypot(edge[0], edge[1]);
}
}

//------------------------------------------------------------------------------
// Every place of a step occurs once along either side, and the points are symmetric about the middle.
TEST(ShadowLattice, NoTwoPointsShareACoordinate)
{
  for (int count = 1; count <= 300; ++count)
  {
    const vtkShadowLattice lattice(count);
    std::set<int> places[2];
    std::set<std::pair<int, int>> points;
    for (int i = 0; i < count; ++i)
    {
      const auto point = lattice.GetPoint(i);
      int place[2];
      for (int axis = 0; axis < 2; ++axis)
      {
        const double step = 0.5 * (count * (point[axis] + 1.0) - 1.0);
        place[axis] = static_cast<int>(std::lround(step));
        ASSERT_NEAR(step, place[axis], 1e-9) << "point " << i << " of " << count;
        ASSERT_GE(place[axis], 0);
        ASSERT_LT(place[axis], count);
        places[axis].insert(place[axis]);
      }
      points.emplace(place[0], place[1]);
    }
    EXPECT_EQ(places[0].size(), static_cast<size_t>(count));
    EXPECT_EQ(places[1].size(), static_cast<size_t>(count));
    for (const auto& point : points)
    {
      EXPECT_EQ(points.count({ count - 1 - point.first, count - 1 - point.second }), 1u)
        << "of " << count;
    }
  }
}

//------------------------------------------------------------------------------
// No two points are nearer than the cell's shorter edge, and cells of that area tile the square.
TEST(ShadowLattice, PointsAreAsFarApartAsTheCellSays)
{
  for (const int count : { 4, 5, 9, 16, 25, 49, 64, 100, 256 })
  {
    const vtkShadowLattice lattice(count);
    double nearest = std::numeric_limits<double>::max();
    for (int i = 0; i < count; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        const auto a = lattice.GetPoint(i);
        const auto b = lattice.GetPoint(j);
        nearest = std::min(nearest, std::hypot(a[0] - b[0], a[1] - b[1]));
      }
    }
    const vtkShadowLattice::Basis cell = lattice.GetCell();
    EXPECT_NEAR(nearest, Length(cell[0]), 1e-12) << count << " points";
    EXPECT_LE(Length(cell[0]), Length(cell[1])) << count << " points";
    const double area = std::abs(cell[0][0] * cell[1][1] - cell[0][1] * cell[1][0]);
    EXPECT_GE(area, 4.0 / count - 1e-12);
    EXPECT_LE(area, 4.0 * (count + 1.0) / (1.0 * count * count) + 1e-12);
    // A square cell's edge, or a longer one.
    EXPECT_GE(Length(cell[0]), 0.999 * 2.0 / std::sqrt(count)) << count << " points";
  }
}

//------------------------------------------------------------------------------
// Edges along the light's axes: closed form, n steps of 1 / n have an RMS of 1 / (n sqrt(12)), a grid's
// sqrt(n) that many of 1 / sqrt(n).
TEST(ShadowLattice, EdgesAlongTheAxesHaveAStepPerPoint)
{
  for (const int count : { 16, 25, 64 })
  {
    const double step = 1.0 / (count * std::sqrt(12.0));
    EXPECT_NEAR(ErrorsOf(Sampling::LATTICE, count, false).Axes, step, 0.1 * step);
    EXPECT_GT(ErrorsOf(Sampling::GRID, count, false).Axes, 3.5 * step);
  }
}

//------------------------------------------------------------------------------
// Over all directions a lattice is no worse than the grid by more than an eighth, on disks too.
TEST(ShadowLattice, EdgesInAllDirectionsAreAsGoodAsTheGrids)
{
  for (const int count : { 4, 9, 16, 25, 36, 49, 64, 100, 144, 256 })
  {
    for (const bool disk : { false, true })
    {
      const Errors lattice = ErrorsOf(Sampling::LATTICE, count, disk);
      const Errors grid = ErrorsOf(Sampling::GRID, count, disk);
      EXPECT_LT(lattice.All, 1.125 * grid.All) << count << " points" << (disk ? " of a disk" : "");
      EXPECT_LT(lattice.Axes, disk ? 0.75 * grid.Axes : 0.55 * grid.Axes)
        << count << " points" << (disk ? " of a disk" : "");
    }
  }
}

//------------------------------------------------------------------------------
// As many points as a pass takes are found at once.
TEST(ShadowLattice, ManyPointsAreSpreadToo)
{
  for (const int count : { 1021, 1024, 4096 })
  {
    const vtkShadowLattice::Basis cell = vtkShadowLattice(count).GetCell();
    EXPECT_GT(Length(cell[0]), 2.0 / std::sqrt(count)) << count << " points";
  }
}
