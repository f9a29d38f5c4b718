// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowProjection
 * @brief   What an emitter's centre sees of bodies within limits: their windows and depths.
 *
 * A flat body is its rectangle, any other its box. Both are cut by the limits, exactly, before they
 * are projected, so bodies around, behind or far beside the light are no special case.
 */

#ifndef vtkShadowProjection_h
#define vtkShadowProjection_h

#include "vtkShadowCasters.h"  // For bodies
#include "vtkShadowEmitter.h"  // For the emitter
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array>  // For windows
#include <vector> // For planes

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowProjection
{
public:
  /// {xmin, xmax, ymin, ymax}, of x/z and y/z if positional, of x and y if directional.
  using Window = std::array<double, 4>;

  /// What is left of a body.
  struct Part
  {
    bool Empty = true;
    Window Extent = { { 0.0, 0.0, 0.0, 0.0 } };
    double Nearest = 0.0; ///< linear distances along the emitter's direction
    double Farthest = 0.0;
  };

  /// Sees what is in the emitter's cone, and for positional emitters in the window.
  vtkShadowProjection(const vtkShadowEmitter& emitter, const Window& limit);

  Part Project(const vtkShadowCasters::Body& body) const;

private:
  using Point = std::array<double, 3>;
  using Plane = std::array<double, 4>; // inside: a x + b y + c z + d >= 0

  void AddWindow(const vtkShadowEmitter& emitter, const Window& limit);
  void AddCone(const vtkShadowEmitter& emitter);
  Point ToEmitter(const Point& world) const;
  void AddPolygon(const Point* corners, Part& part) const;
  void AddPoint(const Point& point, Part& part) const;

  std::array<double, 16> WorldToEmitter;
  bool Directional;
  std::vector<Plane> Planes;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowProjection.h
