// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualPlanner
 * @brief   Asks the GPU what texels the pixels want, and plans and bakes the tiles that have them.
 *
 * As many emitters as memory allows are prepared before the first is filtered: the GPU is asked for all
 * their grids and waited for once.
 */

#ifndef vtkVirtualPlanner_h
#define vtkVirtualPlanner_h

#include "vtkShadowMapView.h"  // For views
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For counts
#include "vtkVirtualGrid.h"    // For members
#include "vtkVirtualScreen.h"  // For members

#include <memory> // For screens
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkSoftShadowServices;
class vtkVirtualDrawing;
struct vtkVirtualEmitter;
struct vtkVirtualSettings;

class vtkVirtualPlanner
{
public:
  /// Begins an estimate.
  void Begin(const vtkSoftShadowServices& services);

  /// Draws the emitter's kernels before the first emitter is filtered, if memory allows.
  void Prepare(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    vtkVirtualEmitter& emitter, vtkVirtualDrawing& drawing);

  /// Makes sure of the emitter's kernels and wishes. False if they cannot be had.
  bool Request(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    vtkVirtualEmitter& emitter, vtkVirtualDrawing& drawing);

  /// Plans the tiles by the wishes and bakes them.
  static void BakeTiles(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    vtkVirtualEmitter& emitter);

  /// The picture is still late; data were asked for in between.
  bool IsOwed() const { return this->Owed; }
  ///@{
  /// Of this estimate: times that the CPU waited for grids, and emitters whose grid is not its own.
  vtkTypeInt64 GetWaits() const { return this->Waits; }
  vtkTypeInt64 GetLate() const { return this->Late; }
  ///@}
  /// By how much late tiles were too coarse, as of the newest request that told.
  double GetExcess() const { return this->Excess; }

  vtkTypeInt64 GetBytes() const;
  int GetNumberOfBuilds() const { return this->Grid.GetNumberOfBuilds(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool TakeShapes(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    vtkVirtualEmitter& emitter, vtkVirtualScreen& screen, vtkVirtualDrawing& drawing);
  bool RequestTiles(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    const std::vector<vtkVirtualEmitter*>& emitters, const std::vector<vtkShadowMapView>& views);
  void LookBack(const vtkVirtualEmitter& emitter);
  static void PlanTiles(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    vtkVirtualEmitter& emitter, double mostTexels);

  ///@{
  /// Of the emitters that are prepared.
  std::vector<vtkVirtualEmitter*> Prepared;
  std::vector<vtkShadowMapView> PreparedViews;
  std::vector<std::unique_ptr<vtkVirtualScreen>> Screens;
  bool IsRequested = false; // their grids have been drawn in this estimate
  ///@}
  vtkVirtualScreen Spare; // kernels of an emitter that was not prepared
  vtkVirtualGrid Grid;
  vtkTypeInt64 State = 0; // of all that a grid depends on; changes with it
  vtkTypeInt64 Waits = 0;
  vtkTypeInt64 Late = 0;
  bool Owed = false;
  double Excess = 1.0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualPlanner.h
