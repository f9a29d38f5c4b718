// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShiftedEdges.h
 * @brief Pixels that lie on the other side of an edge in one of two images of the same scene.
 *
 * Whether a pixel's centre is on this or on that side of an edge, of two triangles or of a hard shadow,
 * hangs on a hair where it lies on the edge, and OpenGL drivers differ by a hair. Such a pixel has a
 * value that the other image has beside it, or its own image where both agree. One that a wrong
 * estimate made has not.
 */

#ifndef SoftShadowsMetrics_ShiftedEdges_h
#define SoftShadowsMetrics_ShiftedEdges_h

#include <vector> // For images

namespace softshadows
{

/// What two drivers' values may differ by without any edge.
constexpr double DriverTolerance = 0.02;

/**
 * 1 where the estimate differs from the truth by more than the tolerance, and either lies between the
 * least and the greatest value of the truth's 3 x 3 pixels around or no farther beyond them than the
 * tolerance, or differs by no more than that from a pixel around in which both images do not either;
 * else 0. Top row first, NaN where there is no value: such a pixel is on no edge and has no part in the
 * least and the greatest.
 */
std::vector<unsigned char> FindShiftedEdges(int width, int height, const std::vector<float>& truth,
  const std::vector<float>& estimate, double tolerance = DriverTolerance);

/// How many pixels could be found: those around which the truth's 3 x 3 values differ by more than the
/// tolerance.
int CountEdges(
  int width, int height, const std::vector<float>& truth, double tolerance = DriverTolerance);

}

#endif
