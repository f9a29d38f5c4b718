// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowEmitter
 * @brief   What shines: a whole light or a part of one, in world coordinates and double precision.
 *
 * A technique is given one emitter at a time and never assumes that it is a whole light. Emitter
 * coordinates (x, y, z) are distances along AxisU, AxisV and Direction from Center.
 *
 * A directional emitter has no position: Center is any point, x and y of a direction are tangents
 * of the angles to Direction, and HalfSize is the tangent of half the angular diameter.
 */

#ifndef vtkShadowEmitter_h
#define vtkShadowEmitter_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <array>  // For members
#include <string> // For the reason
#include <vector> // For the parts

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;

struct VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowEmitter
{
  enum ShapeType
  {
    RECTANGLE = 0,
    DISK = 1,
    POINT = 2
  };

  int Shape = POINT;
  bool Directional = false;
  /// Shines to all sides: a point or sphere without a cone. Only its Faces() can be looked through.
  bool Omni = false;
  /// One face of an omni light: serves receivers with |x| <= z and |y| <= z as seen from Apex.
  bool Face = false;
  /// World coordinates; orthonormal axes with AxisU = Direction x AxisV.
  std::array<double, 3> Center = { { 0.0, 0.0, 0.0 } };
  std::array<double, 3> AxisU = { { 1.0, 0.0, 0.0 } };
  std::array<double, 3> AxisV = { { 0.0, 1.0, 0.0 } };
  std::array<double, 3> Direction = { { 0.0, 0.0, -1.0 } };
  /// Half the extent along AxisU and AxisV: world units, or tangents if directional. Zero for
  /// points.
  std::array<double, 2> HalfSize = { { 0.0, 0.0 } };
  /// This part's share of the whole light, in (0, 1]; the parts of a light sum to 1.
  double Weight = 1.0;

  /// The whole light's cone: its apex (the light's centre) and half angle in degrees; 90 is none.
  std::array<double, 3> Apex = { { 0.0, 0.0, 0.0 } };
  double ConeAngle = 90.0;
  /// This part's place in the window [-1, 1]^2 of the whole light, for weights that vary over it.
  std::array<double, 2> WindowCenter = { { 0.0, 0.0 } };
  std::array<double, 2> WindowHalfSize = { { 1.0, 1.0 } };

  bool HasExtent() const { return this->HalfSize[0] > 0.0 || this->HalfSize[1] > 0.0; }
  bool HasCone() const { return !this->Directional && this->ConeAngle < 90.0; }

  /**
   * The emitter of a light as VTK sees it now (its transform applied). False, with the reason in
   * words, for a light that can cast no shadow. A light that is switched off is not asked about
   * here.
   */
  static bool FromLight(vtkLight* light, vtkShadowEmitter& emitter, std::string& reason);

  /**
   * The emitter cut into countU x countV parts of its window, each a rectangle with the area's
   * centroid and second moments of what the emitter has there; cells that a disk does not touch are
   * left out. Weights are areas, or, if gaussian, the integrals of N(0, 0.5) over the window [-1,
   * 1]. An emitter without extent is its own only part.
   */
  std::vector<vtkShadowEmitter> Split(int countU, int countV, bool gaussian = false) const;

  /// The six faces of a cube around an omni emitter, each an emitter of its own; else the emitter.
  std::vector<vtkShadowEmitter> Faces() const;

  /// The emitter shrunk to the point at window coordinates (u, v) in [-1, 1]^2.
  vtkShadowEmitter PointAt(double u, double v, double weight) const;

  /// World coordinates to emitter coordinates, row-major 4 x 4.
  std::array<double, 16> WorldToEmitter() const;

  bool operator==(const vtkShadowEmitter& other) const;
  bool operator!=(const vtkShadowEmitter& other) const { return !(*this == other); }
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowEmitter.h
