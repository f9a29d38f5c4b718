// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is written is read as the same.

#include "SceneReader.h"
#include "SceneWriter.h"

#include <gtest/gtest.h>

#include <string>

using namespace softshadows;

namespace
{

// No value is the default, some have no short decimal form.
const char* const FullScene = R"({ "version": 1,
  "image": {"width": 320, "height": 200},
  "camera": {"position": [0.1, -4, 2], "focal_point": [1e-7, 0, 1], "view_up": [0, 0, 1],
             "view_angle": 33.333333333333336},
  "lights": [
    {"position": [2, -2, 4], "focal_point": [0, 0, 1], "view_up": [0, 1, 0], "shape": "disk",
     "size": [0.5, 0.25], "cone_angle": 45, "color": [1, 0.5, 0.25], "intensity": 2},
    {"position": [2, -2, 4], "shape": "point"},
    {"directional": true, "position": [1, 1, 3], "angular_diameter": 0.53} ],
  "objects": [
    {"file": "bunny.ply", "matrix": [2, 0, 0, 1e7, 0, 1, 0, 2, 0, 0.1, 1, 3, 0, 0, 0, 1],
     "color": [0.8, 0.7, 0.6], "cast_shadow": false, "receive_shadow": false},
    {"source": "plane", "origin": [-2, -2, 0], "point1": [2, -2, 0], "point2": [-2, 2, 0],
     "x_resolution": 2, "y_resolution": 3},
    {"source": "box", "bounds": [0, 1, 0, 2, 0, 3]},
    {"source": "sphere", "center": [0, 0, 1], "radius": 0.75, "theta_resolution": 64,
     "phi_resolution": 32, "start_theta": 1, "end_theta": 2, "start_phi": 3, "end_phi": 4},
    {"source": "cylinder", "center": [1, 0, 0], "radius": 0.75, "height": 2, "resolution": 32,
     "capping": false},
    {"source": "cone", "center": [1, 0, 0], "radius": 0.75, "height": 2, "resolution": 32,
     "direction": [0, 0, 1], "capping": false},
    {"source": "torus", "ring_radius": 3, "cross_section_radius": 0.75, "u_resolution": 32,
     "v_resolution": 16} ] })";

}

TEST(SceneWriter, WritesWhatIsReadAsTheSame)
{
  const SceneDescription scene = ParseScene(FullScene, "scene.json");
  const std::string written = WriteScene(scene);
  const SceneDescription again = ParseScene(written, "scene.json");
  EXPECT_EQ(WriteScene(again), written);

  EXPECT_EQ(again.Width, 320);
  EXPECT_EQ(again.Camera->Position, scene.Camera->Position);
  EXPECT_EQ(again.Camera->FocalPoint, scene.Camera->FocalPoint);
  EXPECT_EQ(again.Camera->ViewAngle, 33.333333333333336);
  EXPECT_EQ(again.Lights.size(), 3u);
  EXPECT_EQ(again.Lights[0].Shape, LightShape::Disk);
  EXPECT_EQ(again.Lights[0].Size, scene.Lights[0].Size);
  EXPECT_EQ(again.Lights[1].Shape, LightShape::Point);
  EXPECT_FALSE(again.Lights[1].ViewUp.has_value());
  EXPECT_EQ(again.Lights[2].AngularDiameter, 0.53);
  EXPECT_EQ(again.Objects.size(), 7u);
  EXPECT_EQ(again.Objects[0].Matrix, scene.Objects[0].Matrix);
  EXPECT_FALSE(again.Objects[0].CastShadow);
  for (std::size_t i = 0; i < again.Objects.size(); ++i)
  {
    EXPECT_EQ(again.Objects[i].Shape.index(), scene.Objects[i].Shape.index()) << i;
  }
}

TEST(SceneWriter, LosesNoKeyOfTheFullScene)
{
  // Every key and number of the text above stands in what is written.
  const std::string written = WriteScene(ParseScene(FullScene, "scene.json"));
  for (const char* text : { "\"width\": 320", "\"view_angle\": 33.333333333333336", "1e-07",
         "\"shape\": \"disk\"", "\"cone_angle\": 45.0", "\"intensity\": 2.0",
         "\"angular_diameter\": 0.53", "\"directional\": true", "\"file\": \"bunny.ply\"",
         "10000000.0", "\"cast_shadow\": false", "\"receive_shadow\": false", "\"x_resolution\": 2",
         "\"y_resolution\": 3", "\"bounds\"", "\"theta_resolution\": 64", "\"phi_resolution\": 32",
         "\"start_theta\": 1.0", "\"end_theta\": 2.0", "\"start_phi\": 3.0", "\"end_phi\": 4.0",
         "\"capping\": false", "\"direction\"", "\"ring_radius\": 3.0",
         "\"cross_section_radius\": 0.75", "\"u_resolution\": 32", "\"v_resolution\": 16" })
  {
    EXPECT_NE(written.find(text), std::string::npos) << text << " in\n" << written;
  }
}

TEST(SceneWriter, WritesOneProjection)
{
  const SceneDescription scene =
    ParseScene(R"({"version": 1, "camera": {"position": [0, 0, 4], "parallel_scale": 2}})", "");
  const std::string written = WriteScene(scene);
  EXPECT_EQ(ParseScene(written, "").Camera->ParallelScale.value(), 2.0);
  EXPECT_EQ(written.find("view_angle"), std::string::npos);
}

TEST(SceneWriter, RefusesNamesThatAreNotUtf8)
{
  SceneDescription scene;
  scene.Objects.emplace_back();
  scene.Objects[0].Shape = ModelShape{ "\xff.ply", {} };
  EXPECT_THROW(WriteScene(scene), SceneError);
}
