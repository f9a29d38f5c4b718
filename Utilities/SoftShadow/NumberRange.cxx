// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NumberRange.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
std::string Spell(double value)
{
  std::ostringstream text;
  text.precision(value == std::floor(value) ? 10 : 6);
  text << value;
  return text.str();
}

//--------------------------------------------------------------------------------------------------
/// The text as a number; what is none, and what is not finite, is not a number.
double Parse(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isWhole = end != text.c_str() && *end == '\0';
  return isWhole && std::isfinite(value) ? value : std::nan("");
}

//--------------------------------------------------------------------------------------------------
/// The condition must be false of what is not a number.
CLI::Validator Make(
  const std::string& wanted, const std::string& shown, const std::function<bool(double)>& isRight)
{
  const auto check = [wanted, isRight](std::string& text)
  { return isRight(Parse(text)) ? std::string() : "must be " + wanted + ", is '" + text + "'"; };
  return { check, shown };
}

}

//--------------------------------------------------------------------------------------------------
CLI::Validator WholeNumber(long long least, long long most)
{
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  return Make("a whole number from " + range, "in " + range,
    [least, most](double value)
    {
      return value == std::floor(value) && value >= static_cast<double>(least) &&
        value <= static_cast<double>(most);
    });
}

//--------------------------------------------------------------------------------------------------
CLI::Validator Number(double least, double most)
{
  const std::string range = Spell(least) + " to " + Spell(most);
  return Make("a number from " + range, "in " + range,
    [least, most](double value) { return value >= least && value <= most; });
}

//--------------------------------------------------------------------------------------------------
CLI::Validator NumberAboveZero()
{
  return Make("a number above 0", "above 0", [](double value) { return value > 0.0; });
}

}
