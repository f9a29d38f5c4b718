// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What happens in the limit: of many samples, of many parts, of a light that shrinks to a point.
#include "ImageComparison.h"
#include "Props.h"
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkRenderer.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkShadowLightSampling.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 80;
const int Height = 60;

//------------------------------------------------------------------------------
Picture Sampled(const BallScene& scene, int samples, int pattern)
{
  auto pass = vtkSmartPointer<vtkSampledSoftShadowPass>::New();
  pass->SetMapSize(256);
  pass->SetPattern(pattern);
  pass->SetNumberOfSamples(samples);
  Stage stage(scene.Renderer, pass, Width, Height);
  return stage.RenderVisibility(scene.Lamp);
}

//------------------------------------------------------------------------------
double Error(const Picture& first, const Picture& second)
{
  return Compare(first, second, Identical).RootMeanSquare;
}

class Limit : public testing::TestWithParam<Technique>
{
protected:
  Picture Draw(const BallScene& scene) const
  {
    Stage stage(scene.Renderer, this->GetParam().Make(Effort::Quick, Weights::Mean), Width, Height);
    return stage.RenderVisibility(scene.Lamp);
  }
};

}

//------------------------------------------------------------------------------
TEST(SampledConvergence, ErrorFallsWithTheNumberOfSamples)
{
  const BallScene scene = MakeBallScene(0.8);
  const int grid = vtkShadowLightSampling::GRID;
  const Picture reference = Sampled(scene, 1024, grid);
  EXPECT_GT(CountShadowed(reference), 20);
  for (const int pattern : { grid, static_cast<int>(vtkShadowLightSampling::STRATIFIED),
         static_cast<int>(vtkShadowLightSampling::HAMMERSLEY) })
  {
    double last = 1.0;
    for (const int samples : { 1, 4, 16, 64, 256 })
    {
      const double error = Error(Sampled(scene, samples, pattern), reference);
      EXPECT_LT(error, 0.7 * last) << "pattern " << pattern << ", " << samples << " samples";
      last = error;
    }
    EXPECT_LT(last, 0.01) << "pattern " << pattern << ", 256 samples";
  }
}

//------------------------------------------------------------------------------
// Every technique converges as the light is cut into parts with a map each.
TEST_P(Limit, PartsOfTheLight)
{
  const BallScene scene = MakeBallScene(1.5);
  const Picture reference = Sampled(scene, 1024, vtkShadowLightSampling::GRID);
  const auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
  Stage stage(scene.Renderer, pass, Width, Height);
  const double whole = Error(stage.RenderVisibility(scene.Lamp), reference);
  pass->SetSplit(4);
  const double parts = Error(stage.RenderVisibility(scene.Lamp), reference);
  EXPECT_LT(parts, 0.02) << "unsplit: " << whole;
  EXPECT_TRUE(parts < whole || (!this->GetParam().HasMaps && parts == whole));
}

//------------------------------------------------------------------------------
TEST_P(Limit, SmallLightsCastHardShadows)
{
  BallScene scene = MakeBallScene(0.0);
  scene.Lamp->SetShapeToPoint();
  const Picture hard = this->Draw(scene);
  EXPECT_GT(CountShadowed(hard), 20);
  for (const float v : hard.Values)
  {
    EXPECT_TRUE(std::isnan(v) || v == 0.0f || v == 1.0f) << "a hard shadow has the value " << v;
  }
  scene.Lamp->SetShapeToDisk();
  EXPECT_TRUE(Matches(this->Draw(scene), hard, Identical)) << "a disk of size zero";
  double last = 1.0;
  for (const double size : { 0.8, 0.2, 0.05, 0.0125 })
  {
    scene.Lamp->SetSize(size, size);
    const double error = Error(this->Draw(scene), hard);
    EXPECT_LT(error, 0.8 * last) << "light of size " << size;
    last = error;
  }
  EXPECT_LT(last, 0.04);
}

//------------------------------------------------------------------------------
// Hard shadows are the same thing for all techniques.
TEST_P(Limit, HardShadowsAreTheSame)
{
  const BallScene scene = MakeBallScene(0.0);
  const Picture hard = this->Draw(scene);
  const auto first = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
  Stage stage(scene.Renderer, first, Width, Height);
  const Picture other = stage.RenderVisibility(scene.Lamp);
  // Without a map nothing rounds to its texels: pixels on the very edge may be on the other side.
  EXPECT_LE(Compare(hard, other, Identical).ShareOff, this->GetParam().HasMaps ? 0.0 : 0.001);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Limit, testing::ValuesIn(AllTechniques()), NameOfTechnique);
