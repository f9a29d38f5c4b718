// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FaceCorners_h
#define FaceCorners_h

#include <algorithm>

namespace softshadows
{

/// Whether a face has three corners at different points, so that it can be shown. pointOf: the number
/// of a corner's point.
template <typename Corners, typename PointOf>
bool HasThreePoints(const Corners& corners, PointOf pointOf)
{
  if (corners.empty())
  {
    return false;
  }
  const auto first = pointOf(corners.front());
  const auto second = std::find_if(
    corners.begin(), corners.end(), [&](const auto& corner) { return pointOf(corner) != first; });
  return std::any_of(second, corners.end(),
    [&](const auto& corner)
    { return pointOf(corner) != first && pointOf(corner) != pointOf(*second); });
}

}

#endif
