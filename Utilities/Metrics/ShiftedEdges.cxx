// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShiftedEdges.h"

#include <algorithm> // For the range
#include <cmath>     // For std::abs

namespace softshadows
{

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
      if (!(std::abs(value - truth[pixel]) > tolerance))
      {
        continue;
      }
      double least = truth[pixel];
      double greatest = truth[pixel];
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j)
      {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i)
        {
          const double other = truth[static_cast<size_t>(j) * width + i];
          least = other < least ? other : least; // not NaN
          greatest = other > greatest ? other : greatest;
        }
      }
      found[pixel] = value >= least - tolerance && value <= greatest + tolerance ? 1 : 0;
    }
  }
  return found;
}

}
