// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedHits
 * @brief   Eight rays on their way, and the judge of what Embree finds in it. For sources only.
 *
 * Embree works in single precision, and so does whoever drew the receivers. A triangle in whose plane
 * the receiver lies, as near as these tell, is the receiver's own or goes on as its own does: it does not
 * block. That is decided in double precision with the triangle's own points.
 */

#ifndef vtkTracedHits_h
#define vtkTracedHits_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedEmbree.h"
#include "vtkTracedVector.h"

#include <array> // For members

VTK_ABI_NAMESPACE_BEGIN
class vtkTracedScene;

struct vtkTracedHits
{
  static constexpr int Width = 8;

  vtkTracedContext Context; // first: a pointer to it is a pointer to all
  const vtkTracedScene* Scene = nullptr;

  /// Local coordinates of the place that view coordinates are relative to.
  vtkTracedVector Eye{};

  /// How far a drawn surface is off its plane, whose farthest corner is so far from the eye: mappers bring
  /// corners to view coordinates in single precision.
  static double GetRounding(double distance) { return 5e-7 * distance; }

  /// Per ray, which its id counts: where it starts, and how near a plane has to be to be its own.
  std::array<vtkTracedVector, Width> Receivers;
  std::array<double, Width> Tolerances;

  /// Where it was stopped, as a share of its way; only where it was.
  std::array<float, Width> Distances;

  /// Embree's filter of hits on meshes.
  static void Judge(const RTCFilterFunctionNArguments* arguments);

  /// Embree's search for hits on vtkTracedRounds.
  static void JudgeRounds(const RTCOccludedFunctionNArguments* arguments);
};

VTK_ABI_NAMESPACE_END
#endif
