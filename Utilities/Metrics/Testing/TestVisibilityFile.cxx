// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFile.h"
#include "VisibilityFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

using namespace softshadows;

namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

//--------------------------------------------------------------------------------------------------
std::string PathOf(const std::string& name)
{
  std::filesystem::create_directories(SOFTSHADOWS_TEST_OUTPUT_DIR);
  return std::string(SOFTSHADOWS_TEST_OUTPUT_DIR) + "/" + name;
}

//--------------------------------------------------------------------------------------------------
TEST(VisibilityFile, GivesBackWhatWasWritten)
{
  VisibilityImage image;
  image.Width = 3;
  image.Height = 2;
  // Eleven lights: V10 comes before V2 in the file.
  for (int light = 0; light < 11; ++light)
  {
    const auto value = static_cast<float>(light) / 16.0F;
    image.Visibility.push_back({ value, 1.0F, 0.0F, NaN, 1.0F / 3.0F, value });
  }
  image.Depth = { 1.0F, 2.5F, 1e7F, NaN, 3.0F, 4.0F };
  const std::string path = PathOf("VisibilityFile.exr");
  WriteVisibility(path, image);
  const VisibilityImage read = ReadVisibility(path);
  ASSERT_EQ(read.Width, 3);
  ASSERT_EQ(read.Height, 2);
  ASSERT_EQ(read.Visibility.size(), 11U);
  for (int light = 0; light < 11; ++light)
  {
    EXPECT_EQ(read.Visibility[light][0], image.Visibility[light][0]);
    EXPECT_EQ(read.Visibility[light][4], 1.0F / 3.0F);
    EXPECT_TRUE(std::isnan(read.Visibility[light][3]));
  }
  EXPECT_EQ(read.Depth[2], 1e7F);
  EXPECT_TRUE(std::isnan(read.Depth[3]));
}

//--------------------------------------------------------------------------------------------------
TEST(VisibilityFile, ErrorsNameTheFile)
{
  try
  {
    ReadVisibility("/no/such/file.exr");
    FAIL() << "a file that is not there was read";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("/no/such/file.exr"), std::string::npos);
  }
  VisibilityImage image;
  image.Width = 1;
  image.Height = 1;
  image.Visibility = { { 1.0F } };
  EXPECT_THROW(WriteVisibility("/no/such/folder/v.exr", image), std::runtime_error);
  image.Depth = { 1.0F, 2.0F };
  EXPECT_THROW(WriteVisibility(PathOf("Wrong.exr"), image), std::invalid_argument);
}

//--------------------------------------------------------------------------------------------------
TEST(VisibilityFile, APictureIsNoVisibility)
{
  const std::string path = PathOf("NoVisibility.png");
  WritePicture(path, 1, 1, { 1, 2, 3 });
  EXPECT_THROW(ReadVisibility(path), std::runtime_error);
}

}
