// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The measures on images whose numbers can be worked out by hand.
#include "DifferencePicture.h"
#include "ErrorMeasures.h"
#include "StructuralSimilarity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace softshadows;
using Image = std::vector<float>;

namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeasures, EqualImagesHaveNoError)
{
  const Image image = { 0.0F, 0.25F, 0.5F, 1.0F, NaN, 0.75F };
  const VisibilityErrors errors = MeasureErrors(3, 2, image, image);
  EXPECT_EQ(errors.All.Pixels, 5);
  EXPECT_EQ(errors.Penumbra.Pixels, 3);
  EXPECT_EQ(errors.All.Rmse, 0.0);
  EXPECT_EQ(errors.All.Maximum, 0.0);
  EXPECT_EQ(errors.All.Psnr, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(errors.All.Ssim, 1.0, 1e-12);
  EXPECT_EQ(errors.OnlyInTruth + errors.OnlyInEstimate + errors.LeftOut, 0);
}

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeasures, AreThoseWorkedOutByHand)
{
  // Errors 0.5, -0.25, 0, 0.25; the penumbra has the second and third pixel.
  const Image truth = { 0.0F, 0.5F, 0.5F, 0.0F };
  const Image estimate = { 0.5F, 0.25F, 0.5F, 0.25F };
  const VisibilityErrors errors = MeasureErrors(2, 2, truth, estimate);
  EXPECT_DOUBLE_EQ(errors.All.Rmse, std::sqrt(0.375 / 4.0));
  EXPECT_DOUBLE_EQ(errors.All.Mean, 0.25);
  EXPECT_DOUBLE_EQ(errors.All.Bias, 0.125);
  EXPECT_DOUBLE_EQ(errors.All.Maximum, 0.5);
  EXPECT_DOUBLE_EQ(errors.All.Percentile99, 0.5);
  EXPECT_NEAR(errors.All.Psnr, 10.28029, 1e-5); // 10 log10(4 / 0.375)
  EXPECT_EQ(errors.Penumbra.Pixels, 2);
  EXPECT_DOUBLE_EQ(errors.Penumbra.Rmse, std::sqrt(0.03125));
  EXPECT_DOUBLE_EQ(errors.Penumbra.Bias, -0.125);
  EXPECT_DOUBLE_EQ(errors.Penumbra.Maximum, 0.25);
}

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeasures, WorstTileStartsAtTheLowerLeft)
{
  // 64 x 40 pixels: tiles of 32 x 32 in the lower rows, 32 x 8 in the upper eight.
  Image truth(64 * 40, 0.5F);
  Image estimate = truth;
  std::vector<unsigned char> leftOut(truth.size(), 0);
  for (int x = 32; x < 64; ++x)
  {
    estimate[7 * 64 + x] = 0.75F; // a row of an upper tile, an eighth of what it counts as
    estimate[8 * 64 + x] = 0.75F; // of a lower tile, a thirty-second
  }
  estimate[20 * 64] = 0.0F; // the only pixel of its tile with an error, left out
  leftOut[20 * 64] = 1;
  const VisibilityErrors errors = MeasureErrors(64, 40, truth, estimate, leftOut);
  EXPECT_DOUBLE_EQ(errors.WorstTile, 0.25 * std::sqrt(0.125));
  EXPECT_DOUBLE_EQ(errors.WorstTileWithLeftOut, 0.25 * std::sqrt(0.125));
  estimate[20 * 64] = 4.5F;
  EXPECT_DOUBLE_EQ(
    MeasureErrors(64, 40, truth, estimate, leftOut).WorstTileWithLeftOut, 4.0 / 32.0);
  truth.assign(truth.size(), NaN);
  EXPECT_EQ(MeasureErrors(64, 40, truth, estimate).WorstTile, 0.0);
}

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeasures, PercentileLeavesOutOnePixelInAHundred)
{
  Image truth(200, 0.0F);
  Image estimate(200, 0.125F);
  estimate[3] = 1.0F;
  estimate[77] = 0.5F;
  EXPECT_DOUBLE_EQ(MeasureErrors(20, 10, truth, estimate).All.Percentile99, 0.125);
  estimate[150] = 0.25F;
  EXPECT_DOUBLE_EQ(MeasureErrors(20, 10, truth, estimate).All.Percentile99, 0.25);
}

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeasures, CountLeaksAndFalseShadows)
{
  const Image truth = { 0.0F, 0.0F, 0.0F, 0.5F, 1.0F, 1.0F, 1.0F, 1.0F };
  const Image estimate = { 0.05F, 0.2F, 1.0F, 0.0F, 1.0F, 0.95F, 0.5F, 0.8F };
  const VisibilityErrors errors = MeasureErrors(4, 2, truth, estimate);
  EXPECT_EQ(errors.LightLeaks, 2);
  EXPECT_EQ(errors.FalseShadows, 2);
}

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeasures, PixelsWithoutValueAreCountedButNotMeasured)
{
  const Image truth = { NaN, 0.5F, NaN, 1.0F, 0.0F, 0.0F };
  const Image estimate = { NaN, NaN, 0.5F, 0.75F, 0.0F, 1.0F };
  const std::vector<unsigned char> leftOut = { 0, 1, 0, 0, 0, 1 };
  const VisibilityErrors errors = MeasureErrors(6, 1, truth, estimate, leftOut);
  EXPECT_EQ(errors.OnlyInTruth, 1);
  EXPECT_EQ(errors.OnlyInEstimate, 1);
  EXPECT_EQ(errors.LeftOut, 1);
  EXPECT_EQ(errors.All.Pixels, 2);
  EXPECT_DOUBLE_EQ(errors.All.Maximum, 0.25);
  EXPECT_EQ(errors.LightLeaks, 0) << "the leak is at a pixel that is left out";
  EXPECT_EQ(errors.Penumbra.Pixels, 0);
  EXPECT_TRUE(std::isnan(errors.Penumbra.Rmse));
}

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeasures, RefuseImagesOfOtherSizes)
{
  EXPECT_THROW(MeasureErrors(2, 2, Image(4), Image(3)), std::invalid_argument);
  EXPECT_THROW(MeasureErrors(2, 2, Image(4), Image(4), { 1 }), std::invalid_argument);
}

//--------------------------------------------------------------------------------------------------
TEST(StructuralSimilarity, OfConstantsIsTheLuminanceTerm)
{
  const Image first(64, 0.5F);
  const Image second(64, 0.25F);
  const std::vector<double> map =
    StructuralSimilarityMap(8, 8, first, second, std::vector<unsigned char>(64, 1));
  for (double value : map)
  {
    EXPECT_NEAR(value, 0.2501 / 0.3126, 1e-12); // (2 a b + C1) / (a^2 + b^2 + C1)
  }
}

//--------------------------------------------------------------------------------------------------
TEST(StructuralSimilarity, OfInvertedStripesIsNegative)
{
  // Stripes a pixel wide: the window's weights on even and odd columns are equal to 1e-4, so the
  // means are 1/2, the variances 1/4 and the covariance -1/4: (C2 - 1/2) / (C2 + 1/2).
  constexpr int size = 24;
  Image first;
  Image second;
  for (int i = 0; i < size * size; ++i)
  {
    first.push_back(static_cast<float>(i % 2));
    second.push_back(static_cast<float>(1 - i % 2));
  }
  const std::vector<double> map =
    StructuralSimilarityMap(size, size, first, second, std::vector<unsigned char>(size * size, 1));
  EXPECT_NEAR(map[12 * size + 12], (0.0009 - 0.5) / (0.0009 + 0.5), 1e-3);
}

//--------------------------------------------------------------------------------------------------
TEST(StructuralSimilarity, WindowIsElevenPixelsWide)
{
  // One pixel differs: what is more than five pixels away does not notice.
  constexpr int size = 32;
  Image first(size * size, 0.5F);
  Image second = first;
  second[16 * size + 16] = 1.0F;
  const std::vector<double> map =
    StructuralSimilarityMap(size, size, first, second, std::vector<unsigned char>(size * size, 1));
  EXPECT_LT(map[16 * size + 21], 1.0 - 1e-6);
  EXPECT_NEAR(map[16 * size + 22], 1.0, 1e-12);
  // At the pixel itself, weight w = g(0)^2 of the window: meanB = 0.5 + w / 2, varB = w (1 - w) / 4.
  double sum = 0.0;
  for (int i = -5; i <= 5; ++i)
  {
    sum += std::exp(-i * i / 4.5);
  }
  const double w = 1.0 / (sum * sum);
  const double mean = 0.5 + 0.5 * w;
  const double luminance = (mean + 1e-4) / (0.25 + mean * mean + 1e-4);
  const double contrast = 9e-4 / (0.25 * w * (1.0 - w) + 9e-4);
  EXPECT_NEAR(map[16 * size + 16], luminance * contrast, 1e-12);
}

//--------------------------------------------------------------------------------------------------
TEST(StructuralSimilarity, DoesNotSeeUnusedPixels)
{
  Image first(121, 0.5F);
  Image second(121, 0.5F);
  std::vector<unsigned char> used(121, 1);
  for (size_t i = 0; i < 121; i += 3)
  {
    first[i] = NaN;
    second[i] = 7.0F;
    used[i] = 0;
  }
  const std::vector<double> map = StructuralSimilarityMap(11, 11, first, second, used);
  EXPECT_TRUE(std::isnan(map[0]));
  EXPECT_NEAR(map[1], 1.0, 1e-12);
}

//--------------------------------------------------------------------------------------------------
TEST(DifferencePicture, IsBlueRedWhiteAndGrey)
{
  const Image truth = { 0.5F, 1.0F, 0.0F, NaN, NaN };
  const Image estimate = { 0.5F, 0.0F, 1.0F, NaN, 0.5F };
  const std::vector<unsigned char> rgb = DrawDifference(truth, estimate);
  ASSERT_EQ(rgb.size(), 15U);
  EXPECT_GT(std::min({ rgb[0], rgb[1], rgb[2] }), 215) << "no error: white";
  EXPECT_GT(rgb[5], 2 * rgb[3]) << "too dark: blue";
  EXPECT_GT(rgb[6], 2 * rgb[8]) << "too bright: red";
  EXPECT_EQ(rgb[9], 128);
  EXPECT_EQ(rgb[10], 128);
  EXPECT_EQ(rgb[12], 0) << "a value in one image alone: black";
}

}
