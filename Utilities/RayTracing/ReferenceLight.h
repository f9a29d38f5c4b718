// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReferenceLight
 * @brief   Points (or directions) of a light, drawn in strata, and whom the light can reach.
 *
 * Shapes: rectangle; disk and ellipse (concentric map of Shirley and Chiu 1997, which keeps areas);
 * the disk of directions of a directional light, uniform in solid angle; point. With Gaussian
 * weights a sample counts exp(-(u^2 + v^2) / (2 0.5^2)), (u, v) its place in the window [-1, 1]^2
 * of the light: along its half sizes, for directional lights along the tangents of the angles.
 */

#ifndef SoftShadowsRayTracing_ReferenceLight_h
#define SoftShadowsRayTracing_ReferenceLight_h

#include "ReferenceGeometry.h"

#include "vtkShadowEmitter.h"

namespace softshadows
{

class ReferenceLight
{
public:
  struct Sample
  {
    /// In local coordinates; for directional lights the unit direction to the light.
    Vector Place;
    double Weight = 1.0;
  };

  ReferenceLight(const vtkShadowEmitter& emitter, const ReferenceGeometry& geometry, bool gaussian);

  bool IsDirectional() const { return this->Emitter.Directional; }
  bool HasExtent() const { return this->Emitter.HasExtent(); }

  /// False outside the light's cone and behind a rectangle or a disk. Local coordinates.
  bool Reaches(const Vector& point) const;

  /// The sample at a place in the unit square.
  Sample GetSample(double s, double t) const;

private:
  Sample GetDirection(double u, double v) const;

  vtkShadowEmitter Emitter; ///< Lengths and places in local coordinates.
  bool Gaussian;
  double CosineOfCone = 0.0;
  double CosineOfSun = 1.0;
};

}

#endif
