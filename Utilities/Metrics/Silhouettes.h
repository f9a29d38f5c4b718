// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Silhouettes.h
 * @brief Pixels at silhouettes of the primary view, which comparisons leave out.
 *
 * There a sample belongs to one of two surfaces by a hair, and techniques that differentiate over
 * neighbouring pixels mix both. The rule: 1 / depth is an affine function of the pixel for any plane
 * seen in perspective. Along each of the four lines through a pixel's 3 x 3 neighbourhood the pixel
 * is compared with the mean of its two neighbours; it is left out if they differ by more than one
 * percent of 1 / depth on any line, or if a neighbour sees no surface. So planes at any grazing angle
 * stay, steps go, on both sides. Outside the image nothing is compared.
 */

#ifndef SoftShadowsMetrics_Silhouettes_h
#define SoftShadowsMetrics_Silhouettes_h

#include <vector> // For images

namespace softshadows
{

/**
 * 1 at silhouettes, else 0 (also where there is no surface). depth: linear view depth, top row
 * first, NaN where there is no surface.
 */
std::vector<unsigned char> FindSilhouettes(int width, int height, const std::vector<float>& depth);

}

#endif
