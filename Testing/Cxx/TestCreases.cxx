// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where two surfaces meet in an edge: no light comes through, and none is lost on the lit side.
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

using Vector = Point;

const std::vector<Vector>& Suns()
{
  static const std::vector<Vector> suns{ { { 11.1, 15.3, 6.4 } }, { { 8.0, 9.0, 16.0 } },
    { { 5.0, 18.0, 4.0 } } };
  return suns;
}

void AddQuad(vtkRenderer* renderer, const Vector& origin, const Vector& edge1, const Vector& edge2)
{
  renderer->AddActor(MakeQuadActor({ { origin, edge1, edge2 } }));
}

vtkSmartPointer<vtkAreaLight> AddSun(vtkRenderer* renderer, const Vector& from)
{
  auto sun = vtkSmartPointer<vtkAreaLight>::New();
  sun->SetPosition(from[0], from[1], from[2]);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->PositionalOff();
  sun->SetShapeToDisk();
  sun->SetAngularDiameter(0.53);
  renderer->AddLight(sun);
  return sun;
}

// Looks from the corner of the room that is nearest to the suns at the walls that face them.
void SetCamera(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(1.8, 1.2, 1.3);
  camera->SetFocalPoint(-2.0, 1.2, -1.5);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(80.0);
  renderer->ResetCameraClippingRange();
}

// A floor and two walls, 4 x 2.5 x 3; closed with a roof and two more walls.
vtkSmartPointer<vtkRenderer> MakeCorner(bool closed)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  AddQuad(renderer, { { -2, 0, -1.5 } }, { { 4, 0, 0 } }, { { 0, 0, 3 } });
  AddQuad(renderer, { { -2, 0, -1.5 } }, { { 0, 2.5, 0 } }, { { 0, 0, 3 } });
  AddQuad(renderer, { { -2, 0, -1.5 } }, { { 4, 0, 0 } }, { { 0, 2.5, 0 } });
  if (closed)
  {
    AddQuad(renderer, { { -2, 2.5, -1.5 } }, { { 4, 0, 0 } }, { { 0, 0, 3 } });
    AddQuad(renderer, { { 2, 0, -1.5 } }, { { 0, 2.5, 0 } }, { { 0, 0, 3 } });
    AddQuad(renderer, { { -2, 0, 1.5 } }, { { 4, 0, 0 } }, { { 0, 2.5, 0 } });
  }
  return renderer;
}

// The share of the pixels that are off by more than a step of 8 bits, over all suns.
double ShareOff(const Technique& technique, bool closed, double expected)
{
  int off = 0;
  int all = 0;
  for (const Vector& from : Suns())
  {
    const auto renderer = MakeCorner(closed);
    const auto sun = AddSun(renderer, from);
    SetCamera(renderer);
    Stage stage(renderer, technique.Make(Effort::Quick, Weights::Mean), 160, 120);
    const Picture visibility = stage.RenderVisibility(sun);
    for (const float value : visibility.Values)
    {
      all += std::isnan(value) ? 0 : 1;
      off += std::abs(value - expected) > 1.0 / 255.0 ? 1 : 0;
    }
  }
  EXPECT_GT(all, 160 * 120);
  return static_cast<double>(off) / all;
}

class Creases : public testing::TestWithParam<Technique>
{
};

}

//------------------------------------------------------------------------------
// What is left are single pixels, most of them where three surfaces meet.
TEST_P(Creases, LetNoLightIntoAClosedRoom)
{
  const double share = ShareOff(this->GetParam(), true, 0.0);
  this->RecordProperty("ShareOff", std::to_string(share));
  EXPECT_LE(share, 0.001);
}

//------------------------------------------------------------------------------
TEST_P(Creases, AreLitWhereNothingIsInFront)
{
  const double share = ShareOff(this->GetParam(), false, 1.0);
  this->RecordProperty("ShareOff", std::to_string(share));
  EXPECT_EQ(share, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Creases, testing::ValuesIn(AllTechniques()), NameOfTechnique);
