// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The projective map of a depth map: by hand, and the two properties that carry every technique.

#include "vtkMath.h"
#include "vtkShadowEmitter.h"
#include "vtkShadowMapView.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace
{
using Vector = std::array<double, 3>;

Vector Transform(const std::array<double, 16>& matrix, const Vector& point)
{
  double result[4];
  for (int row = 0; row < 4; ++row)
  {
    result[row] = matrix[4 * row] * point[0] + matrix[4 * row + 1] * point[1] +
      matrix[4 * row + 2] * point[2] + matrix[4 * row + 3];
  }
  return { { result[0] / result[3], result[1] / result[3], result[2] / result[3] } };
}

// World coordinates of emitter coordinates.
Vector FromEmitter(const vtkShadowEmitter& emitter, double x, double y, double z)
{
  Vector point;
  for (int i = 0; i < 3; ++i)
  {
    point[i] =
      emitter.Center[i] + x * emitter.AxisU[i] + y * emitter.AxisV[i] + z * emitter.Direction[i];
  }
  return point;
}

class Random
{
public:
  double Between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }

  // Any direction, any place, a window that need not be centred.
  vtkShadowMapView View(bool directional)
  {
    vtkShadowMapView view;
    vtkShadowEmitter& emitter = view.Emitter;
    emitter.Directional = directional;
    emitter.Shape = vtkShadowEmitter::RECTANGLE;
    Vector up;
    for (int i = 0; i < 3; ++i)
    {
      emitter.Center[i] = this->Between(-5.0, 5.0);
      emitter.Direction[i] = this->Between(-1.0, 1.0);
      up[i] = this->Between(-1.0, 1.0);
    }
    vtkMath::Normalize(emitter.Direction.data());
    vtkMath::Cross(emitter.Direction.data(), up.data(), emitter.AxisU.data());
    vtkMath::Normalize(emitter.AxisU.data());
    vtkMath::Cross(emitter.AxisU.data(), emitter.Direction.data(), emitter.AxisV.data());
    emitter.HalfSize = { { this->Between(0.01, 0.5), this->Between(0.01, 0.5) } };
    view.Window = { { this->Between(-2.0, 0.0), this->Between(0.1, 2.0), this->Between(-2.0, 0.0),
      this->Between(0.1, 2.0) } };
    view.Near = directional ? this->Between(-3.0, 1.0) : this->Between(0.1, 1.0);
    view.Far = view.Near + this->Between(0.5, 10.0);
    return view;
  }

private:
  std::minstd_rand Engine{ 7 };
};

vtkShadowMapView HandView(bool directional)
{
  vtkShadowMapView view;
  view.Emitter.Directional = directional;
  view.Emitter.Shape = vtkShadowEmitter::RECTANGLE;
  view.Emitter.Center = { { 10.0, 20.0, 30.0 } }; // looks down: z = 30 - world z
  view.Emitter.HalfSize = { { 0.5, 0.25 } };
  view.Window = { { -1.0, 3.0, -2.0, 2.0 } };
  view.Near = 2.0;
  view.Far = 8.0;
  return view;
}
} // namespace

//------------------------------------------------------------------------------
TEST(ShadowMapView, PositionalMapByHand)
{
  const vtkShadowMapView view = HandView(false);
  // Emitter coordinates (4, 2, 4): x / z = 1, y / z = 1/2, 1 / z = 1/4.
  const Vector map = Transform(view.WorldToMap(), { { 14.0, 22.0, 26.0 } });
  EXPECT_NEAR(map[0], (1.0 + 1.0) / 4.0, 1e-14);
  EXPECT_NEAR(map[1], (0.5 + 2.0) / 4.0, 1e-14);
  EXPECT_NEAR(map[2], (1.0 / 4.0 - 1.0 / 8.0) / (1.0 / 8.0 - 1.0 / 2.0), 1e-14);
  EXPECT_NEAR(view.GetDepthToLinear()[0], 0.125, 1e-15);
  EXPECT_NEAR(view.GetDepthToLinear()[1], -0.375, 1e-15);
  // At 1 / z_o - 1 / z_q = 0.375 (d = -1 and 0) the light's half extent is 0.5 * 0.375 in x / z.
  EXPECT_NEAR(view.GetKernelScale()[0], 0.5 * 0.375 / 4.0, 1e-15);
  EXPECT_NEAR(view.GetKernelScale()[1], 0.25 * 0.375 / 4.0, 1e-15);
}

//------------------------------------------------------------------------------
TEST(ShadowMapView, DirectionalMapByHand)
{
  const vtkShadowMapView view = HandView(true);
  const Vector map = Transform(view.WorldToMap(), { { 12.0, 19.0, 25.0 } });
  EXPECT_NEAR(map[0], (2.0 + 1.0) / 4.0, 1e-14);
  EXPECT_NEAR(map[1], (-1.0 + 2.0) / 4.0, 1e-14);
  EXPECT_NEAR(map[2], (5.0 - 8.0) / 6.0, 1e-14);
  EXPECT_NEAR(view.GetDepthToLinear()[0], 8.0, 1e-15);
  EXPECT_NEAR(view.GetDepthToLinear()[1], 6.0, 1e-15);
  EXPECT_NEAR(view.GetKernelScale()[0], 0.5 * 6.0 / 4.0, 1e-15);
  EXPECT_NEAR(view.GetKernelScale()[1], 0.25 * 6.0 / 4.0, 1e-15);
}

class ShadowMapViewProperty : public testing::TestWithParam<bool>
{
protected:
  // A point before the map's eye, in emitter coordinates.
  Vector AnyPoint(const vtkShadowMapView& view)
  {
    return { { this->Any.Between(-3.0, 3.0), this->Any.Between(-3.0, 3.0),
      this->Any.Between(view.Near, view.Far) } };
  }
  Random Any;
};

INSTANTIATE_TEST_SUITE_P(Lights, ShadowMapViewProperty, testing::Bool(),
  [](const testing::TestParamInfo<bool>& instance)
  { return instance.param ? "Directional" : "Positional"; });

//------------------------------------------------------------------------------
TEST_P(ShadowMapViewProperty, CornersOfTheWindowAreCornersOfTheMap)
{
  for (int trial = 0; trial < 100; ++trial)
  {
    const vtkShadowMapView view = this->Any.View(this->GetParam());
    for (int corner = 0; corner < 8; ++corner)
    {
      const double expected[3] = { double(corner & 1), double(corner >> 1 & 1),
        double(corner >> 2 & 1) };
      const double z = expected[2] > 0.0 ? view.Far : view.Near;
      const double spread = this->GetParam() ? 1.0 : z;
      const Vector world = FromEmitter(view.Emitter, view.Window[corner & 1] * spread,
        view.Window[2 + (corner >> 1 & 1)] * spread, z);
      const Vector map = Transform(view.WorldToMap(), world);
      const Vector clip = Transform(view.WorldToClip(), world);
      const Vector halfClip = Transform(view.WorldToClip(true), world);
      for (int i = 0; i < 2; ++i)
      {
        EXPECT_NEAR(map[i], expected[i], 1e-10) << "trial " << trial << ", corner " << corner;
        EXPECT_NEAR(clip[i], 2.0 * expected[i] - 1.0, 1e-10)
          << "trial " << trial << ", corner " << corner;
        EXPECT_EQ(halfClip[i], clip[i]) << "trial " << trial << ", corner " << corner;
      }
      EXPECT_NEAR(map[2], expected[2] - 1.0, 1e-10) << "trial " << trial << ", corner " << corner;
      EXPECT_NEAR(clip[2], 1.0 - 2.0 * expected[2], 1e-10) << "trial " << trial;
      EXPECT_NEAR(halfClip[2], 1.0 - expected[2], 1e-10) << "trial " << trial;
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(ShadowMapViewProperty, ClipCoordinatesAreMapCoordinatesStretched)
{
  for (int trial = 0; trial < 200; ++trial)
  {
    const vtkShadowMapView view = this->Any.View(this->GetParam());
    const Vector p = this->AnyPoint(view);
    const Vector world = FromEmitter(view.Emitter, p[0], p[1], p[2]);
    const Vector map = Transform(view.WorldToMap(), world);
    const Vector clip = Transform(view.WorldToClip(), world);
    const double expected[3] = { 2.0 * map[0] - 1.0, 2.0 * map[1] - 1.0, -2.0 * map[2] - 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(clip[i], expected[i], 1e-9 * (1.0 + std::abs(map[i])))
        << "trial " << trial << ", component " << i;
    }
    EXPECT_NEAR(Transform(view.WorldToClip(true), world)[2], -map[2], 1e-9);
  }
}

//------------------------------------------------------------------------------
TEST_P(ShadowMapViewProperty, LinearDepthUndoesTheMapsDepth)
{
  for (int trial = 0; trial < 200; ++trial)
  {
    const vtkShadowMapView view = this->Any.View(this->GetParam());
    const Vector p = this->AnyPoint(view);
    const Vector world = FromEmitter(view.Emitter, p[0], p[1], p[2]);
    const double depth = Transform(view.WorldToMap(), world)[2];
    EXPECT_GE(depth, -1.0 - 1e-10) << "trial " << trial;
    EXPECT_LE(depth, 1e-10) << "trial " << trial;
    EXPECT_NEAR(view.LinearDepth(depth), p[2], 1e-9 * (1.0 + std::abs(p[2])))
      << "trial " << trial << ", depth value " << depth;
  }
}

//------------------------------------------------------------------------------
TEST_P(ShadowMapViewProperty, PlanesStayPlanes)
{
  for (int trial = 0; trial < 200; ++trial)
  {
    const vtkShadowMapView view = this->Any.View(this->GetParam());
    const Vector a = this->AnyPoint(view);
    const Vector b = this->AnyPoint(view);
    const Vector c = this->AnyPoint(view);
    // A convex mean of three points is on their plane and before the eye.
    double weights[3] = { this->Any.Between(0.1, 1.0), this->Any.Between(0.1, 1.0),
      this->Any.Between(0.1, 1.0) };
    const double sum = weights[0] + weights[1] + weights[2];
    Vector d;
    for (int i = 0; i < 3; ++i)
    {
      d[i] = (weights[0] * a[i] + weights[1] * b[i] + weights[2] * c[i]) / sum;
    }
    const auto matrix = view.WorldToMap();
    Vector edges[3];
    const Vector origin = Transform(matrix, FromEmitter(view.Emitter, a[0], a[1], a[2]));
    int edge = 0;
    for (const Vector& corner : { b, c, d })
    {
      const Vector map =
        Transform(matrix, FromEmitter(view.Emitter, corner[0], corner[1], corner[2]));
      vtkMath::Subtract(map.data(), origin.data(), edges[edge].data());
      vtkMath::Normalize(edges[edge].data());
      ++edge;
    }
    EXPECT_NEAR(
      vtkMath::Determinant3x3(edges[0].data(), edges[1].data(), edges[2].data()), 0.0, 1e-8)
      << "trial " << trial;
  }
}

//------------------------------------------------------------------------------
TEST_P(ShadowMapViewProperty, KernelIsTheImageOfTheLightAtTheBlockersDepth)
{
  for (int trial = 0; trial < 500; ++trial)
  {
    const vtkShadowMapView view = this->Any.View(this->GetParam());
    const vtkShadowEmitter& emitter = view.Emitter;
    const auto matrix = view.WorldToMap();
    const Vector q = this->AnyPoint(view);
    const Vector receiver = FromEmitter(emitter, q[0], q[1], q[2]);
    const double blockerZ = this->Any.Between(view.Near, q[2]);
    const double u = this->Any.Between(-1.0, 1.0);
    const double v = this->Any.Between(-1.0, 1.0);

    // Where the ray from the receiver to the light's point (u, v) meets the blocker's depth.
    const vtkShadowEmitter point = emitter.PointAt(u, v, 1.0);
    Vector ray; // from the light to the receiver
    if (emitter.Directional)
    {
      ray = point.Direction;
    }
    else
    {
      vtkMath::Subtract(receiver.data(), point.Center.data(), ray.data());
    }
    const double along = vtkMath::Dot(ray.data(), emitter.Direction.data());
    Vector blocker;
    for (int i = 0; i < 3; ++i)
    {
      blocker[i] = receiver[i] - (q[2] - blockerZ) / along * ray[i];
    }

    const Vector receiverMap = Transform(matrix, receiver);
    const Vector blockerMap = Transform(matrix, blocker);
    const double difference = receiverMap[2] - blockerMap[2];
    const std::array<double, 2> scale = view.GetKernelScale();
    const double expected[2] = { u * scale[0] * difference, v * scale[1] * difference };
    EXPECT_GE(difference, -1e-12) << "trial " << trial;
    for (int i = 0; i < 2; ++i)
    {
      EXPECT_GT(scale[i], 0.0) << "trial " << trial;
      EXPECT_NEAR(blockerMap[i] - receiverMap[i], expected[i], 1e-9)
        << "trial " << trial << ", axis " << i << ", light point (" << u << ", " << v << ")";
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowMapView, EqualityComparesEveryMember)
{
  const vtkShadowMapView view = HandView(false);
  vtkShadowMapView other = view;
  EXPECT_EQ(view, other);
  other.Near = 2.5;
  EXPECT_NE(view, other);
  other = view;
  other.Far = 9.0;
  EXPECT_NE(view, other);
  other = view;
  other.Window[3] = 2.5;
  EXPECT_NE(view, other);
  other = view;
  other.Emitter.HalfSize[1] = 0.5;
  EXPECT_NE(view, other);
}
