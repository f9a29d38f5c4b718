// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedRays
 * @brief   Shoots rays from the pixels of a tile to points of a light and keeps count.
 *
 * Rays go out eight at a time, those of one pixel and of its neighbours together.
 */

#ifndef vtkTracedRays_h
#define vtkTracedRays_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedHits.h"
#include "vtkTracedReceivers.h"

#include <cstddef> // For pixels
#include <vector>  // For sums

VTK_ABI_NAMESPACE_BEGIN
class vtkTracedLight;
class vtkTracedScene;

/// What the rays of a pixel found.
struct vtkTracedPixel
{
  float Lit = 0.0f; // weight of the points that are seen, ...
  float All = 0.0f; // ... and of all; 0 where nothing was asked
  /// Sum over what was hit of its nearness to the light, way / (1 - way): a penumbra is as wide as the light
  /// times that.
  float Spread = 0.0f;
  float Hits = 0.0f;
  /// Whether some of the light lies behind the surface, which depends on how that is tilted.
  bool IsAtHorizon = false;

  bool IsKnown() const { return this->All > 0.0f; }
  float GetVisibility() const { return this->Lit / this->All; }
};

class vtkTracedRays
{
public:
  /// The eye is that of the receivers.
  vtkTracedRays(const vtkTracedScene& scene, const vtkTracedLight& light,
    const vtkTracedVector& eye, std::vector<vtkTracedPixel>& pixels);

  /// From now on nothing is in the way of any ray: none is shot.
  void SetFree(bool isFree) { this->IsFree = isFree; }

  /// Points first to last (exclusive) of the pixel's own.
  void Add(std::size_t pixel, int x, int y, const vtkTracedReceivers::Point& receiver, int first,
    int last);

  /// Shoots what has not been yet.
  void Flush();

  /// Rays that were shot.
  long long GetCount() const { return this->Shot; }

private:
  void Push(std::size_t pixel, const vtkTracedReceivers::Point& receiver,
    const vtkTracedVector& start, const vtkTracedVector& place, double weight);

  const vtkTracedScene& Scene;
  const vtkTracedLight& Light;
  std::vector<vtkTracedPixel>& Pixels;
  RTCRay8 Rays;
  vtkTracedHits Hits;
  std::array<std::size_t, vtkTracedHits::Width> PixelOfRay;
  std::array<float, vtkTracedHits::Width> Weights;
  int Waiting = 0;
  bool IsFree = false;
  long long Shot = 0;
};

VTK_ABI_NAMESPACE_END
#endif
