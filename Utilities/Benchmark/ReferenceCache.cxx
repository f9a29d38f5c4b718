// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceCache.h"

#include "ReferenceHash.h"
#include "ReferenceTracer.h"

#include <filesystem> // For the folder
#include <stdexcept>  // For damaged files

#include <unistd.h>

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
bool Read(const std::string& path, int width, int height, VisibilityImage& image)
{
  if (!std::filesystem::exists(path))
  {
    return false;
  }
  try
  {
    image = ReadVisibility(path);
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
  return image.Width == width && image.Height == height && !image.Depth.empty();
}

}

//--------------------------------------------------------------------------------------------------
VisibilityImage ReferenceCache::Get(vtkRenderer* renderer, int width, int height,
  int samplesPerAxis, bool gaussian, const std::function<void(double)>& progress)
{
  VisibilityImage image;
  std::string path;
  if (!this->Folder.empty())
  {
    path = (std::filesystem::path(this->Folder) /
      (HashScene(renderer) + "-" + std::to_string(width) + "x" + std::to_string(height) + "-" +
        std::to_string(samplesPerAxis) + (gaussian ? "-gaussian" : "") + ".exr"))
             .string();
    if (Read(path, width, height, image))
    {
      return image;
    }
  }
  ReferenceTracer tracer(width, height, samplesPerAxis);
  tracer.SetGaussian(gaussian);
  tracer.SetProgress(progress);
  ReferenceVisibility traced = tracer.Trace(renderer);
  image = { width, height, std::move(traced.Visibility), std::move(traced.Depth) };
  if (!path.empty())
  {
    // Under another name first: a run that is stopped leaves no half of a reference, and two runs at
    // once do not write into one file.
    std::filesystem::create_directories(this->Folder);
    const std::string unfinished = path + "." + std::to_string(getpid()) + ".part.exr";
    WriteVisibility(unfinished, image);
    std::filesystem::rename(unfinished, path);
  }
  return image;
}

}
