// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuralSimilarity.h"

#include <algorithm> // For std::clamp
#include <array>     // For the window
#include <cmath>     // For std::exp
#include <limits>    // For NaN

namespace softshadows
{
namespace
{

constexpr int Radius = 5;
using Window = std::array<double, 2 * Radius + 1>;

//--------------------------------------------------------------------------------------------------
Window MakeWindow()
{
  constexpr double deviation = 1.5;
  Window window;
  for (int i = -Radius; i <= Radius; ++i)
  {
    window[i + Radius] = std::exp(-0.5 * i * i / (deviation * deviation));
  }
  return window;
}

//--------------------------------------------------------------------------------------------------
// Weighted sums along rows (step 1) or columns (step width); nothing lies beyond the border.
std::vector<double> BlurAlong(
  const std::vector<double>& image, int width, int height, bool rows, const Window& window)
{
  std::vector<double> result(image.size(), 0.0);
  const int length = rows ? width : height;
  const int step = rows ? 1 : width;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const int place = rows ? x : y;
      const std::ptrdiff_t centre = static_cast<std::ptrdiff_t>(y) * width + x;
      const int last = std::min(Radius, length - 1 - place);
      double sum = 0.0;
      for (int k = std::max(-Radius, -place); k <= last; ++k)
      {
        sum += window[k + Radius] * image[centre + static_cast<std::ptrdiff_t>(k) * step];
      }
      result[centre] = sum;
    }
  }
  return result;
}

//--------------------------------------------------------------------------------------------------
// The window's sums of product(i) over the used pixels.
template <typename Product>
std::vector<double> Blur(
  int width, int height, const std::vector<unsigned char>& used, Product product)
{
  static const Window window = MakeWindow();
  std::vector<double> image(used.size(), 0.0);
  for (size_t i = 0; i < used.size(); ++i)
  {
    image[i] = used[i] ? product(i) : 0.0;
  }
  return BlurAlong(BlurAlong(image, width, height, true, window), width, height, false, window);
}

}

//--------------------------------------------------------------------------------------------------
std::vector<double> StructuralSimilarityMap(int width, int height, const std::vector<float>& first,
  const std::vector<float>& second, const std::vector<unsigned char>& used)
{
  const auto blur = [&](auto product) { return Blur(width, height, used, product); };
  const auto a = [&](size_t i) { return static_cast<double>(first[i]); };
  const auto b = [&](size_t i) { return static_cast<double>(second[i]); };
  const std::vector<double> weights = blur([](size_t) { return 1.0; });
  const std::vector<double> sumA = blur(a);
  const std::vector<double> sumB = blur(b);
  const std::vector<double> sumAA = blur([&](size_t i) { return a(i) * a(i); });
  const std::vector<double> sumBB = blur([&](size_t i) { return b(i) * b(i); });
  const std::vector<double> sumAB = blur([&](size_t i) { return a(i) * b(i); });

  constexpr double c1 = 0.01 * 0.01;
  constexpr double c2 = 0.03 * 0.03;
  std::vector<double> map(used.size(), std::numeric_limits<double>::quiet_NaN());
  for (size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i])
    {
      continue;
    }
    const double meanA = sumA[i] / weights[i];
    const double meanB = sumB[i] / weights[i];
    // Rounding may take a variance below 0.
    const double varianceA = std::max(0.0, sumAA[i] / weights[i] - meanA * meanA);
    const double varianceB = std::max(0.0, sumBB[i] / weights[i] - meanB * meanB);
    const double covariance = sumAB[i] / weights[i] - meanA * meanB;
    map[i] = (2.0 * meanA * meanB + c1) * (2.0 * covariance + c2) /
      ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
  }
  return map;
}

}
