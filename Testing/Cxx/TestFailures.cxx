// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever OpenGL does not have to give: the light is shown without shadows, a warning says so once,
// and the next frame that gets it is right.
#include "Faults.h"
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShadowLimits.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTextureUnitManager.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 64;
const int Height = 48;

/// While one lives, OpenGL allows no more.
class Limits
{
public:
  Limits(int size, int layers) { vtkShadowLimits::Restrict(size, layers); }
  ~Limits() { vtkShadowLimits::Restrict(0, 0); }
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;
};

//------------------------------------------------------------------------------
/// Each an OpenGL error that nobody took.
int CountErrors()
{
  int count = 0;
  while (count < 100 && glGetError() != GL_NO_ERROR)
  {
    ++count;
  }
  return count;
}

class Failures : public testing::TestWithParam<Technique>
{
protected:
  vtkSmartPointer<vtkSoftShadowPass> Make(int mapSize = 64) const
  {
    auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(mapSize);
    return pass;
  }
};

}

//------------------------------------------------------------------------------
TEST_P(Failures, OfAnyAllocationLeaveTheLightUnshadowed)
{
  for (const int split : { 1, 2 })
  {
    const BallScene plainScene = MakeBallScene();
    Stage plain(plainScene.Renderer, nullptr, Width, Height);
    const Picture unshadowed = plain.RenderColors();
    const BallScene freshScene = MakeBallScene();
    const auto freshPass = this->Make();
    freshPass->SetSplit(split);
    Stage fresh(freshScene.Renderer, freshPass, Width, Height);
    const Picture expected = fresh.RenderVisibility(freshScene.Lamp);
    const Picture shadowed = fresh.GetWindow().Read();
    freshPass->Modified(); // a second frame may have more texels than one in which all was new
    const Picture expectedAgain = fresh.RenderVisibility(freshScene.Lamp);
    const Picture shadowedAgain = fresh.GetWindow().Read();
    ASSERT_FALSE(Matches(shadowed, unshadowed, SameButForEdges));

    bool failed = true;
    int lost = 0;
    for (int which = 1; failed && which < 200; ++which)
    {
      SCOPED_TRACE("split " + std::to_string(split) + ", allocation " + std::to_string(which));
      const BallScene scene = MakeBallScene();
      const auto pass = this->Make();
      pass->SetSplit(split);
      Stage stage(scene.Renderer, nullptr, Width, Height);
      stage.Render(); // a new window loads OpenGL's functions
      stage.SetPass(pass);
      Messages messages;
      {
        const Faults faults(which);
        const Picture shown = stage.RenderColors();
        failed = faults.HasFailed();
        if (messages.Get().empty())
        {
          // A technique may have done with less, and does until something changes.
          pass->Modified();
          EXPECT_TRUE(Compare(shown, shadowed, Identical).RootMeanSquare < 0.05);
        }
        else
        {
          ++lost;
          EXPECT_TRUE(Matches(shown, unshadowed, SameToRounding));
          EXPECT_EQ(messages.Count("Warning"), 1) << messages.Get();
          EXPECT_EQ(messages.Count("Light 0 is shown without shadows: "), 1) << messages.Get();
          EXPECT_EQ(messages.Count(pass->GetClassName()), 1) << messages.Get();
          EXPECT_EQ(messages.Count("ERROR"), 0) << messages.Get();
          EXPECT_NE(pass->GetLightReport().find("casts nothing: "), std::string::npos);
        }
        EXPECT_EQ(CountErrors(), 0);
      }
      const std::string before = messages.Get();
      const bool again = before.empty();
      EXPECT_TRUE(Matches(
        stage.RenderVisibility(scene.Lamp), again ? expectedAgain : expected, SameToRounding));
      EXPECT_TRUE(
        Matches(stage.GetWindow().Read(), again ? shadowedAgain : shadowed, SameToRounding));
      EXPECT_EQ(messages.Get(), before);
      EXPECT_EQ(CountErrors(), 0);
      if (!failed)
      {
        EXPECT_EQ(before, "");
      }
    }
    EXPECT_FALSE(failed) << "no end of allocations";
    EXPECT_GT(lost, 4) << "receivers, marks and a map at least";
  }
}

//------------------------------------------------------------------------------
// A light that has all it needs keeps its shadow.
TEST_P(Failures, OfOneLightAreItsOwn)
{
  BallScene scenes[2] = { MakeBallScene(), MakeBallScene() };
  vtkSmartPointer<vtkAreaLight> others[2];
  std::vector<Picture> expected;
  for (int i = 0; i < 2; ++i)
  {
    others[i] = MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2);
    scenes[i].Renderer->AddLight(others[i]);
  }
  {
    Stage fresh(scenes[0].Renderer, this->Make(), Width, Height);
    expected.push_back(fresh.RenderVisibility(scenes[0].Lamp));
    expected.push_back(PictureOf(fresh.GetPass()->GetVisibilityImage(others[0])));
  }
  int alone = 0;
  bool failed = true;
  for (int which = 1; failed && which < 200; ++which)
  {
    SCOPED_TRACE("allocation " + std::to_string(which));
    const auto pass = this->Make();
    Stage stage(scenes[1].Renderer, nullptr, Width, Height);
    stage.Render();
    stage.SetPass(pass);
    Messages messages;
    const Faults faults(which);
    stage.Render();
    failed = faults.HasFailed();
    const bool isLost[2] = { pass->GetVisibilityLayer(scenes[1].Lamp) < 0,
      pass->GetVisibilityLayer(others[1]) < 0 };
    if (isLost[0] != isLost[1])
    {
      ++alone;
      const int kept = isLost[0] ? 1 : 0;
      EXPECT_TRUE(
        Matches(PictureOf(pass->GetVisibilityImage(kept)), expected[kept], SameToRounding));
      const std::string number = std::to_string(1 - kept);
      EXPECT_EQ(messages.Count("Light " + number + " is shown without shadows: "), 1)
        << messages.Get();
    }
    EXPECT_EQ(CountErrors(), 0);
  }
  EXPECT_GE(alone, 2);
}

//------------------------------------------------------------------------------
// It is tried again, but not in every frame, and told once.
TEST_P(Failures, ThatLastAreToldOnce)
{
  const BallScene scene = MakeBallScene();
  const auto pass = this->Make(512);
  Stage stage(scene.Renderer, pass, Width, Height);
  Messages messages;
  {
    const Limits limits(32, 0); // no texture of the picture's size
    for (int frame = 0; frame < 40; ++frame)
    {
      stage.Render();
    }
    EXPECT_EQ(messages.Count("shown without shadows"), 1) << messages.Get();
    EXPECT_LT(pass->GetStatistics().VisibilityFrames, 8);
    EXPECT_EQ(pass->GetVisibilityLayer(scene.Lamp), -1);
  }
  scene.Lamp->SetPosition(scene.Lamp->GetPosition()[0] + 0.01, 0.0, 4.0); // whatever changes
  stage.Render();
  EXPECT_EQ(pass->GetVisibilityLayer(scene.Lamp), 0);
  EXPECT_GT(CountShadowed(PictureOf(pass->GetVisibilityImage(scene.Lamp))), 10);
  EXPECT_EQ(CountErrors(), 0);
}

//------------------------------------------------------------------------------
TEST_P(Failures, MapsAreAsLargeAsOpenGLAllows)
{
  const BallScene scene = MakeBallScene();
  Picture expected;
  {
    Stage stage(scene.Renderer, this->Make(128), Width, Height);
    expected = stage.RenderVisibility(scene.Lamp);
  }
  const auto pass = this->Make(512);
  Stage stage(scene.Renderer, pass, Width, Height);
  Messages messages;
  const Limits limits(128, 0);
  const Picture shown = stage.RenderVisibility(scene.Lamp);
  // The technique with a map of its own size for the search has less of that, too.
  const bool hasSearchMap = this->GetParam().Name == "Virtual";
  EXPECT_TRUE(hasSearchMap ? Compare(shown, expected, Identical).RootMeanSquare < 0.05
                           : bool(Matches(shown, expected, SameToRounding)));
  pass->Modified();
  stage.Render();
  EXPECT_EQ(messages.Count("Warning"), 1) << messages.Get();
  EXPECT_EQ(messages.Count("Depth maps have 128 texels along an edge, not 512"), 1);
  EXPECT_EQ(pass->GetMapSize(), 512) << "the setting stays";
  EXPECT_EQ(CountErrors(), 0);
}

//------------------------------------------------------------------------------
TEST_P(Failures, FewLayersMakeBatches)
{
  for (const int split : { 1, 2 })
  {
    const BallScene scene = MakeBallScene();
    Picture expected;
    for (const int layers : { 0, 3 })
    {
      const auto pass = this->Make();
      pass->SetSplit(split);
      Stage stage(scene.Renderer, pass, Width, Height);
      Messages messages;
      const Limits limits(0, layers);
      const Picture shown = stage.RenderVisibility(scene.Lamp);
      if (layers == 0)
      {
        expected = shown;
      }
      EXPECT_TRUE(this->GetParam().Name == "Virtual"
          ? Compare(shown, expected, Identical).RootMeanSquare < 0.05
          : bool(Matches(shown, expected, SameToRounding)));
      EXPECT_EQ(messages.Get(), "");
      EXPECT_EQ(CountErrors(), 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(Failures, MoreLightsThanLayersAreTold)
{
  const BallScene scene = MakeBallScene();
  scene.Renderer->AddLight(MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2));
  const auto pass = this->Make();
  Stage stage(scene.Renderer, pass, Width, Height);
  Messages messages;
  const Limits limits(0, 1);
  for (int frame = 0; frame < 3; ++frame)
  {
    stage.Render();
    EXPECT_EQ(pass->GetVisibilityLayer(scene.Lamp), 0);
    pass->Modified();
  }
  EXPECT_EQ(messages.Count("Light 1 is shown without shadows"), 1) << messages.Get();
  EXPECT_EQ(messages.Count("Warning"), 1) << messages.Get();
}

//------------------------------------------------------------------------------
// An application that has taken VTK's texture units, all but a few that VTK itself needs for a moment.
TEST_P(Failures, TextureUnitsThatRunOut)
{
  const BallScene scene = MakeBallScene();
  Picture expected;
  {
    Stage stage(scene.Renderer, this->Make(), Width, Height);
    expected = stage.RenderVisibility(scene.Lamp);
  }
  for (const int left : { 0, 1, 3, 6 })
  {
    SCOPED_TRACE(left);
    const auto pass = this->Make();
    Stage stage(scene.Renderer, nullptr, Width, Height);
    stage.Render();
    vtkTextureUnitManager* units =
      stage.GetWindow().GetOpenGL()->GetState()->GetTextureUnitManager();
    std::vector<int> taken;
    for (int unit = units->Allocate(); unit >= 0; unit = units->Allocate())
    {
      taken.push_back(unit);
    }
    for (int i = 0; i < left; ++i)
    {
      units->Free(taken.back());
      taken.pop_back();
    }
    Messages messages;
    stage.SetPass(pass);
    stage.Render();
    if (left == 0)
    {
      EXPECT_EQ(pass->GetVisibilityLayer(scene.Lamp), -1);
      EXPECT_EQ(messages.Count("Light 0 is shown without shadows: no texture unit is left"), 1);
      EXPECT_EQ(messages.Count("Warning"), 1) << messages.Get();
      EXPECT_EQ(messages.Count("ERROR"), 0) << messages.Get();
    }
    else
    {
      EXPECT_TRUE(
        Matches(PictureOf(pass->GetVisibilityImage(scene.Lamp)), expected, SameToRounding));
      EXPECT_EQ(messages.Get(), "");
    }
    EXPECT_EQ(CountErrors(), 0);
    for (const int unit : taken)
    {
      EXPECT_TRUE(units->IsAllocated(unit)) << "given back, but not ours";
      units->Free(unit);
    }
    EXPECT_EQ(units->Allocate(), 0) << "still taken";
    units->Free(0);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, Failures, testing::ValuesIn(EveryTechnique()), NameOfTechnique);
