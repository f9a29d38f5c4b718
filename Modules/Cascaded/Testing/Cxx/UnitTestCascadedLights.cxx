// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Several lights have cascades of their own: their number, and the tint of one or of all.
#include "CascadedStage.h"

#include "vtkMath.h"
#include "vtkShadowCasters.h"

#include <gtest/gtest.h>

using namespace SoftShadowsTesting;

namespace
{
void AddCaster(vtkRenderer* renderer, const Point& origin)
{
  const auto actor = MakeQuadActor({ { origin, { { 1, 0, 0 } }, { { 0, 0, 1 } } } });
  vtkShadowCasters::SetReceivesShadow(actor, false);
  renderer->AddActor(actor);
}

// A wall at a depth of 10, left, one at 40, right, and a caster before each; nothing in between.
vtkSmartPointer<vtkRenderer> MakeWalls()
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -6, 10, -4 } }, { { 5, 0, 0 } }, { { 0, 0, 8 } });
  AddQuad(renderer, { { 9, 40, -10 } }, { { 12, 0, 0 } }, { { 0, 0, 20 } });
  AddCaster(renderer, { { -3.5, 8, -0.5 } });
  AddCaster(renderer, { { 14, 38, -0.5 } });
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 1.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(50.0);
  camera->SetClippingRange(0.1, 100.0);
  return renderer;
}

// Shines on both walls.
vtkSmartPointer<vtkAreaLight> MakeSun()
{
  auto sun = vtkSmartPointer<vtkAreaLight>::New();
  sun->SetPosition(0.0, -1.0, 0.2);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetAngularDiameter(1.0);
  return sun;
}

// Shines on the near wall only.
vtkSmartPointer<vtkAreaLight> MakeLamp()
{
  auto lamp = vtkSmartPointer<vtkAreaLight>::New();
  lamp->SetConeAngle(10.0);
  lamp->SetPosition(-3.0, 0.0, 0.0);
  lamp->SetFocalPoint(-3.0, 10.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(0.1, 0.1);
  return lamp;
}
}

// The largest number over the lights, in whatever order they stand.
TEST(CascadedLights, OccupiedCascadesAreTheMostOfAnyLight)
{
  for (const bool lampLast : { true, false })
  {
    const auto renderer = MakeWalls();
    const auto sun = MakeSun();
    const auto lamp = MakeLamp();
    renderer->AddLight(lampLast ? sun : lamp);
    renderer->AddLight(lampLast ? lamp : sun);
    Stage stage(renderer);
    stage.Render();
    EXPECT_EQ(stage.Pass->GetNumberOfOccupiedCascades(), 2) << "lamp last " << lampLast;
    // A light that is gone counts no more.
    sun->SwitchOff();
    stage.Render();
    EXPECT_EQ(stage.Pass->GetNumberOfOccupiedCascades(), 1) << "lamp last " << lampLast;
  }
}

// By one light's cascades, or by the mean of all.
TEST(CascadedLights, TheTintIsOfOneLightOrTheMean)
{
  const auto renderer = MakeWalls();
  renderer->AddLight(MakeSun());
  renderer->AddLight(MakeLamp());
  Stage stage(renderer);
  stage.Render();
  const Picture plain = stage.Read();
  // A lit place on the far wall.
  const int x =
    static_cast<int>(Width / 2 + 0.27 * Height / std::tan(vtkMath::RadiansFromDegrees(25.0)) * 0.5);
  const int y = Height / 2 + 5;
  const auto expectTint = [&](double red, double green, double blue)
  {
    stage.Render();
    const Picture tinted = stage.Read();
    const double expected[3] = { red, green, blue };
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(tinted.At(x, y, channel) / plain.At(x, y, channel), expected[channel], 0.02)
        << "channel " << channel << ", light " << stage.Pass->GetTintLight();
    }
  };
  stage.Pass->TintOn();
  stage.Pass->SetTintLight(0);
  expectTint(0.55, 1.0, 0.55);
  stage.Pass->SetTintLight(1);
  expectTint(1.0, 0.55, 0.55);
  stage.Pass->SetTintLight(-1);
  expectTint(0.775, 0.775, 0.55);
  // A light that does not exist tints nothing.
  stage.Pass->SetTintLight(7);
  expectTint(1.0, 1.0, 1.0);
}
