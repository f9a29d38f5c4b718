// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneReader.h"

#include "LocatedJson.h"
#include "SceneKeyReader.h"
#include "SceneKeys.h"
#include "SceneRules.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace softshadows
{
namespace
{

/// The shape that "source" or "file" asks for, with VTK's defaults in it.
ShapeDescription ShapeOf(const KeyReader& keys)
{
  if (keys.Has("file") && keys.Has("source"))
  {
    keys.Fail("source", "an object has either a file or a source, not both");
  }
  if (keys.Has("file"))
  {
    return ModelShape{};
  }
  if (!keys.Has("source"))
  {
    keys.Fail("", "an object needs the key 'file' or the key 'source'");
  }
  const ShapeDescription sources[] = { PlaneShape{}, BoxShape{}, SphereShape{}, CylinderShape{},
    ConeShape{}, TorusShape{} };
  std::string wanted;
  keys("source", wanted, Any);
  std::vector<std::string> known;
  for (const ShapeDescription& source : sources)
  {
    const std::string name =
      std::visit([](const auto& shape) { return SourceName(shape); }, source);
    if (name == wanted)
    {
      return source;
    }
    known.push_back(name);
  }
  keys.FailUnknown("source", "source", wanted, known);
}

ObjectDescription ReadObject(const KeyReader& keys)
{
  ObjectDescription object;
  object.Place = keys.PlaceOf("");
  object.Shape = ShapeOf(keys);
  KeyLister allowed;
  allowed.Add(std::holds_alternative<ModelShape>(object.Shape) ? "file" : "source");
  std::visit([&](auto& shape) { Describe(allowed, shape); }, object.Shape);
  DescribeCommon(allowed, object);
  keys.AllowOnly(allowed.GetKeys());

  std::visit(
    [&](auto& shape)
    {
      Describe(keys, shape);
      CheckShape(keys, shape);
    },
    object.Shape);
  if (auto* model = std::get_if<ModelShape>(&object.Shape))
  {
    model->Place = keys.PlaceOf("file");
  }
  else
  {
    object.Color = Vector3{ { 1.0, 1.0, 1.0 } }; // shapes have no colours of their own
  }
  DescribeCommon(keys, object);
  CheckMatrix(keys, object.Matrix);
  return object;
}

LightDescription ReadLight(const KeyReader& keys)
{
  LightDescription light;
  keys("directional", light.Directional, Any);
  KeyLister allowed;
  Describe(allowed, light);
  keys.AllowOnly(allowed.GetKeys(),
    light.Directional ? " of a directional light" : " of a light that is not directional");
  keys.Require("position");
  Describe(keys, light);
  if (!light.Directional && light.Shape != LightShape::Point)
  {
    keys.Require("size");
  }
  CheckDirection(keys, light.Position, light.FocalPoint);
  return light;
}

CameraDescription ReadCamera(const KeyReader& keys)
{
  CameraDescription camera;
  KeyLister allowed;
  Describe(allowed, camera);
  keys.AllowOnly(allowed.GetKeys());
  keys.Require("position");
  if (keys.Has("view_angle") && keys.Has("parallel_scale"))
  {
    keys.Fail("parallel_scale", "stands in place of view_angle; give one of the two");
  }
  Describe(keys, camera);
  CheckDirection(keys, camera.Position, camera.FocalPoint);
  CheckViewUp(keys, camera);
  return camera;
}

void ReadImage(const KeyReader& keys, SceneDescription& scene)
{
  KeyLister allowed;
  DescribeImage(allowed, scene);
  keys.AllowOnly(allowed.GetKeys());
  DescribeImage(keys, scene);
}

void CheckVersion(const KeyReader& keys)
{
  keys.Require("version");
  int version = 0;
  keys("version", version, Any);
  if (version != 1)
  {
    keys.Fail(
      "version", "only version 1 of the format is known, this is " + std::to_string(version));
  }
}

}

//--------------------------------------------------------------------------------------------------
SceneDescription ParseScene(const std::string& text, const std::string& fileName)
{
  const LocatedJson root = ReadLocatedJson(text, fileName);
  const KeyReader keys(root, fileName, "");
  keys.AllowOnly({ "version", "image", "camera", "lights", "objects" });
  CheckVersion(keys);

  SceneDescription scene;
  scene.Folder = std::filesystem::path(fileName).parent_path().string();
  if (keys.Has("image"))
  {
    ReadImage(keys.Object("image"), scene);
  }
  if (keys.Has("camera"))
  {
    scene.Camera = ReadCamera(keys.Object("camera"));
  }
  for (const KeyReader& light : keys.List("lights"))
  {
    scene.Lights.push_back(ReadLight(light));
  }
  for (const KeyReader& object : keys.List("objects"))
  {
    scene.Objects.push_back(ReadObject(object));
  }
  return scene;
}

//--------------------------------------------------------------------------------------------------
SceneDescription ReadScene(const std::string& fileName)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(fileName, error);
  if (!std::filesystem::exists(status))
  {
    throw SceneError({ fileName, 0, "" }, "no such file");
  }
  std::ostringstream text;
  std::ifstream file(fileName, std::ios::binary);
  if (std::filesystem::is_directory(status) || !file || !(text << file.rdbuf()))
  {
    throw SceneError({ fileName, 0, "" }, "cannot be read, or is empty");
  }
  return ParseScene(text.str(), fileName);
}

}
