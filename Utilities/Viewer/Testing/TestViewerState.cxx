// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The viewer's state without a window: what actions change, what observers hear, what passes get.
#include "KeyBindings.h"
#include "ViewerState.h"

#include "vtkPercentageCloserSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

using namespace softshadows;
using Kind = ViewerAction::Kind;
using Change = ViewerState::Change;

namespace
{

//--------------------------------------------------------------------------------------------------
SceneDescription MakeScene(int lights = 2)
{
  SceneDescription scene;
  CameraDescription camera;
  camera.ViewUp = { { 0.0, 0.1, 0.9 } };
  scene.Camera = camera;
  for (int i = 0; i < lights; ++i)
  {
    LightDescription light;
    light.Position = { { 3.0, 0.0, 4.0 + i } };
    light.Size = { { 1.0, 1.0 } };
    scene.Lights.push_back(light);
  }
  return scene;
}

//--------------------------------------------------------------------------------------------------
class ViewerStates : public testing::Test
{
protected:
  ViewerStates()
  {
    this->State.SetObserver([this](Change change) { this->Heard.insert(change); });
  }

  void Press(const std::string& key) { this->State.Perform(FindAction(key)); }

  ViewerState State{ MakeScene(), "pcss" };
  std::set<Change> Heard;
};

}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, StartsWithTheTechniquesDefaults)
{
  const vtkSmartPointer<vtkSoftShadowPass> pass = FindTechnique("pcss").Create();
  EXPECT_EQ(this->State.GetTechnique().Name, "pcss");
  for (const TechniqueOption& option : this->State.GetTechnique().Options)
  {
    EXPECT_EQ(this->State.GetOption(option.Name), option.Get(pass)) << option.Name;
  }
  EXPECT_EQ(this->State.GetView().Name, "picture");
}

//--------------------------------------------------------------------------------------------------
TEST(ViewerState, TakesOptionsByNameAndRefusesOthers)
{
  const ViewerState state(MakeScene(), "sampled", { { "samples", "64" } });
  EXPECT_EQ(state.GetOption("samples"), 64.0);
  EXPECT_THROW(ViewerState(MakeScene(), "samplad"), std::runtime_error);
  EXPECT_THROW(ViewerState(MakeScene(), "sampled", { { "rays", "1" } }), std::runtime_error);
  EXPECT_THROW(ViewerState(MakeScene(), "sampled", { { "samples", "-1" } }), std::runtime_error);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, KeysGoThroughAllTechniquesAndAroundTheEnd)
{
  const int count = static_cast<int>(GetTechniques().size());
  std::set<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    names.insert(this->State.GetTechnique().Name);
    this->Press("t");
  }
  EXPECT_EQ(static_cast<int>(names.size()), count);
  EXPECT_EQ(this->State.GetTechnique().Name, "pcss");
  this->Press("T");
  EXPECT_EQ(this->State.GetTechnique().Name, "sampled");
  this->Press("3");
  EXPECT_EQ(this->State.GetTechnique().Name, GetTechniques()[2].Name);
  EXPECT_EQ(this->Heard, std::set<Change>{ Change::Technique });
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, ArrowsSelectAndChangeSettings)
{
  this->Press("Down");
  this->Press("Down");
  this->Press("Down");
  EXPECT_EQ(this->Heard, std::set<Change>{ Change::Menu });
  ASSERT_EQ(this->State.GetSettings()[this->State.GetSelection()]->Name, "search_width");
  const double before = this->State.GetOption("search_width");
  this->Press("Right");
  EXPECT_EQ(this->State.GetOption("search_width"), before + 2.0);
  EXPECT_TRUE(this->Heard.count(Change::Options));
  this->Press("Left");
  EXPECT_EQ(this->State.GetOption("search_width"), before);
  for (int i = 0; i < 100; ++i)
  {
    this->Press("Down");
  }
  EXPECT_EQ(this->State.GetSelection(), static_cast<int>(this->State.GetSettings().size()) - 1);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, EveryTechniqueKeepsItsOptions)
{
  this->State.SetOption("filter_width", 33.0);
  this->Press("t");
  EXPECT_NE(this->State.GetOption("filter_width"), 33.0);
  this->Press("T");
  EXPECT_EQ(this->State.GetOption("filter_width"), 33.0);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, QualitiesSetAllOptions)
{
  const auto place = [](const std::string& name)
  {
    const std::vector<QualityClass>& all = GetQualities();
    const auto found = std::find_if(
      all.begin(), all.end(), [&name](const QualityClass& each) { return each.Name == name; });
    return static_cast<int>(found - all.begin());
  };
  EXPECT_EQ(this->State.GetQualityPlace(), -1) << "the defaults of one map are no class";
  this->State.SetQuality(place("good"));
  EXPECT_EQ(this->State.GetQualityPlace(), place("good"));
  this->State.SetOption("filter_width", 33.0);
  EXPECT_EQ(this->State.GetQualityPlace(), -1);
  this->State.SetQuality(place("draft"));
  EXPECT_EQ(this->State.GetQualityPlace(), place("draft"));
  for (const auto& [name, text] : this->State.GetTechnique().Draft.Options)
  {
    EXPECT_EQ(this->State.GetOption(name), this->State.GetTechnique().FindOption(name).Parse(text));
  }
  this->Press("c");
  EXPECT_EQ(this->State.GetQualityPlace(), place("good"));
  EXPECT_EQ(this->State.GetOption("split"), 2.0);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, StepsOverQualitiesThatATechniqueDoesNotHave)
{
  const auto& techniques = GetTechniques();
  const Technique& rival = FindTechnique("ssabss");
  this->State.SetTechnique(static_cast<int>(&rival - techniques.data()));
  EXPECT_TRUE(this->State.HasQuality(0));
  ASSERT_FALSE(this->State.HasQuality(1));
  ASSERT_FALSE(this->State.HasQuality(2));
  const double before = this->State.GetOption("filter_width");
  this->State.SetQuality(2);
  EXPECT_EQ(this->State.GetOption("filter_width"), before);
  this->Press("c");
  EXPECT_EQ(this->State.GetQualityPlace(), 0);
  this->Press("c");
  EXPECT_EQ(this->State.GetQualityPlace(), 0);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, OptionsStayInTheirRange)
{
  this->State.SetOption("filter_width", 1e9);
  EXPECT_EQ(this->State.GetOption("filter_width"), 128.0);
  this->State.SetOption("filter_width", -5.0);
  EXPECT_EQ(this->State.GetOption("filter_width"), 1.0);
  this->State.SetOption("weights", 7.0);
  EXPECT_EQ(this->State.GetOption("weights"), 1.0);
  EXPECT_TRUE(this->State.HasGaussianWeights());
  EXPECT_THROW(this->State.SetOption("no_such", 1.0), std::runtime_error);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, PassesGetWhatChangedAndAreElseLeftAlone)
{
  vtkNew<vtkPercentageCloserSoftShadowPass> pass;
  const vtkMTimeType before = pass->GetMTime();
  this->State.Apply(pass);
  EXPECT_EQ(pass->GetMTime(), before) << "defaults: nothing to set";
  this->State.SetOption("filter_width", 9.0);
  this->State.SetOption("map_size", 512.0);
  this->State.Apply(pass);
  EXPECT_EQ(pass->GetFilterWidth(), 9);
  EXPECT_EQ(pass->GetMapSize(), 512);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, ViewsOfATechniqueSetItsOption)
{
  this->State.SetTechnique(static_cast<int>(&FindTechnique("pvssm") - GetTechniques().data()));
  for (const TechniqueOption* option : this->State.GetSettings())
  {
    EXPECT_NE(option->Name, "debug_view") << "it is a view, not a setting";
  }
  while (this->State.GetView().Name != "tiles")
  {
    this->Press("v");
  }
  EXPECT_FALSE(this->State.GetView().KeepsVisibility());
  const vtkSmartPointer<vtkSoftShadowPass> pass = this->State.GetTechnique().Create();
  this->State.Apply(pass);
  const TechniqueOption& option = this->State.GetTechnique().FindOption("debug_view");
  EXPECT_EQ(option.Spell(option.Get(pass)), "tiles");
  this->State.SetView(0);
  this->State.Apply(pass);
  EXPECT_EQ(option.Spell(option.Get(pass)), "none");
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, AViewIsKeptWhereTheNextTechniqueHasIt)
{
  this->Press("v");
  EXPECT_EQ(this->State.GetView().Name, "visibility");
  this->Press("t");
  EXPECT_EQ(this->State.GetView().Name, "visibility");
  this->State.SetTechnique(static_cast<int>(&FindTechnique("cascaded") - GetTechniques().data()));
  this->Press("V");
  this->Press("V");
  ASSERT_EQ(this->State.GetView().Name, "cascades");
  EXPECT_TRUE(this->State.GetView().KeepsVisibility());
  this->Press("t");
  EXPECT_EQ(this->State.GetView().Name, "picture");
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, LightsAreChangedOneAtATime)
{
  const LightDescription second = this->State.GetScene().Lights[1];
  this->Press("plus");
  EXPECT_DOUBLE_EQ(this->State.GetLight().Size[0], 1.25);
  this->Press("w"); // up is z: the camera's nearest axis
  EXPECT_GT(this->State.GetLight().Position[2], 4.0);
  this->Press("n");
  EXPECT_EQ(this->Heard, std::set<Change>{ Change::Light });
  EXPECT_EQ(this->State.GetScene().Lights[1].Position, second.Position);
  this->Press("L");
  EXPECT_EQ(this->State.GetLight().Position, (Vector3{ { 3.0, 0.0, 4.0 } }));
  EXPECT_EQ(this->State.GetLight().Size, (Vector2{ { 1.0, 1.0 } }));
  this->Press("l");
  EXPECT_EQ(this->State.GetLightPlace(), 1);
  this->Press("l");
  EXPECT_EQ(this->State.GetLightPlace(), 0);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, ALightIsNeverPutOnItsFocalPoint)
{
  const Vector3 before = this->State.GetLight().Position;
  this->State.SetLightPosition(this->State.GetLight().FocalPoint);
  EXPECT_EQ(this->State.GetLight().Position, before);
}

//--------------------------------------------------------------------------------------------------
TEST(ViewerState, ASceneWithoutLightsHasNothingToMove)
{
  ViewerState state(MakeScene(0), "pcss");
  for (const KeyBinding& binding : GetKeyBindings())
  {
    state.Perform(binding.Does);
  }
  EXPECT_FALSE(state.HasLight());
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerStates, LeavesWindowsActionsToTheWindow)
{
  for (const char* key : { "F2", "F3", "F4", "q", "r" })
  {
    EXPECT_FALSE(this->State.Perform(FindAction(key))) << key;
  }
  EXPECT_TRUE(this->Heard.empty());
  EXPECT_TRUE(this->State.Perform(FindAction("h")));
  EXPECT_TRUE(this->State.IsHelpOpen());
}
