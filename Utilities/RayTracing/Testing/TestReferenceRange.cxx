// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The truth holds wherever the scene lies, however large it is, and whatever type its points have.
#include "ReferenceTracer.h"
#include "Scenes.h"

#include "vtkAreaLight.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;
using softshadows::ReferenceVisibility;

namespace
{

constexpr int Width = 48;
constexpr int Height = 36;
constexpr double LargestRms = 2e-3;

//--------------------------------------------------------------------------------------------------
vtkPolyData* MeshOf(vtkActor* actor)
{
  return vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
}

//--------------------------------------------------------------------------------------------------
void RoundPoints(vtkActor* actor)
{
  vtkPolyData* mesh = MeshOf(actor);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(mesh->GetPoints());
  mesh->SetPoints(points);
}

//--------------------------------------------------------------------------------------------------
// Two boxes on a floor, all corners at whole numbers, under a square lamp.
struct TwoBoxes
{
  explicit TwoBoxes(const Placement& where, bool inSingle, double halfFloor = 16.0)
  {
    const Quad floor{ { { -halfFloor, -halfFloor, 0.0 } }, { { 2.0 * halfFloor, 0.0, 0.0 } },
      { { 0.0, 2.0 * halfFloor, 0.0 } } };
    this->Actors = { MakeQuadActor({ floor }, where),
      MakeQuadActor(BoxQuads({ { -3.0, -1.0, -1.0, 1.0, 0.0, 2.0 } }), where),
      MakeQuadActor(BoxQuads({ { 1.0, 2.0, -2.0, 1.0, 0.0, 4.0 } }), where) };
    for (const auto& actor : this->Actors)
    {
      if (inSingle)
      {
        RoundPoints(actor);
      }
      this->Renderer->AddActor(actor);
    }
    this->Renderer->AutomaticLightCreationOff();
    this->Lamp->SetPosition(where.ToWorld({ { 4.0, -4.0, 8.0 } }).data());
    this->Lamp->SetFocalPoint(where.ToWorld({ { 0.0, 0.0, 0.0 } }).data());
    this->Lamp->SetSize(2.0 * where.Scale, 2.0 * where.Scale);
    this->Renderer->AddLight(this->Lamp);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(where.ToWorld({ { 2.0, -16.0, 12.0 } }).data());
    camera->SetFocalPoint(where.ToWorld({ { -1.0, 0.0, 0.0 } }).data());
    camera->SetViewUp(0.0, 0.0, 1.0);
  }

  ReferenceVisibility Trace() const { return softshadows::Trace(this->Renderer, Width, Height, 8); }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAreaLight> Lamp;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

//--------------------------------------------------------------------------------------------------
void ExpectAsAtHome(const ReferenceVisibility& found)
{
  static const ReferenceVisibility expected = TwoBoxes({}, false).Trace();
  double sum = 0.0;
  int penumbra = 0;
  int umbra = 0;
  int pixels = 0;
  for (size_t i = 0; i < expected.Depth.size(); ++i)
  {
    const float a = expected.Visibility[0][i];
    const float b = found.Visibility[0][i];
    ASSERT_EQ(std::isnan(a), std::isnan(b)) << "pixel " << i;
    if (!std::isnan(a))
    {
      sum += (a - b) * (a - b);
      penumbra += a > 0.02 && a < 0.98 ? 1 : 0;
      umbra += a == 0.0F ? 1 : 0;
      ++pixels;
    }
  }
  EXPECT_GT(penumbra, 50) << "too few to judge by";
  EXPECT_GT(umbra, 50) << "too few to judge by";
  EXPECT_LT(std::sqrt(sum / pixels), LargestRms);
}

//--------------------------------------------------------------------------------------------------
struct RangeCase
{
  const char* Name;
  bool InSingle;
  Placement Where;
};

// Corners that are whole numbers at the origin are exact in these places, but for scales.
const std::vector<RangeCase> Cases = {
  { "SingleSmall", true, { 1e-6, { { 0.0, 0.0, 0.0 } } } },
  { "SingleLarge", true, { 1e8, { { 0.0, 0.0, 0.0 } } } },
  { "DoubleSmall", false, { 1e-6, { { 0.0, 0.0, 0.0 } } } },
  { "DoubleLarge", false, { 1e8, { { 0.0, 0.0, 0.0 } } } },
  { "DoubleOnAMap", false, { 1.0, { { 512345.0, 5403210.0, 410.0 } } } },
  { "DoubleFarAway", false, { 1.0, { { 1e8, -1e8, 1e8 } } } },
  { "DoubleSmallAndMoved", false, { 1.0 / (1 << 20), { { 1000.0, -1000.0, 1000.0 } } } },
  { "DoubleLargeAndMoved", false, { 1e8, { { 1e8, 0.0, -1e8 } } } },
};

// Here single precision rounds corners at fractions: closed forms are of other scenes.
const std::vector<RangeCase> WholeNumbers = {
  { "SingleOnAMap", true, { 1.0, { { 512345.0, 5403210.0, 410.0 } } } },
  { "SingleFarAway", true, { 8.0, { { 1e8, -1e8, 1e8 } } } },
  { "SingleSmallAndMoved", true, { 1.0 / (1 << 20), { { 1.0, -1.0, 0.5 } } } },
  { "SingleLargeAndMoved", true, { 1 << 26, { { 1 << 26, 0.0, -(1 << 26) } } } },
};

std::string NameOf(const testing::TestParamInfo<RangeCase>& range)
{
  return range.param.Name;
}

std::ostream& operator<<(std::ostream& stream, const RangeCase& range)
{
  return stream << range.Name;
}

//--------------------------------------------------------------------------------------------------
class ReferenceRange : public testing::TestWithParam<RangeCase>
{
};

TEST_P(ReferenceRange, ChangesNoTruth)
{
  ExpectAsAtHome(TwoBoxes(GetParam().Where, GetParam().InSingle).Trace());
}

INSTANTIATE_TEST_SUITE_P(Placements, ReferenceRange, testing::ValuesIn(Cases), NameOf);
INSTANTIATE_TEST_SUITE_P(WholeNumbers, ReferenceRange, testing::ValuesIn(WholeNumbers), NameOf);

//--------------------------------------------------------------------------------------------------
class ReferenceRangeOfClosedForms : public testing::TestWithParam<RangeCase>
{
};

TEST_P(ReferenceRangeOfClosedForms, ReachesThem)
{
  softshadows::ReferenceTracer tracer(Width, Height, 64);
  tracer.SetPilotSamplesPerAxis(16);
  const Placement& where = GetParam().Where;
  for (const Scene& scene :
    { MakeRectangleScene(Weights::Mean, where), MakeSunScene(5.0, true, where) })
  {
    vtkActorCollection* actors = scene.Renderer->GetActors();
    actors->InitTraversal();
    for (vtkActor* actor = actors->GetNextActor(); actor && GetParam().InSingle;
         actor = actors->GetNextActor())
    {
      RoundPoints(actor);
    }
    const ReferenceVisibility result = tracer.Trace(scene.Renderer);
    const std::vector<PlanePixel> pixels = GetPlanePixels(scene, Width, Height);
    double sum = 0.0;
    for (const PlanePixel& pixel : pixels)
    {
      const size_t index = static_cast<size_t>(Height - 1 - pixel.Y) * Width + pixel.X;
      sum += std::pow(result.Visibility[0][index] - pixel.Expected, 2.0);
    }
    EXPECT_GT(pixels.size(), 200U) << scene.Description;
    EXPECT_LT(std::sqrt(sum / pixels.size()), LargestRms) << scene.Description;
  }
}

INSTANTIATE_TEST_SUITE_P(Placements, ReferenceRangeOfClosedForms, testing::ValuesIn(Cases), NameOf);

//--------------------------------------------------------------------------------------------------
TEST(ReferenceRangeOf, AMatrixThatLeadsBackChangesNoTruth)
{
  // Points far from their own origin, brought back by the actor: the translation is exact.
  const TwoBoxes home({}, false);
  const Placement away{ 1.0, { { 512345.0, 5403210.0, 410.0 } } };
  TwoBoxes moved(away, true);
  vtkNew<vtkMatrix4x4> back;
  for (int i = 0; i < 3; ++i)
  {
    back->SetElement(i, 3, -away.Translation[i]);
  }
  for (const auto& actor : moved.Actors)
  {
    actor->SetUserMatrix(back);
  }
  moved.Lamp->SetPosition(home.Lamp->GetPosition());
  moved.Lamp->SetFocalPoint(home.Lamp->GetFocalPoint());
  moved.Renderer->SetActiveCamera(home.Renderer->GetActiveCamera());
  ExpectAsAtHome(moved.Trace());
}

//--------------------------------------------------------------------------------------------------
class ReferenceFloor : public testing::TestWithParam<double>
{
};

TEST_P(ReferenceFloor, OfAnySizeLeavesTheTruthAsItIs)
{
  for (bool inSingle : { false, true })
  {
    ExpectAsAtHome(TwoBoxes({}, inSingle, 16.0 * GetParam()).Trace());
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ReferenceFloor, testing::Values(1e2, 1e4, 1e6, 1e8));

}
