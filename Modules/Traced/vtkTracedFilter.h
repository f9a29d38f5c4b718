// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedFilter
 * @brief   What neighbours on the screen tell of a pixel's visibility.
 *
 * The rays that were stopped tell how wide the penumbra is, in pixels. A penumbra that is wide enough is
 * smooth over a block of pixels, whose points together are many: their mean is taken. A narrow one is not,
 * and needs rays of its own. The mean stops at edges: neighbours count that lie on the pixel's surface.
 */

#ifndef vtkTracedFilter_h
#define vtkTracedFilter_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedRays.h"

#include <vector> // For pixels

VTK_ABI_NAMESPACE_BEGIN
class vtkTracedLight;
class vtkTracedReceivers;

class vtkTracedFilter
{
public:
  vtkTracedFilter(const vtkTracedReceivers& receivers, const vtkTracedLight& light,
    const std::vector<vtkTracedPixel>& pixels);

  /// The width of the penumbra that what stopped a pixel's rays throws, in pixels; infinite if nothing did.
  float FindOwnWidth(int x, int y) const;

  /// The least of these around a pixel, of which widths has one per pixel.
  float FindWidth(int x, int y, const std::vector<float>& widths) const;

  /// Whether pixels around this one saw parts of the light, or some all of it and some nothing.
  bool IsMixed(int x, int y) const;

  /// A penumbra of that width cannot be filtered: more rays are wanted.
  static bool IsNarrow(float width) { return width < 2.0f * WidestMean; }

  /// The mean of what neighbours saw, as far around as a penumbra of that width allows.
  float FindMean(int x, int y, float width) const;

private:
  static constexpr float WidestMean = 4.0f; // pixels along an edge: a block
  static constexpr int Reach = 2;

  struct Window
  {
    int Left;
    int Right;
    int Bottom;
    int Top;
  };
  Window GetWindow(int x, int y, int reach) const;
  std::size_t At(int x, int y) const { return static_cast<std::size_t>(y) * this->Width + x; }
  bool AreOnOneSurface(std::size_t a, std::size_t b) const;

  const vtkTracedReceivers& Receivers;
  const vtkTracedLight& Light;
  const std::vector<vtkTracedPixel>& Pixels;
  int Width;
  int Height;
};

VTK_ABI_NAMESPACE_END
#endif
