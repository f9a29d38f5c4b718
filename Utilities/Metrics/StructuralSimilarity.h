// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StructuralSimilarity.h
 * @brief The structural similarity of two images (Wang, Bovik, Sheikh, Simoncelli 2004).
 *
 * Window: Gaussian of 11 x 11 pixels, standard deviation 1.5. Constants K1 = 0.01, K2 = 0.03; the
 * range of values is 1. Where a window reaches pixels that are not used (no value, left out, beyond
 * the border) its weights are spread over the rest; the paper's own code drops the border instead.
 */

#ifndef SoftShadowsMetrics_StructuralSimilarity_h
#define SoftShadowsMetrics_StructuralSimilarity_h

#include <vector> // For images

namespace softshadows
{

/**
 * The SSIM at every used pixel, in [-1, 1], 1 for equal surroundings; NaN at the others. used holds
 * one value per pixel, not 0 for pixels whose values count.
 */
std::vector<double> StructuralSimilarityMap(int width, int height, const std::vector<float>& first,
  const std::vector<float>& second, const std::vector<unsigned char>& used);

}

#endif
