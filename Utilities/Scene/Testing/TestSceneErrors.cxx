// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Every way in which a scene file can be wrong: the message names the file, the line, the key and
// what is wrong with it.

#include "SceneReader.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <ostream>
#include <random>
#include <string>
#include <vector>

using namespace softshadows;

namespace
{

struct WrongScene
{
  const char* Name;
  const char* Text;
  int Line;
  const char* Key;
  const char* Message; ///< A part of it.
};

std::ostream& operator<<(std::ostream& os, const WrongScene& scene)
{
  return os << scene.Name;
}

class SceneErrors : public testing::TestWithParam<WrongScene>
{
};

}

TEST_P(SceneErrors, NameFileLineAndKey)
{
  const WrongScene& wrong = this->GetParam();
  try
  {
    ParseScene(wrong.Text, "some/scene.json");
    FAIL() << "accepted: " << wrong.Text;
  }
  catch (const SceneError& error)
  {
    EXPECT_EQ(error.GetPlace().File, "some/scene.json");
    EXPECT_EQ(error.GetPlace().Line, wrong.Line) << error.what();
    EXPECT_EQ(error.GetPlace().Key, wrong.Key) << error.what();
    const std::string text = error.what();
    EXPECT_NE(text.find(wrong.Message), std::string::npos) << text;
    EXPECT_EQ(text.find("some/scene.json:" + std::to_string(wrong.Line) + ": "), 0u) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

namespace
{

std::string NameOf(const testing::TestParamInfo<WrongScene>& info)
{
  return info.param.Name;
}

// No JSON.
const std::vector<WrongScene> WrongJson = {
  { "Empty", "", 1, "", "not valid JSON" },
  { "CutOff", "{\"version\": 1,\n\"lights\": [\n", 2, "", "not valid JSON" },
  { "CommaMissing", "{\"version\": 1\n\"lights\": []}", 2, "", "not valid JSON" },
  { "CommaTooMuch", "{\"version\": 1,\n\"lights\": [],\n}", 3, "", "not valid JSON" },
  { "Comment", "{\n// hello\n\"version\": 1}", 2, "", "not valid JSON" },
  { "TwoValues", "{\"version\": 1}\n{}", 2, "", "not valid JSON" },
  { "NumberTooLarge", "{\"version\": 1,\n\"image\": {\"width\":\n1e999}}", 3, "", "1e999" },
  { "NotANumber", "{\"version\": NaN}", 1, "", "not valid JSON" },
  { "NotUtf8", "{\"version\": 1, \n\"\xff\": 1}", 2, "", "not valid JSON" },
  { "KeyTwice", "{\"version\": 1,\n\"version\": 1}", 2, "version", "key given twice" },
};

// The outermost object, image and camera.
const std::vector<WrongScene> WrongFrames = {
  { "NoObject", "[1]", 1, "", "must be an object in braces, is a list" },
  { "NoVersion", "{\"lights\": []}", 1, "version", "key is missing" },
  { "OtherVersion", "{\n\"version\": 2}", 2, "version", "only version 1" },
  { "VersionText", "{\n\"version\": \"1\"}", 2, "version", "must be a number, is a text" },
  { "VersionFraction", "{\n\"version\": 1.5}", 2, "version", "must be a whole number" },
  { "UnknownKey", "{\"version\": 1,\n\"lihgts\": []}", 2, "lihgts",
    "unknown key; did you mean 'lights'? Known are: version, image, camera, lights, objects" },
  { "UnknownKeyUnlikeAny", "{\"version\": 1,\n\"fog\": []}", 2, "fog", "unknown key; Known are" },
  { "ImageList", "{\"version\": 1,\n\"image\":\n[640, 480]}", 3, "image", "must be an object" },
  { "ImageKey", "{\"version\": 1,\n\"image\": {\"widht\": 640}}", 2, "image.widht",
    "did you mean 'width'" },
  { "WidthZero", "{\"version\": 1,\n\"image\": {\"width\": 0}}", 2, "image.width",
    "must be at least 1 and at most 16384, is 0" },
  { "WidthFraction", "{\"version\": 1,\n\"image\": {\"width\": 640.5}}", 2, "image.width",
    "must be a whole number, is 640.5" },
  { "WidthTiny", "{\"version\": 1,\n\"image\": {\"width\": 1e-320}}", 2, "image.width",
    "must be at least 1 and at most 16384, is" },
  { "HeightHuge", "{\"version\": 1,\n\"image\": {\"height\": 100000}}", 2, "image.height",
    "at most 16384, is 100000" },
  { "HeightText", "{\"version\": 1,\n\"image\": {\"height\": \"480\"}}", 2, "image.height",
    "must be a number, is a text" },
  { "CameraKey", "{\"version\": 1,\n\"camera\": {\"position\": [0,0,1],\n\"up\": [0,1,0]}}", 3,
    "camera.up", "unknown key" },
  { "CameraPositionMissing", "{\"version\": 1,\n\"camera\": {\"view_up\": [0,1,0]}}", 2,
    "camera.position", "key is missing" },
  { "CameraPositionShort", "{\"version\": 1,\n\"camera\": {\"position\": [0,0]}}", 2,
    "camera.position", "must be a list of 3 numbers, has 2" },
  { "CameraPositionWithText", "{\"version\": 1,\n\"camera\": {\"position\": [0,0,\n\"1\"]}}", 3,
    "camera.position[2]", "must be a number, is a text" },
  { "CameraPositionNull", "{\"version\": 1,\n\"camera\": {\"position\": null}}", 2,
    "camera.position", "must be a list, is null" },
  { "CameraNoDirection",
    "{\"version\": 1,\n\"camera\": {\"position\": [1,2,3],\n\"focal_point\": [1,2,3]}}", 3,
    "camera.focal_point", "same point" },
  { "CameraNoDirectionByDefault", "{\"version\": 1,\n\"camera\": {\"position\": [0,0,0]}}", 2,
    "camera.position", "same point" },
  { "ViewUpAlongView",
    "{\"version\": 1,\n\"camera\": {\"position\": [0,0,4],\n\"view_up\": [0,0,1]}}", 3,
    "camera.view_up", "along the direction of view" },
  { "ViewUpNull", "{\"version\": 1,\n\"camera\": {\"position\": [0,0,4],\n\"view_up\": [0,0,0]}}",
    3, "camera.view_up", "is null" },
  { "ViewUpMissing", "{\"version\": 1,\n\"camera\": {\"position\": [0,4,0]}}", 2, "camera.position",
    "0, 1, 0 if left out" },
  { "ViewAngleFlat", "{\"version\": 1,\n\"camera\": {\"position\": [0,0,4],\n\"view_angle\": 180}}",
    3, "camera.view_angle", "greater than 0 and less than 180, is 180" },
  { "ViewAngleZero", "{\"version\": 1,\n\"camera\": {\"position\": [0,0,4],\n\"view_angle\": 0}}",
    3, "camera.view_angle", "greater than 0" },
  { "ParallelScaleNegative",
    "{\"version\": 1,\n\"camera\": {\"position\": [0,0,4],\n\"parallel_scale\": -1}}", 3,
    "camera.parallel_scale", "must be greater than 0, is -1" },
  { "TwoProjections",
    "{\"version\": 1,\n\"camera\": {\"position\": [0,0,4], \"view_angle\": "
    "30,\n\"parallel_scale\": "
    "1}}",
    3, "camera.parallel_scale", "in place of view_angle" },
};

// Lights.
const std::vector<WrongScene> WrongLights = {
  { "LightsObject", "{\"version\": 1,\n\"lights\": {}}", 2, "lights", "must be a list" },
  { "LightNumber", "{\"version\": 1,\n\"lights\": [\n7]}", 3, "lights[0]", "must be an object" },
  { "PositionMissing", "{\"version\": 1,\n\"lights\": [\n{\"size\": [1,1]}]}", 3,
    "lights[0].position", "key is missing" },
  { "SizeMissing",
    "{\"version\": 1,\n\"lights\": [{\"shape\": \"point\", \"position\": [0,0,1]},\n"
    "{\"position\": [0,0,1]}]}",
    3, "lights[1].size", "key is missing" },
  { "DiskSizeMissing",
    "{\"version\": 1,\n\"lights\": [{\"shape\": \"disk\", \"position\": [0,0,1]}]}", 2,
    "lights[0].size", "key is missing" },
  { "SizeNegative", "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"size\": [1,-0.5]}]}",
    3, "lights[0].size[1]", "must be at least 0, is -0.5" },
  { "SizeNumber", "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"size\": 1}]}", 3,
    "lights[0].size", "must be a list, is a number" },
  { "SizeLong", "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"size\": [1,1,1]}]}", 3,
    "lights[0].size", "2 numbers, has 3" },
  { "ShapeUnknown",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"shape\": \"disc\"}]}", 3,
    "lights[0].shape", "unknown shape 'disc'; did you mean 'disk'? Known are: rectangle, disk" },
  { "ShapeNumber", "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"shape\": 1}]}", 3,
    "lights[0].shape", "must be a text" },
  { "ConeAngleZero",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1], \"size\": [1,1],\n"
    "\"cone_angle\": 0}]}",
    3, "lights[0].cone_angle", "must be greater than 0" },
  { "DirectionalNumber",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"directional\": 1}]}", 3,
    "lights[0].directional", "must be true or false, is a number" },
  { "SizeOfDirectional",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1], \"directional\": "
    "true,\n\"size\": [1,1]}]}",
    3, "lights[0].size", "unknown key of a directional light" },
  { "DiameterOfPositional",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"angular_diameter\": 1}]}", 3,
    "lights[0].angular_diameter", "unknown key of a light that is not directional" },
  { "DiameterHuge",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1], \"directional\": true,\n"
    "\"angular_diameter\": 171}]}",
    3, "lights[0].angular_diameter", "at most 170, is 171" },
  { "ColorNegative",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1], \"size\": [1,1],\n"
    "\"color\": [1,-1,1]}]}",
    3, "lights[0].color[1]", "at least 0" },
  { "IntensityNegative",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1], \"size\": [1,1],\n"
    "\"intensity\": -1}]}",
    3, "lights[0].intensity", "at least 0" },
  { "LightNoDirection",
    "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,0],\n\"size\": [1,1]}]}", 2,
    "lights[0].position", "same point" },
  { "LightKey", "{\"version\": 1,\n\"lights\": [{\"position\": [0,0,1],\n\"sice\": [1,1]}]}", 3,
    "lights[0].sice", "did you mean 'size'?" },
};

// Objects.
const std::vector<WrongScene> WrongObjects = {
  { "ObjectsText", "{\"version\": 1,\n\"objects\": \"box\"}", 2, "objects", "must be a list" },
  { "NeitherFileNorSource", "{\"version\": 1,\n\"objects\": [\n{}]}", 3, "objects[0]",
    "needs the key 'file' or the key 'source'" },
  { "FileAndSource",
    "{\"version\": 1,\n\"objects\": [{\"file\": \"a.ply\",\n\"source\": \"box\"}]}", 3,
    "objects[0].source", "not both" },
  { "FileEmpty", "{\"version\": 1,\n\"objects\": [{\"file\": \"\"}]}", 2, "objects[0].file",
    "is empty" },
  { "FileNumber", "{\"version\": 1,\n\"objects\": [{\"file\": 3}]}", 2, "objects[0].file",
    "must be a text" },
  { "SourceUnknown", "{\"version\": 1,\n\"objects\": [{\"source\": \"cube\"}]}", 2,
    "objects[0].source", "unknown source 'cube'" },
  { "SourceNumber", "{\"version\": 1,\n\"objects\": [{\"source\": 1}]}", 2, "objects[0].source",
    "must be a text" },
  { "KeyOfAnotherSource", "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"radius\": 1}]}",
    3, "objects[0].radius", "unknown key" },
  { "SourceKeyOfAFile",
    "{\"version\": 1,\n\"objects\": [{\"file\": \"a.ply\",\n\"center\": [0,0,0]}]}", 3,
    "objects[0].center", "unknown key" },
  { "ThirdColor",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\"},{\"source\": \"box\"},\n"
    "{\"source\": \"box\",\n\"colour\": [1,1,1]}]}",
    4, "objects[2].colour", "did you mean 'color'?" },
  { "ColorBytes", "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"color\": [255,0,0]}]}",
    3, "objects[0].color[0]", "at most 1, is 255" },
  { "CastShadowText",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"cast_shadow\": \"no\"}]}", 3,
    "objects[0].cast_shadow", "must be true or false, is a text" },
  { "ReceiveShadowNumber",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"receive_shadow\": 0}]}", 3,
    "objects[0].receive_shadow", "must be true or false, is a number" },
  { "MatrixShort",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"matrix\": [1,0,0,0,1,0,0,0,1]}]}", 3,
    "objects[0].matrix", "must be a list of 16 numbers, has 9" },
  { "MatrixByColumns",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"matrix\": "
    "[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]}]}",
    3, "objects[0].matrix", "row by row" },
  { "MatrixFlat",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"matrix\": "
    "[1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1]}]}",
    3, "objects[0].matrix", "no inverse" },
  { "MatrixNested",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"matrix\": [[1,0,0,0],[0,1,0,0],"
    "[0,0,1,0],[0,0,0,1],5,6,7,8,9,10,11,12,13,14,15,16]}]}",
    3, "objects[0].matrix[0]", "must be a number, is a list" },
  { "PlaneFlat",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"plane\",\n\"origin\": [0,0,0],\n"
    "\"point1\": [1,0,0],\n\"point2\": [2,0,0]}]}",
    4, "objects[0].point1", "on one line" },
  { "PlanePoint",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"plane\",\n\"origin\": "
    "[-0.5,0.5,0]}]}",
    3, "objects[0].origin", "on one line" },
  { "PlaneResolution",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"plane\",\n\"x_resolution\": 0}]}", 3,
    "objects[0].x_resolution", "at least 1" },
  { "BoxInsideOut",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"bounds\": [0,1,1,0,0,1]}]}", 3,
    "objects[0].bounds", "minimum of y" },
  { "BoxCorners",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"box\",\n\"bounds\": [[0,0,0],[1,1,1]]}]}", 3,
    "objects[0].bounds", "6 numbers, has 2" },
  { "SphereRadius", "{\"version\": 1,\n\"objects\": [{\"source\": \"sphere\",\n\"radius\": 0}]}", 3,
    "objects[0].radius", "must be greater than 0, is 0" },
  { "SphereTheta",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"sphere\",\n\"theta_resolution\": 2}]}", 3,
    "objects[0].theta_resolution", "at least 3" },
  { "SpherePhi",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"sphere\",\n\"phi_resolution\": 4097}]}", 3,
    "objects[0].phi_resolution", "at most 4096" },
  { "SphereNoTheta",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"sphere\",\n\"start_theta\": 360}]}", 3,
    "objects[0].start_theta", "are the same" },
  { "SphereNoPhi", "{\"version\": 1,\n\"objects\": [{\"source\": \"sphere\",\n\"end_phi\": 0}]}", 3,
    "objects[0].end_phi", "are the same" },
  { "CylinderHeight",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"cylinder\",\n\"height\": -1}]}", 3,
    "objects[0].height", "must be greater than 0" },
  { "CylinderResolution",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"cylinder\",\n\"resolution\": 513}]}", 3,
    "objects[0].resolution", "at least 3 and at most 512, is 513" },
  { "ConeDirection",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"cone\",\n\"direction\": [0,0,0]}]}", 3,
    "objects[0].direction", "is null" },
  { "ConeCenter",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"cone\",\n\"center\": \"0 0 0\"}]}", 3,
    "objects[0].center", "must be a list" },
  { "TorusRadius",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"torus\",\n\"cross_section_radius\": -2}]}", 3,
    "objects[0].cross_section_radius", "must be greater than 0" },
  { "TorusResolution",
    "{\"version\": 1,\n\"objects\": [{\"source\": \"torus\",\n\"u_resolution\": 3.5}]}", 3,
    "objects[0].u_resolution", "must be a whole number" },
};

}

INSTANTIATE_TEST_SUITE_P(Json, SceneErrors, testing::ValuesIn(WrongJson), NameOf);
INSTANTIATE_TEST_SUITE_P(Frame, SceneErrors, testing::ValuesIn(WrongFrames), NameOf);
INSTANTIATE_TEST_SUITE_P(Lights, SceneErrors, testing::ValuesIn(WrongLights), NameOf);
INSTANTIATE_TEST_SUITE_P(Objects, SceneErrors, testing::ValuesIn(WrongObjects), NameOf);

TEST(SceneErrorLimits, RefuseDeepNestingAndManyKeys)
{
  EXPECT_THROW(ParseScene(std::string(100000, '['), "scene.json"), SceneError);
  EXPECT_THROW(
    ParseScene("{\"version\": 1, \"lights\": " + std::string(65, '[') + std::string(65, ']') + "}",
      "scene.json"),
    SceneError);
  std::string keys = "{";
  for (int i = 0; i < 300; ++i)
  {
    keys += "\"" + std::to_string(i) + "\": 0, ";
  }
  EXPECT_THROW(ParseScene(keys + "\"version\": 1}", "scene.json"), SceneError);
}

TEST(SceneErrorLimits, EveryPrefixOfASceneIsRefusedWithoutHarm)
{
  const std::string scene = R"({"version": 1, "camera": {"position": [0, 0, 1]},
    "lights": [{"position": [0, 0, 1.5e0], "size": [1, 1]}], "objects": [{"source": "box"}]})";
  EXPECT_NO_THROW(ParseScene(scene, "scene.json"));
  for (std::size_t length = 0; length < scene.size(); ++length)
  {
    EXPECT_THROW(ParseScene(scene.substr(0, length), "scene.json"), SceneError) << length;
  }
}

TEST(SceneErrorLimits, DamagedScenesAreRefusedOrReadWithoutHarm)
{
  const std::string scene = R"({"version": 1, "image": {"width": 64, "height": 48},
    "camera": {"position": [0, -4, 2], "view_up": [0, 0, 1], "view_angle": 30},
    "lights": [{"position": [2, -2, 4], "shape": "disk", "size": [0.5, 0.5], "cone_angle": 45},
      {"directional": true, "position": [1, 1, 3], "angular_diameter": 0.53}],
    "objects": [{"file": "a.ply", "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "color": [1,1,1]},
      {"source": "sphere", "radius": 0.5, "theta_resolution": 64}, {"source": "torus"}]})";
  const std::vector<std::string> pieces = { "1e999", "-0", "1e-320", "null", "true", "[", "]", "{",
    "}", "\"", ",", ":", "\\u0000", "\xff", "99999999999999999999", "-1" };
  std::mt19937 random(1);
  const auto below = [&random](std::size_t end) { return random() % end; };
  int read = 0;
  constexpr int times = 20000;
  for (int i = 0; i < times; ++i)
  {
    std::string damaged = scene;
    const std::size_t place = below(damaged.size());
    switch (below(3))
    {
      case 0:
        damaged[place] = static_cast<char>(below(256));
        break;
      case 1:
        damaged.erase(place, below(8));
        break;
      default:
        damaged.insert(place, pieces[below(pieces.size())]);
    }
    try
    {
      ParseScene(damaged, "scene.json");
      ++read;
    }
    catch (const SceneError& error)
    {
      ASSERT_GE(error.GetPlace().Line, 1) << error.what();
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, times / 2);
}

TEST(SceneFiles, AreNamedWhenTheyCannotBeRead)
{
  try
  {
    ReadScene("no/such/scene.json");
    FAIL();
  }
  catch (const SceneError& error)
  {
    EXPECT_STREQ(error.what(), "no/such/scene.json: no such file");
  }
  EXPECT_THROW(ReadScene("."), SceneError);
}
