// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Things near a lamp and things far away, up to a million times as far, have their shadows at once.
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

using namespace SoftShadowsTesting;

namespace
{

class DepthRange : public testing::TestWithParam<Technique>
{
};

// A desk with a lamp 0.35 above it, in units of so much, and what else there is.
struct Desk
{
  explicit Desk(double scale)
    : Scale(scale)
    , Renderer(MakeRenderer({ { 0.0, 0.0, scale } }, { { 0.0, 0.0, 0.0 } }))
    , Lamp(MakeLamp({ { 0.0, 0.0, 0.35 * scale } }, { { 0.35 * scale, 0.0, 0.0 } }, 0.06 * scale))
  {
    this->Lamp->SetConeAngle(60.0);
    this->Renderer->AddLight(this->Lamp);
  }

  void AddBox(std::array<double, 6> bounds, double scale) const
  {
    for (double& bound : bounds)
    {
      bound *= scale;
    }
    this->Renderer->AddActor(MakeBoxActor(bounds));
  }

  // The desk, a box on it, and two posts between which the lamp sees the horizon.
  void AddNear() const
  {
    const double s = this->Scale;
    this->AddBox({ { -0.8, 0.8, -0.8, 0.8, -0.02, 0.0 } }, s);
    this->AddBox({ { 0.28, 0.38, -0.05, 0.05, 0.0, 0.1 } }, s);
    this->AddBox({ { 0.48, 0.52, -0.42, -0.38, 0.0, 0.6 } }, s);
    this->AddBox({ { 0.48, 0.52, 0.38, 0.42, 0.0, 0.6 } }, s);
  }

  // A post before a wall, which from the lamp look the same at any distance.
  void AddFar(double distance) const
  {
    const double s = this->Scale * distance;
    this->AddBox({ { 0.8, 0.84, -0.05, 0.05, -0.1, 0.05 } }, s);
    this->AddBox({ { 1.0, 1.02, -0.2, 0.2, -0.2, 0.1 } }, s);
  }

  void LookAtDesk() const
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double s = this->Scale;
    camera->SetPosition(-0.4 * s, -1.2 * s, 1.2 * s);
    camera->SetFocalPoint(0.3 * s, 0.0, 0.0);
    camera->SetViewAngle(40.0);
    camera->SetClippingRange(0.5 * s, 3.0 * s);
  }

  void LookAtWall(double distance) const
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double s = this->Scale * distance;
    camera->SetPosition(0.4 * s, 0.3 * s, 0.2 * s);
    camera->SetFocalPoint(s, 0.0, 0.0);
    camera->SetViewAngle(40.0);
    camera->SetClippingRange(0.2 * s, 2.0 * s);
  }

  double Scale;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAreaLight> Lamp;
};

// The mean difference of two visibilities; pictures without a value agree.
double MeanDifference(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    EXPECT_EQ(std::isnan(a.Values[i]), std::isnan(b.Values[i]));
    if (!std::isnan(a.Values[i]))
    {
      sum += std::abs(a.Values[i] - b.Values[i]);
      ++count;
    }
  }
  return count > 0 ? sum / count : 1.0;
}

}

//------------------------------------------------------------------------------
TEST_P(DepthRange, NearAndFarThingsKeepTheirShadows)
{
  const auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    Desk alone(scale);
    alone.AddNear();
    alone.LookAtDesk();
    Stage aloneStage(alone.Renderer, pass);
    const Picture desk = aloneStage.RenderVisibility(alone.Lamp);
    EXPECT_GT(CountShadowed(desk), 400) << scale;

    Desk away(scale);
    away.AddFar(10.0);
    away.LookAtWall(10.0);
    const auto awayPass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    Stage awayStage(away.Renderer, awayPass);
    const int onWall = CountShadowed(awayStage.RenderVisibility(away.Lamp));
    EXPECT_GT(onWall, 400) << scale;

    for (const double range : { 1e3, 1e4, 1e5, 1e6 })
    {
      SCOPED_TRACE(testing::Message() << "scale " << scale << ", range " << range);
      // The nearest caster is about 0.3 from the lamp, along its axis.
      const double distance = 0.3 * range;
      Desk both(scale);
      both.AddNear();
      both.AddFar(distance);
      const auto bothPass = this->GetParam().Make(Effort::Quick, Weights::Mean);
      Stage stage(both.Renderer, bothPass);
      both.LookAtDesk();
      const Picture seen = stage.RenderVisibility(both.Lamp);
      EXPECT_LE(MeanDifference(desk, seen), 1.0 / 255.0);
      EXPECT_NEAR(CountShadowed(seen), CountShadowed(desk), 0.01 * CountShadowed(desk));
      both.LookAtWall(distance);
      EXPECT_NEAR(CountShadowed(stage.RenderVisibility(both.Lamp)), onWall, 0.05 * onWall);
    }
  }
}

//------------------------------------------------------------------------------
TEST(DepthRangeReport, NamesTheLightThatCannotHoldItAll)
{
  Desk both(1.0);
  both.AddNear();
  both.AddFar(1e9);
  both.LookAtDesk();
  const auto pass = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
  Stage stage(both.Renderer, pass);
  stage.Render();
  EXPECT_NE(pass->GetLightReport().find("casts, but not with"), std::string::npos)
    << pass->GetLightReport();
  EXPECT_NE(pass->GetLightReport().find("4 casters"), std::string::npos) << pass->GetLightReport();
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, DepthRange, testing::ValuesIn(AllTechniques()), NameOfTechnique);
