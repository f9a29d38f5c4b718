// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RawVisibility.h"

#include "Silhouettes.h"

#include <filesystem>   // For what is left over
#include <fstream>      // For files
#include <limits>       // For NaN
#include <sstream>      // For the first line
#include <stdexcept>    // For errors
#include <system_error> // For removing

namespace softshadows
{
namespace
{

const char* const Magic = "softshadows-visibility";
constexpr int MostPixelsPerSide = 32768;
constexpr int MostLights = 1024;

//--------------------------------------------------------------------------------------------------
void LeaveOut(std::vector<float>& values, const std::vector<unsigned char>& isLeftOut)
{
  for (size_t i = 0; i < isLeftOut.size(); ++i)
  {
    if (isLeftOut[i])
    {
      values[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
VisibilityImage ReadRawVisibility(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!std::getline(file, line))
  {
    throw std::runtime_error(path + ": cannot be read");
  }
  std::istringstream words(line);
  std::string magic;
  VisibilityImage image;
  int lights = -1;
  words >> magic >> image.Width >> image.Height >> lights;
  const auto isSide = [](int pixels) { return pixels > 0 && pixels <= MostPixelsPerSide; };
  if (!words || magic != Magic || !isSide(image.Width) || !isSide(image.Height) || lights < 0 ||
    lights > MostLights)
  {
    throw std::runtime_error(path + ": is no visibility of plain floats");
  }
  const auto pixels = static_cast<size_t>(image.Width) * image.Height;
  for (int light = 0; light < lights; ++light)
  {
    std::vector<float> values(pixels);
    file.read(
      reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(pixels * sizeof(float)));
    if (!file)
    {
      throw std::runtime_error(path + ": ends within light " + std::to_string(light));
    }
    image.Visibility.push_back(std::move(values));
  }
  return image;
}

//--------------------------------------------------------------------------------------------------
void WriteRawVisibility(const std::string& path, const VisibilityImage& image)
{
  const std::vector<unsigned char> silhouettes = image.Depth.empty()
    ? std::vector<unsigned char>()
    : FindSilhouettes(image.Width, image.Height, image.Depth);
  std::ofstream file(path, std::ios::binary);
  file << Magic << ' ' << image.Width << ' ' << image.Height << ' ' << image.Visibility.size()
       << '\n';
  for (std::vector<float> values : image.Visibility)
  {
    LeaveOut(values, silhouettes);
    file.write(reinterpret_cast<const char*>(values.data()),
      static_cast<std::streamsize>(values.size() * sizeof(float)));
  }
  file.close();
  if (!file)
  {
    std::error_code error;
    std::filesystem::remove(path, error);
    throw std::runtime_error(path + ": cannot be written");
  }
}

}
