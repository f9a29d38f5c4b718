// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReferenceRayCaster
 * @brief   First hits and blocked segments among the triangles of a ReferenceGeometry.
 *
 * Embree finds candidates in single precision, by boxes wide enough to leave nothing out; each is
 * then judged in double precision with the triangle's own points. So what is small in a large scene
 * is as exact as what is large. Surfaces are two-sided. All functions may be called from several threads at once.
 */

#ifndef SoftShadowsRayTracing_ReferenceRayCaster_h
#define SoftShadowsRayTracing_ReferenceRayCaster_h

#include "ReferenceGeometry.h"

#include <memory> // For the implementation

namespace softshadows
{

class ReferenceRayCaster
{
public:
  struct Ray
  {
    Vector Origin;
    Vector Direction; ///< Unit length.
  };

  struct Hit
  {
    Vector Point;
    Vector Normal; ///< Unit length, towards the ray's origin.
    unsigned int Triangle = 0;
  };

  /// Throws std::runtime_error if Embree gives no device. Keeps a reference to the geometry.
  explicit ReferenceRayCaster(const ReferenceGeometry& geometry);
  ~ReferenceRayCaster();

  ReferenceRayCaster(const ReferenceRayCaster&) = delete;
  ReferenceRayCaster& operator=(const ReferenceRayCaster&) = delete;

  /// The first surface along the ray; the ray's origin may be any distance away.
  bool FindFirstHit(const Ray& ray, Hit& hit) const;

  /**
   * Whether a triangle of a casting object, other than the one left out, crosses the ray between its
   * origin and the given distance (infinite for lights without a place).
   */
  bool IsBlocked(const Ray& ray, double distance, unsigned int leftOut) const;

private:
  class Internals;
  std::unique_ptr<Internals> Impl;
};

}

#endif
