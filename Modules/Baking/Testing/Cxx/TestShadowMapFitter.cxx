// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapFitter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using Body = vtkShadowCasters::Body;

Body MakeBox(double x0, double x1, double y0, double y1, double z0, double z1)
{
  Body body;
  body.Bounds = { { x0, x1, y0, y1, z0, z1 } };
  return body;
}

// A rectangle perpendicular to the z axis.
Body MakeSheet(double x0, double x1, double y0, double y1, double z)
{
  Body body = MakeBox(x0, x1, y0, y1, z, z);
  body.Flat = true;
  body.Normal = { { 0.0, 0.0, 1.0 } };
  body.Offset = z;
  body.Corners = { { { { x0, y0, z } }, { { x1, y0, z } }, { { x1, y1, z } }, { { x0, y1, z } } } };
  return body;
}

Body MakeGround(double halfSize)
{
  return MakeSheet(-halfSize, halfSize, -halfSize, halfSize, 0.0);
}

vtkShadowEmitter MakeEmitter(double x, double y, double z, bool directional, double half = 0.0)
{
  vtkShadowEmitter emitter;
  emitter.Directional = directional;
  emitter.Shape = half > 0.0 ? vtkShadowEmitter::RECTANGLE : vtkShadowEmitter::POINT;
  emitter.Center = { { x, y, z } };
  emitter.Apex = emitter.Center;
  emitter.Direction = { { 0.0, 0.0, -1.0 } };
  emitter.AxisU = { { 1.0, 0.0, 0.0 } };
  emitter.AxisV = { { 0.0, 1.0, 0.0 } };
  emitter.HalfSize = { { half, half } };
  return emitter;
}

bool Fit(const std::vector<Body>& bodies, const vtkShadowEmitter& emitter, vtkShadowMapView& view)
{
  return vtkShadowMapFitter(bodies).Fit(emitter, view);
}

// The window without its margins.
std::array<double, 4> Inner(const vtkShadowMapView& view)
{
  const auto& w = view.Window;
  const double x = 0.5 * (w[1] - w[0]) / (1.0 + 2.0 / 30.0 + 2e-6);
  const double y = 0.5 * (w[3] - w[2]) / (1.0 + 2.0 / 30.0 + 2e-6);
  return { { 0.5 * (w[0] + w[1]) - x, 0.5 * (w[0] + w[1]) + x, 0.5 * (w[2] + w[3]) - y,
    0.5 * (w[2] + w[3]) + y } };
}

void ExpectWindow(const vtkShadowMapView& view, const std::array<double, 4>& expected)
{
  const auto found = Inner(view);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-6 * (1.0 + std::abs(expected[i]))) << i;
  }
}
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, NothingToCastNothingToBake)
{
  vtkShadowMapView view;
  EXPECT_FALSE(Fit({}, MakeEmitter(0, 0, 5, false), view));
  EXPECT_FALSE(Fit({ MakeGround(10.0) }, MakeEmitter(0, 0, 5, false), view)) << "a plane alone";
  EXPECT_FALSE(Fit({ MakeGround(10.0) }, MakeEmitter(0, 0, 5, true), view));
  Body box = MakeBox(-1, 1, -1, 1, 0, 1);
  box.Casts = false;
  EXPECT_FALSE(Fit({ MakeGround(10.0), box }, MakeEmitter(0, 0, 5, false), view));
  EXPECT_FALSE(Fit({ MakeBox(-1, 1, -1, 1, 6, 7) }, MakeEmitter(0, 0, 5, false), view))
    << "behind the light";
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, CoversABox)
{
  vtkShadowMapView view;
  const std::vector<Body> bodies{ MakeBox(-1.0, 2.0, -0.5, 0.5, 1.0, 3.0), MakeGround(10.0) };
  ASSERT_TRUE(Fit(bodies, MakeEmitter(0, 0, 5, false), view));
  ExpectWindow(view, { { -0.5, 1.0, -0.25, 0.25 } });
  EXPECT_LE(view.Near, 2.0);
  EXPECT_GE(view.Near, 1.9);
  EXPECT_GE(view.Far, 4.0);
  EXPECT_LE(view.Far, 4.1);
  ASSERT_TRUE(Fit(bodies, MakeEmitter(0.5, 0, 5, true), view));
  ExpectWindow(view, { { -1.5, 1.5, -0.5, 0.5 } });
  EXPECT_LE(view.Near, 2.0);
  EXPECT_GE(view.Far, 4.0);
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, MarginsHoldATexelOf32)
{
  vtkShadowMapView view;
  ASSERT_TRUE(Fit({ MakeBox(-1, 1, -1, 1, 1, 3) }, MakeEmitter(0, 0, 5, false), view));
  const double texel = (view.Window[1] - view.Window[0]) / 32.0;
  EXPECT_LE(view.Window[0] + texel, -0.5);
  EXPECT_GE(view.Window[1] - texel, 0.5);
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, AGroundOfAnySizeChangesNothing)
{
  for (const bool directional : { false, true })
  {
    for (const double half : { 0.0, 0.05 })
    {
      vtkShadowEmitter emitter = MakeEmitter(1, 2, 5, directional, half);
      emitter.Direction = { { 0.0, -0.6, -0.8 } };
      emitter.AxisV = { { 0.0, 0.8, -0.6 } };
      vtkShadowMapView small;
      vtkShadowMapView large;
      const Body model = MakeBox(-1, 1, -1, 1, 0, 1);
      ASSERT_TRUE(Fit({ model, MakeGround(2.0) }, emitter, small));
      ASSERT_TRUE(Fit({ MakeGround(2000.0), model }, emitter, large));
      EXPECT_EQ(small, large) << directional << " " << half;
    }
  }
}

//------------------------------------------------------------------------------
// A model that dips into the ground has a part that the ground shadows: so much of the ground counts.
TEST(ShadowMapFitter, AGroundThatIsDippedIntoAddsOnlyWhatShadowsTheModel)
{
  vtkShadowMapView view;
  ASSERT_TRUE(
    Fit({ MakeBox(-1, 1, -1, 1, -0.5, 1), MakeGround(2000.0) }, MakeEmitter(0, 0, 5, true), view));
  ExpectWindow(view, { { -1.0, 1.0, -1.0, 1.0 } });
  Body shell = MakeSheet(-1.0, 1.0, -1.0, 1.0, -0.5); // seen only through the ground
  ASSERT_TRUE(Fit({ shell, MakeGround(2000.0) }, MakeEmitter(0, 0, 5, true, 0.1), view));
  ExpectWindow(view, { { -1.05, 1.05, -1.05, 1.05 } });
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, ALightThatReachesBelowAPlaneSeesBothSides)
{
  // A wall in the plane x = 0 and something on its far side; the light straddles the plane.
  Body wall = MakeBox(0, 0, -1, 1, 0, 2);
  wall.Flat = true;
  wall.Normal = { { 1.0, 0.0, 0.0 } };
  wall.Offset = 0.0;
  wall.Corners = { { { { 0, -1, 0 } }, { { 0, 1, 0 } }, { { 0, 1, 2 } }, { { 0, -1, 2 } } } };
  Body ground = MakeSheet(0.1, 2.0, -2.0, 2.0, 0.0); // on the side x > 0 only
  vtkShadowMapView view;
  EXPECT_FALSE(Fit({ wall, ground }, MakeEmitter(0.5, 0, 5, false, 0.4), view))
    << "all on the light's side";
  EXPECT_TRUE(Fit({ wall, ground }, MakeEmitter(0.3, 0, 5, false, 0.4), view));
  EXPECT_TRUE(Fit({ wall, ground }, MakeEmitter(-0.5, 0, 5, false, 0.4), view));
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, ASheetCastsOnlyOnWhatLiesBehindIt)
{
  vtkShadowMapView view;
  const Body sheet = MakeSheet(-1, 1, -1, 1, 2.0);
  EXPECT_TRUE(Fit({ sheet, MakeGround(0.1) }, MakeEmitter(0, 0, 5, false), view));
  EXPECT_FALSE(
    Fit({ sheet, MakeSheet(4.0, 5.0, 4.0, 5.0, 0.0) }, MakeEmitter(0, 0, 5, false), view))
    << "beside it";
  EXPECT_FALSE(Fit({ sheet, MakeSheet(-1, 1, -1, 1, 3.0) }, MakeEmitter(0, 0, 2.5, false), view))
    << "above the light";
  // The shadow of the edge x = 1 ends at x = 5/3 for a point; a light of half size 1.5 reaches
  // (5/3 + 1.5 * 2/3) = 2.67, so what begins at 2.5 is in the penumbra.
  const Body far = MakeSheet(2.5, 3.0, -1.0, 1.0, 0.0);
  EXPECT_FALSE(Fit({ sheet, far }, MakeEmitter(0, 0, 5, false), view));
  EXPECT_TRUE(Fit({ sheet, far }, MakeEmitter(0, 0, 5, false, 1.5), view));
  EXPECT_FALSE(Fit({ sheet, far }, MakeEmitter(0, 0, 5, false, 1.2), view));
  Body blind = MakeGround(10.0);
  blind.Receives = false;
  EXPECT_FALSE(Fit({ sheet, blind }, MakeEmitter(0, 0, 5, false), view)) << "receives nothing";
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, TiltedSheetsUseTheirCornersNotTheirBox)
{
  // A sheet seen edge-on by the light: its window is a line.
  Body sheet = MakeBox(-1, 1, -1, 1, 1, 3);
  sheet.Flat = true;
  const double h = std::sqrt(0.5);
  sheet.Normal = { { h, 0.0, -h } };
  sheet.Offset = -h * 2.0;
  sheet.Corners = { { { { -1, -1, 1 } }, { { 1, -1, 3 } }, { { 1, 1, 3 } }, { { -1, 1, 1 } } } };
  vtkShadowEmitter emitter = MakeEmitter(0, 0, 0, true);
  emitter.Direction = { { -h, 0.0, -h } };
  emitter.AxisU = { { h, 0.0, -h } };
  vtkShadowMapView view;
  ASSERT_TRUE(Fit({ sheet, MakeGround(100.0) }, emitter, view));
  EXPECT_NEAR(Inner(view)[3] - Inner(view)[2], 2.0, 1e-6);
  EXPECT_LT(view.Window[1] - view.Window[0], 0.01);
  EXPECT_GT(view.Window[1] - view.Window[0], 0.0);
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, WhatIsOutsideTheConeIsNoCaster)
{
  vtkShadowEmitter emitter = MakeEmitter(0, 0, 5, false, 0.1);
  emitter.ConeAngle = 20.0;
  const Body model = MakeBox(-0.5, 0.5, -0.5, 0.5, 0, 1);
  const Body post = MakeBox(30, 31, 0, 1, 0, 4);
  vtkShadowMapView with;
  vtkShadowMapView without;
  ASSERT_TRUE(Fit({ model, post, MakeGround(100.0) }, emitter, with));
  ASSERT_TRUE(Fit({ model, MakeGround(100.0) }, emitter, without));
  EXPECT_EQ(with, without);
  // A wall that leaves the cone counts as far as the cone, grown by the light's extent, reaches.
  ASSERT_TRUE(Fit({ MakeBox(-50, 50, -0.5, 0.5, 0, 1), MakeGround(100.0) }, emitter, with));
  const double slope = std::tan(20.0 * std::acos(-1.0) / 180.0);
  ExpectWindow(with, { { -slope - 0.1 / 4.0, slope + 0.1 / 4.0, -0.125, 0.125 } });
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, BodiesAroundTheLightAreClipped)
{
  vtkShadowMapView view;
  ASSERT_TRUE(Fit({ MakeBox(-10, 10, -10, 10, -10, 10) }, MakeEmitter(0, 0, 0, false), view));
  const double steepest = std::tan(85.0 * std::acos(-1.0) / 180.0);
  ExpectWindow(view, { { -steepest, steepest, -steepest, steepest } });
  EXPECT_GE(view.Near, 0.999e-3 * view.Far);
  EXPECT_GE(view.Far, 10.0);
  EXPECT_LE(view.Far, 10.2);
  // Half behind the light.
  ASSERT_TRUE(Fit({ MakeBox(1, 2, -1, 1, -4, 4) }, MakeEmitter(0, 0, 0, false), view));
  EXPECT_NEAR(Inner(view)[0], 0.25, 1e-6);
  EXPECT_NEAR(Inner(view)[1], steepest, 1e-5);
  for (const double value : { view.Window[2], view.Window[3], view.Near, view.Far })
  {
    EXPECT_TRUE(std::isfinite(value));
  }
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, ScaleAndPlaceChangeNothing)
{
  vtkShadowMapView unit;
  const auto bodies = [](double s, double t)
  {
    return std::vector<Body>{ MakeBox(t - s, t + s, t - s, t + s, t + s, t + 2 * s),
      MakeSheet(t - 9 * s, t + 9 * s, t - 9 * s, t + 9 * s, t) };
  };
  ASSERT_TRUE(Fit(bodies(1.0, 0.0), MakeEmitter(0.2, 0.1, 5, false, 0.5), unit));
  for (const double s : { 1e-6, 1e-3, 1e3, 1e6 })
  {
    vtkShadowMapView view;
    ASSERT_TRUE(Fit(bodies(s, 0.0), MakeEmitter(0.2 * s, 0.1 * s, 5 * s, false, 0.5 * s), view));
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(view.Window[i], unit.Window[i], 1e-9) << s;
    }
    EXPECT_NEAR(view.Near / s, unit.Near, 1e-9) << s;
    EXPECT_NEAR(view.Far / s, unit.Far, 1e-9) << s;
  }
  vtkShadowMapView far;
  ASSERT_TRUE(Fit(bodies(1.0, 1e7), MakeEmitter(1e7 + 0.2, 1e7 + 0.1, 1e7 + 5, false, 0.5), far));
  EXPECT_NEAR(far.Window[0], unit.Window[0], 1e-7);
  EXPECT_NEAR(far.Near, unit.Near, 1e-7);
}

//------------------------------------------------------------------------------
TEST(ShadowMapFitter, AnOmniLightHasAFaceForEveryCaster)
{
  vtkShadowEmitter emitter = MakeEmitter(0, 0, 0, false);
  emitter.Omni = true;
  const std::vector<Body> bodies{ MakeBox(3, 4, -0.5, 0.5, -0.5, 0.5),
    MakeBox(-0.5, 0.5, -0.5, 0.5, -4, -3) };
  const auto views = vtkShadowMapFitter(bodies).FitAll(emitter);
  ASSERT_EQ(views.size(), 2u);
  for (const vtkShadowMapView& view : views)
  {
    const double along = view.Emitter.Direction[0] - view.Emitter.Direction[2];
    EXPECT_NEAR(along, 1.0, 1e-12) << "towards +x or -z";
    EXPECT_LE(view.Window[1], 0.2);
    EXPECT_GE(view.Near, 2.9);
  }
  // All around: six faces, each a little wider than a face of the cube.
  const auto room = vtkShadowMapFitter({ MakeBox(-5, 5, -5, 5, -5, 5) }).FitAll(emitter);
  ASSERT_EQ(room.size(), 6u);
  for (const vtkShadowMapView& view : room)
  {
    EXPECT_LT(view.Window[0], -1.0);
    EXPECT_GT(view.Window[1], 1.0);
    EXPECT_LT(view.Window[1], 1.2);
  }
}
