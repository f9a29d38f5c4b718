// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is made of results, on results made by hand.
#include "BenchmarkCharts.h"
#include "HtmlReport.h"
#include "MarkdownReport.h"
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
TEST(BenchmarkCharts, KernelWidthsMakeOneSeriesThoughTheSearchGrowsToo)
{
  SceneResult scene;
  for (const int width : { 15, 41 })
  {
    scene.Contestants.push_back(MakeResult("pcss", 1.0 * width, 0.1));
    scene.Contestants.back().Options = { { "filter_width", std::to_string(width) },
      { "search_width", std::to_string(width / 2) }, { "weights", "mean" } };
  }
  const ChartDescription chart = TimeAgainstOption(scene, "filter_width");
  ASSERT_EQ(chart.Series.size(), 1U);
  EXPECT_EQ(chart.Series[0].Name, "pcss");
  EXPECT_EQ(chart.Series[0].Y, (std::vector<double>{ 15.0, 41.0 }));
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkCharts, PlotOfAllScenesHasGeometricMeansOfCompleteContestants)
{
  BenchmarkResults results;
  results.Scenes.resize(3);
  results.Scenes[0].Name = "a";
  results.Scenes[0].Contestants = { MakeResult("good", 10.0, 0.01), MakeResult("once", 1.0, 0.5) };
  results.Scenes[1].Name = "b";
  results.Scenes[1].Contestants = { MakeResult("good", 40.0, 0.04) };
  results.Scenes[2].Name = "actors-10";
  results.Scenes[2].Contestants = { MakeResult("good", 1e6, 1.0) };
  const ChartDescription chart = SpeedAgainstErrorOfAll(results);
  ASSERT_EQ(chart.Series.size(), 2U) << "the front and one technique";
  EXPECT_TRUE(chart.Series[0].IsFront);
  ASSERT_EQ(chart.Series[1].X.size(), 1U);
  EXPECT_NEAR(chart.Series[1].X[0], 20.0, 1e-9);
  EXPECT_NEAR(chart.Series[1].Y[0], 0.02, 1e-12);
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

}
