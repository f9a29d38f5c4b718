// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a light shines from: every kind of light, and the lights that cast nothing, with the reason.

#include "vtkAreaLight.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationKeyLookup.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkShadowEmitter.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace
{
using Vector = std::array<double, 3>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

vtkShadowEmitter EmitterOf(vtkLight* light)
{
  vtkShadowEmitter emitter;
  std::string reason;
  EXPECT_TRUE(vtkShadowEmitter::FromLight(light, emitter, reason)) << reason;
  return emitter;
}

void ExpectRefused(vtkLight* light, const std::string& words)
{
  vtkShadowEmitter emitter;
  std::string reason;
  EXPECT_FALSE(vtkShadowEmitter::FromLight(light, emitter, reason)) << words;
  EXPECT_NE(reason.find(words), std::string::npos) << "the reason given is: " << reason;
}

// A positional lamp at (1, 2, 3) that shines along -z, without a cone.
void PlaceLamp(vtkLight* light)
{
  light->SetPositional(1);
  light->SetConeAngle(90.0);
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFocalPoint(1.0, 2.0, -4.0);
}

// The key of VTK's ray tracing module, which these tests do not link.
vtkInformationDoubleKey* RadiusKey()
{
  vtkInformationKey* key = vtkInformationKeyLookup::Find("RADIUS", "vtkOSPRayLightNode");
  return key ? vtkInformationDoubleKey::SafeDownCast(key)
             : vtkInformationDoubleKey::MakeKey("RADIUS", "vtkOSPRayLightNode");
}

void ExpectNear(const Vector& actual, const Vector& expected, const char* what)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(actual[i], expected[i], 1e-12) << what << ", component " << i;
  }
}

void ExpectRightHandedFrame(const vtkShadowEmitter& emitter)
{
  Vector width;
  vtkMath::Cross(emitter.Direction.data(), emitter.AxisV.data(), width.data());
  ExpectNear(emitter.AxisU, width, "AxisU = Direction x AxisV");
  EXPECT_NEAR(vtkMath::Norm(emitter.AxisU.data()), 1.0, 1e-12);
  EXPECT_NEAR(vtkMath::Norm(emitter.AxisV.data()), 1.0, 1e-12);
  EXPECT_NEAR(vtkMath::Norm(emitter.Direction.data()), 1.0, 1e-12);
}
} // namespace

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfARectangle)
{
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  light->SetSize(0.4, 0.6);
  light->SetViewUp(0.0, 1.0, 0.0);
  const vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_EQ(emitter.Shape, vtkShadowEmitter::RECTANGLE);
  EXPECT_FALSE(emitter.Directional);
  EXPECT_FALSE(emitter.Omni) << "rectangles shine to their front only";
  EXPECT_FALSE(emitter.Face);
  EXPECT_FALSE(emitter.HasCone());
  EXPECT_TRUE(emitter.HasExtent());
  ExpectNear(emitter.Center, { { 1, 2, 3 } }, "center");
  ExpectNear(emitter.Apex, { { 1, 2, 3 } }, "apex");
  ExpectNear(emitter.AxisU, { { 1, 0, 0 } }, "width axis");
  ExpectNear(emitter.AxisV, { { 0, 1, 0 } }, "height axis");
  ExpectNear(emitter.Direction, { { 0, 0, -1 } }, "direction");
  EXPECT_NEAR(emitter.HalfSize[0], 0.2, 1e-15);
  EXPECT_NEAR(emitter.HalfSize[1], 0.3, 1e-15);
  EXPECT_EQ(emitter.Weight, 1.0);
  EXPECT_EQ(emitter.WindowCenter, (std::array<double, 2>{ { 0.0, 0.0 } }));
  EXPECT_EQ(emitter.WindowHalfSize, (std::array<double, 2>{ { 1.0, 1.0 } }));
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfADisk)
{
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  light->SetShapeToDisk();
  light->SetSize(0.8, 0.8);
  const vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_EQ(emitter.Shape, vtkShadowEmitter::DISK);
  EXPECT_FALSE(emitter.Omni) << "disks shine to their front only";
  EXPECT_NEAR(emitter.HalfSize[0], 0.4, 1e-15);
  EXPECT_NEAR(emitter.HalfSize[1], 0.4, 1e-15);
  ExpectRightHandedFrame(emitter);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfALineStillHasExtent)
{
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  light->SetSize(2.0, 0.0);
  const vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_EQ(emitter.Shape, vtkShadowEmitter::RECTANGLE);
  EXPECT_TRUE(emitter.HasExtent());
  EXPECT_EQ(emitter.HalfSize[1], 0.0);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfAPointShinesToAllSidesUnlessItHasACone)
{
  for (const bool shape : { true, false })
  {
    vtkNew<vtkAreaLight> light;
    PlaceLamp(light);
    shape ? light->SetShapeToPoint() : light->SetSize(0.0, 0.0);
    const char* what = shape ? "shape point" : "size zero";
    vtkShadowEmitter emitter = EmitterOf(light);
    EXPECT_EQ(emitter.Shape, vtkShadowEmitter::POINT) << what;
    EXPECT_FALSE(emitter.HasExtent()) << what;
    EXPECT_TRUE(emitter.Omni) << what;
    light->SetConeAngle(30.0);
    emitter = EmitterOf(light);
    EXPECT_FALSE(emitter.Omni) << what;
    EXPECT_TRUE(emitter.HasCone()) << what;
    EXPECT_EQ(emitter.ConeAngle, 30.0) << what;
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfASunIsADiskOfTangents)
{
  for (const double degrees : { 0.53, 5.0, 170.0 })
  {
    vtkNew<vtkAreaLight> light;
    light->SetPosition(3.0, 0.0, 4.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetConeAngle(20.0); // which directional lights do not have
    light->SetAngularDiameter(degrees);
    const vtkShadowEmitter emitter = EmitterOf(light);
    const double tangent = std::tan(degrees / 2.0 * vtkMath::Pi() / 180.0);
    EXPECT_TRUE(emitter.Directional);
    EXPECT_EQ(emitter.Shape, vtkShadowEmitter::DISK) << degrees;
    EXPECT_FALSE(emitter.Omni) << degrees;
    EXPECT_FALSE(emitter.HasCone()) << degrees;
    EXPECT_NEAR(emitter.HalfSize[0], tangent, 1e-12 * tangent) << degrees;
    EXPECT_NEAR(emitter.HalfSize[1], tangent, 1e-12 * tangent) << degrees;
    ExpectNear(emitter.Direction, { { -0.6, 0.0, -0.8 } }, "direction");
    ExpectRightHandedFrame(emitter);
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfASunWithoutAngleIsHard)
{
  vtkNew<vtkAreaLight> light;
  light->SetSize(3.0, 3.0);
  vtkObject::GlobalWarningDisplayOff();
  light->SetPositional(0); // which warns: directional lights ignore the size
  vtkObject::GlobalWarningDisplayOn();
  const vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_TRUE(emitter.Directional);
  EXPECT_EQ(emitter.Shape, vtkShadowEmitter::POINT);
  EXPECT_FALSE(emitter.HasExtent());
  EXPECT_FALSE(emitter.Omni);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfASpotHasItsApexAtTheLight)
{
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  light->SetConeAngle(35.0);
  const vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_TRUE(emitter.HasCone());
  EXPECT_EQ(emitter.ConeAngle, 35.0);
  EXPECT_FALSE(emitter.Omni);
  ExpectNear(emitter.Apex, { { 1, 2, 3 } }, "apex");
  light->SetConeAngle(120.0);
  EXPECT_FALSE(EmitterOf(light).HasCone()) << "90 degrees and above are no cone";
  EXPECT_EQ(EmitterOf(light).ConeAngle, 90.0);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfAPlainLightIsHard)
{
  vtkNew<vtkLight> light;
  vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_TRUE(emitter.Directional);
  EXPECT_FALSE(emitter.HasExtent());
  PlaceLamp(light);
  emitter = EmitterOf(light);
  EXPECT_FALSE(emitter.Directional);
  EXPECT_EQ(emitter.Shape, vtkShadowEmitter::POINT);
  EXPECT_TRUE(emitter.Omni);
  ExpectNear(emitter.Direction, { { 0, 0, -1 } }, "direction");
  light->SetConeAngle(30.0);
  EXPECT_FALSE(EmitterOf(light).Omni);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfAPlainLightWithTheRayTracersRadius)
{
  vtkNew<vtkLight> light;
  light->GetInformation()->Set(RadiusKey(), 5.0);
  vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_EQ(emitter.Shape, vtkShadowEmitter::DISK);
  EXPECT_NEAR(emitter.HalfSize[0], std::tan(2.5 * vtkMath::Pi() / 180.0), 1e-14)
    << "degrees for suns";

  PlaceLamp(light);
  light->GetInformation()->Set(RadiusKey(), 0.25);
  emitter = EmitterOf(light);
  EXPECT_EQ(emitter.Shape, vtkShadowEmitter::DISK);
  EXPECT_EQ(emitter.HalfSize[0], 0.25) << "the radius of a lamp";
  EXPECT_EQ(emitter.HalfSize[1], 0.25);

  for (const double none : { 0.0, -1.0, NotANumber, Infinity })
  {
    light->GetInformation()->Set(RadiusKey(), none);
    EXPECT_FALSE(EmitterOf(light).HasExtent()) << "a radius of " << none;
  }
  light->SetInformation(nullptr);
  EXPECT_FALSE(EmitterOf(light).HasExtent()) << "no information at all";
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfAnAreaLightIgnoresTheRayTracersRadius)
{
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  light->SetSize(0.4, 0.6);
  light->GetInformation()->Set(RadiusKey(), 7.0);
  EXPECT_EQ(EmitterOf(light).Shape, vtkShadowEmitter::RECTANGLE);
  EXPECT_NEAR(EmitterOf(light).HalfSize[0], 0.2, 1e-15);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfCameraLightsAndHeadlightsFollowsTheirTransform)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, 20.0, 30.0);
  transform->RotateX(90.0); // -z becomes +y
  for (const int type : { VTK_LIGHT_TYPE_CAMERA_LIGHT, VTK_LIGHT_TYPE_HEADLIGHT })
  {
    for (const bool positional : { true, false })
    {
      vtkNew<vtkAreaLight> light;
      light->SetLightType(type);
      light->SetPositional(positional);
      light->SetPosition(0.0, 0.0, 1.0);
      light->SetFocalPoint(0.0, 0.0, 0.0);
      light->SetTransformMatrix(transform->GetMatrix());
      const vtkShadowEmitter emitter = EmitterOf(light);
      ExpectNear(emitter.Direction, { { 0, 1, 0 } }, "direction");
      const Vector lamp = { { 10, 19, 30 } };
      const Vector focus = { { 10, 20, 30 } };
      ExpectNear(emitter.Center, positional ? lamp : focus, "center");
      ExpectRightHandedFrame(emitter);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfALightWithoutDirection)
{
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  light->SetFocalPoint(1.0, 2.0, 3.0);
  ExpectRefused(light, "its position is its focal point");
  light->SetPositional(0);
  ExpectRefused(light, "its position is its focal point");
  light->SetPositional(1);
  light->SetShapeToPoint();
  light->SetConeAngle(30.0);
  ExpectRefused(light, "its position is its focal point");
  // To all sides needs no direction.
  light->SetConeAngle(90.0);
  const vtkShadowEmitter emitter = EmitterOf(light);
  EXPECT_TRUE(emitter.Omni);
  ExpectRightHandedFrame(emitter);
  // A transform may fold the two together.
  vtkNew<vtkAreaLight> folded;
  PlaceLamp(folded);
  vtkNew<vtkMatrix4x4> flat;
  flat->SetElement(2, 2, 0.0);
  folded->SetTransformMatrix(flat);
  ExpectRefused(folded, "its position is its focal point");
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfALightWithoutACone)
{
  for (const double angle : { 0.0, -5.0 })
  {
    vtkNew<vtkAreaLight> light;
    PlaceLamp(light);
    light->SetConeAngle(angle);
    ExpectRefused(light, "its cone angle is 0");
    light->SetPositional(0);
    EXPECT_TRUE(EmitterOf(light).Directional) << "directional lights have no cone";
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, OfALightThatIsNotFinite)
{
  for (const double bad : { NotANumber, Infinity, -Infinity })
  {
    for (const int positional : { 0, 1 })
    {
      vtkNew<vtkAreaLight> light;
      PlaceLamp(light);
      light->SetPositional(positional);
      light->SetPosition(1.0, bad, 3.0);
      ExpectRefused(light, "not finite");
      PlaceLamp(light);
      light->SetPositional(positional);
      light->SetFocalPoint(1.0, 2.0, bad);
      ExpectRefused(light, "not finite");
    }
  }
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  light->SetConeAngle(NotANumber);
  ExpectRefused(light, "its cone angle is not a number");
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, ForgetsWhatItWas)
{
  vtkNew<vtkAreaLight> light;
  PlaceLamp(light);
  const vtkShadowEmitter fresh = EmitterOf(light);
  vtkShadowEmitter used = fresh.Split(2, 2)[1];
  used.Omni = true;
  used.Face = true;
  std::string reason;
  ASSERT_TRUE(vtkShadowEmitter::FromLight(light, used, reason));
  EXPECT_EQ(used, fresh);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitter, WorldToEmitterMeasuresAlongTheAxes)
{
  vtkNew<vtkAreaLight> light;
  light->SetPosition(1e7 + 1.0, -2.0, 3.0);
  light->SetFocalPoint(1e7 - 1.0, 4.0, -2.0);
  light->SetViewUp(0.2, 0.3, 1.0);
  const vtkShadowEmitter emitter = EmitterOf(light);
  const Vector expected = { { 0.5, -1.5, 4.0 } };
  double world[4] = { 0.0, 0.0, 0.0, 1.0 };
  for (int i = 0; i < 3; ++i)
  {
    world[i] = emitter.Center[i] + expected[0] * emitter.AxisU[i] + expected[1] * emitter.AxisV[i] +
      expected[2] * emitter.Direction[i];
  }
  const std::array<double, 16> matrix = emitter.WorldToEmitter();
  double result[4];
  vtkMatrix4x4::MultiplyPoint(matrix.data(), world, result);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(result[i], expected[i], 1e-7) << "component " << i; // 1e7 in doubles: 2e-9
  }
  EXPECT_EQ(result[3], 1.0);
}
