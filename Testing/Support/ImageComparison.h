// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageComparison.h
 * @brief Pictures against pictures, by OpenImageIO, under tolerances that have names.
 *
 * A tolerance limits three things at once, because each alone is blind to something: the worst
 * pixel (a hole), the share of pixels that are off by more than a limit (a band), and the root mean
 * square (a penumbra that is everywhere a little too wide).
 */

#ifndef SoftShadowsTesting_ImageComparison_h
#define SoftShadowsTesting_ImageComparison_h

#include "Picture.h"

#include <gtest/gtest.h>

#include <string> // For names

namespace SoftShadowsTesting
{

struct Tolerance
{
  const char* Name;
  /// No channel of any pixel may be off by more.
  double Maximum;
  /// A pixel is off if a channel differs by more than this.
  double PixelLimit;
  /// Largest share of pixels that may be off.
  double ShareOff;
  /// Largest root mean square over all channels.
  double RootMeanSquare;
};

///@{
/// The one table of tolerances; see ImageComparison.cxx for what each is for.
extern const Tolerance Identical;
extern const Tolerance SameToRounding;
extern const Tolerance SameButForFlips;
extern const Tolerance SameButForEdges;
extern const Tolerance BaselinePicture;
///@}

struct Difference
{
  double Maximum = 0.0;
  double RootMeanSquare = 0.0;
  double ShareOff = 0.0;
  /// Where the maximum is (bottom row first) and the two values there.
  int X = 0;
  int Y = 0;
  int Channel = 0;
  double First = 0.0;
  double Second = 0.0;
  /// Channels that are NaN in one picture only. Where both are NaN they are the same.
  int NaNsInOneOnly = 0;
};

/// Both pictures must have the same size and number of channels.
Difference Compare(const Picture& first, const Picture& second, const Tolerance& tolerance);

/// For EXPECT_TRUE: the message has the tolerance, the sizes, the worst pixel and both its values.
testing::AssertionResult Matches(
  const Picture& first, const Picture& second, const Tolerance& tolerance);

/**
 * Compares with a baseline file. If it is missing or differs, the picture (and what differs) are
 * written to the output folder and the message says where.
 */
testing::AssertionResult MatchesBaseline(const Picture& picture, const std::string& name,
  const std::string& baselineFolder, const std::string& outputFolder, const Tolerance& tolerance);

}

#endif
