// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Every key of the scene file and every default.

#include "SceneReader.h"

#include <gtest/gtest.h>

#include <string>

using namespace softshadows;

namespace
{

SceneDescription Parse(const std::string& text)
{
  return ParseScene(text, "folder/scene.json");
}

template <typename Shape>
Shape ParseShape(const std::string& object)
{
  const SceneDescription scene = Parse(R"({"version": 1, "objects": [)" + object + "]}");
  return std::get<Shape>(scene.Objects.at(0).Shape);
}

LightDescription ParseLight(const std::string& light)
{
  return Parse(R"({"version": 1, "lights": [)" + light + "]}").Lights.at(0);
}

CameraDescription ParseCamera(const std::string& camera)
{
  return Parse(R"({"version": 1, "camera": )" + camera + "}").Camera.value();
}

}

TEST(SceneReader, LeavesOutEverythingButTheVersion)
{
  const SceneDescription scene = Parse(R"({"version": 1})");
  EXPECT_EQ(scene.Width, 640);
  EXPECT_EQ(scene.Height, 480);
  EXPECT_FALSE(scene.Camera.has_value());
  EXPECT_TRUE(scene.Lights.empty());
  EXPECT_TRUE(scene.Objects.empty());
  EXPECT_EQ(scene.Folder, "folder");
}

TEST(SceneReader, ReadsTheImage)
{
  const SceneDescription scene =
    Parse(R"({"version": 1, "image": {"width": 1280, "height": 720.0}})");
  EXPECT_EQ(scene.Width, 1280);
  EXPECT_EQ(scene.Height, 720);
}

TEST(SceneReader, ReadsACamera)
{
  const CameraDescription camera = ParseCamera(
    R"({"position": [0, -4, 2], "focal_point": [1, 2, 3], "view_up": [0, 0, 1], "view_angle": 45})");
  EXPECT_EQ(camera.Position, (Vector3{ { 0, -4, 2 } }));
  EXPECT_EQ(camera.FocalPoint, (Vector3{ { 1, 2, 3 } }));
  EXPECT_EQ(camera.ViewUp, (Vector3{ { 0, 0, 1 } }));
  EXPECT_EQ(camera.ViewAngle, 45.0);
  EXPECT_FALSE(camera.ParallelScale.has_value());
}

TEST(SceneReader, ReadsAParallelCameraAndItsDefaults)
{
  const CameraDescription camera = ParseCamera(R"({"position": [1, 0, 2], "parallel_scale": 2.5})");
  EXPECT_EQ(camera.ParallelScale.value(), 2.5);
  EXPECT_EQ(camera.FocalPoint, (Vector3{ { 0, 0, 0 } }));
  EXPECT_EQ(camera.ViewUp, (Vector3{ { 0, 1, 0 } }));
  EXPECT_EQ(camera.ViewAngle, 30.0);
}

TEST(SceneReader, ReadsAPositionalLight)
{
  const LightDescription light =
    ParseLight(R"({"position": [2, -2, 4], "focal_point": [1, 0, 0], "view_up": [0, 1, 0],
      "shape": "disk", "size": [0.5, 0.25], "cone_angle": 45, "color": [1, 0.5, 2], "intensity": 3})");
  EXPECT_FALSE(light.Directional);
  EXPECT_EQ(light.Position, (Vector3{ { 2, -2, 4 } }));
  EXPECT_EQ(light.FocalPoint, (Vector3{ { 1, 0, 0 } }));
  EXPECT_EQ(light.ViewUp.value(), (Vector3{ { 0, 1, 0 } }));
  EXPECT_EQ(light.Shape, LightShape::Disk);
  EXPECT_EQ(light.Size, (Vector2{ { 0.5, 0.25 } }));
  EXPECT_EQ(light.ConeAngle, 45.0);
  EXPECT_EQ(light.Color, (Vector3{ { 1, 0.5, 2 } }));
  EXPECT_EQ(light.Intensity, 3.0);
}

TEST(SceneReader, KnowsTheDefaultsOfAPositionalLight)
{
  const LightDescription light = ParseLight(R"({"position": [0, 0, 4], "size": [1, 0]})");
  EXPECT_EQ(light.FocalPoint, (Vector3{ { 0, 0, 0 } }));
  EXPECT_FALSE(light.ViewUp.has_value());
  EXPECT_EQ(light.Shape, LightShape::Rectangle);
  EXPECT_EQ(light.ConeAngle, 90.0);
  EXPECT_EQ(light.Color, (Vector3{ { 1, 1, 1 } }));
  EXPECT_EQ(light.Intensity, 1.0);
}

TEST(SceneReader, KnowsThreeShapesOfLights)
{
  const char* rest = R"(, "position": [0, 0, 4], "size": [1, 1]})";
  EXPECT_EQ(
    ParseLight(std::string(R"({"shape": "rectangle")") + rest).Shape, LightShape::Rectangle);
  EXPECT_EQ(ParseLight(std::string(R"({"shape": "disk")") + rest).Shape, LightShape::Disk);
  EXPECT_EQ(ParseLight(std::string(R"({"shape": "point")") + rest).Shape, LightShape::Point);
  EXPECT_EQ(ParseLight(R"({"shape": "point", "position": [0, 0, 4]})").Shape, LightShape::Point);
}

TEST(SceneReader, ReadsADirectionalLight)
{
  const LightDescription light = ParseLight(
    R"({"directional": true, "position": [1, 1, 3], "view_up": [1, 0, 0], "angular_diameter": 0.53})");
  EXPECT_TRUE(light.Directional);
  EXPECT_EQ(light.AngularDiameter, 0.53);
  EXPECT_EQ(light.ViewUp.value(), (Vector3{ { 1, 0, 0 } }));
  EXPECT_EQ(ParseLight(R"({"directional": true, "position": [1, 1, 3]})").AngularDiameter, 0.0);
}

TEST(SceneReader, ReadsWhatEveryObjectHas)
{
  const SceneDescription scene = Parse(R"({"version": 1, "objects": [
    {"file": "bunny.ply", "matrix": [1, 2, 0, 4, 0, 1, 0, 5, 0, 0, 1, 6, 0, 0, 0, 1],
     "color": [0.8, 0.7, 0.6], "cast_shadow": false, "receive_shadow": false},
    {"source": "box"} ]})");
  const ObjectDescription& model = scene.Objects.at(0);
  EXPECT_EQ(std::get<ModelShape>(model.Shape).File, "bunny.ply");
  EXPECT_EQ(std::get<ModelShape>(model.Shape).Place.Key, "objects[0].file");
  EXPECT_EQ(std::get<ModelShape>(model.Shape).Place.Line, 2);
  EXPECT_EQ(
    model.Matrix, (std::array<double, 16>{ { 1, 2, 0, 4, 0, 1, 0, 5, 0, 0, 1, 6, 0, 0, 0, 1 } }));
  EXPECT_EQ(model.Color, (Vector3{ { 0.8, 0.7, 0.6 } }));
  EXPECT_FALSE(model.CastShadow);
  EXPECT_FALSE(model.ReceiveShadow);

  const ObjectDescription& box = scene.Objects.at(1);
  EXPECT_EQ(
    box.Matrix, (std::array<double, 16>{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } }));
  EXPECT_EQ(box.Color, (Vector3{ { 1, 1, 1 } }));
  EXPECT_TRUE(box.CastShadow);
  EXPECT_TRUE(box.ReceiveShadow);
  EXPECT_EQ(box.Place.Line, 4);
}

TEST(SceneReader, ReadsAPlane)
{
  const auto plane = ParseShape<PlaneShape>(R"({"source": "plane", "origin": [-2, -2, 0],
    "point1": [2, -2, 0], "point2": [-2, 2, 0], "x_resolution": 3, "y_resolution": 4})");
  EXPECT_EQ(plane.Origin, (Vector3{ { -2, -2, 0 } }));
  EXPECT_EQ(plane.Point1, (Vector3{ { 2, -2, 0 } }));
  EXPECT_EQ(plane.Point2, (Vector3{ { -2, 2, 0 } }));
  EXPECT_EQ(plane.XResolution, 3);
  EXPECT_EQ(plane.YResolution, 4);
}

TEST(SceneReader, ReadsABox)
{
  const auto box = ParseShape<BoxShape>(R"({"source": "box", "bounds": [0, 1, 2, 3, 4, 4]})");
  EXPECT_EQ(box.Bounds, (Box{ { 0, 1, 2, 3, 4, 4 } }));
}

TEST(SceneReader, ReadsASphere)
{
  const auto sphere = ParseShape<SphereShape>(R"({"source": "sphere", "center": [0, 0, 1],
    "radius": 0.25, "theta_resolution": 64, "phi_resolution": 32, "start_theta": 10,
    "end_theta": 200, "start_phi": 5, "end_phi": 90})");
  EXPECT_EQ(sphere.Center, (Vector3{ { 0, 0, 1 } }));
  EXPECT_EQ(sphere.Radius, 0.25);
  EXPECT_EQ(sphere.ThetaResolution, 64);
  EXPECT_EQ(sphere.PhiResolution, 32);
  EXPECT_EQ(sphere.StartTheta, 10.0);
  EXPECT_EQ(sphere.EndTheta, 200.0);
  EXPECT_EQ(sphere.StartPhi, 5.0);
  EXPECT_EQ(sphere.EndPhi, 90.0);
}

TEST(SceneReader, ReadsACylinder)
{
  const auto cylinder = ParseShape<CylinderShape>(R"({"source": "cylinder", "center": [1, 2, 3],
    "radius": 0.25, "height": 2, "resolution": 32, "capping": false})");
  EXPECT_EQ(cylinder.Center, (Vector3{ { 1, 2, 3 } }));
  EXPECT_EQ(cylinder.Radius, 0.25);
  EXPECT_EQ(cylinder.Height, 2.0);
  EXPECT_EQ(cylinder.Resolution, 32);
  EXPECT_FALSE(cylinder.Capping);
}

TEST(SceneReader, ReadsACone)
{
  const auto cone = ParseShape<ConeShape>(R"({"source": "cone", "center": [1, 2, 3],
    "radius": 0.25, "height": 2, "resolution": 32, "direction": [0, 0, 1], "capping": false})");
  EXPECT_EQ(cone.Center, (Vector3{ { 1, 2, 3 } }));
  EXPECT_EQ(cone.Radius, 0.25);
  EXPECT_EQ(cone.Height, 2.0);
  EXPECT_EQ(cone.Resolution, 32);
  EXPECT_EQ(cone.Direction, (Vector3{ { 0, 0, 1 } }));
  EXPECT_FALSE(cone.Capping);
}

TEST(SceneReader, ReadsATorus)
{
  const auto torus = ParseShape<TorusShape>(R"({"source": "torus", "ring_radius": 2,
    "cross_section_radius": 0.25, "u_resolution": 40, "v_resolution": 20})");
  EXPECT_EQ(torus.RingRadius, 2.0);
  EXPECT_EQ(torus.CrossSectionRadius, 0.25);
  EXPECT_EQ(torus.UResolution, 40);
  EXPECT_EQ(torus.VResolution, 20);
}
