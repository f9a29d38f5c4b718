// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// One small scene with a few contestants, run for real and read back from all reports.
#include "BenchmarkReport.h"
#include "BenchmarkRunner.h"
#include "HtmlReport.h"
#include "SceneBuilder.h"
#include "SceneReader.h"
#include "Technique.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

using namespace softshadows;

namespace
{

const char* const SceneText = R"({ "version": 1,
  "image": { "width": 96, "height": 64 },
  "camera": { "position": [0, -5, 4], "focal_point": [0, 0, 0], "view_up": [0, 0, 1] },
  "lights": [ { "position": [1, 0, 4], "focal_point": [0, 0, 0], "size": [0.6, 0.6],
    "cone_angle": 40 } ],
  "objects": [
    { "source": "plane", "origin": [-3, -3, 0], "point1": [3, -3, 0], "point2": [-3, 3, 0] },
    { "source": "box", "bounds": [-0.5, 0.5, -0.5, 0.5, 0.4, 1] } ] })";

//--------------------------------------------------------------------------------------------------
BenchmarkScene MakeScene()
{
  const SceneDescription description = ParseScene(SceneText, "box.json");
  return { "box", description.Width, description.Height,
    [description]
    {
      ModelStore models;
      return BuildScene(description, models).Renderer;
    },
    false, "" };
}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakePass(
  const std::string& technique, const TechniqueOptions& options)
{
  return CreatePass(FindTechnique(technique), OptionTexts(options.begin(), options.end()));
}

//--------------------------------------------------------------------------------------------------
// Run once for all tests below.
class BenchmarkRun : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    BenchmarkSettings settings;
    settings.Rounds = 3;
    settings.ReferenceSamplesPerAxis = 24;
    settings.CacheFolder = CacheFolder();
    std::filesystem::remove_all(CacheFolder());
    const BenchmarkRunner runner(settings, MakePass);
    Results = new BenchmarkResults;
    Results->Context.Host = "a <test>";
    Results->Scenes.push_back(runner.Run(MakeScene(),
      { { "plain", {} }, { "vtk", {} }, { "rays", { { "samples", "16" } } },
        { "sampled", { { "samples", "1" }, { "map_size", "512" } } },
        { "sampled", { { "samples", "64" }, { "map_size", "512" } } }, { "nonsense", {} } }));
    BenchmarkScene broken;
    broken.Name = "broken";
    broken.Failure = "broken.json:3: no such key";
    Results->Scenes.push_back(runner.Run(broken, { { "plain", {} } }));
  }

  static void TearDownTestSuite()
  {
    delete Results;
    Results = nullptr;
    std::filesystem::remove_all(CacheFolder());
  }

  // Of this process alone: ctest runs every test below in a process of its own, several at a time.
  static std::string CacheFolder()
  {
    return SOFTSHADOWS_TEST_OUTPUT_DIR "/ReferenceCache" + std::to_string(getpid());
  }

  static const ContestantResult& Get(const std::string& name)
  {
    for (const ContestantResult& contestant : Results->Scenes[0].Contestants)
    {
      if (contestant.Name == name)
      {
        return contestant;
      }
    }
    throw std::runtime_error("no contestant " + name);
  }

  static BenchmarkResults* Results;
};

BenchmarkResults* BenchmarkRun::Results = nullptr;

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, JudgesAndTimesEveryContestant)
{
  const SceneResult& scene = Results->Scenes[0];
  EXPECT_EQ(scene.Failure, "");
  EXPECT_EQ(scene.Lights, 1);
  EXPECT_EQ(scene.Actors, 2);
  EXPECT_EQ(scene.Triangles, 14);
  for (const char* name :
    { "plain", "vtk", "sampled map_size=512 samples=1", "sampled map_size=512 samples=64" })
  {
    for (const FrameTimes& times : Get(name).Times)
    {
      EXPECT_EQ(times.Milliseconds.size(), 3U) << name;
    }
  }
  EXPECT_FALSE(Get("plain").Picture.Pixels.empty());
  EXPECT_FALSE(Get("sampled map_size=512 samples=1").Difference.Pixels.empty());
  EXPECT_TRUE(Get("sampled map_size=512 samples=64").Difference.Pixels.empty())
    << "pictures are of the first of a technique";
  EXPECT_FALSE(Get("plain").HasErrors());
  EXPECT_FALSE(Get("vtk").HasErrors());
  EXPECT_LT(
    Get("sampled map_size=512 samples=64").Rmse, Get("sampled map_size=512 samples=1").Rmse);
  EXPECT_LT(Get("rays samples=16").Rmse, 0.05);
  EXPECT_GT(Get("rays samples=16").Rmse, 0.001);
  EXPECT_NE(Get("nonsense").Failure, "");
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, MovingLightsBakesMapsAndStandingStillDoesNot)
{
  const auto& counts = Get("sampled map_size=512 samples=64").Counts;
  const auto baked = std::find_if(
    counts.begin(), counts.end(), [](const auto& count) { return count.first == "maps_baked"; });
  ASSERT_NE(baked, counts.end());
  // The first frame, the warm-up with moving lights, and three rounds.
  EXPECT_GE(baked->second, 64 * 5);
  EXPECT_LT(baked->second, 64 * 6);
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, ReferenceComesFromTheCacheTheSecondTime)
{
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(CacheFolder()), {}), 1);
  const std::string file = std::filesystem::directory_iterator(CacheFolder())->path().string();
  // A reference that says "all lit" is believed if it is in the cache.
  VisibilityImage image = ReadVisibility(file);
  for (float& value : image.Visibility[0])
  {
    value = std::isnan(value) ? value : 1.0F;
  }
  WriteVisibility(file, image);
  BenchmarkSettings settings;
  settings.Rounds = 1;
  settings.ReferenceSamplesPerAxis = 24;
  settings.CacheFolder = CacheFolder();
  const SceneResult again =
    BenchmarkRunner(settings, MakePass).Run(MakeScene(), { { "rays", { { "samples", "16" } } } });
  EXPECT_GT(again.Contestants[0].Rmse, 0.1);
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, SlowContestantsAreTimedOnceOrLeftOut)
{
  BenchmarkSettings settings;
  settings.ReferenceSamplesPerAxis = 2;
  settings.LongestFrame = 1e-6; // slow is whatever takes a microsecond
  const SceneResult slow =
    BenchmarkRunner(settings, MakePass)
      .Run(MakeScene(), { { "rays", { { "samples", "1" } } }, { "rays", { { "samples", "4" } } } });
  ASSERT_EQ(slow.Contestants.size(), 2U);
  const auto light = static_cast<size_t>(Motion::Light);
  EXPECT_EQ(slow.Contestants[0].Times[light].Milliseconds.size(), 1U);
  EXPECT_TRUE(slow.Contestants[0].HasErrors());
  EXPECT_NE(slow.Contestants[1].Failure.find("left out"), std::string::npos);
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, JsonHasGoogleBenchmarksForm)
{
  const auto json = nlohmann::json::parse(ToJson(*Results).dump());
  EXPECT_TRUE(json.at("context").contains("num_cpus"));
  int frames = 0;
  int medians = 0;
  for (const auto& entry : json.at("benchmarks"))
  {
    EXPECT_EQ(entry.at("time_unit"), "ms");
    EXPECT_GT(entry.at("real_time").get<double>(), -1e-9);
    if (entry.at("run_name") == "box/sampled map_size=512 samples=64/light")
    {
      frames += entry.at("run_type") == "iteration" ? 1 : 0;
      if (entry.value("aggregate_name", "") == "median")
      {
        ++medians;
        EXPECT_EQ(entry.at("real_time"),
          Get("sampled map_size=512 samples=64")
            .Times[static_cast<size_t>(Motion::Light)]
            .Median());
      }
    }
  }
  EXPECT_EQ(frames, 3);
  EXPECT_EQ(medians, 1);
  const auto& scenes = json.at("soft_shadows").at("scenes");
  EXPECT_EQ(scenes[1].at("failure"), "broken.json:3: no such key");
  EXPECT_EQ(scenes[0].at("contestants")[4].at("rmse"), Get("sampled map_size=512 samples=64").Rmse);
  EXPECT_GT(scenes[0].at("contestants")[4].at("lights")[0].at("penumbra").at("pixels"), 100);
  EXPECT_FALSE(scenes[0].at("contestants")[4].at("steps").empty());
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, CsvHasALinePerContestantAndEveryColumn)
{
  std::stringstream csv;
  WriteCsv(csv, *Results);
  std::string line;
  std::vector<std::string> lines;
  while (std::getline(csv, line))
  {
    lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 1U + 6U + 1U);
  const auto columns = std::count(lines[0].begin(), lines[0].end(), ',');
  for (const std::string& row : lines)
  {
    if (row.find('"') == std::string::npos)
    {
      EXPECT_EQ(std::count(row.begin(), row.end(), ','), columns) << row;
    }
  }
  EXPECT_EQ(lines[5].rfind("box,sampled map_size=512 samples=64,,", 0), 0U) << lines[5];
  EXPECT_EQ(lines[7].rfind("broken,,broken.json:3: no such key,", 0), 0U) << lines[7];
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, PageShowsTheNumbersOfTheJson)
{
  std::stringstream stream;
  WriteHtml(stream, *Results);
  const std::string page = stream.str();
  std::ofstream(SOFTSHADOWS_TEST_OUTPUT_DIR "/Benchmark.html") << page; // to look at
  const auto json = ToJson(*Results);
  for (const auto& contestant : json["soft_shadows"]["scenes"][0]["contestants"])
  {
    EXPECT_NE(page.find(contestant["name"].get<std::string>()), std::string::npos);
    if (contestant.contains("lights"))
    {
      const double rmse = contestant["lights"][0]["all"]["rmse"];
      EXPECT_NE(page.find("<td>" + FormatNumber(rmse) + "</td>"), std::string::npos) << rmse;
    }
    if (contestant.contains("milliseconds"))
    {
      const double median = contestant["milliseconds"]["light"]["median"];
      EXPECT_NE(page.find("<td>" + FormatNumber(median) + " <span"), std::string::npos) << median;
    }
  }
  EXPECT_NE(page.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(page.find("a &lt;test&gt;"), std::string::npos);
  EXPECT_NE(page.find("Broken: broken.json:3: no such key"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos) << "the page needs other files";
}

}
