// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedPlan
 * @brief   How finely one cascade of one emitter is sampled, and what the queries said about it.
 */

#ifndef vtkCascadedPlan_h
#define vtkCascadedPlan_h

#include "vtkShadowBorderGrid.h" // For levels
#include "vtkShadowQueries.h"    // For members
#include "vtkSoftShadowsABI.h"   // For the ABI namespace
#include "vtkType.h"             // For counts

#include <array> // For counts

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowQueryReader;

struct vtkCascadedPlan
{
  static constexpr int MaximumCounts = vtkShadowBorderGrid::LargestLevel + 2;

  /// The last level that pixels need; negative: nothing is known.
  int LastLevel = -1;
  /// The last level that may be drawn.
  int LargestLevel = 0;
  /// The light has no extent: its one level has one point.
  bool IsHard = false;
  /// Pixels that needed each of the Counted levels, and that would have needed the one after them.
  std::array<vtkTypeInt64, MaximumCounts> Counts = { {} };
  int Counted = 0;
  vtkShadowQueries Queries;
  int Pending = 0; // queries in flight
  /// Pixels need more levels than the last draw had. Until the next one.
  bool WantsMore = false;

  /// The last level to draw.
  int GetLastLevel() const;
  /// Reads the queries if all of them are there. What fewPixels need is not worth another level.
  void Collect(vtkShadowQueryReader& reader, vtkTypeInt64 fewPixels);
  /// The points that all pixels together looked at.
  vtkTypeInt64 GetNumberOfPixelSamples() const;
  void ReleaseGraphicsResources();
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkCascadedPlan.h
