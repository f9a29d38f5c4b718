// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewerFiles.h"

#include "SceneWriter.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <variant>

namespace softshadows
{
namespace
{

namespace fs = std::filesystem;

//--------------------------------------------------------------------------------------------------
/// The file that the builder took, as an absolute name.
std::string FindModel(
  const std::string& file, const std::string& sceneFolder, const std::vector<std::string>& folders)
{
  if (fs::path(file).is_absolute())
  {
    return file;
  }
  std::error_code error;
  const fs::path beside = fs::path(sceneFolder) / file;
  if (fs::exists(beside, error))
  {
    return fs::absolute(beside).lexically_normal().string();
  }
  for (const std::string& folder : folders)
  {
    const fs::path there = fs::path(folder) / file;
    if (fs::exists(there, error))
    {
      return fs::absolute(there).lexically_normal().string();
    }
  }
  return file;
}

}

//--------------------------------------------------------------------------------------------------
std::string FreeFileName(
  const std::string& folder, const std::string& stem, const std::string& ending)
{
  for (int number = 1;; ++number)
  {
    const fs::path path = fs::path(folder) / (stem + "-" + std::to_string(number) + ending);
    std::error_code error;
    if (!fs::exists(path, error))
    {
      return path.string();
    }
  }
}

//--------------------------------------------------------------------------------------------------
void SaveScene(
  const std::string& path, SceneDescription scene, const std::vector<std::string>& folders)
{
  for (ObjectDescription& object : scene.Objects)
  {
    if (auto* model = std::get_if<ModelShape>(&object.Shape))
    {
      model->File = FindModel(model->File, scene.Folder, folders);
    }
  }
  const std::string text = WriteScene(scene);
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file)
  {
    std::error_code error;
    fs::remove(path, error);
    throw std::runtime_error(path + ": cannot be written");
  }
}

}
