// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedPicture
 * @brief   The visibility of one emitter at every pixel, found tile by tile on all cores.
 *
 *  1. Every pixel that the emitter serves shoots its first rays.
 *  2. Where neighbours disagree and the penumbra is narrow, pixels shoot their other rays.
 *  3. Where the penumbra is wide, the mean of neighbours is taken.
 */

#ifndef vtkTracedPicture_h
#define vtkTracedPicture_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedRays.h"

#include <functional> // For steps
#include <vector>     // For pixels

VTK_ABI_NAMESPACE_BEGIN
class vtkTracedLight;
class vtkTracedReceivers;
class vtkTracedScene;
class vtkTracedWorkers;

class vtkTracedPicture
{
public:
  /// What an estimate is made of.
  struct Steps
  {
    bool Adapts = true;
    bool Filters = true;
  };

  /// Returns the number of rays.
  long long Trace(const vtkTracedScene& scene, const vtkTracedLight& light,
    const vtkTracedReceivers& receivers, vtkTracedWorkers& workers, const Steps& steps);

  /// Bottom row first; anything where the emitter serves no receiver.
  const std::vector<float>& GetVisibilities() const { return this->Visibilities; }

private:
  void ForEachTile(vtkTracedWorkers& workers,
    const std::function<void(int left, int right, int bottom, int top)>& work) const;
  template <typename Functor>
  void ForEachPixel(vtkTracedWorkers& workers, Functor&& work) const;

  int Width = 0;
  int Height = 0;
  std::vector<vtkTracedPixel> Pixels;
  std::vector<float> OwnWidths; // of penumbrae, see vtkTracedFilter
  std::vector<float> Visibilities;
};

VTK_ABI_NAMESPACE_END
#endif
