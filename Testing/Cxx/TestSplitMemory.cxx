// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of a split light share the light's memory, in techniques that keep maps of their own.
#include "ImageComparison.h"
#include "Picture.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"
#include "vtkAreaLight.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <vector>

using namespace SoftShadowsTesting;

namespace
{

class SplitMemory : public testing::TestWithParam<Technique>
{
};

//------------------------------------------------------------------------------
std::vector<Technique> TechniquesWithMaps()
{
  std::vector<Technique> techniques;
  for (const Technique& technique : AllTechniques())
  {
    if (technique.Name == "Sampled" || technique.Name == "Bilateral" ||
      technique.Name == "Cascaded")
    {
      techniques.push_back(technique);
    }
  }
  return techniques;
}

}

//------------------------------------------------------------------------------
TEST_P(SplitMemory, IsThatOfTheLight)
{
  const BallScene scene = MakeBallScene();
  vtkTypeInt64 bytes[2];
  Picture pictures[2];
  for (const int i : { 0, 1 })
  {
    auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(256); // 0.25 MiB
    pass->SetSplit(4);
    pass->SetMapMemory(i == 0 ? 1024 : 4);
    Stage stage(scene.Renderer, pass, 80, 60);
    stage.RenderVisibility(scene.Lamp);
    pass->Modified();
    pictures[i] = stage.RenderVisibility(scene.Lamp);
    bytes[i] = pass->GetStatistics().BytesHeld;
  }
  EXPECT_LT(bytes[1], 12 << 20);
  EXPECT_GT(bytes[0], 16 << 20) << "without a limit it is more: the test can fail";
  EXPECT_TRUE(Matches(pictures[0], pictures[1], SameToRounding));
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, SplitMemory, testing::ValuesIn(TechniquesWithMaps()), NameOfTechnique);
