// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceCache.h"

#include "ReferenceHash.h"

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

//--------------------------------------------------------------------------------------------------
std::string NameFile(
  const std::string& folder, vtkRenderer* renderer, const ReferenceRequest& request)
{
  const std::string name = HashScene(renderer) + "-" + std::to_string(request.Width) + "x" +
    std::to_string(request.Height) + "-" + std::to_string(request.SamplesPerAxis) +
    (request.Gaussian ? "-gaussian" : "") + ".exr";
  return (std::filesystem::path(folder) / name).string();
}

//--------------------------------------------------------------------------------------------------
// Under another name first: a run that is stopped leaves no half of a reference, and two runs at
// once do not write into one file.
void Keep(const std::string& path, const VisibilityImage& image)
{
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  const std::string unfinished = path + "." + std::to_string(getpid()) + ".part.exr";
  WriteVisibility(unfinished, image);
  std::filesystem::rename(unfinished, path);
}

}

//--------------------------------------------------------------------------------------------------
ReferenceSource CacheReferences(const std::string& folder)
{
  return [folder](vtkRenderer* renderer, const ReferenceRequest& request,
           const std::function<void(double)>& progress)
  {
    const std::string path = folder.empty() ? std::string() : NameFile(folder, renderer, request);
    VisibilityImage image;
    if (!path.empty() && Read(path, request.Width, request.Height, image))
    {
      return image;
    }
    image = TraceReference(renderer, request, progress);
    if (!path.empty())
    {
      Keep(path, image);
    }
    return image;
  };
}

}
