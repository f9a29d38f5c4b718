// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedPicture
 * @brief   The visibility of one emitter at every pixel, found tile by tile on all cores.
 *
 *  1. Every pixel that the emitter serves shoots its first rays, unless nothing can be in the way of its
 *     tile (vtkTracedShaft).
 *  2. Where neighbours disagree and the penumbra is narrow, pixels shoot their other rays.
 *  3. Where the penumbra is wide, the mean of neighbours is taken.
 *
 * Tiles around which all pixels are lit, or all dark, are through after the first step.
 */

#ifndef vtkTracedPicture_h
#define vtkTracedPicture_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedRays.h"

#include <atomic>     // For counts
#include <cstddef>    // For pixels
#include <functional> // For steps
#include <vector>     // For pixels

VTK_ABI_NAMESPACE_BEGIN
class vtkTracedFilter;
class vtkTracedLight;
class vtkTracedReceivers;
class vtkTracedScene;
class vtkTracedWorkers;

class vtkTracedPicture
{
public:
  vtkTracedPicture(vtkTracedScene& scene, vtkTracedReceivers& receivers, vtkTracedWorkers& workers)
    : Scene(scene)
    , Receivers(receivers)
    , Workers(workers)
  {
  }

  /// What an estimate is made of.
  struct Steps
  {
    bool Adapts = true;
    bool Filters = true;
    bool Proves = true;
  };

  void Trace(const vtkTracedLight& light, const Steps& steps);

  /// Bottom row first; anything where the emitter serves no receiver.
  const std::vector<float>& GetVisibilities() const { return this->Visibilities; }

  /// Rays that the last Trace shot.
  long long GetRays() const { return this->Rays; }

private:
  struct Area
  {
    int Tile; // its number
    int Left;
    int Right; // exclusive, as the top
    int Bottom;
    int Top;
  };

  // What the rays of some pixels met: light, and something in the way.
  struct Sight
  {
    bool Light = false;
    bool Dark = false;
    bool IsMixed() const { return this->Light && this->Dark; }
    void Add(const Sight& other)
    {
      this->Light = this->Light || other.Light;
      this->Dark = this->Dark || other.Dark;
    }
  };

  Area GetArea(int tile) const;
  void ForEachTile(const std::function<void(const Area&)>& work) const;
  template <typename Functor>
  void ForEachPixel(const Area& area, Functor&& work) const;
  // The sum over a tile and its eight neighbours.
  template <typename Functor>
  Sight LookAround(int tile, Functor&& look) const;

  void ShootFirst(const vtkTracedLight& light, bool proves);
  void ShootFirst(const vtkTracedLight& light, const Area& area, bool proves);
  void FindWidths(const vtkTracedFilter& filter);
  void ShootMore(const vtkTracedLight& light);
  void FindMeans(const vtkTracedFilter& filter, bool filters);

  vtkTracedScene& Scene;
  vtkTracedReceivers& Receivers;
  vtkTracedWorkers& Workers;
  int Width = 0;
  int Height = 0;
  int Columns = 0; // of tiles
  int Rows = 0;
  std::atomic<long long> Rays{ 0 };
  std::vector<vtkTracedPixel> Pixels;
  std::vector<Sight> Tiles;
  std::vector<Sight> Around;    // of every tile
  std::vector<float> OwnWidths; // of penumbrae, see vtkTracedFilter
  std::vector<float> Visibilities;
};

VTK_ABI_NAMESPACE_END
#endif
