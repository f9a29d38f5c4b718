// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouettes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

using softshadows::FindSilhouettes;

namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr int Size = 8;
using Image = std::vector<float>;

//--------------------------------------------------------------------------------------------------
int CountOf(const std::vector<unsigned char>& found)
{
  return std::accumulate(found.begin(), found.end(), 0);
}

//--------------------------------------------------------------------------------------------------
// A floor from depth 1 to far away: 1 / depth falls by the same amount in every row.
Image MakeFloor()
{
  Image depth;
  for (int i = 0; i < Size * Size; ++i)
  {
    depth.push_back(1.0F / (1.0F - 0.12F * (i / Size)));
  }
  return depth;
}

//--------------------------------------------------------------------------------------------------
TEST(Silhouettes, PlanesHaveNone)
{
  EXPECT_EQ(CountOf(FindSilhouettes(Size, Size, MakeFloor())), 0);
}

//--------------------------------------------------------------------------------------------------
TEST(Silhouettes, StepsAreOneOnBothSides)
{
  Image depth = MakeFloor();
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < 3; ++x)
    {
      depth[y * Size + x] *= 0.9F;
    }
  }
  const std::vector<unsigned char> found = FindSilhouettes(Size, Size, depth);
  for (int y = 1; y < Size - 1; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      EXPECT_EQ(found[y * Size + x], x == 2 || x == 3 ? 1 : 0) << x << ", " << y;
    }
  }
}

//--------------------------------------------------------------------------------------------------
TEST(Silhouettes, TheBorderOfASurfaceIsOne)
{
  Image depth(Size * Size, 2.0F);
  depth[3 * Size + 3] = NaN;
  const std::vector<unsigned char> found = FindSilhouettes(Size, Size, depth);
  EXPECT_EQ(CountOf(found), 8) << "the neighbours of the hole";
  EXPECT_EQ(found[3 * Size + 3], 0) << "the hole has no surface";
  EXPECT_EQ(found[4 * Size + 4], 1);
}

}
