// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterClusters
 * @brief   The parts of one mesh that a map is fitted to as if they were meshes of their own.
 *
 * A mesh that holds the ground and the things on it would make its map as large as the ground. What lies
 * in one plane with more than half of the mesh's area is a part, and the rest is cut where that leaves
 * boxes less than half as large as before, again and again. A mesh that this does not make
 * smaller stays whole. Takes time in proportion to the triangles.
 */

#ifndef vtkShadowCasterClusters_h
#define vtkShadowCasterClusters_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array>   // For boxes
#include <cstdint> // For indices
#include <vector>  // For clusters

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowCasterClusters
{
public:
  using Point = std::array<double, 3>;

  struct Cluster
  {
    std::array<double, 6> Bounds; ///< {xmin, xmax, ymin, ymax, zmin, zmax}
    bool Flat = false;            ///< in a plane, to 1e-6 of the mesh's extent
    std::array<Point, 4> Corners; ///< if flat: of a rectangle in that plane that holds it, in order
  };

  /// Points: 3 numbers each. Empty if the mesh is best taken as a whole.
  static std::vector<Cluster> Find(
    const std::vector<double>& points, const std::vector<std::uint32_t>& indices);

  /**
   * The corners of the smallest rectangle, among those with an edge at one of the angles, around
   * points base + q[0] axis + q[1] other.
   */
  static std::array<Point, 4> FindRectangle(const std::vector<std::array<double, 2>>& points,
    const std::vector<double>& angles, const double base[3], const double axis[3],
    const double other[3]);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterClusters.h
