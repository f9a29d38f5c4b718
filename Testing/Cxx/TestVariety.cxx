// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever VTK draws a body with, it casts the shadow of the same geometry in a plain actor, and
// what it receives is the same too. See TestMaterials.cxx for receivers drawn in other ways.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "StoredPicture.h"
#include "Techniques.h"
#include "Varieties.h"

#include "vtkAreaLight.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace SoftShadowsTesting;

namespace
{

// Casters and receivers are the base class's work: one technique with one map, one with many.
const char* const TechniqueNames[] = { "Sampled", "PercentageCloser" };

class VarietyTest : public testing::TestWithParam<Variety>
{
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakePass(const std::string& name)
{
  for (const Technique& technique : AllTechniques())
  {
    if (technique.Name == name)
    {
      return technique.Make(Effort::Quick, Weights::Mean);
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
/// The visibility of the ball scene's lamp, the ball exchanged for these props.
Picture Draw(
  const std::vector<vtkSmartPointer<vtkProp>>& props, const std::string& technique, int mapSize)
{
  const BallScene scene = MakeBallScene();
  scene.Renderer->RemoveActor(scene.Ball);
  for (vtkProp* prop : props)
  {
    scene.Renderer->AddViewProp(prop);
  }
  scene.Renderer->ResetCameraClippingRange();
  const auto pass = MakePass(technique);
  pass->SetMapSize(mapSize);
  Stage stage(scene.Renderer, pass, 120, 90);
  vtkNew<vtkGenericRenderWindowInteractor> interactor; // vtkQuadricLODActor asks it for its rate
  interactor->SetRenderWindow(stage.GetWindow().Get());
  Picture visibility = stage.RenderVisibility(scene.Lamp);
  EXPECT_TRUE(Matches(visibility, stage.RenderVisibility(scene.Lamp), Identical)) << "drawn again";
  return visibility;
}

}

//------------------------------------------------------------------------------
TEST_P(VarietyTest, CastsAndReceivesAsAPlainActor)
{
  const Variety& variety = this->GetParam();
  for (const char* technique : TechniqueNames)
  {
    SCOPED_TRACE(technique);
    const Picture expected = Draw(variety.MakePlain(), technique, variety.MapSize);
    const Picture actual = Draw(variety.MakeVaried(), technique, variety.MapSize);
    EXPECT_GT(CountShadowed(expected), 200);
    const Difference difference = Compare(actual, expected, SameButForEdges);
    EXPECT_LE(difference.ShareOff, variety.LargestShareOff) << difference.RootMeanSquare;
    EXPECT_LE(difference.RootMeanSquare, variety.LargestRmse);
    EXPECT_LE(difference.NaNsInOneOnly, 0);
    if (this->HasFailure())
    {
      const std::string path = SOFTSHADOWS_TEST_OUTPUT_DIR "/" + variety.Name + technique;
      WritePicture(path + ".png", actual);
      WritePicture(path + "Plain.png", expected);
      std::cout << "Written: " << path << ".png and Plain.png\n";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Casters, VarietyTest, testing::ValuesIn(AllVarieties()),
  [](const testing::TestParamInfo<Variety>& variety) { return variety.param.Name; });
