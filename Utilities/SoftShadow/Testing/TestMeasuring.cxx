// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// softshadow compare, reference and benchmark: what they write, and what they refuse.

#include "ToolRun.h"

#include "VisibilityFile.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

using namespace softshadows;

namespace
{

const float NaN = std::numeric_limits<float>::quiet_NaN();

// From above, parallel, 16 pixels a unit: a square of 1 x 1 at z = 1 under a light of 0.4 x 0.4 at
// z = 3, over a ground. The penumbra at each edge is 0.2 wide,
// around +-0.75.
const char* const SquareScene = R"({ "version": 1,
  "image":  {"width": 64, "height": 48},
  "camera": {"position": [0, 0, 10], "view_up": [0, 1, 0], "parallel_scale": 1.5},
  "lights": [ {"position": [0, 0, 3], "size": [0.4, 0.4], "cone_angle": 60} ],
  "objects": [
    {"source": "plane", "origin": [-9, -9, 0], "point1": [9, -9, 0], "point2": [-9, 9, 0]},
    {"source": "plane", "origin": [-0.5, -0.5, 1], "point1": [0.5, -0.5, 1],
     "point2": [-0.5, 0.5, 1]} ] })";

//--------------------------------------------------------------------------------------------------
class Measuring : public ToolTest
{
protected:
  std::string PathOf(const std::string& name) const { return (this->Folder / name).string(); }

  nlohmann::json ReadJson(const std::string& name) const
  {
    return nlohmann::json::parse(this->Read(name));
  }

  /// 4 x 2 pixels of two lights; the second pixel of the first light is off by the error.
  void WritePair(float error) const
  {
    VisibilityImage image;
    image.Width = 4;
    image.Height = 2;
    image.Visibility = { { 0.0F, 0.5F, 1.0F, 1.0F, NaN, 0.25F, 1.0F, 0.0F },
      std::vector<float>(8, 1.0F) };
    image.Depth = std::vector<float>(8, 3.0F);
    WriteVisibility(this->PathOf("truth.exr"), image);
    image.Visibility[0][1] += error;
    WriteVisibility(this->PathOf("ours.exr"), image);
  }
};

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, CompareWritesNumbersAndPictures)
{
  this->WritePair(0.25F);
  const ToolResult run =
    this->Run("compare truth.exr ours.exr --diff diff.png --report report.json");
  EXPECT_EQ(run.ExitCode, 0) << run.Output;
  EXPECT_NE(run.Output.find("rmse"), std::string::npos);
  const nlohmann::json report = this->ReadJson("report.json");
  ASSERT_EQ(report.at("lights").size(), 2U);
  const nlohmann::json& first = report["lights"][0];
  EXPECT_EQ(first.at("all").at("pixels"), 7);
  EXPECT_NEAR(first["all"].at("rmse").get<double>(), std::sqrt(0.0625 / 7.0), 1e-12);
  EXPECT_EQ(first.at("penumbra").at("pixels"), 2);
  EXPECT_EQ(first["penumbra"].at("maximum"), 0.25);
  EXPECT_EQ(report["lights"][1].at("all").at("rmse"), 0.0);
  EXPECT_TRUE(report["lights"][1]["all"].at("psnr").is_null()) << "equal images";
  EXPECT_EQ(this->Files(),
    (std::set<std::string>{ "truth.exr", "ours.exr", "diff.png", "diff-1.png", "report.json" }));
}

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, CompareTakesOneLight)
{
  this->WritePair(0.25F);
  const ToolResult run = this->Run("compare truth.exr ours.exr --light 1 --report report.json");
  EXPECT_EQ(run.ExitCode, 0) << run.Output;
  const nlohmann::json report = this->ReadJson("report.json");
  ASSERT_EQ(report.at("lights").size(), 1U);
  EXPECT_EQ(report["lights"][0].at("light"), 1);
}

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, NumbersOutOfTheirRangeAreRefusedWithTheRange)
{
  this->WritePair(0.25F);
  this->Write("square.json", SquareScene);
  const struct
  {
    const char* Arguments;
    const char* Message;
  } cases[] = {
    { "compare truth.exr ours.exr --light -1",
      "--light -1: must be a whole number from 0 to 1; truth.exr has 4 x 2 pixels and 2 light(s)" },
    { "compare truth.exr ours.exr --light 2", "--light 2: must be a whole number from 0 to 1" },
    { "compare truth.exr ours.exr --light nan", "--light" },
    { "compare truth.exr ours.exr --diff d.png --diff-range nan", "must be a number above 0" },
    { "compare truth.exr ours.exr --diff d.png --diff-range -1", "above 0, is '-1'" },
    { "compare truth.exr ours.exr --diff d.png --diff-range inf", "above 0, is 'inf'" },
#ifdef SOFTSHADOWS_HAVE_RAY_TRACING
    { "reference square.json -o a.exr --samples nan", "from 1 to 1048576, is 'nan'" },
    { "reference square.json -o a.exr --pilot inf", "from 1 to 1048576, is 'inf'" },
    { "reference square.json -o a.exr --width 0", "from 1 to 16384, is '0'" },
    { "benchmark --output out --budget nan", "--budget: must be a number above 0, is 'nan'" },
    { "benchmark --output out --budget -5", "above 0, is '-5'" },
    { "benchmark --output out --seconds inf", "above 0, is 'inf'" },
    { "benchmark --output out --paper pcss --paper-scale nan", "from 0.05 to 4, is 'nan'" },
    { "benchmark --output out --rounds nan", "from 1 to 1000, is 'nan'" },
    { "benchmark --output out --width 8", "from 16 to 8192, is '8'" },
    { "benchmark --output out --reference-samples 0", "from 1 to 1048576, is '0'" },
#endif
  };
  const std::set<std::string> before = this->Files();
  for (const auto& test : cases)
  {
    const ToolResult run = this->Run(test.Arguments);
    EXPECT_EQ(run.ExitCode, 1) << test.Arguments << ": " << run.Output;
    EXPECT_NE(run.Output.find(test.Message), std::string::npos) << run.Output;
    EXPECT_LT(run.Output.size(), 250U) << "a line that can be read: " << run.Output;
    EXPECT_EQ(this->Files(), before) << test.Arguments;
  }
}

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, CompareRefusesOtherSizesAndItsOwnInputs)
{
  this->WritePair(0.0F);
  VisibilityImage other;
  other.Width = 2;
  other.Height = 2;
  other.Visibility = { { 1.0F, 1.0F, 1.0F, 1.0F } };
  WriteVisibility(this->PathOf("other.exr"), other);
  const ToolResult run = this->Run("compare truth.exr other.exr --report report.json");
  EXPECT_NE(run.ExitCode, 0);
  EXPECT_NE(run.Output.find("other.exr has 2 x 2 pixels"), std::string::npos) << run.Output;
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "truth.exr", "ours.exr", "other.exr" }));
  EXPECT_NE(this->Run("compare truth.exr ours.exr --report ours.exr").ExitCode, 0);
}

#ifdef SOFTSHADOWS_HAVE_RAY_TRACING

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, ReferenceIsTheClosedForm)
{
  this->Write("square.json", SquareScene);
  const ToolResult run = this->Run("reference square.json -o truth.exr --samples 4000");
  EXPECT_EQ(run.ExitCode, 0) << run.Output;
  const VisibilityImage image = ReadVisibility(this->PathOf("truth.exr"));
  ASSERT_EQ(image.Width, 64);
  ASSERT_EQ(image.Height, 48);
  ASSERT_EQ(image.Visibility.size(), 1U);
  int penumbra = 0;
  for (int row = 0; row < 48; ++row)
  {
    for (int column = 0; column < 64; ++column)
    {
      const double x = (column + 0.5 - 32.0) / 16.0;
      const double y = (24.0 - row - 0.5) / 16.0;
      if (std::abs(x) < 0.5 && std::abs(y) < 0.5)
      {
        continue; // the square itself
      }
      // The edge at 0.5 and z = 1, seen from p, stands before the point 3 * 0.5 - 2 p of the light.
      const auto blocked = [](double p)
      {
        const auto share = [](double edge)
        { return std::min(1.0, std::max(0.0, (edge + 0.2) / 0.4)); };
        return share(1.5 - 2.0 * p) - share(-1.5 - 2.0 * p);
      };
      const double expected = 1.0 - blocked(x) * blocked(y);
      EXPECT_NEAR(image.Visibility[0][row * 64 + column], expected, 0.02) << x << ", " << y;
      penumbra += expected > 0.02 && expected < 0.98 ? 1 : 0;
    }
  }
  EXPECT_GT(penumbra, 200);
}

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, BenchmarkReportsGoodAndBrokenScenes)
{
  std::filesystem::create_directories(this->Folder / "scenes");
  this->Write("scenes/square.json", SquareScene);
  this->Write("scenes/torn.json", "{ \"version\": 1,");
  const ToolResult run = this->Run(
    "benchmark --scenes scenes --output out --only square,torn --rounds 2 --reference-samples 256"
    " --contestant plain --contestant 'sampled samples=4 map_size=256'");
  EXPECT_EQ(run.ExitCode, 1) << run.Output;
  EXPECT_NE(run.Output.find("torn.json:"), std::string::npos) << run.Output;
  EXPECT_NE(run.Output.find("1 of 2 scenes failed"), std::string::npos) << run.Output;
  const nlohmann::json json = this->ReadJson("out/benchmark.json");
  const nlohmann::json& scenes = json.at("soft_shadows").at("scenes");
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_EQ(scenes[0].at("name"), "square");
  const nlohmann::json& sampled = scenes[0].at("contestants")[1];
  EXPECT_EQ(sampled.at("name"), "sampled map_size=256 samples=4");
  EXPECT_EQ(sampled.at("milliseconds").at("light").at("frames"), 2);
  EXPECT_NE(scenes[1].value("failure", ""), "");
  EXPECT_NE(
    this->Read("out/benchmark.html").find("sampled map_size=256 samples=4"), std::string::npos);
  EXPECT_EQ(this->Read("out/benchmark.csv").rfind("scene,contestant,", 0), 0U);
  const ToolResult unknown = this->Run("benchmark --scenes scenes --output out --only round");
  EXPECT_NE(unknown.ExitCode, 0);
  EXPECT_NE(unknown.Output.find("square"), std::string::npos) << "names what there is";
}

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, BenchmarkNamesAFolderOfNoUse)
{
  std::filesystem::create_directories(this->Folder / "empty");
  std::filesystem::create_directories(this->Folder / "closed");
  this->Write("file", "no folder");
  std::filesystem::permissions(this->Folder / "closed", std::filesystem::perms::none);
  const struct
  {
    std::string Arguments;
    const char* Message;
  } cases[] = {
    { "--output out --scenes nowhere", "folder of scenes, nowhere: No such file or directory" },
    { "--output out --scenes file", "folder of scenes, file: Not a directory" },
    { "--output out --scenes empty", "folder of scenes, empty: there is no scene file in it" },
    { "--output out --scenes closed", "closed: " }, // the superuser may read it, and finds nothing
    { "--output file/out", "file/out: Not a directory" },
    { "--write-models file", "file: " },
  };
  const std::set<std::string> before = this->Files();
  for (const auto& test : cases)
  {
    const ToolResult run = this->Run("benchmark --contestant plain " + test.Arguments);
    EXPECT_EQ(run.ExitCode, 1) << test.Arguments << ": " << run.Output;
    EXPECT_NE(run.Output.find(test.Message), std::string::npos) << run.Output;
    EXPECT_EQ(run.Output.find("filesystem error"), std::string::npos) << run.Output;
    EXPECT_EQ(this->Files(), before) << test.Arguments;
  }
  std::filesystem::permissions(this->Folder / "closed", std::filesystem::perms::owner_all);
}

//--------------------------------------------------------------------------------------------------
// A bar on a terminal, and nothing of it in a file or a pipe.
TEST_F(Measuring, ProgressIsForTerminalsOnly)
{
  this->Write("square.json", SquareScene);
  const std::string reference = "reference square.json -o truth.exr --samples 16";
  const ToolResult piped = this->Run(reference);
  EXPECT_EQ(piped.ExitCode, 0);
  EXPECT_EQ(piped.Output, "");
  std::filesystem::create_directories(this->Folder / "scenes");
  this->Write("scenes/square.json", SquareScene);
  const ToolResult benchmark = this->Run(
    "benchmark --scenes scenes --output out --rounds 1 --reference-samples 16 --contestant plain");
  EXPECT_EQ(benchmark.ExitCode, 0) << benchmark.Output;
  EXPECT_EQ(benchmark.Output.find_first_of("\r\x1b"), std::string::npos) << benchmark.Output;
#ifdef __linux__
  this->Write("terminal.sh", "script -qec \"$*\" /dev/null\n"); // which gives it a terminal
  const ToolResult shown = this->Run(reference, "sh terminal.sh");
  if (shown.ExitCode != 127)
  {
    EXPECT_NE(shown.Output.find("###] 100 %"), std::string::npos) << shown.Output;
  }
#endif
}

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, BenchmarkRefusesUnknownContestants)
{
  std::filesystem::create_directories(this->Folder / "scenes");
  this->Write("scenes/square.json", SquareScene);
  const ToolResult run =
    this->Run("benchmark --scenes scenes --output out --only square --contestant nonsense");
  EXPECT_EQ(run.ExitCode, 1) << run.Output;
  EXPECT_NE(run.Output.find("no technique nonsense"), std::string::npos) << run.Output;
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out")) << "nothing was begun";
}

//--------------------------------------------------------------------------------------------------
TEST_F(Measuring, BenchmarkTracesReferencesBeforeItsBudgetBegins)
{
  std::filesystem::create_directories(this->Folder / "scenes");
  this->Write("scenes/square.json", SquareScene);
  this->Write("scenes/torn.json", "{ \"version\": 1,");
  const std::string benchmark = "benchmark --scenes scenes --output out --only square,torn"
                                " --rounds 1 --reference-samples 16 --contestant plain ";
  const ToolResult prepared = this->Run(benchmark + "--references-only");
  EXPECT_EQ(prepared.ExitCode, 1) << prepared.Output;
  EXPECT_NE(prepared.Output.find("1 of 2 scenes failed"), std::string::npos) << prepared.Output;
  const ToolResult run = this->Run(benchmark + "--budget 20");
  const std::size_t reference = run.Output.find("square: reference is there");
  ASSERT_NE(reference, std::string::npos) << run.Output;
  EXPECT_LT(reference, run.Output.find("square: plain")) << run.Output;
}

#endif

}
