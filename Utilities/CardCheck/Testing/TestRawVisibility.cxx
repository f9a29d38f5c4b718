// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RawVisibility.h"

#include "Silhouettes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace softshadows;

namespace
{

constexpr int Width = 8;
constexpr int Height = 6;

//--------------------------------------------------------------------------------------------------
// Two lights; the right half stands twice as far away.
VisibilityImage MakeImage()
{
  VisibilityImage image{ Width, Height, {}, {} };
  for (int light = 0; light < 2; ++light)
  {
    image.Visibility.emplace_back();
    for (int i = 0; i < Width * Height; ++i)
    {
      image.Visibility.back().push_back(i == 0 ? std::nanf("") : 0.01F * i + 0.5F * light);
    }
  }
  for (int i = 0; i < Width * Height; ++i)
  {
    image.Depth.push_back(i % Width < Width / 2 ? 1.0F : 2.0F);
  }
  return image;
}

//--------------------------------------------------------------------------------------------------
std::string NameOf(const std::string& name)
{
  return (std::filesystem::temp_directory_path() / ("raw-visibility-" + name)).string();
}

//--------------------------------------------------------------------------------------------------
std::string WhyUnread(const std::string& path)
{
  try
  {
    ReadRawVisibility(path);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

//--------------------------------------------------------------------------------------------------
TEST(RawVisibility, ComesBackWithoutSilhouettes)
{
  const std::string path = NameOf("whole");
  const VisibilityImage image = MakeImage();
  WriteRawVisibility(path, image);
  const VisibilityImage read = ReadRawVisibility(path);
  std::filesystem::remove(path);
  ASSERT_EQ(read.Width, Width);
  ASSERT_EQ(read.Height, Height);
  ASSERT_EQ(read.Visibility.size(), 2U);
  const auto silhouettes = FindSilhouettes(Width, Height, image.Depth);
  int leftOut = 0;
  for (size_t light = 0; light < 2; ++light)
  {
    for (size_t i = 0; i < silhouettes.size(); ++i)
    {
      const float value = read.Visibility[light][i];
      if (silhouettes[i] || i == 0)
      {
        EXPECT_TRUE(std::isnan(value)) << i;
        ++leftOut;
      }
      else
      {
        EXPECT_EQ(value, image.Visibility[light][i]) << i;
      }
    }
  }
  EXPECT_GE(leftOut, 2 * Height);
}

//--------------------------------------------------------------------------------------------------
TEST(RawVisibility, DamagedFilesAreNamed)
{
  EXPECT_NE(
    WhyUnread(NameOf("none")).find("raw-visibility-none: cannot be read"), std::string::npos);
  const std::string path = NameOf("damaged");
  for (const char* text : { "softshadows-visibility 8 6\n", "softshadows-visibility -8 6 1\n",
         "softshadows-visibility 8 6 -1\n", "softshadows-visibility 99999999 99999999 1\n",
         "P6 8 6 1\n", "\n" })
  {
    std::ofstream(path, std::ios::binary) << text << "rest";
    EXPECT_NE(WhyUnread(path).find("no visibility of plain floats"), std::string::npos) << text;
  }
  WriteRawVisibility(path, MakeImage());
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_NE(WhyUnread(path).find("ends within light 1"), std::string::npos) << WhyUnread(path);
  std::filesystem::remove(path);
}

//--------------------------------------------------------------------------------------------------
TEST(RawVisibility, FilesThatCannotBeWrittenAreNamed)
{
  EXPECT_THROW(WriteRawVisibility("/nowhere/at/all", MakeImage()), std::runtime_error);
}

}
