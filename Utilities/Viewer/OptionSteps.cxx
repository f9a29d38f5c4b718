// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OptionSteps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
double StepInteger(const TechniqueOption& option, double value, bool up)
{
  constexpr double doublingRange = 256.0;
  constexpr double shortRange = 32.0;
  const double least = std::max(1.0, option.Least);
  if (option.Most > doublingRange * least)
  {
    return up ? std::max(1.0, 2.0 * value) : std::floor(0.5 * value);
  }
  const double step = option.Most - option.Least <= shortRange ? 1.0 : 2.0;
  return up ? value + step : value - step;
}

//--------------------------------------------------------------------------------------------------
/// To three digits, so that up and down again is where it was.
double Round(double value)
{
  if (value == 0.0)
  {
    return 0.0;
  }
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
  return std::round(value / unit) * unit;
}

//--------------------------------------------------------------------------------------------------
double StepNumber(const TechniqueOption& option, double value, bool up)
{
  constexpr double ratio = 1.25;
  const double range = option.Most - option.Least;
  if ((option.Least <= 0.0 && range <= 1.0) || value <= 0.0)
  {
    const double step = 0.05 * std::min(range, 1.0);
    // On multiples of the step, where rounding is not carried along.
    const double place = std::round((value - option.Least) / step);
    return option.Least + step * (up ? place + 1.0 : place - 1.0);
  }
  return Round(up ? value * ratio : value / ratio);
}

}

//--------------------------------------------------------------------------------------------------
double StepValue(const TechniqueOption& option, double value, int steps)
{
  if (!option.Choices.empty())
  {
    const int count = static_cast<int>(option.Choices.size());
    const int place = (static_cast<int>(value) + steps) % count;
    return place < 0 ? place + count : place;
  }
  for (int i = 0; i < std::abs(steps); ++i)
  {
    value = option.Is == TechniqueOption::Kind::Integer ? StepInteger(option, value, steps > 0)
                                                        : StepNumber(option, value, steps > 0);
    value = std::clamp(value, option.Least, option.Most);
  }
  return value;
}

}
