// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// softshadow render: what it writes.

#include "ToolRun.h"

#include "VisibilityFile.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

using namespace softshadows;

namespace
{

const std::string Data = SOFTSHADOWS_TEST_DATA_DIR;

// From above, parallel, one world unit is 16 pixels: a square of 1 x 1 at z = 1 over a ground of
// 3.5 x 3.5 in a view of 4 x 4. The first light, 0.2 x 0.2 at z = 5, stands over the centre. The
// second, a point with a cone of 11.3 degrees, lights a circle of radius 0.2 x 5 = 1 on the ground.
const char* const SquareScene = R"({ "version": 1,
  "image":  {"width": 64, "height": 64},
  "camera": {"position": [0, 0, 10], "view_up": [0, 1, 0], "parallel_scale": 2},
  "lights": [
    {"position": [0, 0, 5], "size": [0.2, 0.2]},
    {"position": [1, 0, 5], "focal_point": [1, 0, 0], "shape": "point", "cone_angle": 11.309932} ],
  "objects": [
    {"source": "plane", "origin": [-1.75, -1.75, 0], "point1": [1.75, -1.75, 0],
     "point2": [-1.75, 1.75, 0]},
    {"source": "plane", "origin": [-0.5, 0.5, 1], "point1": [0, 0.5, 1], "point2": [-0.5, 1, 1]},
    {"source": "plane", "origin": [0.5, -1.5, 2], "point1": [1, -1.5, 2], "point2": [0.5, -1, 2],
     "cast_shadow": false, "receive_shadow": false} ] })";

class Render : public ToolTest
{
protected:
  VisibilityImage ReadExr(const std::string& name) const
  {
    return ReadVisibility((this->Folder / name).string());
  }

  OIIO::ImageBuf ReadPicture(const std::string& name) const
  {
    OIIO::ImageBuf picture((this->Folder / name).string());
    EXPECT_TRUE(picture.read()) << picture.geterror();
    return picture;
  }
};

/// The pixel at a point of the ground of the square scene.
std::size_t PixelAt(double x, double y)
{
  const auto column = static_cast<std::size_t>(std::floor(16.0 * (x + 2.0)));
  const auto row = static_cast<std::size_t>(std::floor(16.0 * (2.0 - y))); // the top row first
  return 64 * row + column;
}

}

TEST_F(Render, WritesPictureVisibilityAndReport)
{
  this->Write("scene.json", SquareScene);
  const ToolResult result = this->Run("render scene.json -o picture.png --technique sampled "
                                      "--option samples=16 --option map_size=1024 "
                                      "--visibility v.exr --report r.json");
  ASSERT_EQ(result.ExitCode, 0) << result.Output;
  EXPECT_EQ(result.Output, "");
  EXPECT_EQ(
    this->Files(), (std::set<std::string>{ "scene.json", "picture.png", "v.exr", "r.json" }));

  const OIIO::ImageBuf picture = this->ReadPicture("picture.png");
  EXPECT_EQ(picture.spec().width, 64);
  EXPECT_EQ(picture.spec().height, 64);
  EXPECT_EQ(picture.spec().nchannels, 3);

  const auto report = nlohmann::json::parse(this->Read("r.json"));
  EXPECT_EQ(report["technique"], "sampled");
  EXPECT_EQ(report["options"]["samples"], 16);
  EXPECT_EQ(report["options"]["map_size"], 1024);
  EXPECT_EQ(report["options"]["split"], 1);
  EXPECT_EQ(report["image"]["width"], 64);
  EXPECT_EQ(report["lights"].size(), 2u);
  EXPECT_EQ(report["counts"]["frames"], 1);
  EXPECT_GT(report["frame_milliseconds"], 0.0);
  EXPECT_TRUE(report["step_milliseconds"].contains("visibility"));
}

TEST_F(Render, WritesVisibilityAtPixelCentresTopRowFirst)
{
  this->Write("scene.json", SquareScene);
  const ToolResult result = this->Run("render scene.json --technique sampled --option samples=16 "
                                      "--option map_size=1024 --visibility v.exr");
  ASSERT_EQ(result.ExitCode, 0) << result.Output;
  const VisibilityImage image = this->ReadExr("v.exr");
  ASSERT_EQ(image.Width, 64);
  ASSERT_EQ(image.Height, 64);
  ASSERT_EQ(image.Visibility.size(), 2u);
  ASSERT_EQ(image.Depth.size(), 64u * 64u);

  // The first light throws the square from (-0.5 .. 0, 0.5 .. 1) at z = 1 onto the ground 5 / 4 as
  // large: (-0.625 .. 0, 0.625 .. 1.25), with penumbrae 0.05 wide.
  const std::vector<float>& first = image.Visibility[0];
  EXPECT_EQ(first[PixelAt(-0.56, 1.15)], 0.0f) << "umbra beside the square";
  EXPECT_EQ(first[PixelAt(-0.56, -1.15)], 1.0f) << "the same upside down is lit";
  EXPECT_EQ(first[PixelAt(0.56, 1.15)], 1.0f);
  EXPECT_EQ(first[PixelAt(-0.25, 0.75)], 1.0f) << "on the square itself";
  EXPECT_TRUE(std::isnan(first[PixelAt(-1.9, 1.9)])) << "no surface";
  EXPECT_TRUE(std::isnan(first[PixelAt(0.75, -1.25)])) << "receives no shadow";
  EXPECT_EQ(first[PixelAt(0.3, -0.4)], 1.0f) << "what casts none throws none";

  const std::vector<float>& second = image.Visibility[1];
  EXPECT_EQ(second[PixelAt(1.0, 0.0)], 1.0f);
  EXPECT_EQ(second[PixelAt(1.0, 0.9)], 1.0f) << "just inside the cone";
  EXPECT_TRUE(std::isnan(second[PixelAt(1.0, 1.1)])) << "just outside the cone";
  EXPECT_TRUE(std::isnan(second[PixelAt(-1.0, 0.0)]));

  EXPECT_NEAR(image.Depth[PixelAt(1.0, 1.0)], 10.0f, 1e-4);
  EXPECT_NEAR(image.Depth[PixelAt(-0.25, 0.75)], 9.0f, 1e-4);
  EXPECT_NEAR(image.Depth[PixelAt(0.75, -1.25)], 8.0f, 1e-4);
  EXPECT_TRUE(std::isnan(image.Depth[PixelAt(-1.9, 1.9)]));
}

TEST_F(Render, WritesLinearDepthOfAPerspectiveCamera)
{
  this->Write("scene.json", R"({"version": 1, "image": {"width": 65, "height": 33},
    "camera": {"position": [0, 0, 8], "view_angle": 60},
    "objects": [{"source": "plane", "origin": [-50, -50, 0], "point1": [50, -50, 0],
                 "point2": [-50, 50, 0]}]})");
  const ToolResult result = this->Run("render scene.json --visibility v.exr -o v.png");
  ASSERT_EQ(result.ExitCode, 0) << result.Output;
  // ReadVisibility asks for a light; this scene has none.
  OIIO::ImageBuf image((this->Folder / "v.exr").string());
  ASSERT_TRUE(image.read());
  ASSERT_EQ(image.spec().channelnames, std::vector<std::string>{ "depth" });
  EXPECT_EQ(image.spec().format, OIIO::TypeDesc::FLOAT);
  for (const int x : { 0, 32, 64 })
  {
    EXPECT_NEAR(image.getchannel(x, 0, 0, 0), 8.0f, 1e-4) << "along the view, not to the eye";
  }
}

TEST_F(Render, RendersWithEveryTechniqueThatIsListed)
{
  this->Write("scene.json", SquareScene);
  const ToolResult list = this->Run("--list-techniques");
  ASSERT_EQ(list.ExitCode, 0) << list.Output;
  std::istringstream lines(list.Output);
  int techniques = 0;
  for (std::string line; std::getline(lines, line);)
  {
    const std::string name = line.substr(0, line.find(' '));
    if (name.empty())
    {
      continue;
    }
    ++techniques;
    const ToolResult result = this->Run("render scene.json --technique " + name +
      " --option map_size=512 --visibility " + name + ".exr");
    ASSERT_EQ(result.ExitCode, 0) << result.Output;
    const VisibilityImage image = this->ReadExr(name + ".exr");
    EXPECT_NEAR(image.Visibility[0][PixelAt(-0.56, 1.15)], 0.0f, 0.02f) << name;
    EXPECT_NEAR(image.Visibility[0][PixelAt(1.5, -0.5)], 1.0f, 0.02f) << name;
  }
  EXPECT_GE(techniques, 2);
  for (const std::string arguments : { "--list-techniques --json", "--json --list-techniques" })
  {
    const ToolResult json = this->Run(arguments);
    EXPECT_EQ(json.ExitCode, 0) << json.Output;
    EXPECT_EQ(json.Output.rfind("{\n  \"techniques\": [", 0), 0u) << arguments << json.Output;
  }
}

TEST_F(Render, RendersModelsOfEveryKind)
{
  for (const std::string model : { "bunny.ply", "bunny.stl", "teapot.obj", "dragon.vtp" })
  {
    const ToolResult result = this->Run("render " + Data + "/" + model +
      " --width 80 --height 60 --option map_size=512 -o picture.png --visibility v.exr");
    ASSERT_EQ(result.ExitCode, 0) << result.Output;
    const VisibilityImage image = this->ReadExr("v.exr");
    ASSERT_EQ(image.Visibility.size(), 1u) << "one key light";
    int lit = 0;
    int blocked = 0;
    for (const float visibility : image.Visibility[0])
    {
      lit += visibility > 0.99f ? 1 : 0;
      blocked += visibility < 0.01f ? 1 : 0;
    }
    EXPECT_GT(lit, 80 * 60 / 4) << model;
    EXPECT_GT(blocked, 80 * 60 / 50) << model;
    // The model stands in the middle: nearer than the ground behind it.
    EXPECT_LT(image.Depth[80 * 30 + 40], image.Depth[80 * 5 + 40]) << model;
  }
}

TEST_F(Render, RendersBaseColorsOfGltf)
{
  // A tetrahedron, red and blue; what else there is is named.
  this->Write("scene.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 60, "uri":
    "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAIBAAMCAAEDAQID"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}},
      {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 1]}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]},
      {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 1}]},
      {"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}],
    "nodes": [{"mesh": 0}, {"mesh": 1, "translation": [1.5, 0, 0]}, {"mesh": 2}]})");
  const ToolResult result =
    this->Run("render scene.gltf --width 160 --height 120 --option map_size=512 -o picture.ppm");
  ASSERT_EQ(result.ExitCode, 0) << result.Output;
  EXPECT_NE(result.Output.find("scene.gltf' has what is not shown: 4 points"), std::string::npos)
    << result.Output;
  std::ifstream stream(this->Folder / "picture.ppm", std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream), {} };
  ASSERT_GE(bytes.size(), 160u * 120u * 3u);
  int red = 0;
  int blue = 0;
  for (std::size_t i = bytes.size() - 160 * 120 * 3; i + 2 < bytes.size(); i += 3)
  {
    const auto at = [&](std::size_t k) { return static_cast<unsigned char>(bytes[i + k]); };
    red += at(0) > 30 && at(1) == 0 && at(2) == 0 ? 1 : 0;
    blue += at(2) > 30 && at(0) == 0 && at(1) == 0 ? 1 : 0;
  }
  EXPECT_GT(red, 200);
  EXPECT_GT(blue, 200);
}

TEST_F(Render, LooksForModelsInTheFoldersGiven)
{
  this->Write("scene.json", R"({"version": 1, "image": {"width": 32, "height": 24},
    "lights": [{"position": [0, 30, 30], "size": [1, 1]}], "objects": [{"file": "bunny.ply"}]})");
  EXPECT_EQ(this->Run("render scene.json -o a.png --option map_size=256").ExitCode, 1);
  const ToolResult result = this->Run(
    "render --models /no/such --models " + Data + " scene.json -o a.png --option map_size=256");
  EXPECT_EQ(result.ExitCode, 0) << result.Output;
  EXPECT_TRUE(this->Files().count("a.png"));
}

TEST_F(Render, SaysWhichLightsCastNothing)
{
  this->Write("scene.json", R"({"version": 1, "image": {"width": 16, "height": 12},
    "lights": [{"position": [0, 1, 5], "size": [1, 1]},
      {"position": [0, 1e200, 1e200], "size": [1, 1]}],
    "objects": [{"source": "plane"}]})");
  const ToolResult result = this->Run("render scene.json -o a.png --option map_size=256");
  EXPECT_EQ(result.ExitCode, 0);
  EXPECT_EQ(result.Output,
    "softshadow: light 1: casts nothing: its position is too far from its focal point for a "
    "direction to be computed\n");
}

TEST_F(Render, ConvergesAndReportsIt)
{
  this->Write("scene.json", SquareScene);
  const std::string render = "render scene.json --technique pcss --option map_size=256 "
                             "--visibility v.exr --report r.json --converge ";
  const ToolResult result = this->Run(render + "0.05");
  ASSERT_EQ(result.ExitCode, 0) << result.Output;
  EXPECT_EQ(result.Output, "");
  const auto converged = nlohmann::json::parse(this->Read("r.json"))["converge"];
  EXPECT_EQ(converged["tolerance"], 0.05);
  EXPECT_EQ(converged["converged"], true);
  EXPECT_LE(converged["estimated_error"].get<double>(), 0.05);
  EXPECT_GT(converged["frames"].get<int>(), 10);
  EXPECT_GE(converged["points"].get<int>(), 128);

  const ToolResult bounded = this->Run(render + "0.05 --converge-frames 5");
  EXPECT_EQ(bounded.ExitCode, 2) << "scripts can tell";
  EXPECT_NE(bounded.Output.find("not converged to 0.05 after 5 frames"), std::string::npos)
    << bounded.Output;
  EXPECT_NE(bounded.Output.find("goes on"), std::string::npos) << "says why: " << bounded.Output;
  const auto stopped = nlohmann::json::parse(this->Read("r.json"))["converge"];
  EXPECT_EQ(stopped["converged"], false);
  EXPECT_EQ(stopped["frames"], 5);
  EXPECT_EQ(this->Run(render + "0").ExitCode, 1) << "a tolerance of nothing";
}

TEST_F(Render, RendersTheBundledBunny)
{
  const ToolResult result = this->Run("render " + Data +
    "/Scenes/bunny.json --option map_size=512 --width 160 --height 120 -o bunny.png");
  ASSERT_EQ(result.ExitCode, 0) << result.Output;
  const auto statistics = OIIO::ImageBufAlgo::computePixelStats(this->ReadPicture("bunny.png"));
  EXPECT_GT(statistics.max[0] - statistics.min[0], 0.5) << "light and shadow";
}

TEST_F(Render, WritesTheFormatThatTheNameSays)
{
  this->Write("scene.json", SquareScene);
  for (const std::string kind : { "png", "jpg", "exr", "tif" })
  {
    const ToolResult result =
      this->Run("render scene.json --option map_size=64 -o picture." + kind);
    ASSERT_EQ(result.ExitCode, 0) << result.Output;
    EXPECT_EQ(this->ReadPicture("picture." + kind).spec().width, 64) << kind;
  }
}

TEST_F(Render, IsNotLimitedByTheScreen)
{
  this->Write("scene.json", R"({"version": 1, "image": {"width": 3000, "height": 16},
    "camera": {"position": [0, 0, 8]}, "lights": [{"position": [0, 0, 4], "size": [1, 1]}],
    "objects": [{"source": "plane", "origin": [-900, -50, 0], "point1": [900, -50, 0],
                 "point2": [-900, 50, 0]}]})");
  const ToolResult result = this->Run("render scene.json --option map_size=64 --visibility v.exr");
  ASSERT_EQ(result.ExitCode, 0) << result.Output;
  const VisibilityImage image = this->ReadExr("v.exr");
  ASSERT_EQ(image.Width, 3000);
  EXPECT_EQ(image.Visibility[0][0], 1.0f);
  EXPECT_EQ(image.Visibility[0][2999], 1.0f);
}

TEST_F(Render, ReplacesWhatWasThere)
{
  this->Write("scene.json", SquareScene);
  this->Write("picture.png", "old");
  ASSERT_EQ(this->Run("render scene.json --option map_size=64 -o picture.png").ExitCode, 0);
  EXPECT_EQ(this->ReadPicture("picture.png").spec().width, 64);
}

TEST_F(Render, WorksWithoutADisplayAndLeavesNoServer)
{
  // An Xvfb in the path that tells its process number before it becomes the real one.
  this->Write("scene.json", SquareScene);
  this->Write("Xvfb",
    "#!/bin/sh\necho $$ > '" + (this->Folder / "server").string() +
      "'\nPATH=${PATH#*:}\nexec Xvfb \"$@\"\n");
  std::filesystem::permissions(this->Folder / "Xvfb", std::filesystem::perms::owner_all);
  const std::string path = this->Folder.string() + ":" + std::getenv("PATH");
  for (const std::string display : { "-u DISPLAY", "DISPLAY=", "DISPLAY=:987" })
  {
    const ToolResult result = this->Run(
      "render scene.json --option map_size=64 -o picture.png", display + " 'PATH=" + path + "'");
    ASSERT_EQ(result.ExitCode, 0) << display << ": " << result.Output;
    EXPECT_EQ(this->ReadPicture("picture.png").spec().width, 64);
    if (!std::filesystem::exists(this->Folder / "server"))
    {
      GTEST_SKIP() << "this VTK needs no display";
    }
    const pid_t server = std::stoi(this->Read("server"));
    EXPECT_NE(kill(server, 0), 0) << "the server still runs";
    EXPECT_EQ(errno, ESRCH);
    std::filesystem::remove(this->Folder / "server");
    std::filesystem::remove(this->Folder / "picture.png");
  }
}
