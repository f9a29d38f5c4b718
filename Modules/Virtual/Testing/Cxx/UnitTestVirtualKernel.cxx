// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Kernels against numeric integration, and the sums of their overlaps with texels.

#include "vtkMath.h"
#include "vtkVirtualKernel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 2>;
const Vector Unit = { { 1.0, 1.0 } };

struct Shape
{
  std::string Name;
  Vector Light;
  Vector U;
  Vector V;
};

// Half extents in texels: lights and footprints of every kind, the degenerate ones last.
const std::vector<Shape>& Shapes()
{
  static const std::vector<Shape> shapes = {
    { "light alone", { { 5.3, 3.7 } }, { { 0.0, 0.0 } }, { { 0.0, 0.0 } } },
    { "small footprint", { { 5.3, 3.7 } }, { { 0.4, 0.1 } }, { { -0.1, 0.3 } } },
    { "footprint alone", { { 0.0, 0.0 } }, { { 3.0, 1.0 } }, { { -1.0, 2.0 } } },
    { "long footprint along s", { { 0.5, 0.5 } }, { { 20.0, 1.0 } }, { { 0.0, 0.5 } } },
    { "long footprint along t", { { 0.5, 0.5 } }, { { 1.0, 20.0 } }, { { 0.5, 0.0 } } },
    { "diagonal footprint", { { 1.0, 1.0 } }, { { 10.0, 10.0 } }, { { 0.5, -0.5 } } },
    { "one texel", { { 0.5, 0.5 } }, { { 0.0, 0.0 } }, { { 0.0, 0.0 } } },
    { "line light", { { 7.0, 0.0 } }, { { 0.0, 0.0 } }, { { 0.0, 0.0 } } },
    { "edge-on footprint", { { 0.0, 0.0 } }, { { 5.0, 2.0 } }, { { -2.5, -1.0 } } },
    { "point", { { 0.0, 0.0 } }, { { 0.0, 0.0 } }, { { 0.0, 0.0 } } },
  };
  return shapes;
}

vtkVirtualKernel MakeKernel(const Shape& shape, bool disk)
{
  return vtkVirtualKernel::FromVariance(
    vtkVirtualKernel::Convolve(shape.Light, disk, vtkVirtualKernel::Variance(shape.U, shape.V)),
    disk, Unit);
}

double Everywhere(int, int)
{
  return 1.0;
}

// A map of texels: a half plane, as a depth map would show it.
double HalfPlane(int x, int y)
{
  return 0.6 * (x - 49.5) + 0.8 * (y - 49.5) < 0.0 ? 1.0 : 0.0;
}

double HalfPlaneAt(double x, double y)
{
  return HalfPlane(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
}

// The parallelogram or ellipse itself, integrated on a fine grid of points.
double IntegrateHalfPlane(const vtkVirtualKernel& kernel, double s, double t)
{
  const int count = 801;
  double lit = 0.0;
  double total = 0.0;
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      const double a = (2.0 * i + 1.0) / count - 1.0;
      const double b = (2.0 * j + 1.0) / count - 1.0;
      if (kernel.Disk && a * a + b * b > 1.0)
      {
        continue;
      }
      const double along = kernel.Along * a;
      const double across = kernel.Lean * a + kernel.Across * b;
      lit +=
        kernel.Transposed ? HalfPlaneAt(s + across, t + along) : HalfPlaneAt(s + along, t + across);
      total += 1.0;
    }
  }
  return lit / total;
}
} // namespace

TEST(VirtualKernel, OverlapsSumToTheArea)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> somewhere(40.0, 60.0);
  for (const Shape& shape : Shapes())
  {
    for (const bool disk : { false, true })
    {
      const vtkVirtualKernel kernel = MakeKernel(shape, disk);
      for (int i = 0; i < 50; ++i)
      {
        const double s = somewhere(random);
        const double t = somewhere(random);
        const double area = kernel.Filter(s, t, 100, 100, Everywhere)[1];
        EXPECT_NEAR(area / kernel.GetArea(), 1.0, 1e-4)
          << shape.Name << " disk " << disk << " at " << s << ", " << t;
      }
    }
  }
}

TEST(VirtualKernel, OverlapOfAnAlignedBoxIsExact)
{
  const vtkVirtualKernel kernel = MakeKernel(Shapes()[0], false);
  // [4.7, 15.3] x [6.3, 13.7] around (10, 10).
  EXPECT_NEAR(kernel.GetOverlap(10.0, 10.0, 4, 6), 0.3 * 0.7, 1e-12);
  EXPECT_NEAR(kernel.GetOverlap(10.0, 10.0, 15, 13), 0.3 * 0.7, 1e-12);
  EXPECT_NEAR(kernel.GetOverlap(10.0, 10.0, 10, 10), 1.0, 1e-12);
  EXPECT_NEAR(kernel.GetOverlap(10.0, 10.0, 3, 10), 0.0, 1e-12);
  EXPECT_NEAR(kernel.GetOverlap(10.0, 10.0, 10, 14), 0.0, 1e-12);
}

TEST(VirtualKernel, VarianceOfLightAndFootprintAdd)
{
  const vtkVirtualVariance footprint =
    vtkVirtualKernel::Variance({ { 3.0, 1.0 } }, { { -1.0, 2.0 } });
  EXPECT_NEAR(footprint[0], 10.0, 1e-12);
  EXPECT_NEAR(footprint[1], 1.0, 1e-12);
  EXPECT_NEAR(footprint[2], 5.0, 1e-12);
  const vtkVirtualVariance sum = vtkVirtualKernel::Convolve({ { 2.0, 3.0 } }, false, footprint);
  const vtkVirtualKernel kernel = vtkVirtualKernel::FromVariance(sum, false, Unit);
  // L L^T is the sum again, with the longer axis first.
  const int longer = sum[0] >= sum[2] ? 0 : 2;
  EXPECT_EQ(kernel.Transposed, longer == 2);
  EXPECT_NEAR(kernel.Along * kernel.Along, sum[longer], 1e-12);
  EXPECT_NEAR(kernel.Along * kernel.Lean, sum[1], 1e-12);
  EXPECT_NEAR(kernel.Lean * kernel.Lean + kernel.Across * kernel.Across, sum[2 - longer], 1e-12);
}

TEST(VirtualKernel, TheKernelHasTheVarianceOfItsParts)
{
  // Points of a disk light plus points of a footprint: second moments add, whatever the shapes.
  for (const bool disk : { false, true })
  {
    const Shape shape = { "", { { 2.0, 2.0 } }, { { 3.0, 1.0 } }, { { -1.0, 2.0 } } };
    const vtkVirtualKernel kernel = MakeKernel(shape, disk);
    const double perKernel = disk ? 0.25 : 1.0 / 3.0;
    const double perLight = disk ? 0.25 : 1.0 / 3.0;
    const double expected = perLight * 4.0 + (9.0 + 1.0) / 3.0;
    EXPECT_NEAR(perKernel * kernel.Along * kernel.Along, expected, 1e-12) << "disk " << disk;
  }
}

TEST(VirtualKernel, EqualsNumericIntegration)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> somewhere(48.0, 52.0);
  for (const Shape& shape : Shapes())
  {
    for (const bool disk : { false, true })
    {
      const vtkVirtualKernel kernel = MakeKernel(shape, disk);
      // The integration itself is good to 1 / 801 of the kernel. Strips are boxes: where the kernel
      // leans, or is round, its border is off by up to half a texel, to both sides alike.
      const bool aligned = !disk && kernel.Lean == 0.0;
      const double tolerance = aligned ? 0.004 : 0.004 + 0.06 / (1.0 + kernel.Along);
      for (int i = 0; i < 20; ++i)
      {
        const double s = somewhere(random);
        const double t = somewhere(random);
        const std::array<double, 2> sums = kernel.Filter(s, t, 100, 100, HalfPlane);
        const double error = std::abs(sums[0] / sums[1] - IntegrateHalfPlane(kernel, s, t));
        EXPECT_LE(error, tolerance) << shape.Name << " disk " << disk << " at " << s << ", " << t;
      }
    }
  }
}

TEST(VirtualKernel, MovesWithoutSteps)
{
  // The worst map there is: a chessboard of single texels.
  const auto chessboard = [](int x, int y) { return (x + y) % 2 ? 1.0 : 0.0; };
  for (const Shape& shape : Shapes())
  {
    for (const bool disk : { false, true })
    {
      const vtkVirtualKernel kernel = MakeKernel(shape, disk);
      if (kernel.Across < 0.1)
      {
        continue; // a line or a point moves from texel to texel in one step
      }
      const double step = 0.01;
      // All that a step can change is the area it sweeps at the kernel's border.
      const double share =
        4.0 * step * (kernel.Along + kernel.Across + std::abs(kernel.Lean)) / kernel.GetArea();
      double before = -1.0;
      for (int i = 0; i < 400; ++i)
      {
        const std::array<double, 2> sums =
          kernel.Filter(48.0 + i * step, 50.3 + 0.37 * i * step, 100, 100, chessboard);
        const double now = sums[0] / sums[1];
        EXPECT_TRUE(i == 0 || std::abs(now - before) <= share)
          << shape.Name << " disk " << disk << " step " << i << ": " << before << " to " << now
          << ", share " << share;
        before = now;
      }
    }
  }
}

TEST(VirtualKernel, MirroredAxesGiveTheMirroredResult)
{
  const auto map = [](int x, int y) { return (7 * x + 3 * y) % 5 < 2 ? 1.0 : 0.0; };
  const auto mirrored = [&map](int x, int y) { return map(y, x); };
  for (const Shape& shape : Shapes())
  {
    const Shape other = { shape.Name, { { shape.Light[1], shape.Light[0] } },
      { { shape.U[1], shape.U[0] } }, { { shape.V[1], shape.V[0] } } };
    const vtkVirtualKernel kernel = MakeKernel(shape, false);
    if (std::abs(kernel.Along - std::abs(kernel.Lean) - kernel.Across) < 1e-9)
    {
      continue; // which axis is longer is a matter of rounding
    }
    const std::array<double, 2> sums = kernel.Filter(50.2, 49.1, 100, 100, map);
    const std::array<double, 2> mirror =
      MakeKernel(other, false).Filter(49.1, 50.2, 100, 100, mirrored);
    const vtkVirtualVariance variance =
      vtkVirtualKernel::Convolve(shape.Light, false, vtkVirtualKernel::Variance(shape.U, shape.V));
    if (variance[0] != variance[2])
    {
      EXPECT_NEAR(sums[0] / sums[1], mirror[0] / mirror[1], 1e-9) << shape.Name;
    }
  }
}
