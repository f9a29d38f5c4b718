// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShiftedEdges.h"

#include <algorithm> // For the range
#include <cmath>     // For std::abs

namespace softshadows
{
namespace
{

struct Range
{
  double Least;
  double Greatest;
};

//--------------------------------------------------------------------------------------------------
// Of the 3 x 3 values around a pixel that are numbers.
Range RangeAround(int width, int height, const std::vector<float>& truth, int x, int y)
{
  const double own = truth[static_cast<size_t>(y) * width + x];
  Range range{ own, own };
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j)
  {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i)
    {
      const double other = truth[static_cast<size_t>(j) * width + i];
      range.Least = other < range.Least ? other : range.Least; // not NaN
      range.Greatest = other > range.Greatest ? other : range.Greatest;
    }
  }
  return range;
}

//--------------------------------------------------------------------------------------------------
// Whether the estimate shows the same as in a pixel around, in which both images agree.
bool ShowsTheSameAsBeside(int width, int height, const std::vector<float>& truth,
  const std::vector<float>& estimate, int x, int y, double tolerance)
{
  const size_t pixel = static_cast<size_t>(y) * width + x;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j)
  {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i)
    {
      const size_t other = static_cast<size_t>(j) * width + i;
      if (std::abs(estimate[other] - estimate[pixel]) <= tolerance &&
        std::abs(estimate[other] - truth[other]) <= tolerance)
      {
        return true;
      }
    }
  }
  return false;
}

}

//--------------------------------------------------------------------------------------------------
std::vector<unsigned char> FindShiftedEdges(int width, int height, const std::vector<float>& truth,
  const std::vector<float>& estimate, double tolerance)
{
  std::vector<unsigned char> found(truth.size(), 0);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const size_t pixel = static_cast<size_t>(y) * width + x;
      const double value = estimate[pixel];
      if (std::abs(value - truth[pixel]) > tolerance)
      {
        const Range range = RangeAround(width, height, truth, x, y);
        const bool isBeside =
          value >= range.Least - tolerance && value <= range.Greatest + tolerance;
        found[pixel] =
          isBeside || ShowsTheSameAsBeside(width, height, truth, estimate, x, y, tolerance) ? 1 : 0;
      }
    }
  }
  return found;
}

//--------------------------------------------------------------------------------------------------
int CountEdges(int width, int height, const std::vector<float>& truth, double tolerance)
{
  int count = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const Range range = RangeAround(width, height, truth, x, y);
      count += range.Greatest - range.Least > tolerance ? 1 : 0;
    }
  }
  return count;
}

}
