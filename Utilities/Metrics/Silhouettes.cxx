// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouettes.h"

#include <cmath> // For std::isnan

namespace softshadows
{
namespace
{

constexpr double LargestStep = 0.01;

//--------------------------------------------------------------------------------------------------
class DepthView
{
public:
  DepthView(int width, int height, const std::vector<float>& depth)
    : Width(width)
    , Height(height)
    , Depth(depth)
  {
  }

  double At(int x, int y) const { return this->Depth[static_cast<size_t>(y) * this->Width + x]; }

  bool IsSilhouette(int x, int y) const
  {
    return this->Breaks(x, y, 1, 0) || this->Breaks(x, y, 0, 1) || this->Breaks(x, y, 1, 1) ||
      this->Breaks(x, y, 1, -1);
  }

private:
  bool Has(int x, int y) const { return x >= 0 && y >= 0 && x < this->Width && y < this->Height; }

  bool IsEmpty(int x, int y) const { return this->Has(x, y) && std::isnan(this->At(x, y)); }

  bool Breaks(int x, int y, int dx, int dy) const
  {
    if (this->IsEmpty(x + dx, y + dy) || this->IsEmpty(x - dx, y - dy))
    {
      return true;
    }
    if (!this->Has(x + dx, y + dy) || !this->Has(x - dx, y - dy))
    {
      return false;
    }
    const double centre = this->At(x, y);
    const double mean = 0.5 * (1.0 / this->At(x + dx, y + dy) + 1.0 / this->At(x - dx, y - dy));
    return std::abs(centre * mean - 1.0) > LargestStep;
  }

  int Width;
  int Height;
  const std::vector<float>& Depth;
};

}

//--------------------------------------------------------------------------------------------------
std::vector<unsigned char> FindSilhouettes(int width, int height, const std::vector<float>& depth)
{
  const DepthView view(width, height, depth);
  std::vector<unsigned char> found(depth.size(), 0);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const bool isEdge = !std::isnan(view.At(x, y)) && view.IsSilhouette(x, y);
      found[static_cast<size_t>(y) * width + x] = isEdge ? 1 : 0;
    }
  }
  return found;
}

}
