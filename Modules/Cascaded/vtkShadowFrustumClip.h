// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowFrustumClip
 * @brief   At which depths the part of a body that lies in a camera's frustum can be seen.
 */

#ifndef vtkShadowFrustumClip_h
#define vtkShadowFrustumClip_h

#include "vtkShadowCasters.h"  // For the bodies
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array>   // For matrices
#include <utility> // For intervals
#include <vector>  // For planes

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowFrustumClip
{
public:
  /// World to clip coordinates and world to view depth, row-major.
  vtkShadowFrustumClip(
    const std::array<double, 16>& worldToClip, const std::array<double, 4>& worldToDepth);

  /// A convex part of the world: where none of at most six planes . (x, y, z, 1) is negative.
  using Region = std::vector<std::array<double, 4>>;

  /// Restricts flat bodies to the union of these regions; other bodies count as a whole.
  void SetRegions(const std::vector<Region>& regions) { this->Regions = regions; }

  /**
   * False if no part of the body is in the frustum, and, if it is flat, in one of the regions. Bodies
   * aside or inside cost a few products; only those that a plane cuts are clipped.
   */
  bool FindDepths(const vtkShadowCasters::Body& body, std::pair<double, double>& depths) const;

  /**
   * The corners of what the frustum holds of a box (xmin, xmax, ymin, ...) between two depths: all of it lies
   * between them. None if that is nothing.
   */
  std::vector<std::array<double, 3>> FindCorners(
    const std::pair<double, double>& depths, const std::array<double, 6>& bounds) const;

  /// Depths of the near and the far plane.
  std::pair<double, double> GetDepths() const;

  /// Where the frustum's edge (0 to 3, around it) passes a depth, in world coordinates.
  std::array<double, 3> CornerAt(int edge, double depth) const;

private:
  /// planes: those of the frustum that cut the body's box.
  void FindFlatDepths(const vtkShadowCasters::Body& body, const Region& planes,
    std::pair<double, double>& depths) const;
  void FindBoxDepths(const vtkShadowCasters::Body& body, const Region& planes,
    std::pair<double, double>& depths) const;

  std::array<std::array<double, 4>, 6> Planes; // of the frustum: inside, none is negative
  std::array<double, 4> WorldToDepth;
  /// Ends of the frustum's edges on the near and on the far plane, and their depths.
  std::array<std::array<std::array<double, 3>, 2>, 4> Edges;
  std::array<std::array<double, 2>, 4> EdgeDepths;
  std::vector<Region> Regions;
};

VTK_ABI_NAMESPACE_END
#endif
