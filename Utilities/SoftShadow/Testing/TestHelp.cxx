// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the tool says of itself: help, version, suggestions, qualities; manual and completion, which
// must not fall behind.

#include "ToolRun.h"

#include "vtkSoftShadowsVersion.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

class Help : public ToolTest
{
};

//--------------------------------------------------------------------------------------------------
std::set<std::string> Matches(const std::string& text, const char* expression)
{
  const std::regex regex(expression);
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
  {
    found.insert((*match)[1]);
  }
  return found;
}

//--------------------------------------------------------------------------------------------------
std::string SourceFile(const std::string& name)
{
  std::ifstream file(std::string(SOFTSHADOWS_TOOL_SOURCE_DIR) + "/" + name, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

//--------------------------------------------------------------------------------------------------
std::set<std::string> Commands(const std::string& help)
{
  const std::size_t start = help.find("Subcommands:");
  return Matches(help.substr(start, help.find("Examples:") - start), "\n  ([a-z]+) ");
}

}

TEST_F(Help, ShowsCommandsAndExamples)
{
  const ToolResult result = this->Run("--help");
  EXPECT_EQ(result.ExitCode, 0);
  EXPECT_THAT(Commands(result.Output), IsSupersetOf({ "render", "compare" }));
  EXPECT_THAT(result.Output, HasSubstr("Examples:"));
}

TEST_F(Help, ShowsTheVersion)
{
  const ToolResult result = this->Run("--version");
  EXPECT_EQ(result.ExitCode, 0);
  EXPECT_THAT(result.Output, HasSubstr("softshadow " SOFTSHADOWS_VERSION));
}

TEST_F(Help, SuggestsCommandsAndOptions)
{
  EXPECT_THAT(this->Run("rendre a.ply -o a.png").Output, HasSubstr("did you mean 'render'?"));
  EXPECT_THAT(this->Run("render a.ply -o a.png --techniqe=pcss").Output,
    HasSubstr("did you mean '--technique'?"));
  EXPECT_THAT(this->Run("render a.ply -o a.png --frobnicate").Output, Not(HasSubstr("did you")));
  EXPECT_THAT(this->Run("render a.ply -o a.png --quality god").Output,
    HasSubstr("did you mean 'good'? Known are: draft, good, best"));
  EXPECT_THAT(this->Run("render a.ply -o a.png --technique ssabss --quality best").Output,
    HasSubstr("technique 'ssabss' has no quality 'best': "));
}

TEST_F(Help, ManualNamesEveryCommandAndOption)
{
  const std::string manual = SourceFile("softshadow.1");
  for (const std::string& command : Commands(this->Run("--help").Output))
  {
    EXPECT_THAT(manual, HasSubstr("\n.SS " + command + "\n"));
    for (std::string option :
      Matches(this->Run(command + " --help").Output, "(?:^|[ ,\n])--([a-z][a-z-]*)"))
    {
      option = std::regex_replace(option, std::regex("-"), "\\-");
      if (option != "help")
      {
        EXPECT_THAT(manual, HasSubstr("\\-\\-" + option)) << command;
      }
    }
  }
}

TEST_F(Help, CompletesFromTheTool)
{
  struct Line
  {
    const char* Words;
    std::vector<std::string> Completed;
  };
  const std::vector<Line> lines = {
    { "softshadow ren", { "render" } },
    { "softshadow render --tech", { "--technique" } },
    { "softshadow render --technique ps", {} },
    { "softshadow render --technique pc", { "pcss" } },
    { "softshadow render --technique sampled --option sam", { "samples=" } },
    { "softshadow render --quality b", { "best" } },
  };
  std::string script = "softshadow() { \"" SOFTSHADOWS_TOOL "\" \"$@\"; }\n" +
    SourceFile("softshadow.bash-completion") +
    "\nfor line in \"$@\"; do\n  COMP_WORDS=($line); COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
    "  _softshadow; echo \"${COMPREPLY[*]}\"\ndone\n";
  this->Write("complete.sh", script);
  for (const Line& line : lines)
  {
    const ToolResult result =
      this->Run("--version >/dev/null; bash complete.sh '" + std::string(line.Words) + "'");
    std::istringstream words(result.Output);
    const std::vector<std::string> completed{ std::istream_iterator<std::string>(words),
      std::istream_iterator<std::string>() };
    EXPECT_EQ(completed, line.Completed) << line.Words;
  }
}

TEST_F(Help, QualitiesAreSettingsThatOptionsOverrule)
{
  this->Write("scene.json", R"({ "version": 1, "image": {"width": 16, "height": 16},
    "lights": [{"position": [0, 0, 5], "size": [0.2, 0.2]}], "objects": [{"source": "box"}] })");
  const auto samples = [this](const std::string& arguments)
  {
    const ToolResult result =
      this->Run("render scene.json --technique sampled --report r.json " + arguments);
    EXPECT_EQ(result.ExitCode, 0) << result.Output;
    return *Matches(this->Read("r.json"), "\"samples\": \"?([0-9]+)").begin();
  };
  const int draft = std::stoi(samples("--quality draft"));
  const int good = std::stoi(samples(""));
  EXPECT_LT(draft, good);
  EXPECT_LT(good, std::stoi(samples("--quality best")));
  EXPECT_EQ(samples("--option samples=3 --quality draft"), "3");
}
