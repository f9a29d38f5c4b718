// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedEmitter
 * @brief   One emitter's cascades: which points of the light each takes, and the views of their maps.
 */

#ifndef vtkCascadedEmitter_h
#define vtkCascadedEmitter_h

#include "vtkCascadedPlan.h"           // For members
#include "vtkCascadedSettings.h"       // For the number of cascades
#include "vtkCascadedSoftShadowMaps.h" // For members
#include "vtkShadowCascades.h"         // For cascades
#include "vtkSoftShadowsABI.h"         // For the ABI namespace

#include <array>  // For plans
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowQueryReader;
class vtkSoftShadowServices;

class vtkCascadedEmitter
{
public:
  /// Finds the cascades of an estimate, in which one of the emitter's points may see a shadow.
  void Begin(const vtkSoftShadowServices& services, const vtkCascadedSettings& settings);

  /// The sets of a cascade's points: one, or one per level of refinement.
  std::vector<size_t> AddSets(const vtkSoftShadowServices& services,
    const vtkCascadedSettings& settings, size_t cascade, vtkShadowQueryReader& reader);

  const std::vector<vtkShadowCascades::Cascade>& GetCascades() const { return this->Cascades; }
  vtkCascadedPlan& GetPlan(size_t cascade) { return this->Plans[cascade]; }
  vtkCascadedSoftShadowMaps& GetMaps() { return this->Maps; }
  /// Of Begin: the estimate, and the light's number.
  vtkTypeInt64 GetEstimate() const { return this->Estimate; }
  int GetLight() const { return this->Light; }

  void ReleaseGraphicsResources();

private:
  vtkCascadedSoftShadowMaps Maps;
  std::array<vtkCascadedPlan, vtkCascadedSettings::MaximumNumberOfCascades> Plans;
  std::vector<vtkShadowCascades::Cascade> Cascades;
  vtkTypeInt64 Estimate = -1;
  int Light = -1;

  void FindCascades(const vtkSoftShadowServices& services, const vtkCascadedSettings& settings);
  /// Joins cascades to a nearer one whose maps show all that theirs would, no coarser.
  void JoinCascades(const vtkSoftShadowServices& services, const vtkCascadedSettings& settings);
  ///@{
  /// Fits of points over all effective casters, the same for every camera: the k x k points of a grid, or
  /// those that a level of refinement adds.
  static const vtkSoftShadowSamples& FitGrid(
    const vtkSoftShadowServices& services, const vtkCascadedSettings& settings, int k);
  static const vtkSoftShadowSamples& FitLevel(
    const vtkSoftShadowServices& services, const vtkCascadedSettings& settings, int level);
  ///@}
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkCascadedEmitter.h
