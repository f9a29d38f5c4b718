// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// One small scene with a few contestants, run for real and read back from all reports.
#include "BenchmarkReport.h"
#include "BenchmarkRunner.h"
#include "BenchmarkTechniques.h"
#include "Contestant.h"
#include "HtmlReport.h"
#include "MarkdownReport.h"
#include "ReferenceCache.h"
#include "SceneBuilder.h"
#include "SceneReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

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
    false, 3.0, "" };
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
    std::filesystem::remove_all(CacheFolder());
    const BenchmarkRunner runner(settings, CreateContestantPass, CacheReferences(CacheFolder()));
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
  // Both are shadows of the light's centre.
  EXPECT_LT(Get("sampled map_size=512 samples=1").RmseToHard, 0.03);
  EXPECT_TRUE(Get("vtk").HasErrors());
  EXPECT_GT(Get("vtk").Errors[0].All.Pixels, 4000);
  EXPECT_TRUE(std::isnan(Get("sampled map_size=512 samples=64").RmseToHard));
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
  std::string file;
  for (const auto& entry : std::filesystem::directory_iterator(CacheFolder()))
  {
    const std::string path = entry.path().string();
    file = path.find("-24.exr") != std::string::npos ? path : file; // not the hard shadow's
  }
  ASSERT_NE(file, "");
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
  const SceneResult again =
    BenchmarkRunner(settings, CreateContestantPass, CacheReferences(CacheFolder()))
      .Run(MakeScene(), { { "rays", { { "samples", "16" } } } });
  EXPECT_GT(again.Contestants[0].Rmse, 0.1);
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, SlowContestantsAreTimedOnceOrLeftOut)
{
  BenchmarkSettings settings;
  settings.ReferenceSamplesPerAxis = 2;
  settings.LongestFrame = 1e-6; // slow is whatever takes a microsecond
  const SceneResult slow =
    BenchmarkRunner(settings, CreateContestantPass, CacheReferences(""))
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
    // What Google Benchmark's tools/compare.py reads of every entry.
    EXPECT_TRUE(entry.at("name").is_string());
    EXPECT_TRUE(entry.at("run_name").is_string());
    EXPECT_TRUE(entry.at("cpu_time").is_number());
    EXPECT_TRUE(entry.at("repetitions").is_number_integer());
    EXPECT_EQ(entry.at("run_type") == "aggregate", entry.contains("aggregate_name"));
    EXPECT_EQ(entry.at("run_type") == "iteration", entry.contains("repetition_index"));
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

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, DocumentShowsTheNumbersOfTheJson)
{
  std::ostringstream stream;
  WriteMarkdown(stream, *Results, "Images");
  const std::string text = stream.str();
  const auto json = ToJson(*Results);
  int compared = 0;
  for (const auto& contestant : json["soft_shadows"]["scenes"][0]["contestants"])
  {
    if (!contestant.contains("lights"))
    {
      continue;
    }
    const double median = contestant["milliseconds"]["light"]["median"];
    const double rmse = contestant["rmse"];
    const size_t line = text.find(contestant["name"].get<std::string>());
    ASSERT_NE(line, std::string::npos);
    const std::string row = text.substr(line, text.find('\n', line) - line);
    EXPECT_NE(row.find("| " + FormatNumber(median) + " |"), std::string::npos) << row;
    EXPECT_NE(row.find("| " + FormatNumber(rmse) + " |"), std::string::npos) << row;
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

//--------------------------------------------------------------------------------------------------
TEST_F(BenchmarkRun, PicturesAreComparedWithThePictureOfTheTruth)
{
  const double plain = Get("plain").PictureErrors.Rmse;
  const double hard = Get("sampled map_size=512 samples=1").PictureErrors.Rmse;
  const double soft = Get("sampled map_size=512 samples=64").PictureErrors.Rmse;
  EXPECT_EQ(Get("plain").PictureErrors.Pixels, 96 * 64);
  EXPECT_GT(plain, 3.0 * hard);
  EXPECT_GT(hard, 3.0 * soft);
  EXPECT_LT(soft, 0.005);
  EXPECT_GT(Get("sampled map_size=512 samples=64").PictureErrors.Ssim, 0.999);
}

//--------------------------------------------------------------------------------------------------
TEST(HardShadowContestant, ShowsVtksShadowInASquareWindow)
{
  // In others vtkShadowMapPass samples its map with another aspect than it was drawn with.
  BenchmarkSettings settings;
  settings.ReferenceSamplesPerAxis = 1;
  settings.Rounds = 1;
  BenchmarkScene scene = MakeScene();
  scene.Width = 96;
  scene.Height = 96;
  const SceneResult result = BenchmarkRunner(settings, CreateContestantPass, CacheReferences(""))
                               .Run(scene, { { "vtk", {} } });
  ASSERT_EQ(result.Contestants.size(), 1U);
  ASSERT_EQ(result.Contestants[0].Failure, "");
  EXPECT_GT(result.Contestants[0].Errors[0].All.Pixels, 5000);
  EXPECT_LT(result.Contestants[0].RmseToHard, 0.15);
}

//--------------------------------------------------------------------------------------------------
TEST(BenchmarkRunner, LeavesOutWhatTheScenesTimeDoesNotSufficeFor)
{
  BenchmarkSettings settings;
  settings.ReferenceSamplesPerAxis = 1;
  settings.SecondsPerScene = 1e-6;
  const BenchmarkRunner runner(settings, CreateContestantPass, CacheReferences(""));
  const SceneResult result =
    runner.Run(MakeScene(), { { "plain", {} }, { "rays", {} }, { "vtk", {}, true } });
  ASSERT_EQ(result.Contestants.size(), 3U);
  EXPECT_NE(result.Contestants[1].Failure.find("left out"), std::string::npos);
  EXPECT_EQ(result.Contestants[2].Failure, "") << "what is essential is measured";
}

}

//--------------------------------------------------------------------------------------------------
TEST(Contestants, NameTheOptionThatIsNoNumber)
{
  for (const ContestantChoice& choice : { ContestantChoice{ "vtk", { { "map_size", "big" } } },
         ContestantChoice{ "rays", { { "samples", "99999999999" } } },
         ContestantChoice{ "sampled", { { "supersample", "2x" } } },
         ContestantChoice{ "sampled", { { "light_scale", "wide" } } } })
  {
    const std::string option = choice.Options.begin()->first;
    try
    {
      MakeContestant(
        choice, [] { return vtkSmartPointer<vtkRenderer>::New(); }, 8, 8, CreateContestantPass);
      ADD_FAILURE() << option << ": no error";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(std::string(error.what()).find(choice.Technique + ": " + option), 0U)
        << error.what();
    }
  }
}
