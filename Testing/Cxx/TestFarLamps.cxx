// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A lamp very far away is the directional light of its angular size.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

class FarLamps : public testing::TestWithParam<Technique>
{
};

// A box on the ground, of a size, and the sun as it is or as a lamp so far away.
struct Place
{
  explicit Place(double size)
    : Size(size)
    , Renderer(
        MakeRenderer({ { -0.6 * size, -1.6 * size, 1.5 * size } }, { { 0.1 * size, 0.0, 0.0 } }))
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetClippingRange(0.5 * size, 6.0 * size);
    this->Renderer->AddActor(MakeGroundActor(0.5 * size));
    this->Renderer->AddActor(MakeBoxActor(
      { { -0.1 * size, 0.1 * size, -0.1 * size, 0.1 * size, 0.1 * size, 0.4 * size } }));
  }

  static Point Towards() { return { { -0.6, 0.3, 0.8 } }; }

  vtkAreaLight* AddSun(double degrees)
  {
    this->Light = MakeSun(Towards(), degrees);
    this->Renderer->AddLight(this->Light);
    return this->Light;
  }

  vtkAreaLight* AddLamp(double distance, double degrees)
  {
    Point position = Towards();
    const double length =
      std::sqrt(position[0] * position[0] + position[1] * position[1] + position[2] * position[2]);
    for (double& coordinate : position)
    {
      coordinate *= distance / length;
    }
    const double diameter = 2.0 * distance * std::tan(0.5 * degrees * std::acos(-1.0) / 180.0);
    this->Light = MakeLamp(position, { { 0.0, 0.0, 0.0 } }, diameter);
    this->Renderer->AddLight(this->Light);
    return this->Light;
  }

  double Size;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAreaLight> Light;
};

double RootMeanSquare(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    EXPECT_EQ(std::isnan(a.Values[i]), std::isnan(b.Values[i]));
    if (!std::isnan(a.Values[i]))
    {
      sum += (a.Values[i] - b.Values[i]) * (a.Values[i] - b.Values[i]);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 1.0;
}

}

//------------------------------------------------------------------------------
TEST_P(FarLamps, AreDirectionalLightsOfTheirAngularSize)
{
  const double degrees = 2.0 * std::atan(0.5 * 1.39e9 / 1.5e11) * 180.0 / std::acos(-1.0);
  for (const double size : { 1.0, 1000.0 })
  {
    Place lit(size);
    vtkAreaLight* sun = lit.AddSun(degrees);
    const auto sunPass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    Stage sunStage(lit.Renderer, sunPass);
    const Picture expected = sunStage.RenderVisibility(sun);
    EXPECT_GT(CountShadowed(expected), 500);
    for (const double distance : { 1e8, 1e9, 1.5e11, 1e20, 1e30 })
    {
      SCOPED_TRACE(testing::Message() << "size " << size << ", distance " << distance);
      Place place(size);
      vtkAreaLight* lamp = place.AddLamp(distance, degrees);
      const auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
      Stage stage(place.Renderer, pass);
      EXPECT_LE(RootMeanSquare(expected, stage.RenderVisibility(lamp)), 0.01);
      // At 100000 times the scene's size the report says what is done.
      EXPECT_EQ(
        pass->GetLightReport().find("so far away that its rays are parallel") != std::string::npos,
        distance >= 1e6 * size)
        << pass->GetLightReport();
    }
  }
}

//------------------------------------------------------------------------------
// Beyond what a double can square there is no direction; the report says so and nothing is NaN.
TEST_P(FarLamps, BeyondAllNumbersAreReported)
{
  Place place(1.0);
  vtkAreaLight* lamp = place.AddLamp(1e200, 0.5);
  const auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
  Stage stage(place.Renderer, pass);
  const Picture visibility = stage.RenderVisibility(lamp);
  for (const float value : visibility.Values)
  {
    EXPECT_TRUE(std::isnan(value) || (value >= 0.0f && value <= 1.0f));
  }
  EXPECT_NE(pass->GetLightReport().find("too far from its focal point"), std::string::npos)
    << pass->GetLightReport();
}

INSTANTIATE_TEST_SUITE_P(Techniques, FarLamps, testing::ValuesIn(AllTechniques()), NameOfTechnique);
