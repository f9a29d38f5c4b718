// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShiftedEdges.h"

#include <gtest/gtest.h>

#include <limits>

using softshadows::CountEdges;
using softshadows::FindShiftedEdges;

namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr int Width = 6;
constexpr int Height = 4;
using Image = std::vector<float>;

//--------------------------------------------------------------------------------------------------
// Dark to the left of a column, lit from it on.
Image MakeEdge(int column)
{
  Image image;
  for (int i = 0; i < Width * Height; ++i)
  {
    image.push_back(i % Width < column ? 0.0F : 1.0F);
  }
  return image;
}

//--------------------------------------------------------------------------------------------------
TEST(ShiftedEdges, EqualImagesHaveNone)
{
  const Image image = MakeEdge(3);
  EXPECT_EQ(
    FindShiftedEdges(Width, Height, image, image), std::vector<unsigned char>(image.size(), 0));
}

//--------------------------------------------------------------------------------------------------
TEST(ShiftedEdges, AreFoundOnePixelFar)
{
  const std::vector<unsigned char> near = FindShiftedEdges(Width, Height, MakeEdge(3), MakeEdge(4));
  const std::vector<unsigned char> far = FindShiftedEdges(Width, Height, MakeEdge(3), MakeEdge(5));
  for (int i = 0; i < Width * Height; ++i)
  {
    EXPECT_EQ(near[i], i % Width == 3 ? 1 : 0) << i;
    EXPECT_EQ(far[i], i % Width == 3 ? 1 : 0) << i << ": the second column is no edge's";
  }
}

//--------------------------------------------------------------------------------------------------
TEST(ShiftedEdges, AreCountedOnBothSides)
{
  EXPECT_EQ(CountEdges(Width, Height, MakeEdge(3)), 2 * Height);
  EXPECT_EQ(CountEdges(Width, Height, MakeEdge(0)), 0);
}

//--------------------------------------------------------------------------------------------------
TEST(ShiftedEdges, ASingleWrongPixelIsNone)
{
  const Image truth(Width * Height, 1.0F);
  Image estimate = truth;
  estimate[9] = 0.0F;
  EXPECT_EQ(
    FindShiftedEdges(Width, Height, truth, estimate), std::vector<unsigned char>(truth.size(), 0));
}

//--------------------------------------------------------------------------------------------------
// Along an edge both images may go on from values that differ a little.
TEST(ShiftedEdges, MayGoOnFromAPixelInWhichBothAgree)
{
  Image truth(Width * Height, 1.0F);
  Image estimate = truth;
  truth[0] = 0.150F;
  estimate[0] = 0.135F;
  estimate[1] = 0.120F; // 0.03 from the truth's value beside it
  EXPECT_EQ(FindShiftedEdges(Width, Height, truth, estimate)[1], 1);
  estimate[0] = 0.120F; // now both are wrong
  EXPECT_EQ(FindShiftedEdges(Width, Height, truth, estimate)[1], 0);
}

//--------------------------------------------------------------------------------------------------
TEST(ShiftedEdges, PixelsWithoutAValueAreNone)
{
  Image truth = MakeEdge(3);
  Image estimate = truth;
  estimate[3] = NaN;
  truth[9] = NaN;
  EXPECT_EQ(
    FindShiftedEdges(Width, Height, truth, estimate), std::vector<unsigned char>(truth.size(), 0));
}

}
