// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where a light is after it was turned, raised, brought nearer and resized.
#include "LightMotion.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace softshadows;

namespace
{

constexpr Vector3 Up{ { 0.0, 0.0, 1.0 } };

//--------------------------------------------------------------------------------------------------
LightDescription MakeLight()
{
  LightDescription light;
  light.Position = { { 4.0, 0.0, 3.0 } };
  light.FocalPoint = { { 1.0, 0.0, -1.0 } }; // a distance of 5
  light.Size = { { 2.0, 1.0 } };
  return light;
}

//--------------------------------------------------------------------------------------------------
double Distance(const LightDescription& light)
{
  return std::hypot(light.Position[0] - light.FocalPoint[0],
    light.Position[1] - light.FocalPoint[1], light.Position[2] - light.FocalPoint[2]);
}

}

//--------------------------------------------------------------------------------------------------
TEST(LightMotion, NearestAxisKeepsTheSign)
{
  EXPECT_EQ(NearestAxis({ { 0.1, -0.9, 0.3 } }), (Vector3{ { 0.0, -1.0, 0.0 } }));
  EXPECT_EQ(NearestAxis({ { 0.0, 0.0, 1.0 } }), Up);
}

//--------------------------------------------------------------------------------------------------
TEST(LightMotion, TurningIsRightHandedAroundTheFocalPoint)
{
  LightDescription light = MakeLight();
  TurnLight(light, Up, 90.0);
  EXPECT_NEAR(light.Position[0], 1.0, 1e-12);
  EXPECT_NEAR(light.Position[1], 3.0, 1e-12);
  EXPECT_NEAR(light.Position[2], 3.0, 1e-12);
}

//--------------------------------------------------------------------------------------------------
TEST(LightMotion, RaisingKeepsTheDistanceAndStopsBelowTheAxis)
{
  LightDescription light = MakeLight();
  const double before = std::asin(4.0 / 5.0);
  const double step = 10.0 * std::acos(-1.0) / 180.0;
  RaiseLight(light, Up, 10.0);
  EXPECT_NEAR(light.Position[2] + 1.0, 5.0 * std::sin(before + step), 1e-12);
  EXPECT_NEAR(light.Position[1], 0.0, 1e-12);
  for (int i = 0; i < 50; ++i)
  {
    RaiseLight(light, Up, 10.0);
  }
  EXPECT_NEAR(Distance(light), 5.0, 1e-9);
  EXPECT_NEAR(std::asin((light.Position[2] + 1.0) / 5.0) * 180.0 / std::acos(-1.0), 88.0, 1e-6);
  EXPECT_GT(light.Position[0], 1.0) << "still on its side of the axis";
}

//--------------------------------------------------------------------------------------------------
TEST(LightMotion, ALightStraightAboveCanBeLowered)
{
  LightDescription light = MakeLight();
  light.Position = { { 1.0, 0.0, 4.0 } };
  RaiseLight(light, Up, -30.0);
  EXPECT_NEAR(Distance(light), 5.0, 1e-12);
  EXPECT_NEAR(light.Position[2] + 1.0, 5.0 * std::cos(std::acos(-1.0) / 6.0), 1e-12);
}

//--------------------------------------------------------------------------------------------------
TEST(LightMotion, DistanceScalesForLightsThatHaveOne)
{
  LightDescription light = MakeLight();
  ScaleLightDistance(light, 2.0);
  EXPECT_EQ(light.Position, (Vector3{ { 7.0, 0.0, 7.0 } }));
  light.Directional = true;
  ScaleLightDistance(light, 2.0);
  EXPECT_EQ(light.Position, (Vector3{ { 7.0, 0.0, 7.0 } }));
}

//--------------------------------------------------------------------------------------------------
TEST(LightMotion, SizesScaleAndLightsWithoutExtentGetOne)
{
  LightDescription light = MakeLight();
  ScaleLightSize(light, 1.5);
  EXPECT_EQ(light.Size, (Vector2{ { 3.0, 1.5 } }));
  EXPECT_EQ(SpellLightSize(light), "3 x 1.5");

  light.Shape = LightShape::Point;
  EXPECT_EQ(SpellLightSize(light), "point");
  ScaleLightSize(light, 0.8);
  EXPECT_EQ(light.Shape, LightShape::Point) << "nothing to shrink";
  ScaleLightSize(light, 1.25);
  EXPECT_EQ(light.Shape, LightShape::Disk);
  EXPECT_NEAR(light.Size[0], 0.05, 1e-12) << "a hundredth of the distance";
}

//--------------------------------------------------------------------------------------------------
TEST(LightMotion, SunsScaleByTheirAngle)
{
  LightDescription sun = MakeLight();
  sun.Directional = true;
  ScaleLightSize(sun, 1.25);
  EXPECT_DOUBLE_EQ(sun.AngularDiameter, 0.5);
  ScaleLightSize(sun, 2.0);
  EXPECT_DOUBLE_EQ(sun.AngularDiameter, 1.0);
  EXPECT_EQ(SpellLightSize(sun), "1 degrees");
  ScaleLightSize(sun, 1000.0);
  EXPECT_DOUBLE_EQ(sun.AngularDiameter, 170.0);
}
