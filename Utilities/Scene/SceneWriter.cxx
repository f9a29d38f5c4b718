// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneWriter.h"

#include "SceneError.h"
#include "SceneKeys.h"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace softshadows
{
namespace
{

using Json = nlohmann::ordered_json;

/// The visitor of SceneKeys.h that fills a JSON object.
class KeyWriter
{
public:
  Json Object = Json::object();

  template <typename T>
  void operator()(const char* key, const T& value, Range)
  {
    this->Object[key] = value;
  }
  template <typename T>
  void operator()(const char* key, const std::optional<T>& value, Range range)
  {
    if (value)
    {
      (*this)(key, *value, range);
    }
  }
  void operator()(const char* key, const LightShape& value, Range)
  {
    this->Object[key] = LightShapeNames[static_cast<std::size_t>(value)];
  }
};

Json WriteCamera(CameraDescription camera)
{
  KeyWriter writer;
  Describe(writer, camera);
  if (camera.ParallelScale)
  {
    writer.Object.erase("view_angle"); // one stands in place of the other
  }
  return writer.Object;
}

Json WriteLight(LightDescription light)
{
  KeyWriter writer;
  Describe(writer, light);
  return writer.Object;
}

Json WriteObject(ObjectDescription object)
{
  KeyWriter writer;
  std::visit(
    [&](auto& shape)
    {
      if (const char* source = SourceName(shape))
      {
        writer.Object["source"] = source;
      }
      Describe(writer, shape);
    },
    object.Shape);
  DescribeCommon(writer, object);
  return writer.Object;
}

}

//--------------------------------------------------------------------------------------------------
std::string WriteScene(const SceneDescription& scene)
{
  Json root;
  root["version"] = 1;
  KeyWriter image;
  SceneDescription size = scene;
  DescribeImage(image, size);
  root["image"] = image.Object;
  if (scene.Camera)
  {
    root["camera"] = WriteCamera(*scene.Camera);
  }
  root["lights"] = Json::array();
  for (const LightDescription& light : scene.Lights)
  {
    root["lights"].push_back(WriteLight(light));
  }
  root["objects"] = Json::array();
  for (const ObjectDescription& object : scene.Objects)
  {
    root["objects"].push_back(WriteObject(object));
  }
  try
  {
    return root.dump(2) + "\n";
  }
  catch (const Json::exception&)
  {
    throw SceneError({}, "the name of a model is not UTF-8 and cannot be written to a scene file");
  }
}

}
