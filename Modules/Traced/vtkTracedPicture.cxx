// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedPicture.h"

#include "vtkTracedFilter.h"
#include "vtkTracedLight.h"
#include "vtkTracedReceivers.h"
#include "vtkTracedScene.h"
#include "vtkTracedShaft.h"
#include "vtkTracedWorkers.h"

#include <algorithm>
#include <array>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int Tile = 16;          // pixels along an edge
constexpr float NotMixed = -1.0f; // in place of a width, where there is no penumbra
}

//------------------------------------------------------------------------------
vtkTracedPicture::Area vtkTracedPicture::GetArea(int tile) const
{
  const int left = Tile * (tile % this->Columns);
  const int bottom = Tile * (tile / this->Columns);
  return { tile, left, std::min(left + Tile, this->Width), bottom,
    std::min(bottom + Tile, this->Height) };
}

//------------------------------------------------------------------------------
void vtkTracedPicture::ForEachTile(const std::function<void(const Area&)>& work) const
{
  this->Workers.Run(this->Columns * this->Rows, [&](int tile) { work(this->GetArea(tile)); });
}

//------------------------------------------------------------------------------
template <typename Functor>
void vtkTracedPicture::ForEachPixel(const Area& area, Functor&& work) const
{
  for (int y = area.Bottom; y < area.Top; ++y)
  {
    for (int x = area.Left; x < area.Right; ++x)
    {
      work(x, y, static_cast<std::size_t>(y) * this->Width + x);
    }
  }
}

//------------------------------------------------------------------------------
template <typename Functor>
vtkTracedPicture::Sight vtkTracedPicture::LookAround(int tile, Functor&& look) const
{
  const int column = tile % this->Columns;
  const int row = tile / this->Columns;
  Sight sight;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, this->Rows - 1); ++y)
  {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, this->Columns - 1); ++x)
    {
      sight.Add(look(static_cast<std::size_t>(y) * this->Columns + x));
    }
  }
  return sight;
}

//------------------------------------------------------------------------------
void vtkTracedPicture::ShootFirst(const vtkTracedLight& light, const Area& area, bool proves)
{
  struct Asked
  {
    int X;
    int Y;
    std::size_t Pixel;
    vtkTracedReceivers::Point Receiver;
  };
  std::array<Asked, Tile * Tile> asked;
  std::size_t count = 0;
  vtkTracedShaft shaft;
  this->ForEachPixel(area,
    [&](int x, int y, std::size_t pixel)
    {
      if (!this->Receivers.Receives(pixel))
      {
        return;
      }
      const vtkTracedReceivers::Point receiver = this->Receivers.GetPoint(pixel);
      if (light.Reaches(receiver.Place))
      {
        shaft.AddReceiver(receiver.Place, receiver.Normal, receiver.Precision);
        asked[count++] = { x, y, pixel, receiver };
      }
    });
  Sight& sight = this->Tiles[static_cast<std::size_t>(area.Tile)];
  sight = Sight();
  if (count == 0)
  {
    return;
  }
  vtkTracedRays rays(this->Scene, light, this->Receivers.GetEye(), this->Pixels);
  // A proof takes the time of a ray per box: with more boxes than rays it does not pay.
  if (proves && this->Scene.GetBoxes().size() <= count * static_cast<std::size_t>(light.GetRays()))
  {
    light.End(shaft, this->Scene);
    rays.SetFree(shaft.Misses(this->Scene.GetBoxes(), this->Receivers.GetEye()));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    rays.Add(asked[i].Pixel, asked[i].X, asked[i].Y, asked[i].Receiver, 0, light.GetRays());
  }
  rays.Flush();
  this->Rays += rays.GetCount();
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkTracedPixel& sums = this->Pixels[asked[i].Pixel];
    sight.Add({ sums.Lit > 0.0f, sums.Lit < sums.All });
  }
}

//------------------------------------------------------------------------------
void vtkTracedPicture::ShootFirst(const vtkTracedLight& light, bool proves)
{
  this->ForEachTile([&](const Area& area) { this->ShootFirst(light, area, proves); });
}

//------------------------------------------------------------------------------
void vtkTracedPicture::FindWidths(const vtkTracedFilter& filter)
{
  this->Around.resize(this->Tiles.size());
  for (std::size_t tile = 0; tile < this->Tiles.size(); ++tile)
  {
    this->Around[tile] =
      this->LookAround(static_cast<int>(tile), [this](std::size_t i) { return this->Tiles[i]; });
  }
  this->ForEachTile(
    [&](const Area& area)
    {
      // The widths here are wanted where any tile around is filtered.
      const Sight wanted = this->LookAround(area.Tile,
        [this](std::size_t i) {
          return Sight{ this->Around[i].IsMixed(), this->Around[i].IsMixed() };
        });
      if (wanted.IsMixed())
      {
        this->ForEachPixel(area,
          [&](int x, int y, std::size_t pixel)
          { this->OwnWidths[pixel] = filter.FindOwnWidth(x, y); });
      }
    });
  std::vector<float>& widths = this->Visibilities; // until they are known
  this->ForEachTile(
    [&](const Area& area)
    {
      const bool mixed = this->Around[static_cast<std::size_t>(area.Tile)].IsMixed();
      this->ForEachPixel(area,
        [&](int x, int y, std::size_t pixel)
        {
          widths[pixel] = mixed && this->Pixels[pixel].IsKnown() && filter.IsMixed(x, y)
            ? filter.FindWidth(x, y, this->OwnWidths)
            : NotMixed;
        });
    });
}

//------------------------------------------------------------------------------
void vtkTracedPicture::ShootMore(const vtkTracedLight& light)
{
  this->ForEachTile(
    [&](const Area& area)
    {
      if (!this->Around[static_cast<std::size_t>(area.Tile)].IsMixed())
      {
        return;
      }
      vtkTracedRays rays(this->Scene, light, this->Receivers.GetEye(), this->Pixels);
      this->ForEachPixel(area,
        [&](int x, int y, std::size_t pixel)
        {
          const float width = this->Visibilities[pixel];
          if (width != NotMixed && vtkTracedFilter::IsNarrow(width))
          {
            rays.Add(
              pixel, x, y, this->Receivers.GetPoint(pixel), light.GetRays(), light.GetMostRays());
          }
        });
      rays.Flush();
      this->Rays += rays.GetCount();
    });
}

//------------------------------------------------------------------------------
void vtkTracedPicture::FindMeans(const vtkTracedFilter& filter, bool filters)
{
  this->ForEachTile(
    [&](const Area& area)
    {
      this->ForEachPixel(area,
        [&](int x, int y, std::size_t pixel)
        {
          const vtkTracedPixel& sums = this->Pixels[pixel];
          float& visibility = this->Visibilities[pixel];
          if (filters && visibility != NotMixed)
          {
            visibility = filter.FindMean(x, y, visibility);
          }
          else
          {
            visibility = sums.IsKnown() ? sums.GetVisibility() : 1.0f;
          }
        });
    });
}

//------------------------------------------------------------------------------
void vtkTracedPicture::Trace(const vtkTracedLight& light, const Steps& steps)
{
  this->Width = this->Receivers.GetWidth();
  this->Height = this->Receivers.GetHeight();
  this->Columns = (this->Width + Tile - 1) / Tile;
  this->Rows = (this->Height + Tile - 1) / Tile;
  this->Rays = 0;
  const std::size_t count = static_cast<std::size_t>(this->Width) * this->Height;
  this->Pixels.assign(count, vtkTracedPixel());
  this->Visibilities.resize(count);
  this->OwnWidths.resize(count);
  this->Tiles.resize(static_cast<std::size_t>(this->Columns) * this->Rows);
  this->ShootFirst(light, steps.Proves);

  const vtkTracedFilter filter(this->Receivers, light, this->Pixels);
  if (steps.Adapts || steps.Filters)
  {
    this->FindWidths(filter);
  }
  if (steps.Adapts && light.GetMostRays() > light.GetRays())
  {
    this->ShootMore(light);
  }
  this->FindMeans(filter, steps.Filters);
}
VTK_ABI_NAMESPACE_END
