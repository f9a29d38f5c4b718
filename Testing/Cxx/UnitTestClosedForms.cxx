// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The expected values of all other tests, against brute force: rays to many points of the light.
#include "ClosedForms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace SoftShadowsTesting;

namespace
{

const double Pi = 3.14159265358979323846;
const int GridSize = 1000;

//------------------------------------------------------------------------------
/// Mean of visible(u, v) over cell centres of the window [-1, 1]^2, weighted.
double Integrate(const std::function<double(double, double)>& weight,
  const std::function<bool(double, double)>& visible)
{
  double sum = 0.0;
  double total = 0.0;
  for (int j = 0; j < GridSize; ++j)
  {
    const double v = (2.0 * j + 1.0) / GridSize - 1.0;
    for (int i = 0; i < GridSize; ++i)
    {
      const double u = (2.0 * i + 1.0) / GridSize - 1.0;
      const double w = weight(u, v);
      total += w;
      sum += visible(u, v) ? w : 0.0;
    }
  }
  return sum / total;
}

//------------------------------------------------------------------------------
double Uniform(double, double)
{
  return 1.0;
}

//------------------------------------------------------------------------------
double Bell(double u, double v)
{
  return std::exp(-0.5 * (u * u + v * v) / (0.5 * 0.5));
}

//------------------------------------------------------------------------------
double DiskOnly(double u, double v)
{
  return u * u + v * v <= 1.0 ? 1.0 : 0.0;
}

/// A grid of N x N cells resolves a straight edge to about one row of cells.
const double GridTolerance = 2.0 / GridSize;

}

//------------------------------------------------------------------------------
TEST(ClosedForms, RectangleEqualsBruteForce)
{
  const Rectangle blocker{ { { -0.5, 0.3 } }, { { -0.2, 0.6 } }, 1.0 };
  const Rectangle light{ { { -0.3, 0.5 } }, { { -0.6, 0.1 } }, 3.5 };
  for (const Weights weights : { Weights::Mean, Weights::Gaussian })
  {
    for (int k = 0; k < 12; ++k)
    {
      const Point receiver{ { -0.9 + 0.15 * k, -0.4 + 0.1 * k, 0.2 } };
      const double expected = Integrate(weights == Weights::Mean ? Uniform : Bell,
        [&](double u, double v)
        {
          const double x = 0.5 * (light.X[0] + light.X[1]) + 0.5 * u * (light.X[1] - light.X[0]);
          const double y = 0.5 * (light.Y[0] + light.Y[1]) + 0.5 * v * (light.Y[1] - light.Y[0]);
          const double t = (blocker.Height - receiver[2]) / (light.Height - receiver[2]);
          const double hitX = receiver[0] + t * (x - receiver[0]);
          const double hitY = receiver[1] + t * (y - receiver[1]);
          return hitX < blocker.X[0] || hitX > blocker.X[1] || hitY < blocker.Y[0] ||
            hitY > blocker.Y[1];
        });
      EXPECT_NEAR(VisibilityOfRectangle(receiver, blocker, light, weights), expected, GridTolerance)
        << "receiver " << receiver[0] << ' ' << receiver[1]
        << (weights == Weights::Mean ? " mean" : " Gaussian");
    }
  }
}

//------------------------------------------------------------------------------
TEST(ClosedForms, WindowSharesSumToOne)
{
  for (const Weights weights : { Weights::Mean, Weights::Gaussian })
  {
    EXPECT_NEAR(WindowShare(-1.0, 1.0, weights), 1.0, 1e-15);
    EXPECT_NEAR(WindowShare(-9.0, 9.0, weights), 1.0, 1e-15);
    EXPECT_EQ(WindowShare(1.0, 5.0, weights), 0.0);
    EXPECT_EQ(WindowShare(0.5, 0.25, weights), 0.0);
    const double left = WindowShare(-1.0, 0.3, weights);
    const double right = WindowShare(0.3, 1.0, weights);
    EXPECT_NEAR(left + right, 1.0, 1e-15) << left << " + " << right;
  }
}

//------------------------------------------------------------------------------
TEST(ClosedForms, DiskEqualsBruteForce)
{
  const Point center{ { 0.4, -0.2, 4.0 } };
  const double radius = 0.7;
  for (int k = 0; k < 12; ++k)
  {
    const Point receiver{ { -0.5 + 0.1 * k, 0.3, 0.5 } };
    const double edge = 0.1;
    const double height = 1.5;
    const double expected = Integrate(DiskOnly,
      [&](double u, double)
      {
        const double x = center[0] + radius * u;
        const double t = (height - receiver[2]) / (center[2] - receiver[2]);
        return receiver[0] + t * (x - receiver[0]) > edge;
      });
    EXPECT_NEAR(VisibilityOfDisk(receiver, edge, height, center, radius), expected, GridTolerance)
      << "receiver " << receiver[0];
  }
}

//------------------------------------------------------------------------------
TEST(ClosedForms, SunEqualsBruteForce)
{
  // The sun at 50 degrees above a plane, inclined to the edge as well.
  const Point toSun{ { 0.4, 0.3, 0.6 } };
  const double length = std::sqrt(0.61);
  const Point axis{ { toSun[0] / length, toSun[1] / length, toSun[2] / length } };
  const double sideLength = std::hypot(axis[0], axis[2]);
  const Point right{ { axis[2] / sideLength, 0.0, -axis[0] / sideLength } };
  const Point up{ { axis[1] * right[2] - axis[2] * right[1],
    axis[2] * right[0] - axis[0] * right[2], axis[0] * right[1] - axis[1] * right[0] } };
  const double height = 1.0;
  for (const double degrees : { 0.53, 5.0, 60.0, 120.0 })
  {
    const double diameter = degrees * Pi / 180.0;
    for (int k = -6; k <= 6; ++k)
    {
      // The half plane z = height, x <= 0 blocks; receivers lie around the middle of the penumbra.
      const Point receiver{ { -toSun[0] / toSun[2] * height + 0.1 * k * diameter, 0.2, 0.0 } };
      const double expected = Integrate(DiskOnly,
        [&](double u, double v)
        {
          // Equal areas of the unit disk to equal areas of the cap.
          const double radius2 = u * u + v * v;
          const double cosine = 1.0 - radius2 * (1.0 - std::cos(0.5 * diameter));
          const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
          const double phi = std::atan2(v, u);
          Point d;
          for (int c = 0; c < 3; ++c)
          {
            d[c] = cosine * axis[c] + sine * (std::cos(phi) * right[c] + std::sin(phi) * up[c]);
          }
          return d[0] * height > -receiver[0] * d[2];
        });
      const double actual = VisibilityOfSun(receiver, { { 0.0, 5.0, height } },
        { { 0.0, 1.0, 0.0 } }, { { -1.0, 0.0, 0.0 } }, toSun, diameter);
      EXPECT_NEAR(actual, expected, GridTolerance)
        << degrees << " degrees, receiver x " << receiver[0];
    }
  }
}

//------------------------------------------------------------------------------
TEST(ClosedForms, SmallCapIsDisk)
{
  const double halfAngle = 0.5 * 0.53 * Pi / 180.0;
  for (int k = -5; k <= 5; ++k)
  {
    const double t = 0.2 * k;
    EXPECT_NEAR(CapShareBelow(-t * halfAngle, halfAngle), DiskShare(t), 1e-5) << "at " << t;
  }
  EXPECT_EQ(CapShareBelow(0.1, 0.0), 0.0);
  EXPECT_EQ(CapShareBelow(-0.1, 0.0), 1.0);
}
