// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VisibilityPicture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace softshadows
{
namespace
{

using Color = std::array<unsigned char, 3>;

constexpr Color NoValue{ { 70, 80, 100 } };

//--------------------------------------------------------------------------------------------------
template <typename Function>
std::vector<unsigned char> Draw(const std::vector<float>& values, const Function& colorOf)
{
  std::vector<unsigned char> rgb;
  rgb.reserve(3 * values.size());
  for (const float value : values)
  {
    const Color color = std::isnan(value) ? NoValue : colorOf(value);
    rgb.insert(rgb.end(), color.begin(), color.end());
  }
  return rgb;
}

//--------------------------------------------------------------------------------------------------
/// Dark blue, purple, red, orange, yellow: ever brighter, and told apart without colour too.
Color BandColor(float visibility)
{
  static const std::array<Color, 5> colors = { { { { 30, 20, 110 } }, { { 120, 30, 150 } },
    { { 205, 60, 90 } }, { { 245, 140, 50 } }, { { 250, 225, 90 } } } };
  constexpr int bands = 10;
  const int band = std::clamp(static_cast<int>(visibility * bands), 0, bands - 1);
  const double place = band * (colors.size() - 1.0) / (bands - 1.0);
  const auto below = std::min(static_cast<std::size_t>(place), colors.size() - 2);
  const double share = place - static_cast<double>(below);
  Color color;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = static_cast<unsigned char>(
      std::lround((1.0 - share) * colors[below][i] + share * colors[below + 1][i]));
  }
  return color;
}

}

//--------------------------------------------------------------------------------------------------
std::vector<unsigned char> DrawGrey(const std::vector<float>& values)
{
  return Draw(values,
    [](float value)
    {
      const auto grey =
        static_cast<unsigned char>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
      return Color{ { grey, grey, grey } };
    });
}

//--------------------------------------------------------------------------------------------------
std::vector<unsigned char> DrawPenumbra(const std::vector<float>& visibility)
{
  constexpr float umbra = 0.02F;
  constexpr float lit = 0.98F;
  return Draw(visibility,
    [](float value)
    {
      if (value <= umbra)
      {
        return Color{ { 0, 0, 0 } };
      }
      return value >= lit ? Color{ { 255, 255, 255 } } : BandColor(value);
    });
}

}
