// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualTileMaps
 * @brief   The depth maps of one emitter's tiles, kept while neither casters nor tiles change.
 *
 * All layers of a texture share one resolution, so there is a texture per resolution in use, and a
 * tile keeps its layer for as long as it is wanted. Textures are the services'.
 */

#ifndef vtkVirtualTileMaps_h
#define vtkVirtualTileMaps_h

#include "vtkShadowMapView.h"   // For views
#include "vtkSoftShadowsABI.h"  // For the ABI namespace
#include "vtkType.h"            // For times
#include "vtkVirtualTileTree.h" // For tiles

#include <map>    // For members
#include <memory> // For members
#include <vector> // For tiles

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowDepthMaps;
class vtkSoftShadowServices;

class vtkVirtualTileMaps
{
public:
  vtkVirtualTileMaps();
  ~vtkVirtualTileMaps();
  vtkVirtualTileMaps(const vtkVirtualTileMaps&) = delete;
  vtkVirtualTileMaps& operator=(const vtkVirtualTileMaps&) = delete;

  /// A tile with its map.
  struct Entry
  {
    vtkVirtualTile Tile;
    vtkShadowMapView View;
    vtkShadowDepthMaps* Maps = nullptr;
    int Layer = 0;
  };

  /// The part of the whole view that a tile shows; its grid is columns x rows cells.
  static vtkShadowMapView GetTileView(
    const vtkShadowMapView& whole, const vtkVirtualTile& tile, int gridSize);

  /// Makes the maps of the tiles valid. Textures that no tile uses any more are given back. False if the
  /// driver had no texture for some tiles, which are left out.
  bool Update(
    const vtkSoftShadowServices& services, const std::vector<vtkVirtualTile>& tiles, int gridSize);

  const std::vector<Entry>& GetEntries() const { return this->Entries; }

private:
  struct Slots
  {
    std::vector<vtkShadowMapView> Views; // per layer
    std::vector<bool> Used;              // by a tile of this update
  };

  void DropUnused(const vtkSoftShadowServices& services, const std::vector<vtkVirtualTile>& tiles);
  void KeepLayers();
  void FillLayers();

  std::map<int, std::unique_ptr<Slots>> Resolutions;
  std::vector<Entry> Entries;
  vtkMTimeType CastersTime = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualTileMaps.h
