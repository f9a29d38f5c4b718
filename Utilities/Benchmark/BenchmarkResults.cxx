// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkResults.h"

#include <algorithm> // For sorting
#include <cmath>     // For roots
#include <limits>    // For NaN
#include <numeric>   // For sums

namespace softshadows
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
}

//--------------------------------------------------------------------------------------------------
const char* NameOf(Motion motion)
{
  switch (motion)
  {
    case Motion::Still:
      return "still";
    case Motion::Camera:
      return "camera";
    default:
      return "light";
  }
}

//--------------------------------------------------------------------------------------------------
double FrameTimes::Quantile(double share) const
{
  if (this->Milliseconds.empty())
  {
    return NaN;
  }
  std::vector<double> sorted = this->Milliseconds;
  std::sort(sorted.begin(), sorted.end());
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

//--------------------------------------------------------------------------------------------------
double FrameTimes::Mean() const
{
  const double sum = std::accumulate(this->Milliseconds.begin(), this->Milliseconds.end(), 0.0);
  return this->Milliseconds.empty() ? NaN : sum / static_cast<double>(this->Milliseconds.size());
}

//--------------------------------------------------------------------------------------------------
double FrameTimes::StandardDeviation() const
{
  if (this->Milliseconds.size() < 2)
  {
    return this->Milliseconds.empty() ? NaN : 0.0;
  }
  const double mean = this->Mean();
  double squares = 0.0;
  for (double time : this->Milliseconds)
  {
    squares += (time - mean) * (time - mean);
  }
  return std::sqrt(squares / static_cast<double>(this->Milliseconds.size() - 1));
}

}
