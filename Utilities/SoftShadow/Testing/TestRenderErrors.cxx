// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// softshadow render: what is wrong is named, the exit code is 1, and nothing is written.

#include "ToolRun.h"

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace
{

const std::string Data = SOFTSHADOWS_TEST_DATA_DIR;

const char* const Scene = R"({ "version": 1, "image": {"width": 16, "height": 16},
  "lights": [{"position": [0, 0, 5], "size": [0.2, 0.2]}],
  "objects": [{"source": "box"}] })";

struct WrongRun
{
  const char* Name;
  const char* Arguments;
  const char* Message; ///< A part of it.
};

std::ostream& operator<<(std::ostream& os, const WrongRun& run)
{
  return os << run.Name;
}

class RenderErrors
  : public ToolTest
  , public testing::WithParamInterface<WrongRun>
{
};

class RenderFailures : public ToolTest
{
};

std::string NameOf(const testing::TestParamInfo<WrongRun>& info)
{
  return info.param.Name;
}

}

TEST_P(RenderErrors, AreNamedAndNothingIsWritten)
{
  const WrongRun& wrong = this->GetParam();
  this->Write("scene.json", Scene);
  this->Write(
    "key.json", "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"colour\": 1}]}");
  this->Write("model.json", "{\"version\": 1,\n\"objects\": [\n{\"file\": \"no.ply\"}]}");
  this->Write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
  this->Write("old.png", "old");
  const std::set<std::string> before = this->Files();
  const ToolResult result = this->Run(wrong.Arguments);
  EXPECT_EQ(result.ExitCode, 1) << result.Output;
  EXPECT_NE(result.Output.find(wrong.Message), std::string::npos) << result.Output;
  EXPECT_EQ(this->Files(), before);
  EXPECT_EQ(this->Read("old.png"), "old");
  EXPECT_EQ(this->Read("scene.json"), Scene);
}

INSTANTIATE_TEST_SUITE_P(Arguments, RenderErrors,
  testing::Values(WrongRun{ "NoCommand", "", "render" },
    WrongRun{ "UnknownCommand", "rendre scene.json -o a.png", "rendre" },
    WrongRun{ "NoInput", "render -o a.png", "required" },
    WrongRun{ "NoOutput", "render scene.json", "nothing to write" },
    WrongRun{ "UnknownFlag", "render scene.json -o a.png --techniqe pcss", "--techniqe" },
    WrongRun{ "UnknownTechnique", "render scene.json -o old.png --technique pccs",
      "there is no technique 'pccs'; did you mean 'pcss'? Known are: sampled, pcss" },
    WrongRun{ "UnknownOption", "render scene.json -o old.png --option samlpes=4",
      "technique 'pcss' has no option 'samlpes'" },
    WrongRun{ "OptionWithoutValue", "render scene.json -o a.png --option split", "NAME=VALUE" },
    WrongRun{ "OptionOutOfRange", "render scene.json -o a.png --option map_size=7",
      "option 'map_size': must be a whole number from 32 to 16384, is '7'" },
    WrongRun{ "OptionNotANumber", "render scene.json -o a.png --option map_size=big", "is 'big'" },
    WrongRun{ "TwoScenes", "render scene.json scene.json -o a.png", "give one scene" },
    WrongRun{ "SceneAndModel", "render cut.ply scene.json -o a.png", "give one scene" },
    WrongRun{ "UpOfNoAxis", "render cut.ply -o a.png --up q", "--up" },
    WrongRun{ "WidthZero", "render scene.json -o a.png --width 0", "--width" }),
  NameOf);

// What is no number, or none that counts to an end.
INSTANTIATE_TEST_SUITE_P(Numbers, RenderErrors,
  testing::Values(WrongRun{ "ConvergeNan", "render scene.json -o a.png --converge nan",
                    "--converge: must be a number from 0.0001 to 1, is 'nan'" },
    WrongRun{ "ConvergeInfinite", "render scene.json -o a.png --converge inf", "is 'inf'" },
    WrongRun{ "ConvergeNothing", "render scene.json -o a.png --converge ''", "--converge" },
    WrongRun{ "ConvergeTooSmall", "render scene.json -o a.png --converge 1e-5",
      "must be a number from 0.0001 to 1, is '1e-5'" },
    WrongRun{ "FramesNan", "render scene.json -o a.png --converge 0.1 --converge-frames nan",
      "must be a whole number from 1 to 1000000, is 'nan'" },
    WrongRun{ "WidthNan", "render scene.json -o a.png --width nan",
      "--width: must be a whole number from 1 to 16384, is 'nan'" },
    WrongRun{ "HeightInfinite", "render scene.json -o a.png --height -inf", "--height" },
    WrongRun{ "HeightHuge", "render scene.json -o a.png --height 99999999999999999999",
      "must be a whole number from 1 to 16384" },
    WrongRun{ "HeightHalf", "render scene.json -o a.png --height 16.5", "a whole number" },
    WrongRun{ "OptionNan", "render scene.json -o a.png --option map_size=nan", "is 'nan'" },
    WrongRun{ "OptionInfinite",
      "render scene.json -o a.png --technique cascaded --option "
      "lambda=inf",
      "must be a number from 0 to 1, is 'inf'" }),
  NameOf);

INSTANTIATE_TEST_SUITE_P(Inputs, RenderErrors,
  testing::Values(WrongRun{ "NoSuchScene", "render no.json -o old.png", "no.json: no such file" },
    WrongRun{ "NoSuchModel", "render no.ply -o old.png", "no such file 'no.ply'" },
    WrongRun{ "OtherKind", "render scene.txt -o a.png", "'scene.txt' is no model" },
    WrongRun{ "UnknownKey", "render key.json -o old.png",
      "key.json:3: objects[0].colour: unknown key; did you mean 'color'?" },
    WrongRun{ "MissingModel", "render model.json -o old.png --visibility v.exr --report r.json",
      "model.json:3: objects[0].file: no such file 'no.ply'" },
    WrongRun{ "TruncatedModel", "render cut.ply -o old.png", "truncated" }),
  NameOf);

INSTANTIATE_TEST_SUITE_P(Outputs, RenderErrors,
  testing::Values(
    WrongRun{ "UnknownFormat", "render scene.json -o a.pictures", "of no known format" },
    WrongRun{ "NoFormat", "render scene.json -o picture", "of no known format" },
    WrongRun{ "NoFolder", "render scene.json -o no/such/a.png", "there is no folder no/such" },
    WrongRun{ "FolderInPlace", "render scene.json -o ..png --report ..", "is a folder" },
    WrongRun{ "VisibilityFormat", "render scene.json --visibility v.png", "must end in .exr" },
    WrongRun{
      "OverInput", "render scene.json -o a.png --report ./scene.json", "would overwrite an input" },
    WrongRun{
      "TwiceTheSame", "render scene.json -o a.exr --visibility ./a.exr", "is to be written twice" },
    WrongRun{ "SecondOutputFails", "render scene.json -o old.png --report no/such/r.json",
      "there is no folder" }),
  NameOf);

TEST_F(RenderFailures, SayWhatToInstallWhereThereIsNoDisplay)
{
  this->Write("scene.json", Scene);
  const ToolResult result =
    this->Run("render scene.json -o a.png", "-u DISPLAY PATH=/no/such/folder");
  if (result.ExitCode == 0)
  {
    GTEST_SKIP() << "this VTK needs no display";
  }
  EXPECT_EQ(result.ExitCode, 1) << result.Output;
  EXPECT_NE(result.Output.find("apt-get install xvfb"), std::string::npos) << result.Output;
  EXPECT_EQ(this->Files(), std::set<std::string>{ "scene.json" });
}

#ifdef __linux__

// A full disk, as far as a test can have one.
TEST_F(RenderFailures, NameTheOutputThatIsFull)
{
  this->Write("scene.json", Scene);
  this->Write("old.png", "old");
  std::filesystem::create_symlink("/dev/full", this->Folder / "full.exr");
  const std::set<std::string> before = this->Files();
  for (const char* full : { "--visibility full.exr", "--report /dev/full" })
  {
    const ToolResult result = this->Run(std::string("render scene.json -o old.png ") + full);
    EXPECT_EQ(result.ExitCode, 1) << result.Output;
    EXPECT_NE(result.Output.find("/dev/full: cannot be written"), std::string::npos)
      << result.Output;
    EXPECT_EQ(this->Files(), before);
    EXPECT_EQ(this->Read("old.png"), "old");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << "replaced";
  }
}

TEST_F(RenderFailures, LeaveNothingWhenLimitedInSize)
{
  this->Write("scene.json", Scene);
  const std::set<std::string> before = this->Files();
  for (const char* output :
    { "-o a.png", "-o a.exr", "-o a.jpg", "-o a.tif", "--visibility a.exr", "--report a.json" })
  {
    const ToolResult result =
      this->Run(std::string("render scene.json ") + output, "prlimit --fsize=100");
    EXPECT_EQ(result.ExitCode, 1) << output << ": " << result.Output;
    EXPECT_NE(result.Output.find("softshadow: a."), std::string::npos) << result.Output;
    EXPECT_NE(result.Output.find(": cannot be written"), std::string::npos) << result.Output;
    EXPECT_EQ(this->Files(), before) << output;
  }
}

TEST_F(RenderFailures, LeaveNothingWhenEndedByASignal)
{
  this->Write("scene.json", Scene);
  this->Write("old.png", "old");
  const std::set<std::string> before = this->Files();
  const ToolResult result =
    this->Run("render scene.json -o old.png --report r.json --width 600 --height 600 --converge "
              "0.0001 --converge-frames 1000000 --option map_size=8192 --option split=8",
      "timeout -s TERM 2");
  EXPECT_NE(result.ExitCode, 0) << "it was through before the signal came";
  EXPECT_EQ(this->Files(), before);
  EXPECT_EQ(this->Read("old.png"), "old");
}

TEST_F(RenderFailures, AreNoneWhereAnOutputIsALinkOrAStream)
{
  this->Write("scene.json", Scene);
  this->Write("target.json", "old");
  std::filesystem::create_symlink("target.json", this->Folder / "link.json");
  EXPECT_EQ(this->Run("render scene.json --report link.json").ExitCode, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(this->Folder / "link.json"));
  EXPECT_EQ(this->Read("target.json").front(), '{');
  const ToolResult result = this->Run("render scene.json --report /dev/stdout");
  EXPECT_EQ(result.ExitCode, 0);
  EXPECT_NE(result.Output.find("\"technique\""), std::string::npos) << result.Output;
  EXPECT_TRUE(std::filesystem::exists("/dev/stdout"));
}

TEST_F(RenderFailures, AreNoneWhereTheTargetOfALinkIsYetToCome)
{
  this->Write("scene.json", Scene);
  std::filesystem::create_directory(this->Folder / "deep");
  std::filesystem::create_symlink("deep/second.json", this->Folder / "first.json");
  std::filesystem::create_symlink("target.json", this->Folder / "deep" / "second.json");
  EXPECT_EQ(this->Run("render scene.json --report first.json").ExitCode, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(this->Folder / "first.json"));
  EXPECT_TRUE(std::filesystem::is_symlink(this->Folder / "deep" / "second.json"));
  EXPECT_EQ(this->Read("deep/target.json").front(), '{');
}

// A log that the standard output is appended to.
TEST_F(RenderFailures, KeepWhatAnOpenFileHolds)
{
  this->Write("scene.json", Scene);
  this->Write("log", "before\n");
  EXPECT_EQ(this->Run("render scene.json --report /dev/stdout >> log").ExitCode, 0);
  const std::string log = this->Read("log");
  EXPECT_EQ(log.find("before\n"), 0u) << log;
  EXPECT_NE(log.find("\"technique\""), std::string::npos) << log;
}

#endif

TEST_F(RenderFailures, AreNoneWhereHelpIsAskedFor)
{
  EXPECT_EQ(this->Run("--help").ExitCode, 0);
  const ToolResult help = this->Run("render --help");
  EXPECT_EQ(help.ExitCode, 0);
  for (const char* flag : { "--technique", "--option", "--models", "--visibility", "--report" })
  {
    EXPECT_NE(help.Output.find(flag), std::string::npos) << flag;
  }
}
