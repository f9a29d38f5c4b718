// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualTileMaps.h"

#include "vtkShadowCasters.h"
#include "vtkSoftShadowServices.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkVirtualTileMaps::vtkVirtualTileMaps() = default;

//------------------------------------------------------------------------------
vtkVirtualTileMaps::~vtkVirtualTileMaps() = default;

//------------------------------------------------------------------------------
vtkShadowMapView vtkVirtualTileMaps::GetTileView(
  const vtkShadowMapView& whole, const vtkVirtualTile& tile, int gridSize)
{
  vtkShadowMapView view = whole;
  const double width = (whole.Window[1] - whole.Window[0]) / gridSize;
  const double height = (whole.Window[3] - whole.Window[2]) / gridSize;
  view.Window[0] = whole.Window[0] + tile.X * width;
  view.Window[1] = whole.Window[0] + (tile.X + tile.Width) * width;
  view.Window[2] = whole.Window[2] + tile.Y * height;
  view.Window[3] = whole.Window[2] + (tile.Y + tile.Height) * height;
  return view;
}

//------------------------------------------------------------------------------
void vtkVirtualTileMaps::DropUnused(
  const vtkSoftShadowServices& services, const std::vector<vtkVirtualTile>& tiles)
{
  std::map<int, size_t> wanted;
  for (const vtkVirtualTile& tile : tiles)
  {
    ++wanted[tile.Resolution];
  }
  for (auto iterator = this->Resolutions.begin(); iterator != this->Resolutions.end();)
  {
    // A texture keeps layers in reserve, but no more than it uses.
    if (iterator->second->Views.size() > 2 * wanted[iterator->first])
    {
      services.ReleaseMaps(iterator->first);
      iterator = this->Resolutions.erase(iterator);
    }
    else
    {
      ++iterator;
    }
  }
}

//------------------------------------------------------------------------------
void vtkVirtualTileMaps::KeepLayers()
{
  for (Entry& entry : this->Entries)
  {
    std::unique_ptr<Slots>& slots = this->Resolutions[entry.Tile.Resolution];
    if (!slots)
    {
      slots = std::make_unique<Slots>();
    }
    const auto found = std::find(slots->Views.begin(), slots->Views.end(), entry.View);
    entry.Layer = found == slots->Views.end() ? -1 : static_cast<int>(found - slots->Views.begin());
    if (entry.Layer >= 0)
    {
      slots->Used[entry.Layer] = true;
    }
  }
}

//------------------------------------------------------------------------------
void vtkVirtualTileMaps::FillLayers()
{
  for (Entry& entry : this->Entries)
  {
    if (entry.Layer >= 0)
    {
      continue;
    }
    Slots& slots = *this->Resolutions[entry.Tile.Resolution];
    entry.Layer =
      static_cast<int>(std::find(slots.Used.begin(), slots.Used.end(), false) - slots.Used.begin());
    if (entry.Layer == static_cast<int>(slots.Used.size()))
    {
      slots.Used.push_back(true);
      slots.Views.push_back(entry.View);
    }
    slots.Used[entry.Layer] = true;
    slots.Views[entry.Layer] = entry.View;
  }
}

//------------------------------------------------------------------------------
bool vtkVirtualTileMaps::Update(
  const vtkSoftShadowServices& services, const std::vector<vtkVirtualTile>& tiles, int gridSize)
{
  this->DropUnused(services, tiles);
  this->Entries.clear();
  for (const vtkVirtualTile& tile : tiles)
  {
    Entry entry;
    entry.Tile = tile;
    entry.View = GetTileView(services.GetMapView(), tile, gridSize);
    this->Entries.push_back(entry);
  }
  const vtkMTimeType castersTime = services.Casters->GetCastersTime();
  for (auto& resolution : this->Resolutions)
  {
    Slots& slots = *resolution.second;
    if (this->CastersTime != castersTime)
    {
      slots.Views.clear(); // nothing that is held is worth keeping
    }
    slots.Used.assign(slots.Views.size(), false);
  }
  this->CastersTime = castersTime;
  this->KeepLayers();
  this->FillLayers();
  bool isComplete = true;
  for (auto& resolution : this->Resolutions)
  {
    const int edge = resolution.first;
    Slots& slots = *resolution.second;
    vtkShadowDepthMaps* maps =
      slots.Views.empty() ? nullptr : services.BakeMaps(slots.Views, edge, edge);
    for (Entry& entry : this->Entries)
    {
      entry.Maps = entry.Tile.Resolution == edge ? maps : entry.Maps;
    }
    if (!maps)
    {
      isComplete = isComplete && slots.Views.empty();
      slots.Views.clear(); // no such texture: tiles without a map are left out
    }
  }
  this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                        [](const Entry& entry) { return !entry.Maps; }),
    this->Entries.end());
  return isComplete;
}
VTK_ABI_NAMESPACE_END
