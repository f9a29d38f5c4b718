// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedPicture.h"

#include "vtkTracedFilter.h"
#include "vtkTracedLight.h"
#include "vtkTracedReceivers.h"
#include "vtkTracedScene.h"
#include "vtkTracedWorkers.h"

#include <algorithm>
#include <atomic>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int Tile = 16; // pixels along an edge
}

//------------------------------------------------------------------------------
void vtkTracedPicture::ForEachTile(vtkTracedWorkers& workers,
  const std::function<void(int left, int right, int bottom, int top)>& work) const
{
  const int columns = (this->Width + Tile - 1) / Tile;
  const int rows = (this->Height + Tile - 1) / Tile;
  workers.Run(columns * rows,
    [&](int tile)
    {
      const int left = Tile * (tile % columns);
      const int bottom = Tile * (tile / columns);
      work(left, std::min(left + Tile, this->Width), bottom, std::min(bottom + Tile, this->Height));
    });
}

//------------------------------------------------------------------------------
template <typename Functor>
void vtkTracedPicture::ForEachPixel(vtkTracedWorkers& workers, Functor&& work) const
{
  this->ForEachTile(workers,
    [&](int left, int right, int bottom, int top)
    {
      for (int y = bottom; y < top; ++y)
      {
        for (int x = left; x < right; ++x)
        {
          work(x, y, static_cast<std::size_t>(y) * this->Width + x);
        }
      }
    });
}

//------------------------------------------------------------------------------
long long vtkTracedPicture::Trace(const vtkTracedScene& scene, const vtkTracedLight& light,
  const vtkTracedReceivers& receivers, vtkTracedWorkers& workers, const Steps& steps)
{
  this->Width = receivers.GetWidth();
  this->Height = receivers.GetHeight();
  const std::size_t count = static_cast<std::size_t>(this->Width) * this->Height;
  this->Pixels.assign(count, vtkTracedPixel());
  this->Visibilities.resize(count);
  std::atomic<long long> shot{ 0 };
  const auto shoot = [&](int first, int last, const auto& isAsked)
  {
    this->ForEachTile(workers,
      [&](int left, int right, int bottom, int top)
      {
        vtkTracedRays rays(scene, light, this->Pixels);
        for (int y = bottom; y < top; ++y)
        {
          for (int x = left; x < right; ++x)
          {
            const std::size_t pixel = static_cast<std::size_t>(y) * this->Width + x;
            if (isAsked(pixel))
            {
              const vtkTracedReceivers::Point receiver = receivers.GetPoint(pixel);
              if (light.Reaches(receiver.Place))
              {
                rays.Add(pixel, x, y, receiver, first, last);
              }
            }
          }
        }
        rays.Flush();
        shot += rays.GetCount();
      });
  };
  shoot(0, light.GetRays(), [&](std::size_t pixel) { return receivers.Receives(pixel); });

  const vtkTracedFilter filter(receivers, light, this->Pixels);
  std::vector<float>& widths = this->Visibilities; // until they are known
  if (steps.Adapts || steps.Filters)
  {
    constexpr float none = -1.0f;
    this->OwnWidths.resize(count);
    this->ForEachPixel(workers,
      [&](int x, int y, std::size_t pixel) { this->OwnWidths[pixel] = filter.FindOwnWidth(x, y); });
    this->ForEachPixel(workers,
      [&](int x, int y, std::size_t pixel)
      {
        widths[pixel] = this->Pixels[pixel].IsKnown() && filter.IsMixed(x, y)
          ? filter.FindWidth(x, y, this->OwnWidths)
          : none;
      });
  }
  if (steps.Adapts && light.GetMostRays() > light.GetRays())
  {
    shoot(light.GetRays(), light.GetMostRays(),
      [&](std::size_t pixel)
      { return widths[pixel] >= 0.0f && vtkTracedFilter::IsNarrow(widths[pixel]); });
  }
  this->ForEachPixel(workers,
    [&](int x, int y, std::size_t pixel)
    {
      const vtkTracedPixel& sums = this->Pixels[pixel];
      const float own = sums.IsKnown() ? sums.GetVisibility() : 1.0f;
      this->Visibilities[pixel] =
        steps.Filters && widths[pixel] >= 0.0f ? filter.FindMean(x, y, widths[pixel]) : own;
    });
  return shot;
}
VTK_ABI_NAMESPACE_END
