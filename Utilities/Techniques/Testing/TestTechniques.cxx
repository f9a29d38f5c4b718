// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The table of techniques: what it says is what the passes do.

#include "Technique.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkShadowLightSampling.h"

using namespace softshadows;

namespace
{

std::string ErrorOf(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(Techniques, EveryOptionSetsWhatItGetsWithinItsRangeOnly)
{
  std::set<std::string> names;
  for (const Technique& technique : GetTechniques())
  {
    EXPECT_TRUE(names.insert(technique.Name).second) << technique.Name << " stands twice";
    EXPECT_FALSE(technique.Meaning.empty());
    std::set<std::string> optionNames;
    for (const TechniqueOption& option : technique.Options)
    {
      const std::string which = technique.Name + " " + option.Name;
      EXPECT_TRUE(optionNames.insert(option.Name).second) << which << " stands twice";
      EXPECT_FALSE(option.Meaning.empty()) << which;
      const auto pass = technique.Create();
      const double byDefault = option.Get(pass);
      EXPECT_EQ(option.Parse(option.Spell(byDefault)), byDefault) << which;

      const bool isChosen = !option.Choices.empty();
      const double least = isChosen ? 0.0 : option.Least;
      const double most = isChosen ? static_cast<double>(option.Choices.size()) - 1.0 : option.Most;
      EXPECT_LT(least, most) << which;
      for (const double value : { least, most })
      {
        option.Set(pass, option.Parse(option.Spell(value)));
        EXPECT_EQ(option.Get(pass), value) << which;
      }
      if (!isChosen)
      {
        EXPECT_THROW(option.Parse(std::to_string(option.Most + 1.0)), std::runtime_error) << which;
        EXPECT_THROW(option.Parse(std::to_string(option.Least - 1.0)), std::runtime_error) << which;
      }
      for (const std::string wrong : { "", "nan", "inf", "-inf", "7x", "x7", "on off" })
      {
        EXPECT_THROW(option.Parse(wrong), std::runtime_error) << which << " took " << wrong;
      }
    }
  }
}

TEST(Techniques, AreCreatedWithTheirOptions)
{
  const auto pass = CreatePass(FindTechnique("pcss"),
    { { "map_size", "512" }, { "split", "2" }, { "early_out", "off" }, { "search_width", "29" },
      { "filter_width", "41" }, { "weights", "gaussian" } });
  auto* pcss = vtkPercentageCloserSoftShadowPass::SafeDownCast(pass);
  ASSERT_NE(pcss, nullptr);
  EXPECT_EQ(pcss->GetMapSize(), 512);
  EXPECT_EQ(pcss->GetSplit(), 2);
  EXPECT_FALSE(pcss->GetEarlyOut());
  EXPECT_EQ(pcss->GetSearchWidth(), 29);
  EXPECT_EQ(pcss->GetFilterWidth(), 41);
  EXPECT_EQ(pcss->GetWeights(), static_cast<int>(vtkShadowLightSampling::GAUSSIAN));

  const auto sampled = CreatePass(FindTechnique("sampled"),
    { { "samples", "64" }, { "pattern", "hammersley" }, { "early_out", "true" } });
  EXPECT_EQ(vtkSampledSoftShadowPass::SafeDownCast(sampled)->GetNumberOfSamples(), 64);
  EXPECT_EQ(vtkSampledSoftShadowPass::SafeDownCast(sampled)->GetPattern(),
    static_cast<int>(vtkShadowLightSampling::HAMMERSLEY));
}

TEST(Techniques, RefuseWhatIsUnknownAndSayWhatThereIs)
{
  EXPECT_EQ(ErrorOf([] { FindTechnique("pccs"); })
              .find("there is no technique 'pccs'; did you mean 'pcss'? Known are: sampled, pcss"),
    0u);
  const Technique pcss = FindTechnique("pcss");
  EXPECT_EQ(ErrorOf(
              [&] {
                CreatePass(pcss, { { "samples", "4" } });
              })
              .find("technique 'pcss' has no option 'samples'; "),
    0u);
  EXPECT_NE(ErrorOf(
              [&] {
                CreatePass(pcss, { { "mapsize", "4" } });
              })
              .find("did you mean 'map_size'?"),
    std::string::npos);
  EXPECT_EQ(ErrorOf(
              [&] {
                CreatePass(pcss, { { "split", "0" } });
              }),
    "option 'split': must be a whole number from 1 to 32, is '0'");
  EXPECT_EQ(ErrorOf(
              [&] {
                CreatePass(pcss, { { "split", "1.5" } });
              }),
    "option 'split': must be a whole number from 1 to 32, is '1.5'");
  EXPECT_EQ(ErrorOf(
              [&] {
                CreatePass(pcss, { { "weights", "box" } });
              }),
    "option 'weights': must be mean or gaussian, is 'box'");
  EXPECT_EQ(ErrorOf(
              [&] {
                CreatePass(pcss, { { "weights", "1" } });
              }),
    "option 'weights': must be mean or gaussian, is '1'");
  EXPECT_EQ(ErrorOf(
              [&] {
                CreatePass(pcss, { { "early_out", "yes" } });
              }),
    "option 'early_out': must be off or on, is 'yes'");
}

TEST(Techniques, SayWhenRaysAreNotBuilt)
{
  const std::string error = ErrorOf([] { FindTechnique("traced"); });
  EXPECT_TRUE(
    error.empty() || error == "technique 'traced' is not built here: it needs Embree 3 or 4")
    << error;
}

TEST(Techniques, CutOptions)
{
  EXPECT_EQ(SplitOption("a=b"), (std::pair<std::string, std::string>{ "a", "b" }));
  EXPECT_EQ(SplitOption("a=b=c"), (std::pair<std::string, std::string>{ "a", "b=c" }));
  EXPECT_EQ(SplitOption("a="), (std::pair<std::string, std::string>{ "a", "" }));
  EXPECT_THROW(SplitOption("a"), std::runtime_error);
  EXPECT_THROW(SplitOption("=b"), std::runtime_error);
}

TEST(Techniques, ArePrintedWithTheirNamesFirst)
{
  std::ostringstream text;
  PrintTechniques(text);
  std::istringstream lines(text.str());
  std::size_t techniques = 0;
  for (std::string line; std::getline(lines, line);)
  {
    if (line[0] != ' ')
    {
      ASSERT_LT(techniques, GetTechniques().size());
      EXPECT_EQ(line.find(GetTechniques()[techniques].Name + " "), 0u);
      ++techniques;
    }
  }
  EXPECT_EQ(techniques, GetTechniques().size());
  EXPECT_NE(text.str().find("map_size=2048  (a whole number from 32 to 16384)"), std::string::npos);
}

TEST(Techniques, JsonHoldsWhatTheTableHolds)
{
  std::ostringstream text;
  PrintTechniquesAsJson(text);
  const nlohmann::json json = nlohmann::json::parse(text.str());
  ASSERT_EQ(json["techniques"].size(), GetTechniques().size());
  for (std::size_t i = 0; i < GetTechniques().size(); ++i)
  {
    const Technique& technique = GetTechniques()[i];
    const nlohmann::json& entry = json["techniques"][i];
    EXPECT_EQ(entry["name"], technique.Name);
    EXPECT_EQ(entry["class"], technique.Create()->GetClassName());
    ASSERT_EQ(entry["options"].size(), technique.Options.size());
    for (std::size_t j = 0; j < technique.Options.size(); ++j)
    {
      const TechniqueOption& option = technique.Options[j];
      const nlohmann::json& known = entry["options"][j];
      EXPECT_EQ(known["name"], option.Name);
      EXPECT_NE(known["property"], "") << option.Name;
      // A program that has only this can read and set every option.
      const nlohmann::json& value = known["default"];
      const std::string spelled = value.is_string() ? value.get<std::string>() : value.dump();
      EXPECT_EQ(option.Parse(spelled), option.Get(technique.Create())) << option.Name;
      EXPECT_EQ(known.contains("choices"), !option.Choices.empty()) << option.Name;
    }
    EXPECT_EQ(entry["qualities"]["best"].is_null(), !technique.Best.Exists());
  }
  EXPECT_EQ(json["qualities"][1]["name"], "good");
}
