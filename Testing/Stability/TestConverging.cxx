// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What promises to converge, against the ray tracer: lights cut into parts, and a resting camera.
#include "ErrorMeasures.h"
#include "HardCaseJudge.h"
#include "HardCases.h"
#include "ReferenceTracer.h"
#include "Silhouettes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAdaptiveSampledSoftShadowPass.h"
#include "vtkCascadedSoftShadowPass.h"
#include "vtkLight.h"
#include "vtkRenderer.h"
#include "vtkScreenSpaceSoftShadowPass.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>

using namespace SoftShadowsTesting;

namespace
{

//------------------------------------------------------------------------------
HardCase FindCase(const std::string& name)
{
  for (const auto& list : { InvarianceCases(), GeometryCases(), LightCases() })
  {
    for (const HardCase& hardCase : list)
    {
      if (hardCase.Name == name)
      {
        return hardCase;
      }
    }
  }
  throw std::runtime_error("no case " + name);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakeScreenSpace(Effort, Weights)
{
  auto pass = vtkSmartPointer<vtkScreenSpaceSoftShadowPass>::New();
  pass->SetMapSize(512);
  pass->SetWeightsToMean();
  return pass;
}

//------------------------------------------------------------------------------
/// With the one that blurs on the screen, which the other tests ask too much of.
std::vector<Technique> ReallyAllTechniques()
{
  // Only techniques with maps cut lights.
  std::vector<Technique> techniques;
  std::copy_if(AllTechniques().begin(), AllTechniques().end(), std::back_inserter(techniques),
    [](const Technique& technique) { return technique.HasMaps; });
  techniques.push_back({ "ScreenSpace", MakeScreenSpace, 0.0, 0.0, 0.0 });
  return techniques;
}

//------------------------------------------------------------------------------
Technique InParts(const Technique& technique, int parts)
{
  Technique cut = technique;
  cut.Make = [technique, parts](Effort effort, Weights weights)
  {
    vtkSmartPointer<vtkSoftShadowPass> pass = technique.Make(effort, weights);
    pass->SetSplit(parts);
    // Four points of each part are enough to tell, and many times as fast.
    if (auto* cascaded = vtkCascadedSoftShadowPass::SafeDownCast(pass))
    {
      cascaded->SetNumberOfCascades(1);
      cascaded->SetSampleEdge(0, 2);
    }
    if (auto* adaptive = vtkAdaptiveSampledSoftShadowPass::SafeDownCast(pass))
    {
      adaptive->SetMaximumLevel(0);
    }
    return pass;
  };
  return cut;
}

class Parts : public testing::TestWithParam<Technique>
{
};

class Resting : public testing::TestWithParam<std::string>
{
};

}

//------------------------------------------------------------------------------
// Four plates behind each other that the lamp sees past.
TEST_P(Parts, TakeTheErrorAway)
{
  HardCase plates = FindCase("StackOfPlates");
  plates.Settings = Effort::Quick;
  HardCaseJudge judge(plates);
  double last = 1.0;
  for (const int parts : { 1, 2, 4, 8 })
  {
    const double error = judge.Judge(InParts(this->GetParam(), parts)).Rmse;
    // Under the goal it is texels and the ray tracer's own 0.005 that are left.
    EXPECT_LT(error, std::max(1.1 * last, 0.01)) << parts << " x " << parts;
    last = error;
  }
  EXPECT_LT(last, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, Parts, testing::ValuesIn(ReallyAllTechniques()), NameOfTechnique);

//------------------------------------------------------------------------------
TEST_P(Resting, KnowsItsError)
{
  const HardScene scene = FindCase(this->GetParam()).Make();
  const auto pass = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
  pass->ProgressiveOn();
  pass->SetProgressivePoints(64);
  pass->SetMapMemory(16); // maps of at most 2048 texels
  Stage stage(scene.Renderer, nullptr, scene.Width, scene.Height);
  stage.Render(); // lights that follow the camera have their places now
  const int raysPerAxis = 32;
  const auto truth =
    softshadows::ReferenceTracer(scene.Width, scene.Height, raysPerAxis).Trace(scene.Renderer);
  ASSERT_EQ(truth.Visibility.size(), 1u);
  const auto silhouettes = softshadows::FindSilhouettes(scene.Width, scene.Height, truth.Depth);
  stage.SetPass(pass);
  pass->SetProgressiveTolerance(0.02);
  Picture shown = stage.RenderVisibility(scene.Light);
  for (int frame = 0; frame < 200 && pass->GetRefining(); ++frame)
  {
    shown = stage.RenderVisibility(scene.Light);
  }
  EXPECT_FALSE(pass->GetRefining());
  EXPECT_EQ(pass->GetConverged(), pass->GetEstimatedError() <= 0.02);
  std::vector<float> rows; // top row first
  for (int y = scene.Height - 1; y >= 0; --y)
  {
    const auto begin = shown.Values.begin() + std::ptrdiff_t(y) * scene.Width;
    rows.insert(rows.end(), begin, begin + scene.Width);
  }
  const double error = softshadows::MeasureErrors(
    scene.Width, scene.Height, truth.Visibility.front(), rows, silhouettes)
                         .WorstTile;
  EXPECT_GT(error, 0.0005) << "less than the ray tracer's own: nothing was compared";
  EXPECT_LT(error, 2.0 * pass->GetEstimatedError());
}

INSTANTIATE_TEST_SUITE_P(
  Scenes, Resting, testing::Values("StackOfPlates", "Sun", "Needles", "ThinSheets"));
