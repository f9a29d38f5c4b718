// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedFilter.h"

#include "vtkTracedLight.h"
#include "vtkTracedReceivers.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

constexpr float Unbounded = std::numeric_limits<float>::infinity();
constexpr float Flattest =
  0.2f; // sine of the angle between a surface and the way to a neighbour on it
constexpr float LeastCosine = 0.9f;   // of their normals
constexpr float SameCosine = 0.9999f; // where their tilt tells what they see of the light

float Dot(const float* a, const float* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

//------------------------------------------------------------------------------
vtkTracedFilter::vtkTracedFilter(const vtkTracedReceivers& receivers, const vtkTracedLight& light,
  const std::vector<vtkTracedPixel>& pixels)
  : Receivers(receivers)
  , Light(light)
  , Pixels(pixels)
  , Width(receivers.GetWidth())
  , Height(receivers.GetHeight())
{
}

//------------------------------------------------------------------------------
vtkTracedFilter::Window vtkTracedFilter::GetWindow(int x, int y, int reach) const
{
  return { std::max(x - reach, 0), std::min(x + reach, this->Width - 1), std::max(y - reach, 0),
    std::min(y + reach, this->Height - 1) };
}

//------------------------------------------------------------------------------
bool vtkTracedFilter::AreOnOneSurface(std::size_t a, std::size_t b) const
{
  const float* p = this->Receivers.GetPosition(a);
  const float* q = this->Receivers.GetPosition(b);
  const float* n = this->Receivers.GetNormal(a);
  const float* m = this->Receivers.GetNormal(b);
  const float way[3] = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
  const float limit = Flattest * Flattest * Dot(way, way);
  const float first = Dot(n, way);
  const float second = Dot(m, way);
  const bool horizon = this->Pixels[a].IsAtHorizon || this->Pixels[b].IsAtHorizon;
  return Dot(n, m) > (horizon ? SameCosine : LeastCosine) && first * first <= limit &&
    second * second <= limit;
}

//------------------------------------------------------------------------------
float vtkTracedFilter::FindOwnWidth(int x, int y) const
{
  const std::size_t pixel = this->At(x, y);
  const vtkTracedPixel& sums = this->Pixels[pixel];
  if (sums.Hits == 0.0f)
  {
    return Unbounded;
  }
  // The pixel's own size, where it is the longest.
  float footprint = 0.0f;
  const float* p = this->Receivers.GetPosition(pixel);
  const int neighbours[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
  for (const auto& offset : neighbours)
  {
    const int column = x + offset[0];
    const int row = y + offset[1];
    if (column < 0 || row < 0 || column >= this->Width || row >= this->Height)
    {
      continue;
    }
    const std::size_t other = this->At(column, row);
    if (this->Pixels[other].IsKnown() && this->AreOnOneSurface(pixel, other))
    {
      const float* q = this->Receivers.GetPosition(other);
      const float way[3] = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
      footprint = std::max(footprint, Dot(way, way));
    }
  }
  footprint = this->Receivers.GetScale() * std::sqrt(footprint);
  const float width = this->Light.GetSize() * sums.Spread / sums.Hits;
  return footprint > 0.0f ? width / footprint : 0.0f;
}

//------------------------------------------------------------------------------
float vtkTracedFilter::FindWidth(int x, int y, const std::vector<float>& widths) const
{
  const Window window = this->GetWindow(x, y, Reach);
  float width = Unbounded;
  for (int row = window.Bottom; row <= window.Top; ++row)
  {
    for (int column = window.Left; column <= window.Right; ++column)
    {
      width = std::min(width, widths[this->At(column, row)]);
    }
  }
  return width;
}

//------------------------------------------------------------------------------
bool vtkTracedFilter::IsMixed(int x, int y) const
{
  const Window window = this->GetWindow(x, y, Reach);
  bool lit = false;
  bool dark = false;
  for (int row = window.Bottom; row <= window.Top; ++row)
  {
    for (int column = window.Left; column <= window.Right; ++column)
    {
      const vtkTracedPixel& sums = this->Pixels[this->At(column, row)];
      lit = lit || sums.Lit > 0.0f;
      dark = dark || sums.Lit < sums.All;
    }
  }
  return lit && dark;
}

//------------------------------------------------------------------------------
float vtkTracedFilter::FindMean(int x, int y, float width) const
{
  const std::size_t pixel = this->At(x, y);
  const float edge = std::min(std::max(0.5f * width, 1.0f), WidestMean);
  const Window window = this->GetWindow(x, y, Reach);
  float sum = 0.0f;
  float weights = 0.0f;
  for (int row = window.Bottom; row <= window.Top; ++row)
  {
    // Of a block at any place, its border counted in part: every run of points has the same weight.
    const float rowWeight =
      std::min(std::max(0.5f * (edge + 1.0f) - static_cast<float>(std::abs(row - y)), 0.0f), 1.0f);
    for (int column = window.Left; column <= window.Right; ++column)
    {
      const float weight = rowWeight *
        std::min(
          std::max(0.5f * (edge + 1.0f) - static_cast<float>(std::abs(column - x)), 0.0f), 1.0f);
      const std::size_t other = this->At(column, row);
      if (weight > 0.0f && this->Pixels[other].IsKnown() &&
        (other == pixel || this->AreOnOneSurface(pixel, other)))
      {
        sum += weight * this->Pixels[other].GetVisibility();
        weights += weight;
      }
    }
  }
  return sum / weights;
}
VTK_ABI_NAMESPACE_END
