// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is made of results, on results made by hand.
#include "BenchmarkCharts.h"
#include "BenchmarkPlan.h"
#include "HtmlReport.h"
#include "MarkdownReport.h"
#include "PaperTables.h"
#include "PngData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

using namespace softshadows;

namespace
{

//--------------------------------------------------------------------------------------------------
ContestantResult MakeResult(const std::string& name, double milliseconds, double rmse)
{
  ContestantResult result;
  result.Name = name;
  result.Technique = name.substr(0, name.find(' '));
  const size_t equals = name.find('=');
  if (equals != std::string::npos)
  {
    const size_t space = name.find(' ');
    result.Options[name.substr(space + 1, equals - space - 1)] = name.substr(equals + 1);
  }
  result.Times[static_cast<size_t>(Motion::Light)].Milliseconds = { milliseconds };
  result.Rmse = rmse;
  result.Errors.resize(1);
  return result;
}

//--------------------------------------------------------------------------------------------------
TEST(FrameTimes, AreSummedUpInOrderStatistics)
{
  const FrameTimes times{ { 4.0, 1.0, 2.0, 10.0 } };
  EXPECT_DOUBLE_EQ(times.Median(), 3.0);
  EXPECT_DOUBLE_EQ(times.Quantile(0.25), 1.75);
  EXPECT_DOUBLE_EQ(times.Quantile(1.0), 10.0);
  EXPECT_DOUBLE_EQ(times.Mean(), 4.25);
  EXPECT_NEAR(times.StandardDeviation(), 4.031129, 1e-6);
  EXPECT_TRUE(std::isnan(FrameTimes().Median()));
}

//--------------------------------------------------------------------------------------------------
TEST(ParetoFront, HasWhatNoOtherBeatsInBoth)
{
  SceneResult scene;
  scene.Contestants = { MakeResult("good", 10.0, 0.01), MakeResult("slow", 20.0, 0.02),
    MakeResult("fast", 1.0, 0.1), MakeResult("exact", 100.0, 0.001),
    MakeResult("equal", 10.0, 0.05) };
  std::string names;
  for (const ContestantResult* contestant : ParetoFront(scene))
  {
    names += contestant->Name + ' ';
  }
  EXPECT_EQ(names, "fast good exact ");
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkCharts, SeriesAreTechniquesInOrderOfTheOption)
{
  SceneResult scene;
  scene.Contestants = { MakeResult("pcss taps=20", 8.0, 0.1), MakeResult("pcss taps=5", 2.0, 0.2),
    MakeResult("other taps=5", 1.0, 0.2) };
  const ChartDescription chart = TimeAgainstOption(scene, "taps");
  ASSERT_EQ(chart.Series.size(), 1U) << "one value alone is no line";
  EXPECT_EQ(chart.Series[0].X, (std::vector<double>{ 5.0, 20.0 }));
  EXPECT_EQ(chart.Series[0].Y, (std::vector<double>{ 2.0, 8.0 }));
  EXPECT_TRUE(TimeAgainstOption(scene, "map_size").IsEmpty());
}

//--------------------------------------------------------------------------------------------------
TEST(HtmlReport, NumbersHaveFourDigitsAndTextIsEscaped)
{
  EXPECT_EQ(FormatNumber(0.0123456), "0.01235");
  EXPECT_EQ(FormatNumber(std::nan("")), "-");
  EXPECT_EQ(EscapeHtml("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
}

//--------------------------------------------------------------------------------------------------
TEST(PngData, IsBase64OfAPng)
{
  const ColorImage image{ 1, 2, { 255, 0, 0, 0, 0, 255 } };
  EXPECT_EQ(EncodePng(image).substr(1, 3), "PNG");
  EXPECT_EQ(EncodePngUrl(image).rfind("data:image/png;base64,iVBORw0KGgo", 0), 0U);
}

//--------------------------------------------------------------------------------------------------
TEST(MarkdownReport, HasALinePerContestantWithTheFrontInBold)
{
  BenchmarkResults results;
  results.Scenes.resize(1);
  results.Scenes[0].Name = "box";
  results.Scenes[0].Contestants = { MakeResult("good", 10.0, 0.0123456),
    MakeResult("slow", 20.0, 0.5) };
  // One contestant has failed, so there is nothing to plot of it.
  results.Scenes[0].Contestants.emplace_back();
  results.Scenes[0].Contestants.back().Name = "odd";
  results.Scenes[0].Contestants.back().Failure = "is not built";
  std::ostringstream text;
  const std::map<std::string, ColorImage> plots = WriteMarkdown(text, results, "Images");
  EXPECT_NE(text.str().find("| **good** | 10 | - | - | 0.01235 |"), std::string::npos)
    << text.str();
  EXPECT_NE(text.str().find("| slow | 20 | - | - | 0.5 |"), std::string::npos);
  EXPECT_NE(text.str().find("| odd | is not built |"), std::string::npos);
  EXPECT_NE(text.str().find("(Images/speed-box.png)"), std::string::npos);
  EXPECT_EQ(plots.count("speed-box.png"), 1U);
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, RowsOfATableShareSceneAndLight)
{
  for (const char* paper : { "pcss", "sssm", "cascaded", "sbfs", "pvssm" })
  {
    for (const PaperTable& table : GetPaperTables(paper))
    {
      ASSERT_GE(table.Rows.size(), 2U) << table.Title;
      for (const PaperRow& row : table.Rows)
      {
        EXPECT_EQ(row.Scene, table.Rows.front().Scene) << table.Title << ": " << row.Label;
        EXPECT_EQ(row.LightScale, table.Rows.front().LightScale) << table.Title;
      }
    }
  }
  EXPECT_THROW(GetPaperTables("nonsense"), std::runtime_error);
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkPlan, HasPeersAndEveryTechniqueOnceWithEachSetting)
{
  const std::vector<KnownTechnique> known = { { "sampled", { "map_size", "samples", "weights" } },
    { "pcss", { "map_size", "search_width", "filter_width", "weights", "split" } } };
  const std::vector<ContestantChoice> all = PlanContestants(known, false);
  std::set<std::string> names;
  for (const ContestantChoice& choice : all)
  {
    EXPECT_TRUE(names.insert(choice.GetName()).second) << choice.GetName() << " is there twice";
  }
  for (const char* name : { "plain", "vtk map_size=1024", "rays samples=256",
         "sampled map_size=1024 samples=256 weights=mean", "pcss weights=mean",
         "pcss filter_width=41 search_width=29 weights=mean", "pcss split=2 weights=mean" })
  {
    EXPECT_EQ(names.count(name), 1U) << name;
  }
  EXPECT_LT(PlanContestants(known, true).size(), 10U);
  EXPECT_EQ(SelectTechniques(all, { "plain" }).size(), 1U);
  EXPECT_THROW(SelectTechniques(all, { "nonsense" }), std::runtime_error);
}

}
