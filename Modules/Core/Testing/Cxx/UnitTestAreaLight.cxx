// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The light as an object: values, refusals, modification times, copies, and its frame.

#include "vtkAreaLight.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

namespace
{
using Vector = std::array<double, 3>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Counts an object's errors, or its warnings, which are not printed then. Keeps the last's words.
class ErrorCounter
{
public:
  explicit ErrorCounter(vtkObject* object, unsigned long event = vtkCommand::ErrorEvent)
    : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* words)
      {
        auto* counter = static_cast<ErrorCounter*>(self);
        ++counter->Count;
        counter->Words = static_cast<const char*>(words);
      });
    object->AddObserver(event, this->Command);
  }
  ~ErrorCounter() { this->Object->RemoveObserver(this->Command); }
  ErrorCounter(const ErrorCounter&) = delete;
  ErrorCounter& operator=(const ErrorCounter&) = delete;
  int Count = 0;
  std::string Words;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
};

// Every value differs from its default.
void FillIn(vtkAreaLight* light)
{
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFocalPoint(4.0, 5.0, 7.0);
  light->SetAmbientColor(0.1, 0.2, 0.3);
  light->SetDiffuseColor(0.4, 0.5, 0.6);
  light->SetSpecularColor(0.7, 0.8, 0.9);
  light->SetIntensity(0.25);
  light->SetSwitch(0);
  light->SetExponent(3.0);
  light->SetConeAngle(40.0);
  light->SetAttenuationValues(1.0, 2.0, 3.0);
  light->SetShadowAttenuation(0.5f);
  light->SetLightTypeToCameraLight();
  light->SetShapeToDisk();
  light->SetSize(2.0, 3.0);
  light->SetViewUp(0.0, 0.5, 1.0);
  ErrorCounter warnings(light, vtkCommand::WarningEvent); // of a size that has no effect
  light->SetAngularDiameter(5.0);
  EXPECT_EQ(warnings.Count, 1);
}

void ExpectEqual(const double* actual, const double* expected, int count, const char* what)
{
  for (int i = 0; i < count; ++i)
  {
    EXPECT_EQ(actual[i], expected[i]) << what << ", component " << i;
  }
}

void ExpectSameValues(vtkAreaLight* actual, vtkAreaLight* expected)
{
  ExpectEqual(actual->GetPosition(), expected->GetPosition(), 3, "position");
  ExpectEqual(actual->GetFocalPoint(), expected->GetFocalPoint(), 3, "focal point");
  ExpectEqual(actual->GetAmbientColor(), expected->GetAmbientColor(), 3, "ambient color");
  ExpectEqual(actual->GetDiffuseColor(), expected->GetDiffuseColor(), 3, "diffuse color");
  ExpectEqual(actual->GetSpecularColor(), expected->GetSpecularColor(), 3, "specular color");
  ExpectEqual(actual->GetAttenuationValues(), expected->GetAttenuationValues(), 3, "attenuation");
  EXPECT_EQ(actual->GetIntensity(), expected->GetIntensity());
  EXPECT_EQ(actual->GetSwitch(), expected->GetSwitch());
  EXPECT_EQ(actual->GetPositional(), expected->GetPositional());
  EXPECT_EQ(actual->GetExponent(), expected->GetExponent());
  EXPECT_EQ(actual->GetConeAngle(), expected->GetConeAngle());
  EXPECT_EQ(actual->GetShadowAttenuation(), expected->GetShadowAttenuation());
  EXPECT_EQ(actual->GetLightType(), expected->GetLightType());
  EXPECT_EQ(actual->GetShape(), expected->GetShape());
  ExpectEqual(actual->GetSize(), expected->GetSize(), 2, "size");
  ExpectEqual(actual->GetViewUp(), expected->GetViewUp(), 3, "view up");
  EXPECT_EQ(actual->GetAngularDiameter(), expected->GetAngularDiameter());
}

struct Frame
{
  Vector Width;
  Vector Height;
  Vector Direction;
};

Frame FrameOf(vtkLight* light)
{
  Frame frame;
  vtkAreaLight::GetTransformedAxes(
    light, frame.Width.data(), frame.Height.data(), frame.Direction.data());
  return frame;
}

Frame FrameOf(const Vector& direction, const Vector& viewUp)
{
  vtkNew<vtkAreaLight> light;
  light->SetPosition(0.0, 0.0, 0.0);
  light->SetFocalPoint(direction.data());
  light->SetViewUp(viewUp.data());
  return FrameOf(light);
}

void ExpectNear(const Vector& actual, const Vector& expected, const std::string& what)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(actual[i], expected[i], 1e-12) << what << ", component " << i;
  }
}

// Width = direction x up, height = width x direction, computed apart from the class.
void ExpectFrame(const Frame& frame, Vector direction, const Vector& up, const std::string& what)
{
  vtkMath::Normalize(direction.data());
  Vector width;
  vtkMath::Cross(direction.data(), up.data(), width.data());
  vtkMath::Normalize(width.data());
  Vector height;
  vtkMath::Cross(width.data(), direction.data(), height.data());
  ExpectNear(frame.Direction, direction, what + ": direction");
  ExpectNear(frame.Width, width, what + ": width axis");
  ExpectNear(frame.Height, height, what + ": height axis");
}
} // namespace

//------------------------------------------------------------------------------
TEST(AreaLight, HasTheDocumentedDefaults)
{
  vtkNew<vtkAreaLight> light;
  EXPECT_EQ(light->GetShape(), vtkAreaLight::RECTANGLE);
  EXPECT_STREQ(light->GetShapeAsString(), "rectangle");
  EXPECT_EQ(light->GetSize()[0], 1.0);
  EXPECT_EQ(light->GetSize()[1], 1.0);
  EXPECT_EQ(vtkMath::Norm(light->GetViewUp()), 0.0);
  EXPECT_EQ(light->GetAngularDiameter(), 0.0);
  EXPECT_EQ(light->GetPositional(), 1);
  EXPECT_GE(light->GetConeAngle(), 90.0) << "no cone";
  EXPECT_EQ(light->GetShadowAttenuation(), 1.0f);
}

//------------------------------------------------------------------------------
TEST(AreaLight, AnAngularDiameterMakesASunAndZeroMakesNothing)
{
  vtkNew<vtkAreaLight> light;
  light->SetAngularDiameter(0.0);
  EXPECT_EQ(light->GetPositional(), 1);
  light->SetAngularDiameter(0.53);
  EXPECT_EQ(light->GetPositional(), 0);
  light->SetAngularDiameter(0.0);
  EXPECT_EQ(light->GetPositional(), 0);
  ErrorCounter errors(light);
  light->SetAngularDiameter(NotANumber);
  EXPECT_EQ(errors.Count, 1);
  EXPECT_EQ(light->GetAngularDiameter(), 0.0);
}

//------------------------------------------------------------------------------
TEST(AreaLight, WarnsOfASizeOfADirectionalLightOnce)
{
  using Setter = std::function<void(vtkAreaLight*)>;
  const Setter size = [](vtkAreaLight* light) { light->SetSize(0.4, 0.4); };
  const Setter directional = [](vtkAreaLight* light) { light->SetPositional(0); };
  const Setter angle = [](vtkAreaLight* light) { light->SetAngularDiameter(2.0); };
  for (const auto& setters : { std::pair<Setter, Setter>{ size, directional },
         std::pair<Setter, Setter>{ directional, size }, std::pair<Setter, Setter>{ size, angle },
         std::pair<Setter, Setter>{ angle, size } })
  {
    vtkNew<vtkAreaLight> light;
    ErrorCounter warnings(light, vtkCommand::WarningEvent);
    setters.first(light);
    EXPECT_EQ(warnings.Count, 0) << "nothing contradicts anything yet: " << warnings.Words;
    setters.second(light);
    EXPECT_EQ(warnings.Count, 1);
    EXPECT_NE(warnings.Words.find("its Size has no effect"), std::string::npos) << warnings.Words;
    setters.second(light);
    light->SetSize(0.5, 0.5);
    EXPECT_EQ(warnings.Count, 1) << "of the same contradiction";
    light->SetAngularDiameter(0.0);
    light->SetPositional(1);
    EXPECT_EQ(warnings.Count, 1) << "all is well";
    light->SetPositional(0);
    EXPECT_EQ(warnings.Count, 2) << "another contradiction";
  }
}

//------------------------------------------------------------------------------
TEST(AreaLight, WarnsOfAnAngleOfAPositionalLightOnce)
{
  vtkNew<vtkAreaLight> light;
  ErrorCounter warnings(light, vtkCommand::WarningEvent);
  light->SetPositional(1);
  light->SetAngularDiameter(2.0);
  EXPECT_EQ(warnings.Count, 0) << "the angle made it directional: " << warnings.Words;
  light->SetPositional(1);
  light->SetPositional(1);
  EXPECT_EQ(warnings.Count, 1);
  EXPECT_NE(
    warnings.Words.find("its AngularDiameter of 2 degrees has no effect"), std::string::npos)
    << warnings.Words;
  light->SetPositional(0);
  EXPECT_EQ(warnings.Count, 1) << "all is well";
}

//------------------------------------------------------------------------------
TEST(AreaLight, CopiesContradictionsWithoutAWord)
{
  vtkNew<vtkAreaLight> sun;
  vtkNew<vtkAreaLight> lamp;
  vtkNew<vtkAreaLight> plain;
  {
    ErrorCounter first(sun, vtkCommand::WarningEvent);
    ErrorCounter second(lamp, vtkCommand::WarningEvent);
    sun->SetAngularDiameter(2.0);
    sun->SetSize(3.0, 3.0);
    lamp->SetAngularDiameter(2.0);
    lamp->SetPositional(1);
    EXPECT_EQ(first.Count + second.Count, 2);
  }
  for (vtkAreaLight* light : { sun.Get(), lamp.Get(), plain.Get() })
  {
    for (vtkAreaLight* former : { sun.Get(), lamp.Get(), plain.Get() })
    {
      vtkNew<vtkAreaLight> copy;
      ErrorCounter warnings(copy, vtkCommand::WarningEvent);
      copy->DeepCopy(former);
      copy->DeepCopy(light);
      EXPECT_EQ(warnings.Count, 0) << warnings.Words;
      ExpectSameValues(copy, light);
    }
  }
}

//------------------------------------------------------------------------------
TEST(AreaLight, RefusesSizesThatAreNegativeOrNotFinite)
{
  vtkNew<vtkAreaLight> light;
  light->SetSize(2.0, 3.0);
  const vtkMTimeType time = light->GetMTime();
  ErrorCounter errors(light);
  int refused = 0;
  for (const double bad : { -1.0, -1e-300, NotANumber, Infinity, -Infinity })
  {
    light->SetSize(bad, 1.0);
    light->SetSize(1.0, bad);
    refused += 2;
    EXPECT_EQ(errors.Count, refused) << "a size of " << bad;
    EXPECT_EQ(light->GetSize()[0], 2.0) << "a size of " << bad;
    EXPECT_EQ(light->GetSize()[1], 3.0) << "a size of " << bad;
    EXPECT_EQ(light->GetMTime(), time) << "a size of " << bad;
  }
  light->SetSize(0.0, 0.0);
  EXPECT_EQ(errors.Count, refused) << "zero is a size";
  EXPECT_EQ(light->GetSize()[0], 0.0);
}

//------------------------------------------------------------------------------
TEST(AreaLight, ClampsShapeAndAngle)
{
  vtkNew<vtkAreaLight> light;
  light->SetShape(7);
  EXPECT_EQ(light->GetShape(), vtkAreaLight::POINT);
  EXPECT_STREQ(light->GetShapeAsString(), "point");
  light->SetShape(-1);
  EXPECT_EQ(light->GetShape(), vtkAreaLight::RECTANGLE);
  light->SetAngularDiameter(-1.0);
  EXPECT_EQ(light->GetAngularDiameter(), 0.0);
  light->SetAngularDiameter(180.0);
  EXPECT_EQ(light->GetAngularDiameter(), 170.0);
}

//------------------------------------------------------------------------------
TEST(AreaLight, IsModifiedByEveryChangeAndByNothingElse)
{
  vtkNew<vtkAreaLight> light;
  const ErrorCounter warnings(light, vtkCommand::WarningEvent); // of a size and an angle
  const double size[2] = { 4.0, 5.0 };
  const std::array<std::pair<const char*, std::function<void()>>, 9> setters = { {
    { "disk", [&] { light->SetShapeToDisk(); } },
    { "point", [&] { light->SetShapeToPoint(); } },
    { "rectangle", [&] { light->SetShapeToRectangle(); } },
    { "width", [&] { light->SetSize(2.0, 1.0); } },
    { "height", [&] { light->SetSize(2.0, 3.0); } },
    { "size as an array", [&] { light->SetSize(size); } },
    { "view up", [&] { light->SetViewUp(0.0, 0.0, 1.0); } },
    { "angular diameter", [&] { light->SetAngularDiameter(0.53); } },
    { "position", [&] { light->SetPosition(7.0, 8.0, 9.0); } },
  } };
  for (const auto& setter : setters)
  {
    const vtkMTimeType before = light->GetMTime();
    setter.second();
    const vtkMTimeType after = light->GetMTime();
    EXPECT_GT(after, before) << setter.first;
    setter.second();
    EXPECT_EQ(light->GetMTime(), after) << setter.first << " set to what it is";
  }
}

//------------------------------------------------------------------------------
TEST(AreaLight, DeepCopyOfAnAreaLightCopiesEverythingAndSharesNothing)
{
  vtkNew<vtkAreaLight> light;
  FillIn(light);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 11.0);
  light->SetTransformMatrix(matrix);

  vtkNew<vtkAreaLight> copy;
  copy->DeepCopy(light);
  ExpectSameValues(copy, light);
  ASSERT_NE(copy->GetTransformMatrix(), nullptr);
  EXPECT_NE(copy->GetTransformMatrix(), matrix.Get());
  EXPECT_EQ(copy->GetTransformMatrix()->GetElement(0, 3), 11.0);
}

//------------------------------------------------------------------------------
TEST(AreaLight, DeepCopyOfAPlainLightLeavesTheExtent)
{
  vtkNew<vtkLight> plain;
  plain->SetPosition(1.0, 2.0, 3.0);
  plain->SetConeAngle(25.0);
  vtkNew<vtkAreaLight> copy;
  copy->SetShapeToDisk();
  copy->SetAngularDiameter(5.0);
  ErrorCounter warnings(copy, vtkCommand::WarningEvent);
  copy->SetSize(2.0, 3.0);
  EXPECT_EQ(warnings.Count, 1);
  copy->DeepCopy(plain);
  EXPECT_EQ(warnings.Count, 1) << "copies say nothing";
  EXPECT_EQ(copy->GetPosition()[2], 3.0);
  EXPECT_EQ(copy->GetConeAngle(), 25.0);
  EXPECT_EQ(copy->GetShape(), vtkAreaLight::DISK);
  EXPECT_EQ(copy->GetSize()[1], 3.0);
  EXPECT_EQ(copy->GetAngularDiameter(), 5.0);
}

//------------------------------------------------------------------------------
TEST(AreaLight, ShallowCloneHasAllValuesAndSharesTheTransform)
{
  static vtkInformationDoubleKey* key =
    vtkInformationDoubleKey::MakeKey("CLONED", "UnitTestAreaLight");
  vtkNew<vtkAreaLight> light;
  FillIn(light);
  light->GetInformation()->Set(key, 3.0);
  vtkNew<vtkMatrix4x4> matrix;
  light->SetTransformMatrix(matrix);
  const int references = matrix->GetReferenceCount();
  {
    auto clone = vtkSmartPointer<vtkLight>::Take(light->ShallowClone());
    EXPECT_EQ(clone->GetReferenceCount(), 1);
    vtkAreaLight* area = vtkAreaLight::SafeDownCast(clone);
    ASSERT_NE(area, nullptr);
    ExpectSameValues(area, light);
    EXPECT_EQ(clone->GetTransformMatrix(), matrix.Get());
    EXPECT_EQ(clone->GetInformation()->Get(key), 3.0);
  }
  EXPECT_EQ(matrix->GetReferenceCount(), references) << "the clone released the transform";

  light->SetTransformMatrix(nullptr);
  auto clone = vtkSmartPointer<vtkLight>::Take(light->ShallowClone());
  EXPECT_EQ(clone->GetTransformMatrix(), nullptr);
}

//------------------------------------------------------------------------------
TEST(AreaLight, PrintsEveryPublicValue)
{
  vtkNew<vtkAreaLight> light;
  FillIn(light);
  std::ostringstream text;
  light->Print(text);
  for (const char* line : { "Shape: disk\n", "Size: (2, 3)\n", "ViewUp: (0, 0.5, 1)\n",
         "AngularDiameter: 5\n", "Cone Angle: 40\n" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line << "is not in\n" << text.str();
  }
}

//------------------------------------------------------------------------------
TEST(AreaLight, AxesFollowTheViewUp)
{
  ExpectNear(FrameOf({ { 0, 0, -2 } }, { { 0, 3, 0 } }).Width, { { 1, 0, 0 } }, "by hand: width");
  ExpectNear(FrameOf({ { 0, 0, -2 } }, { { 0, 3, 0 } }).Height, { { 0, 1, 0 } }, "by hand: height");
  const Vector direction = { { 1.0, -2.0, 0.5 } };
  for (const Vector& up : { Vector{ { 0, 0, 1 } }, Vector{ { 1, 1, 1 } }, Vector{ { -3, 0, 2 } },
         Vector{ { 1e-9, 0, 1e-9 } } })
  {
    ExpectFrame(FrameOf(direction, up), direction, up,
      "up (" + std::to_string(up[0]) + ", " + std::to_string(up[1]) + ", " + std::to_string(up[2]) +
        ")");
  }
}

//------------------------------------------------------------------------------
TEST(AreaLight, AxesWithoutViewUpTakeTheLeastAlignedWorldAxis)
{
  const Vector x = { { 1, 0, 0 } };
  const Vector y = { { 0, 1, 0 } };
  const Vector z = { { 0, 0, 1 } };
  const struct
  {
    Vector Direction;
    Vector Up;
    const char* What;
  } cases[] = {
    { { { 1, -2, 3 } }, x, "x is least" },
    { { { 3, 1, -2 } }, y, "y is least" },
    { { { -3, 2, 1 } }, z, "z is least" },
    { { { 0, 0, -1 } }, x, "x and y are equal" },
    { { { 0, 1, 0 } }, x, "x and z are equal" },
    { { { -1, 0, 0 } }, y, "y and z are equal" },
    { { { 1, 1, 1 } }, x, "all are equal" },
    { { { 0.7, -0.1, 0.1 } }, y, "y and z are equal but for rounding" },
  };
  for (const auto& test : cases)
  {
    ExpectFrame(FrameOf(test.Direction, { { 0, 0, 0 } }), test.Direction, test.Up, test.What);
    vtkNew<vtkLight> plain;
    plain->SetPosition(0.0, 0.0, 0.0);
    plain->SetFocalPoint(test.Direction.data());
    ExpectFrame(FrameOf(plain), test.Direction, test.Up, std::string("plain light, ") + test.What);
  }
}

//------------------------------------------------------------------------------
TEST(AreaLight, AViewUpOfNoUseIsAsNone)
{
  const Vector direction = { { 1.0, -2.0, 3.0 } };
  const Vector x = { { 1, 0, 0 } };
  ExpectFrame(FrameOf(direction, direction), direction, x, "along the direction");
  ExpectFrame(FrameOf(direction, { { -2, 4, -6 } }), direction, x, "against the direction");
  ExpectFrame(FrameOf(direction, { { NotANumber, 0, 1 } }), direction, x, "not a number");
  ExpectFrame(FrameOf(direction, { { 0, Infinity, 1 } }), direction, x, "infinite");
}

//------------------------------------------------------------------------------
TEST(AreaLight, AxesAreTurnedByTheLightsTransform)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, 20.0, 30.0);
  transform->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  vtkNew<vtkAreaLight> light;
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFocalPoint(4.0, 0.0, 1.0);
  light->SetViewUp(0.0, 0.0, 1.0);
  const Frame plain = FrameOf(light);
  light->SetTransformMatrix(transform->GetMatrix());
  const Frame turned = FrameOf(light);
  const struct
  {
    Vector Before;
    Vector After;
    const char* What;
  } axes[] = { { plain.Width, turned.Width, "width" }, { plain.Height, turned.Height, "height" },
    { plain.Direction, turned.Direction, "direction" } };
  for (const auto& axis : axes)
  {
    Vector expected;
    transform->TransformVector(axis.Before.data(), expected.data());
    ExpectNear(axis.After, expected, axis.What);
  }
}

//------------------------------------------------------------------------------
TEST(AreaLight, ALightThatAimsAtItselfStillHasAFrame)
{
  vtkNew<vtkAreaLight> light;
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFocalPoint(1.0, 2.0, 3.0);
  ExpectFrame(FrameOf(light), { { 0, 0, -1 } }, { { 1, 0, 0 } }, "no direction");
}

//------------------------------------------------------------------------------
TEST(AreaLight, GivesPlainLightsAnExtent)
{
  vtkNew<vtkLight> lamp;
  lamp->SetPositional(1);
  lamp->SetConeAngle(60.0);
  EXPECT_EQ(vtkAreaLight::GetExtent(lamp), 0.0);
  vtkAreaLight::SetExtent(lamp, 0.5);
  EXPECT_EQ(vtkAreaLight::GetExtent(lamp), 0.5);
  vtkNew<vtkLight> sun;
  vtkAreaLight::SetExtent(sun, 0.53);
  EXPECT_EQ(vtkAreaLight::GetExtent(sun), 0.53);
  vtkNew<vtkLight> copy;
  copy->DeepCopy(sun);
  EXPECT_EQ(vtkAreaLight::GetExtent(copy), 0.53);

  vtkNew<vtkAreaLight> area;
  vtkAreaLight::SetExtent(area, 3.0);
  EXPECT_EQ(vtkAreaLight::GetExtent(area), 0.0);
  EXPECT_EQ(area->GetSize()[0], 1.0);
  EXPECT_EQ(vtkAreaLight::GetExtent(nullptr), 0.0);

  const ErrorCounter errors(sun);
  for (const double wrong : { -1.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    vtkAreaLight::SetExtent(sun, wrong);
  }
  EXPECT_EQ(errors.Count, 3);
  EXPECT_EQ(vtkAreaLight::GetExtent(sun), 0.53);
}
