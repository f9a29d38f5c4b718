// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedShaft
 * @brief   What all rays of some receivers to a light pass through, and the proof that nothing is there.
 *
 * The shaft is the hull of two boxes, of the receivers and of the light (Haines and Wallace, "Shaft Culling
 * for Efficient Ray-Traced Radiosity", 1991). The plane of the first receiver bounds it as well: what lies
 * under a flat ground, the ground included, blocks nothing.
 */

#ifndef vtkTracedShaft_h
#define vtkTracedShaft_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedVector.h"

#include <array>   // For planes
#include <cstddef> // For counts
#include <vector>  // For boxes

VTK_ABI_NAMESPACE_BEGIN

/// A box with any axes.
struct vtkTracedBox
{
  /// How far off its sides are as Embree sees them, in single precision.
  double GetDoubt() const;

  vtkTracedVector Center{};
  std::array<vtkTracedVector, 3> HalfAxes{};
};

/// A box along the axes of the coordinates; empty at first.
struct vtkTracedBounds
{
  vtkTracedVector Low = { { 1e300, 1e300, 1e300 } };
  vtkTracedVector High = { { -1e300, -1e300, -1e300 } };

  void Add(const vtkTracedVector& point);
};

class vtkTracedShaft
{
public:
  /// A visible point, the unit normal there, and how far off the point may be: rays start so much above it.
  void AddReceiver(const vtkTracedVector& place, const vtkTracedVector& normal, double precision);

  /// Ends the shaft at the bounds of a light's points.
  void EndAt(const vtkTracedBounds& light);

  /// Ends it a length away along any of the directions within bounds.
  void EndAlong(const vtkTracedBounds& directions, double length);

  /// Whether none of the boxes reaches into it, the receivers having been seen from the eye. Takes about the
  /// time of a ray per box.
  bool Misses(const std::vector<vtkTracedBox>& boxes, const vtkTracedVector& eye) const;

  /// How far the receivers are from the origin at most.
  double GetReach() const;

private:
  struct Plane
  {
    vtkTracedVector Normal; // unit, away from the shaft
    double Offset;
  };

  void AddPlane(const vtkTracedVector& normal, double offset);
  void AddSides(const vtkTracedBounds& end);
  void AddBridges(const vtkTracedBounds& end);
  bool IsOutside(const vtkTracedBox& box) const;
  bool IsOwnPlane(const vtkTracedBox& box, const vtkTracedVector& eye) const;

  vtkTracedBounds Places;
  vtkTracedBounds Receivers; // where rays start
  vtkTracedVector Up{};      // the first receiver's normal
  double Height = 0.0;       // along it, of the lowest receiver
  double Doubt = 0.0;        // how far off rays may be
  double Precision = 0.0;    // the least of the receivers'
  bool IsEmpty = true;
  std::array<Plane, 19> Planes;
  std::size_t Count = 0;
};

VTK_ABI_NAMESPACE_END
#endif
