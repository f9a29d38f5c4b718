// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DifferencePicture.h
 * @brief Errors in colours: blue where the estimate is too dark, red where it is too bright.
 */

#ifndef SoftShadowsMetrics_DifferencePicture_h
#define SoftShadowsMetrics_DifferencePicture_h

#include <vector> // For images

namespace softshadows
{

/// The error that has the strongest colour by default.
constexpr double DefaultDifferenceRange = 0.25;

/**
 * estimate - truth as RGB bytes, top row first, in the diverging colours of Moreland 2009: blue at
 * -range and below, white at 0, red at range and above. Black where one image alone has a value,
 * grey where neither has.
 */
std::vector<unsigned char> DrawDifference(const std::vector<float>& truth,
  const std::vector<float>& estimate, double range = DefaultDifferenceRange);

}

#endif
