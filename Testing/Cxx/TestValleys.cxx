// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where two lit surfaces meet in a concave edge, of which neither hides the light from the other.
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

const double RadiansPerDegree = 0.017453292519943295;

class Valleys : public testing::TestWithParam<Technique>
{
};

// Two slopes of so many degrees that meet along a line, turned about the lamp's axis, and a lamp above.
// The camera sees so little of the line that pixels are smaller than texels there. A plate whose shadow it
// does not see makes a map be drawn.
vtkSmartPointer<vtkRenderer> MakeValley(double slope, double turn, vtkAreaLight* lamp)
{
  const double c = std::cos(turn * RadiansPerDegree);
  const double s = std::sin(turn * RadiansPerDegree);
  const double rise = std::tan(slope * RadiansPerDegree);
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  const Point origin = { { -2.0 * c, -2.0 * s, 0.0 } };
  const Point along = { { 4.0 * c, 4.0 * s, 0.0 } };
  // One actor of both slopes: flat ones alone block nothing and are left out of the map.
  renderer->AddActor(MakeQuadActor({ { origin, along, { { 2.0 * s, -2.0 * c, 2.0 * rise } } },
    { origin, along, { { -2.0 * s, 2.0 * c, 2.0 * rise } } } }));
  renderer->AddActor(
    MakeQuadActor({ { { { 1.2, 1.2, 3.5 } }, { { 0.2, 0.0, 0.0 } }, { { 0.0, 0.2, 0.0 } } } }));
  lamp->SetPosition(0.3, 0.2, 6.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetConeAngle(60.0);
  lamp->SetSize(1.0, 1.0);
  renderer->AddLight(lamp);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.4, 0.1, 4.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(4.0);
  renderer->ResetCameraClippingRange();
  return renderer;
}

}

//------------------------------------------------------------------------------
TEST_P(Valleys, AreLitToTheirEdge)
{
  for (const double slope : { 15.0, 35.0, 50.0 })
  {
    for (const double turn : { 0.0, 25.0, 70.0 })
    {
      SCOPED_TRACE(
        "slopes of " + std::to_string(slope) + " degrees, turned by " + std::to_string(turn));
      vtkNew<vtkAreaLight> lamp;
      const auto renderer = MakeValley(slope, turn, lamp);
      Stage stage(renderer, this->GetParam().Make(Effort::Quick, Weights::Mean), 80, 60);
      const Picture visibility = stage.RenderVisibility(lamp);
      EXPECT_EQ(CountWithoutValue(visibility), 0);
      const auto isDark = [](float value) { return value < 254.0f / 255.0f; };
      EXPECT_EQ(std::count_if(visibility.Values.begin(), visibility.Values.end(), isDark), 0);
    }
  }
}

//------------------------------------------------------------------------------
// The virtual maps keep the least depth within a texel, not the one at its centre; its page has figures.
static std::vector<Technique> WithDepthsAtCentres()
{
  std::vector<Technique> techniques = AllTechniques();
  const auto isVirtual = [](const Technique& technique) { return technique.Name == "Virtual"; };
  techniques.erase(
    std::remove_if(techniques.begin(), techniques.end(), isVirtual), techniques.end());
  return techniques;
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, Valleys, testing::ValuesIn(WithDepthsAtCentres()), NameOfTechnique);
