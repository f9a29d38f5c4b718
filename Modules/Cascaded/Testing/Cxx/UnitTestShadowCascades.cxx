// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Splits, occupied cascades and windows: numbers, no window is opened.
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkShadowBorderGrid.h"
#include "vtkShadowCascadeWindow.h"
#include "vtkShadowCascades.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using Body = vtkShadowCasters::Body;
using Cascade = vtkShadowCascades::Cascade;

// What a camera of 640 x 480 sees.
vtkShadowCascades::View ViewOf(vtkCamera* camera)
{
  vtkShadowCascades::View view;
  std::copy_n(camera->GetCompositeProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0)->GetData(), 16,
    view.WorldToClip.begin());
  for (int i = 0; i < 4; ++i)
  {
    view.WorldToDepth[i] = -camera->GetModelViewTransformMatrix()->GetElement(2, i);
  }
  view.Parallel = camera->GetParallelProjection() != 0;
  return view;
}

// At the origin, looking along +y, z up, 90 degrees high.
vtkSmartPointer<vtkCamera> MakeCamera()
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 1.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(90.0);
  camera->SetClippingRange(0.1, 1000.0);
  return camera;
}

Body MakeBox(double x0, double x1, double y0, double y1, double z0, double z1)
{
  Body body;
  body.Bounds = { { x0, x1, y0, y1, z0, z1 } };
  return body;
}

// A wall across the camera's path.
Body MakeWall(double depth)
{
  return MakeBox(-1.0, 1.0, depth, depth, -1.0, 1.0);
}

// A horizontal rectangle below the camera.
Body MakeGround(double height, double y0, double y1)
{
  Body body = MakeBox(-1000.0, 1000.0, y0, y1, height, height);
  body.Flat = true;
  body.Normal = { { 0.0, 0.0, 1.0 } };
  body.Offset = height;
  body.Corners = { { { { -1000.0, y0, height } }, { { 1000.0, y0, height } },
    { { 1000.0, y1, height } }, { { -1000.0, y1, height } } } };
  return body;
}
}

// Zhang et al. 2006: the mean of logarithmic and uniform splits, with the range's own ends.
TEST(ShadowCascades, SplitsAreTheMeanOfLogarithmicAndUniformOnes)
{
  const std::vector<double> splits = vtkShadowCascades::Split(1.0, 1000.0, 3, 0.5);
  ASSERT_EQ(splits.size(), 4u);
  EXPECT_DOUBLE_EQ(splits[0], 1.0);
  EXPECT_NEAR(splits[1], 0.5 * (10.0 + 334.0), 1e-9);
  EXPECT_NEAR(splits[2], 0.5 * (100.0 + 667.0), 1e-9);
  EXPECT_DOUBLE_EQ(splits[3], 1000.0);
  EXPECT_NEAR(vtkShadowCascades::Split(1.0, 1000.0, 3, 1.0)[1], 10.0, 1e-9);
  EXPECT_NEAR(vtkShadowCascades::Split(-1.0, 2.0, 3, 0.0)[1], 0.0, 1e-12);
}

// The ground 2 below a camera with a half angle of 45 degrees is seen from depth 2 on.
TEST(ShadowCascades, DepthsOfAPlaneAreExact)
{
  const auto view = ViewOf(MakeCamera());
  const auto depths = vtkShadowCascades::FindDepths({ MakeGround(-2.0, -500.0, 100.0) }, view);
  ASSERT_EQ(depths.size(), 1u);
  EXPECT_NEAR(depths[0].first, 2.0, 1e-4);
  EXPECT_NEAR(depths[0].second, 100.0, 1e-2);
}

TEST(ShadowCascades, BodiesOutOfViewHaveNoDepths)
{
  const auto view = ViewOf(MakeCamera());
  EXPECT_TRUE(vtkShadowCascades::FindDepths({ MakeBox(-1, 1, -9, -5, -1, 1) }, view).empty());
  EXPECT_TRUE(vtkShadowCascades::FindDepths({ MakeBox(50, 60, 5, 6, -1, 1) }, view).empty());
  Body unlit = MakeWall(5.0);
  unlit.Receives = false;
  EXPECT_TRUE(vtkShadowCascades::FindDepths({ unlit }, view).empty());
}

// Boxes that planes cut, that lie aside, in or around the frustum: as many points as it takes to know.
TEST(ShadowCascades, DepthsOfBoxesAreThoseOfTheirPointsInView)
{
  const auto view = ViewOf(MakeCamera());
  int seen = 0;
  for (int i = 0; i < 60; ++i)
  {
    const double x = -12.0 + 7.0 * (i % 4);
    const double y = -4.0 + 3.0 * (i / 4 % 5);
    const double z = -9.0 + 6.0 * (i / 20);
    const Body box = MakeBox(x, x + 5.0, y, y + 4.0, z, z + 3.0);
    vtkShadowCascades::Interval expected = { 1e30, -1e30 };
    for (int k = 0; k < 41 * 41 * 41; ++k)
    {
      const double p[4] = { x + 5.0 * (k % 41) / 40.0, y + 4.0 * (k / 41 % 41) / 40.0,
        z + 3.0 * (k / 1681) / 40.0, 1.0 };
      double clip[4];
      vtkMatrix4x4::MultiplyPoint(view.WorldToClip.data(), p, clip);
      if (std::abs(clip[0]) <= clip[3] && std::abs(clip[1]) <= clip[3] &&
        std::abs(clip[2]) <= clip[3])
      {
        expected = { std::min(expected.first, p[1]), std::max(expected.second, p[1]) };
      }
    }
    const auto depths = vtkShadowCascades::FindDepths({ box }, view);
    if (expected.first > expected.second)
    {
      // Less than a step of the points may be in view.
      EXPECT_TRUE(depths.empty() || depths[0].second - depths[0].first < 0.3) << "box " << i;
      continue;
    }
    ASSERT_EQ(depths.size(), 1u) << "box " << i;
    EXPECT_NEAR(depths[0].first, expected.first, 0.2) << "box " << i;
    EXPECT_NEAR(depths[0].second, expected.second, 0.2) << "box " << i;
    ++seen;
  }
  EXPECT_GT(seen, 15);
}

// A camera inside a box sees all depths up to the box's far side.
TEST(ShadowCascades, DepthsOfABoxAroundTheCameraBeginAtItsNearPlane)
{
  const auto depths =
    vtkShadowCascades::FindDepths({ MakeBox(-9, 9, -9, 9, -9, 9) }, ViewOf(MakeCamera()));
  ASSERT_EQ(depths.size(), 1u);
  EXPECT_NEAR(depths[0].first, 0.1, 1e-5);
  EXPECT_NEAR(depths[0].second, 9.0, 1e-3);
}

TEST(ShadowCascades, ReceiversInOneCascadeCostOneCascade)
{
  const auto cascades =
    vtkShadowCascades::Find({ MakeWall(10.0) }, ViewOf(MakeCamera()), 3, 0.5, 0.2);
  ASSERT_EQ(cascades.size(), 1u);
  EXPECT_LE(cascades[0].Covered.first, 10.0);
  EXPECT_GE(cascades[0].Covered.second, 10.0);
}

// Of a ground only what a point of the light sees behind the casters counts; of other bodies all.
TEST(ShadowCascades, FlatReceiversCountWhereAShadowCanFall)
{
  auto view = ViewOf(MakeCamera());
  vtkShadowMapView point;
  point.Emitter.Directional = true;
  point.Emitter.Direction = { { 0.0, 0.0, -1.0 } };
  point.Emitter.AxisU = { { 0.0, 1.0, 0.0 } };
  point.Emitter.AxisV = { { 1.0, 0.0, 0.0 } };
  point.Window = { { 20.0, 30.0, -5.0, 5.0 } };
  point.Near = -1.0;
  point.Far = 10.0;
  view.Points = { { point } };
  const Body ground = MakeGround(-2.0, -500.0, 1000.0);
  auto depths = vtkShadowCascades::FindDepths({ ground }, view);
  ASSERT_EQ(depths.size(), 1u);
  EXPECT_NEAR(depths[0].first, 20.0, 1e-3);
  EXPECT_NEAR(depths[0].second, 30.0, 1e-3);
  // A second point that sees the shadow elsewhere widens the range.
  point.Window = { { 40.0, 50.0, -5.0, 5.0 } };
  view.Points.push_back({ point });
  depths = vtkShadowCascades::FindDepths({ ground }, view);
  EXPECT_NEAR(depths[0].second, 50.0, 1e-3);
  // A cell's image and a filter reach beyond what the point itself sees: d is 3 / 11 on the ground.
  view.Points.pop_back();
  view.Points[0].CellScale = { { 0.55, 0.0 } };
  depths = vtkShadowCascades::FindDepths({ ground }, view);
  EXPECT_NEAR(depths[0].first, 20.0 - 1.5, 1e-3);
  EXPECT_NEAR(depths[0].second, 30.0 + 1.5, 1e-3);
  view.Points[0].Border = 0.1;
  depths = vtkShadowCascades::FindDepths({ ground }, view);
  EXPECT_NEAR(depths[0].first, 20.0 - 2.5, 1e-3);
  EXPECT_NEAR(depths[0].second, 30.0 + 2.5, 1e-3);
  // Above the nearest caster nothing falls.
  view.Points[0].Map.Near = 3.0;
  EXPECT_TRUE(vtkShadowCascades::FindDepths({ ground }, view).empty());
  EXPECT_FALSE(vtkShadowCascades::Find({ ground }, view, 3, 0.5, 0.2).front().Occupied);
  EXPECT_EQ(vtkShadowCascades::FindDepths({ MakeWall(10.0) }, view).size(), 1u);
}

TEST(ShadowCascades, AGapBetweenReceiversIsNoCascade)
{
  const auto cascades =
    vtkShadowCascades::Find({ MakeWall(2.0), MakeWall(100.0) }, ViewOf(MakeCamera()), 3, 0.5, 0.2);
  ASSERT_EQ(cascades.size(), 2u);
  EXPECT_DOUBLE_EQ(vtkShadowCascades::Weight(cascades[0], 2.0), 1.0);
  EXPECT_DOUBLE_EQ(vtkShadowCascades::Weight(cascades[1], 100.0), 1.0);
}

// Whatever the depth, in range or not, band or not.
TEST(ShadowCascades, WeightsSumToOneAndAreSmooth)
{
  for (const double band : { 0.0, 0.2, 1.0 })
  {
    for (int count = 1; count <= 4; ++count)
    {
      const auto cascades = vtkShadowCascades::Find(
        { MakeGround(-2.0, 0.0, 300.0) }, ViewOf(MakeCamera()), count, 0.5, band);
      ASSERT_EQ(cascades.size(), static_cast<size_t>(count));
      double previous = 1.0;
      for (double depth = 0.01; depth < 600.0; depth *= 1.001)
      {
        double sum = 0.0;
        for (const Cascade& cascade : cascades)
        {
          sum += vtkShadowCascades::Weight(cascade, depth);
        }
        ASSERT_NEAR(sum, 1.0, 1e-12) << "depth " << depth << ", " << count << " cascades";
        const double first = vtkShadowCascades::Weight(cascades[0], depth);
        ASSERT_LE(first, previous) << "depth " << depth;
        if (band > 0.1)
        {
          ASSERT_LT(previous - first, 0.05) << "depth " << depth;
        }
        previous = first;
      }
    }
  }
}

namespace
{
// smoothstep in the shader's numbers. Divisions are products with the reciprocal, and what is no normal
// number is flushed to 0: graphics cards may do both.
float SmoothStep(const vtkShadowCascades::Interval& band, float depth)
{
  const auto flush = [](float x) { return std::isnormal(x) ? x : 0.0f; };
  const float low = static_cast<float>(band.first);
  const float reciprocal = flush(1.0f / (static_cast<float>(band.second) - low));
  const float x = std::min(std::max(flush((depth - low) * reciprocal), 0.0f), 1.0f);
  return x * x * (3.0f - 2.0f * x);
}
}

// Of scenes as small as a cell and as large as a planet.
TEST(ShadowCascades, WeightsSumToOneInTheShadersNumbers)
{
  for (const double scale : { 1e-6, 1.0, 1e7 })
  {
    const auto camera = MakeCamera();
    camera->SetClippingRange(0.1 * scale, 1000.0 * scale);
    for (int count = 1; count <= 4; ++count)
    {
      const auto cascades = vtkShadowCascades::Find(
        { MakeGround(-2.0 * scale, 0.0, 300.0 * scale) }, ViewOf(camera), count, 0.5, 0.2);
      ASSERT_EQ(cascades.size(), static_cast<size_t>(count));
      for (double depth = 0.01; depth < 600.0; depth *= 1.01)
      {
        const auto z = static_cast<float>(depth * scale);
        float sum = 0.0f;
        for (const Cascade& cascade : cascades)
        {
          sum += SmoothStep(cascade.FadeIn, z) * (1.0f - SmoothStep(cascade.FadeOut, z));
        }
        ASSERT_NEAR(sum, 1.0f, 1e-5f) << "depth " << z << ", " << count << " cascades";
      }
    }
  }
}

// Receivers of a weight above 0 are in the sphere, whose maps cover them.
TEST(ShadowCascades, TheSphereHoldsAllThatTheCascadeShades)
{
  const auto camera = MakeCamera();
  const auto view = ViewOf(camera);
  const auto cascades =
    vtkShadowCascades::Find({ MakeGround(-2.0, 0.0, 300.0) }, view, 3, 0.5, 0.2);
  double clipToWorld[16];
  vtkMatrix4x4::Invert(view.WorldToClip.data(), clipToWorld);
  for (int i = 0; i < 4000; ++i)
  {
    const double clip[4] = { (i % 20) / 9.5 - 1.0, (i / 20 % 20) / 9.5 - 1.0,
      1.0 - 0.2 * std::pow(0.6, i / 400), 1.0 };
    double p[4];
    vtkMatrix4x4::MultiplyPoint(clipToWorld, clip, p);
    const std::array<double, 3> world = { { p[0] / p[3], p[1] / p[3], p[2] / p[3] } };
    const double depth = world[1];
    for (const Cascade& cascade : cascades)
    {
      if (vtkShadowCascades::Weight(cascade, depth) > 0.0 && depth >= cascade.Covered.first &&
        depth <= cascade.Covered.second)
      {
        const double distance =
          std::sqrt(vtkMath::Distance2BetweenPoints(world.data(), cascade.Center.data()));
        ASSERT_LE(distance, cascade.Radius * (1.0 + 1e-6)) << "depth " << depth;
      }
    }
  }
}

// What is seen of the receivers' box, and no more: not what lies below the ground.
TEST(ShadowCascades, CornersBoundWhatReceives)
{
  const auto camera = MakeCamera();
  const auto cascades =
    vtkShadowCascades::Find({ MakeGround(-2.0, 0.0, 300.0) }, ViewOf(camera), 3, 0.5, 0.2);
  ASSERT_EQ(cascades.size(), 3u);
  for (const Cascade& cascade : cascades)
  {
    ASSERT_FALSE(cascade.Corners.empty());
    double nearest = 1e9;
    double farthest = 0.0;
    for (const auto& corner : cascade.Corners)
    {
      EXPECT_NEAR(corner[2], -2.0, 0.03); // 1e-5 of the ground
      nearest = std::min(nearest, corner[1]);
      farthest = std::max(farthest, corner[1]);
    }
    EXPECT_GE(nearest, cascade.Covered.first * (1.0 - 1e-6));
    EXPECT_NEAR(farthest, std::min(cascade.Covered.second, 300.0), 0.001 * cascade.Covered.second);
  }
}

// One cascade for all depths, whose sphere holds what the others' did.
TEST(ShadowCascades, JoinsNeighbours)
{
  const auto camera = MakeCamera();
  const auto cascades =
    vtkShadowCascades::Find({ MakeGround(-2.0, 0.0, 300.0) }, ViewOf(camera), 3, 0.5, 0.2);
  Cascade joined = cascades[0];
  vtkShadowCascades::Join(joined, cascades[1]);
  vtkShadowCascades::Join(joined, cascades[2]);
  EXPECT_DOUBLE_EQ(joined.Covered.second, cascades[2].Covered.second);
  for (int i = 0; i <= 300; ++i)
  {
    EXPECT_DOUBLE_EQ(vtkShadowCascades::Weight(joined, i), 1.0) << "depth " << i;
  }
  for (const Cascade& cascade : cascades)
  {
    EXPECT_GE(joined.Radius * (1.0 + 1e-12),
      cascade.Radius +
        std::sqrt(vtkMath::Distance2BetweenPoints(joined.Center.data(), cascade.Center.data())));
  }
}

// A walk changes neither the splits nor the spheres' sizes, but at a few places.
TEST(ShadowCascades, AWalkKeepsTheSpheres)
{
  const auto camera = MakeCamera();
  int changes = 0;
  double radius = 0.0;
  for (int step = 0; step < 100; ++step)
  {
    camera->SetPosition(0.0, 0.1 * step, 0.0);
    camera->SetFocalPoint(0.3, 1.0 + 0.1 * step, 0.1);
    const auto cascades =
      vtkShadowCascades::Find({ MakeGround(-2.0, -500.0, 500.0) }, ViewOf(camera), 3, 0.5, 0.2);
    changes += std::abs(cascades[0].Radius - radius) > 1e-6 * radius ? 1 : 0;
    radius = cascades[0].Radius;
  }
  EXPECT_LE(changes, 2);
}

namespace
{
vtkShadowMapView MakeSunView()
{
  vtkShadowMapView view;
  view.Emitter.Directional = true;
  view.Emitter.Direction = { { 0.0, 0.6, -0.8 } };
  view.Emitter.AxisV = { { 0.0, 0.8, 0.6 } };
  vtkMath::Cross(
    view.Emitter.Direction.data(), view.Emitter.AxisV.data(), view.Emitter.AxisU.data());
  view.Window = { { -500.0, 500.0, -500.0, 500.0 } };
  view.Near = -100.0;
  view.Far = 100.0;
  return view;
}
}

// The window holds the sphere with its border, keeps its size, and moves by whole texels.
TEST(ShadowCascadeWindow, MovesByWholeTexels)
{
  constexpr int resolution = 512;
  double edge = 0.0;
  for (int step = 0; step < 200; ++step)
  {
    const std::array<double, 3> center = { { 3.0 + 0.0371 * step, 5.0 - 0.0713 * step, 1.0 } };
    vtkShadowMapView view = MakeSunView();
    ASSERT_TRUE(vtkShadowCascadeWindow::Cut(center, 7.0, {}, resolution, 3, view));
    const double size = view.Window[1] - view.Window[0];
    if (step > 0)
    {
      ASSERT_NEAR(size, edge, 1e-10);
    }
    edge = size;
    const double texel = size / resolution;
    EXPECT_LE(size, 14.0 * std::exp2(0.125) * 1.05);
    const double eighths = 8.0 * std::log2(1000.0 / size); // of an octave, from the fit's edge
    ASSERT_NEAR(eighths, std::round(eighths), 1e-9);
    for (const int i : { 0, 2 })
    {
      const double cells = (view.Window[i] + 500.0) / texel;
      ASSERT_NEAR(cells, std::round(cells), 1e-6);
      const double* axis = i == 0 ? view.Emitter.AxisU.data() : view.Emitter.AxisV.data();
      const double middle = vtkMath::Dot(axis, center.data());
      ASSERT_LE(view.Window[i], middle - 7.0 - 3.0 * texel + 1e-9);
      ASSERT_GE(view.Window[i + 1], middle + 7.0 + 3.0 * texel - 1e-9);
    }
    EXPECT_DOUBLE_EQ(view.Near, -100.0);
    EXPECT_DOUBLE_EQ(view.Far, 100.0);
  }
}

// Where less receives than the sphere holds, the window is smaller: it holds the corners and its border.
TEST(ShadowCascadeWindow, IsCutToTheCorners)
{
  constexpr int resolution = 512;
  std::vector<std::array<double, 3>> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back({ { i & 1 ? 4.0 : 2.0, i & 2 ? 6.0 : 5.0, i & 4 ? 0.5 : 0.0 } });
  }
  vtkShadowMapView view = MakeSunView();
  ASSERT_TRUE(
    vtkShadowCascadeWindow::Cut({ { 3.0, 5.0, 0.0 } }, 7.0, corners, resolution, 3, view));
  EXPECT_LT(view.Window[1] - view.Window[0], 2.0 * 1.2);
  EXPECT_LT(view.Window[3] - view.Window[2], 1.2 * 1.2);
  const double border = 3.0 / resolution;
  for (const auto& corner : corners)
  {
    const double world[4] = { corner[0], corner[1], corner[2], 1.0 };
    double map[4];
    vtkMatrix4x4::MultiplyPoint(view.WorldToMap().data(), world, map);
    for (int axis = 0; axis < 2; ++axis)
    {
      ASSERT_GE(map[axis], border - 1e-9);
      ASSERT_LE(map[axis], 1.0 - border + 1e-9);
    }
  }
}

TEST(ShadowCascadeWindow, KeepsAFitThatIsSmaller)
{
  vtkShadowMapView view = MakeSunView();
  const vtkShadowMapView fit = view;
  EXPECT_TRUE(vtkShadowCascadeWindow::Cut({ { 0.0, 0.0, 0.0 } }, 700.0, {}, 512, 3, view));
  EXPECT_TRUE(view == fit);
}

TEST(ShadowCascadeWindow, NoCasterInFrontOfTheSphereNeedsNoMap)
{
  vtkShadowMapView view = MakeSunView();
  EXPECT_FALSE(vtkShadowCascadeWindow::Cut({ { 600.0, 0.0, 0.0 } }, 50.0, {}, 512, 3, view));
  EXPECT_TRUE(vtkShadowCascadeWindow::Cut({ { 549.0, 0.0, 0.0 } }, 50.0, {}, 512, 3, view));
}

// What a lamp sees of the sphere, by points on it.
TEST(ShadowCascadeWindow, ALampsWindowHoldsTheSphere)
{
  vtkShadowMapView fit;
  fit.Window = { { -8.0, 8.0, -8.0, 8.0 } };
  fit.Near = 0.1;
  fit.Far = 100.0;
  const std::array<double, 3> center = { { 3.0, -2.0, -6.0 } };
  vtkShadowMapView view = fit;
  ASSERT_TRUE(vtkShadowCascadeWindow::Cut(center, 2.0, {}, 1024, 3, view));
  EXPECT_LT(view.Window[1] - view.Window[0], 4.0);
  for (int i = 0; i < 1000; ++i)
  {
    const double polar = std::acos(1.0 - 2.0 * (i + 0.5) / 1000.0);
    const double angle = i * 2.399963;
    const double world[4] = { center[0] + 2.0 * std::sin(polar) * std::cos(angle),
      center[1] + 2.0 * std::sin(polar) * std::sin(angle), center[2] + 2.0 * std::cos(polar), 1.0 };
    double map[4];
    vtkMatrix4x4::MultiplyPoint(view.WorldToMap().data(), world, map);
    for (int axis = 0; axis < 2; ++axis)
    {
      ASSERT_GT(map[axis] / map[3], 3.0 / 1024.0);
      ASSERT_LT(map[axis] / map[3], 1.0 - 3.0 / 1024.0);
    }
  }
  // A lamp inside the sphere looks everywhere.
  view = fit;
  EXPECT_TRUE(vtkShadowCascadeWindow::Cut({ { 0.0, 0.0, -1.0 } }, 2.0, {}, 1024, 3, view));
  EXPECT_TRUE(view == fit);
}

namespace
{
// Sums f over all points of a border grid's level, by its nested form.
template <typename Function>
double SumOver(const vtkShadowEmitter& emitter, int level, int weights, const Function& f)
{
  double sum = 0.0;
  for (int i = 0; i <= level; ++i)
  {
    const vtkShadowBorderGrid grid = vtkShadowBorderGrid::Make(emitter, i, weights);
    sum *= grid.Keep;
    for (const vtkShadowLightSampling::Sample& sample : grid.Added)
    {
      sum += sample.Weight * f(sample.U, sample.V);
    }
  }
  return sum;
}

vtkShadowEmitter MakeEmitter(int shape)
{
  vtkShadowEmitter emitter;
  emitter.Shape = shape;
  emitter.HalfSize = { { 0.5, 0.5 } };
  return emitter;
}
}

// The trapezoid rule is exact for 1, u, v and u v; its error for u^2 is 2 / 3 of the squared step.
TEST(ShadowBorderGrid, IntegratesARectangle)
{
  const vtkShadowEmitter emitter = MakeEmitter(vtkShadowEmitter::RECTANGLE);
  for (int level = 0; level <= 3; ++level)
  {
    const auto sum = [&](auto f) { return SumOver(emitter, level, 0, f); };
    EXPECT_NEAR(sum([](double, double) { return 1.0; }), 1.0, 1e-12);
    EXPECT_NEAR(sum([](double u, double) { return u; }), 0.0, 1e-12);
    EXPECT_NEAR(sum([](double u, double v) { return (1.0 + u) * (2.0 - v); }), 2.0, 1e-12);
    const double step = 2.0 / (1 << level);
    EXPECT_NEAR(sum([](double u, double) { return u * u; }), 1.0 / 3.0 + step * step / 6.0, 1e-12);
  }
}

// Equal weights, as printed in the paper, give the border too much: that is what this guards.
TEST(ShadowBorderGrid, BorderCountsLess)
{
  const vtkShadowBorderGrid grid =
    vtkShadowBorderGrid::Make(MakeEmitter(vtkShadowEmitter::RECTANGLE), 1, 0);
  ASSERT_EQ(grid.Added.size(), 5u);
  EXPECT_DOUBLE_EQ(grid.Keep, 0.25);
  for (const vtkShadowLightSampling::Sample& sample : grid.Added)
  {
    const bool center = sample.U == 0.0 && sample.V == 0.0;
    EXPECT_DOUBLE_EQ(sample.Weight, center ? 0.25 : 0.125);
  }
}

TEST(ShadowBorderGrid, IntegratesADisk)
{
  const vtkShadowEmitter emitter = MakeEmitter(vtkShadowEmitter::DISK);
  const auto sum = [&](auto f) { return SumOver(emitter, 3, 0, f); };
  EXPECT_NEAR(sum([](double, double) { return 1.0; }), 1.0, 1e-12);
  EXPECT_NEAR(sum([](double u, double) { return u; }), 0.0, 1e-12);
  EXPECT_NEAR(sum([](double u, double) { return u * u; }), 0.25, 0.02);
}

TEST(ShadowBorderGrid, GaussianWeightsNestToo)
{
  const vtkShadowEmitter emitter = MakeEmitter(vtkShadowEmitter::RECTANGLE);
  const auto sum = [&](auto f) { return SumOver(emitter, 3, vtkShadowLightSampling::GAUSSIAN, f); };
  EXPECT_NEAR(sum([](double, double) { return 1.0; }), 1.0, 1e-12);
  // The variance of N(0, 0.5) cut to [-1, 1].
  EXPECT_NEAR(sum([](double u, double) { return u * u; }), 0.1934, 0.005);
}

TEST(ShadowBorderGrid, APointHasOnePoint)
{
  const vtkShadowEmitter point;
  EXPECT_EQ(vtkShadowBorderGrid::Make(point, 0, 0).Added.size(), 1u);
  EXPECT_TRUE(vtkShadowBorderGrid::Make(point, 2, 0).Added.empty());
  EXPECT_DOUBLE_EQ(vtkShadowBorderGrid::Make(point, 2, 0).Keep, 1.0);
}
