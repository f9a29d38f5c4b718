// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever is changed in place, at any depth of the object graph: the frame after it is a fresh
// renderer's, picture and visibility, and a frame without a change does nothing.
#include "ChangesInPlace.h"
#include "ImageComparison.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 100;
const int Height = 75;

/// Both of a frame.
struct Frame
{
  Picture Visibility;
  Picture Colors;
};

//------------------------------------------------------------------------------
Frame Draw(Stage& stage, vtkAreaLight* lamp)
{
  Frame frame;
  frame.Visibility = stage.RenderVisibility(lamp);
  frame.Colors = stage.GetWindow().Read();
  return frame;
}

//------------------------------------------------------------------------------
struct Work
{
  vtkTypeInt64 MapsBaked;
  vtkTypeInt64 VisibilityFrames;
};

//------------------------------------------------------------------------------
Work DrawAndCount(Stage& stage)
{
  const vtkSoftShadowStatistics before = stage.GetPass()->GetStatistics();
  stage.Render();
  const vtkSoftShadowStatistics& after = stage.GetPass()->GetStatistics();
  return { after.MapsBaked - before.MapsBaked, after.VisibilityFrames - before.VisibilityFrames };
}

//------------------------------------------------------------------------------
void ExpectRest(Stage& stage, const char* when)
{
  const Work work = DrawAndCount(stage);
  EXPECT_EQ(work.MapsBaked, 0) << when;
  EXPECT_EQ(work.VisibilityFrames, 0) << when;
}

//------------------------------------------------------------------------------
struct Case
{
  Technique Way;
  ChangeInPlace What;
};

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Case& parameter)
{
  return os << parameter.Way.Name << ", " << parameter.What.Name;
}

//------------------------------------------------------------------------------
std::string NameOfCase(const testing::TestParamInfo<Case>& parameter)
{
  return parameter.param.Way.Name + parameter.param.What.Name;
}

//------------------------------------------------------------------------------
/// Every change with a technique of one map and one of many points; a few with all techniques.
std::vector<Case> CasesOfShape()
{
  const std::vector<std::string> few = { "PlaneOrigin", "TexturePixels", "PartPlane" };
  std::vector<Case> cases;
  for (const Technique& technique : AllTechniques())
  {
    const bool all = technique.Name == "Sampled" || technique.Name == "PercentageCloser";
    for (const ChangeInPlace& change : AllChangesInPlace())
    {
      if (all || std::find(few.begin(), few.end(), change.Name) != few.end())
      {
        cases.push_back({ technique, change });
      }
    }
  }
  return cases;
}

//------------------------------------------------------------------------------
std::vector<Case> CasesOfColors()
{
  std::vector<Case> cases;
  for (const ChangeInPlace& change : AllChangesOfColors())
  {
    cases.push_back({ AllTechniques()[1], change });
  }
  return cases;
}

class ChangesOfShape : public testing::TestWithParam<Case>
{
};

class ChangesOfColor : public testing::TestWithParam<Case>
{
};

//------------------------------------------------------------------------------
/// The ball scene without its ball.
BallScene MakeEmptyScene()
{
  BallScene scene = MakeBallScene();
  scene.Renderer->RemoveActor(scene.Ball);
  return scene;
}

}

//------------------------------------------------------------------------------
TEST_P(ChangesOfShape, ShowAtOnceWhatAFreshRendererShows)
{
  BallScene scene = MakeEmptyScene();
  const auto change = this->GetParam().What.Make(scene);
  const auto makePass = [this]
  {
    auto pass = this->GetParam().Way.Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(256);
    return pass;
  };
  Frame before;
  Frame after;
  {
    Stage stage(scene.Renderer, makePass(), Width, Height);
    stage.Render(); // some pipelines find out what they are in the first frame
    before = Draw(stage, scene.Lamp);
    ExpectRest(stage, "before the change");
    change();
    after = Draw(stage, scene.Lamp);
    ExpectRest(stage, "after the change");
  }
  Stage fresh(scene.Renderer, makePass(), Width, Height);
  const Frame expected = Draw(fresh, scene.Lamp);
  EXPECT_TRUE(Matches(after.Visibility, expected.Visibility, SameToRounding));
  EXPECT_TRUE(Matches(after.Colors, expected.Colors, SameToRounding));
  const Difference changed = Compare(before.Colors, after.Colors, SameToRounding);
  EXPECT_GT(changed.ShareOff, 0.001) << "the change is none";
}

//------------------------------------------------------------------------------
TEST_P(ChangesOfColor, BakeNothing)
{
  BallScene scene = MakeEmptyScene();
  const auto change = this->GetParam().What.Make(scene);
  Stage stage(
    scene.Renderer, this->GetParam().Way.Make(Effort::Quick, Weights::Mean), Width, Height);
  stage.Render();
  const Picture before = stage.RenderColors();
  change();
  EXPECT_EQ(DrawAndCount(stage).MapsBaked, 0);
  const Picture after = stage.GetWindow().Read();
  EXPECT_GT(Compare(before, after, SameToRounding).ShareOff, 0.002) << "the change is none";
  ExpectRest(stage, "after the change");
}

INSTANTIATE_TEST_SUITE_P(All, ChangesOfShape, testing::ValuesIn(CasesOfShape()), NameOfCase);
INSTANTIATE_TEST_SUITE_P(All, ChangesOfColor, testing::ValuesIn(CasesOfColors()), NameOfCase);
