// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSoftShadowsVersion.h: its lines say the same, and the comparison compares.

#include "vtkSoftShadowsVersion.h"

#include <gtest/gtest.h>

#include <string>

TEST(SoftShadowsVersion, TextAndNumbersAgree)
{
  EXPECT_EQ(std::string(SOFTSHADOWS_VERSION),
    std::to_string(SOFTSHADOWS_VERSION_MAJOR) + "." + std::to_string(SOFTSHADOWS_VERSION_MINOR) +
      "." + std::to_string(SOFTSHADOWS_VERSION_PATCH));
}

TEST(SoftShadowsVersion, ComparesMajorThenMinorThenPatch)
{
  constexpr int major = SOFTSHADOWS_VERSION_MAJOR;
  constexpr int minor = SOFTSHADOWS_VERSION_MINOR;
  constexpr int patch = SOFTSHADOWS_VERSION_PATCH;
  EXPECT_TRUE(SOFTSHADOWS_VERSION_AT_LEAST(major, minor, patch));
  EXPECT_TRUE(SOFTSHADOWS_VERSION_AT_LEAST(major - 1, minor + 1, patch + 1));
  EXPECT_TRUE(SOFTSHADOWS_VERSION_AT_LEAST(major, minor - 1, patch + 1));
  EXPECT_FALSE(SOFTSHADOWS_VERSION_AT_LEAST(major, minor, patch + 1));
  EXPECT_FALSE(SOFTSHADOWS_VERSION_AT_LEAST(major, minor + 1, 0));
  EXPECT_FALSE(SOFTSHADOWS_VERSION_AT_LEAST(major + 1, 0, 0));
}
