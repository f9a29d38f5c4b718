// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowMapView
 * @brief   The view through one depth map: where it looks from, its window and its depth range.
 *
 * Map coordinates (s, t, d): s in [0, 1] along the emitter's AxisU, t in [0, 1] along its AxisV, d
 * in [-1, 0] from the near to the far plane. A depth map holds -d: floats are dense around 0, and
 * that is where a perspective puts all that is far away, so that d keeps the relative precision of
 * distances however far apart near and far are. With (x, y, z) emitter coordinates, z the linear
 * distance along the emitter's direction:
 *
 *     positional:   (s, t) affine in (x / z, y / z),  d affine in 1 / z
 *     directional:  (s, t) affine in (x, y),          d affine in z
 *
 * Both are projective maps of space. Two consequences carry every technique:
 *  - a plane of space is a plane d = d0 + g . (st - st0) of the map, exactly;
 *  - the light, seen from a receiver at depth d_q, covers at the depth d_o of a blocker a copy of
 * the emitter's shape around the receiver's own (s, t) whose half extent is
 * GetKernelScale() * (d_q - d_o), for perspective and parallel maps alike.
 */

#ifndef vtkShadowMapView_h
#define vtkShadowMapView_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkShadowEmitter.h"                  // For the emitter
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <array> // For matrices

VTK_ABI_NAMESPACE_BEGIN

struct VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowMapView
{
  vtkShadowEmitter Emitter;
  /// {xmin, xmax, ymin, ymax}: of x/z and y/z if positional, of x and y if directional.
  std::array<double, 4> Window = { { -1.0, 1.0, -1.0, 1.0 } };
  /// Linear distances along the emitter's direction; 0 < Near < Far if positional.
  double Near = 1.0;
  double Far = 2.0;

  /**
   * World coordinates to clip coordinates, row-major: -w <= x, y <= w, and z from the near to the far
   * plane from w to -w, or from w to 0 if zeroToOne. Only the latter keeps the precision of d.
   */
  std::array<double, 16> WorldToClip(bool zeroToOne = false) const;

  /// World coordinates to homogeneous map coordinates (s w, t w, d w, w), row-major.
  std::array<double, 16> WorldToMap() const;

  /// Half extent of the emitter in (s, t) per unit of depth difference in d.
  std::array<double, 2> GetKernelScale() const;

  /**
   * {a, b}: positional, 1 / z = a + b d; directional, z = a + b d.
   */
  std::array<double, 2> GetDepthToLinear() const;

  /// The linear distance z of a depth value d.
  double LinearDepth(double d) const;

  bool operator==(const vtkShadowMapView& other) const;
  bool operator!=(const vtkShadowMapView& other) const { return !(*this == other); }
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowMapView.h
