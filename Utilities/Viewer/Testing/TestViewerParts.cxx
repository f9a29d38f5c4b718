// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The viewer's small functions: steps of options, keys, colours, files.
#include "KeyBindings.h"
#include "OptionSteps.h"
#include "SceneReader.h"
#include "ViewerFiles.h"
#include "VisibilityPicture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

using namespace softshadows;

namespace fs = std::filesystem;

namespace
{

//--------------------------------------------------------------------------------------------------
TechniqueOption MakeOption(TechniqueOption::Kind kind, double least, double most)
{
  TechniqueOption option;
  option.Is = kind;
  option.Least = least;
  option.Most = most;
  return option;
}

//--------------------------------------------------------------------------------------------------
fs::path MakeFolder(const std::string& name)
{
  fs::path folder = fs::path(SOFTSHADOWS_TEST_OUTPUT_DIR) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

}

//--------------------------------------------------------------------------------------------------
TEST(OptionSteps, IntegersDoubleOrAdvanceByTheirRange)
{
  const auto kind = TechniqueOption::Kind::Integer;
  const TechniqueOption mapSize = MakeOption(kind, 32, 16384);
  EXPECT_EQ(StepValue(mapSize, 2048, 1), 4096);
  EXPECT_EQ(StepValue(mapSize, 2048, -2), 512);
  EXPECT_EQ(StepValue(mapSize, 16384, 1), 16384);
  EXPECT_EQ(StepValue(mapSize, 32, -1), 32);
  EXPECT_EQ(StepValue(MakeOption(kind, 1, 128), 15, 1), 17);
  EXPECT_EQ(StepValue(MakeOption(kind, 1, 32), 1, 1), 2);
  EXPECT_EQ(StepValue(MakeOption(kind, 1, 128), 2, -1), 1);
}

//--------------------------------------------------------------------------------------------------
TEST(OptionSteps, NumbersComeBackToWhereTheyWere)
{
  const auto kind = TechniqueOption::Kind::Number;
  const TechniqueOption share = MakeOption(kind, 0, 1);
  EXPECT_NEAR(StepValue(share, 0.1, 1), 0.15, 1e-12);
  EXPECT_NEAR(StepValue(share, 0.1, -3), 0.0, 1e-12);
  const TechniqueOption width = MakeOption(kind, 0.1, 100);
  EXPECT_DOUBLE_EQ(StepValue(width, 4.0, 1), 5.0);
  EXPECT_DOUBLE_EQ(StepValue(width, 5.0, -1), 4.0);
  EXPECT_DOUBLE_EQ(StepValue(width, 90.0, 1), 100.0);
  const TechniqueOption small = MakeOption(kind, 1e-6, 1);
  EXPECT_DOUBLE_EQ(StepValue(small, 0.01, 1), 0.0125);
}

//--------------------------------------------------------------------------------------------------
TEST(OptionSteps, ChoicesGoAround)
{
  TechniqueOption choice = MakeOption(TechniqueOption::Kind::Choice, 0, 0);
  choice.Choices = { "a", "b", "c" };
  EXPECT_EQ(StepValue(choice, 2, 1), 0);
  EXPECT_EQ(StepValue(choice, 0, -1), 2);
}

//--------------------------------------------------------------------------------------------------
TEST(OptionSteps, EveryOptionOfEveryTechniqueCanBeChanged)
{
  for (const Technique& technique : GetTechniques())
  {
    const vtkSmartPointer<vtkSoftShadowPass> pass = technique.Create();
    for (const TechniqueOption& option : technique.Options)
    {
      const double value = option.Get(pass);
      const double up = StepValue(option, value, 1);
      const double down = StepValue(option, value, -1);
      EXPECT_TRUE(up != value || down != value) << technique.Name << " " << option.Name;
      EXPECT_NO_THROW(option.Parse(option.Spell(up))) << technique.Name << " " << option.Name;
      EXPECT_NO_THROW(option.Parse(option.Spell(down))) << technique.Name << " " << option.Name;
    }
  }
}

//--------------------------------------------------------------------------------------------------
TEST(KeyBindings, NoKeyMeansTwoThings)
{
  std::set<std::string> keys;
  for (const KeyBinding& binding : GetKeyBindings())
  {
    EXPECT_TRUE(keys.insert(binding.Key).second) << binding.Key;
    EXPECT_EQ(FindAction(binding.Key), binding.Does);
  }
  EXPECT_EQ(FindAction("Z").Is, ViewerAction::Kind::None);
  EXPECT_EQ(FindAction("").Is, ViewerAction::Kind::None);
}

//--------------------------------------------------------------------------------------------------
TEST(KeyBindings, TheHelpNamesEveryLetter)
{
  std::string all;
  for (const HelpLine& line : GetHelp())
  {
    all += " " + line.Keys + ",";
  }
  for (const KeyBinding& binding : GetKeyBindings())
  {
    const bool isLetter = binding.Key.size() == 1 && std::isalpha(binding.Key[0]);
    if (isLetter)
    {
      EXPECT_NE(all.find(" " + binding.Key + ","), std::string::npos) << binding.Key;
    }
  }
}

//--------------------------------------------------------------------------------------------------
TEST(VisibilityPicture, GreyIsTheValue)
{
  EXPECT_EQ(DrawGrey({ 0.0F, 0.5F, 1.0F, 2.0F }),
    (std::vector<unsigned char>{ 0, 0, 0, 128, 128, 128, 255, 255, 255, 255, 255, 255 }));
  EXPECT_NE(DrawGrey({ NAN })[0], DrawGrey({ NAN })[2]) << "no grey stands for no value";
}

//--------------------------------------------------------------------------------------------------
TEST(VisibilityPicture, PenumbraHasTenBands)
{
  EXPECT_EQ(DrawPenumbra({ 0.01F, 0.99F }), (std::vector<unsigned char>{ 0, 0, 0, 255, 255, 255 }));
  std::set<std::vector<unsigned char>> colors;
  for (int i = 0; i < 100; ++i)
  {
    const float visibility = 0.03F + 0.94F * static_cast<float>(i) / 99.0F;
    colors.insert(DrawPenumbra({ visibility }));
  }
  EXPECT_EQ(colors.size(), 10U);
  EXPECT_EQ(DrawPenumbra({ 0.31F }), DrawPenumbra({ 0.39F }));
  EXPECT_NE(DrawPenumbra({ 0.39F }), DrawPenumbra({ 0.41F }));
}

//--------------------------------------------------------------------------------------------------
TEST(ViewerFiles, NothingIsOverwritten)
{
  const fs::path folder = MakeFolder("ViewerFiles");
  const std::string first = FreeFileName(folder.string(), "a", ".png");
  EXPECT_EQ(fs::path(first).filename(), "a-1.png");
  std::ofstream(first) << "x";
  EXPECT_EQ(fs::path(FreeFileName(folder.string(), "a", ".png")).filename(), "a-2.png");
  fs::remove_all(folder);
}

//--------------------------------------------------------------------------------------------------
TEST(ViewerFiles, ASavedSceneIsTheSceneAndFindsItsModels)
{
  const fs::path folder = MakeFolder("ViewerScene");
  fs::create_directories(folder / "models");
  std::ofstream(folder / "models" / "m.ply") << "ply";
  SceneDescription scene;
  scene.Width = 321;
  scene.Folder = folder.string();
  LightDescription light;
  light.Position = { { 0.1, 1.0 / 3.0, 3.0 } };
  light.Size = { { 0.5, 0.25 } };
  scene.Lights.push_back(light);
  ObjectDescription object;
  object.Shape = ModelShape{ "m.ply", {} };
  scene.Objects.push_back(object);
  const std::string path = (folder / "saved.json").string();
  SaveScene(path, scene, { (folder / "models").string() });
  const SceneDescription read = ReadScene(path);
  EXPECT_EQ(read.Width, 321);
  EXPECT_EQ(read.Lights.at(0).Position, light.Position);
  const fs::path model = std::get<ModelShape>(read.Objects.at(0).Shape).File;
  EXPECT_TRUE(model.is_absolute() && fs::exists(model)) << model;
  EXPECT_THROW(SaveScene((folder / "no" / "where.json").string(), scene, {}), std::runtime_error);
  fs::remove_all(folder);
}
