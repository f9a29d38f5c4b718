// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedLight
 * @brief   The points of an emitter that rays go to, and whom it can reach.
 *
 * The pixels of a block of 4 x 4 have different points: each its own run of one scrambled sequence, so
 * that the points of all are as well spread as those of each.
 */

#ifndef vtkTracedLight_h
#define vtkTracedLight_h

#include "vtkShadowEmitter.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedShaft.h"
#include "vtkTracedVector.h"

#include <vector> // For points

VTK_ABI_NAMESPACE_BEGIN
class vtkTracedScene;

class vtkTracedLight
{
public:
  /// Edge of a block.
  static constexpr int Block = 4;

  /// faceAxis: of a face of an omni light, see vtkSoftShadowContext. weights: of the points, see
  /// vtkShadowLightSampling.
  /// rays are a pixel's first, mostRays all that it has.
  vtkTracedLight(const vtkShadowEmitter& emitter, int faceAxis, int weights, int rays, int mostRays,
    const vtkTracedScene& scene);

  struct Point
  {
    /// Local coordinates; of a directional light the unit direction towards it.
    vtkTracedVector Place;
    double Weight;
  };

  ///@{
  /// Points per pixel, those that it asks first and all.
  int GetRays() const { return this->Rays; }
  int GetMostRays() const { return this->MostRays; }
  ///@}
  const Point* GetPoints(int x, int y) const
  {
    const int pixel = x % Block + Block * (y % Block);
    return this->Points.data() + static_cast<std::size_t>(pixel) * this->MostRays;
  }

  /// The lesser of its edges; of a directional light at distance 1.
  float GetSize() const;

  /// Ends a shaft at the points, or far away in all their directions.
  void End(vtkTracedShaft& shaft, const vtkTracedScene& scene) const;

  bool IsDirectional() const { return this->Emitter.Directional; }

  /// Whether the emitter serves a point, in local coordinates. At its borders in doubt yes.
  bool Reaches(const vtkTracedVector& point) const;

private:
  Point FindPoint(unsigned int index, int weights) const;

  vtkShadowEmitter Emitter; // in local coordinates
  vtkTracedVector Apex;
  int FaceAxis;
  int Rays;
  int MostRays;
  double CosineOfCone;
  std::vector<Point> Points; // of the block's pixels, one after the other
  vtkTracedBounds Bounds;    // of the points' places
};

VTK_ABI_NAMESPACE_END
#endif
