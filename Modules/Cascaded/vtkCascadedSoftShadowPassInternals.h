// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedSoftShadowPass::Internals
 * @brief   What the cascaded pass keeps from frame to frame.
 */

#ifndef vtkCascadedSoftShadowPassInternals_h
#define vtkCascadedSoftShadowPassInternals_h

#include "vtkCascadedRefinement.h"
#include "vtkCascadedSoftShadowMaps.h"
#include "vtkCascadedSoftShadowPass.h"
#include "vtkCascadedTint.h"
#include "vtkShadowCascades.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkSoftShadowScreenFilter.h"

#include "vtkCascadedSoftShadowFS.h"
#include "vtkCascadedSumsFS.h"

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkCascadedSoftShadowPass::Internals
{
public:
  /// One emitter's points and their maps.
  struct EmitterMaps
  {
    vtkShadowEmitter Emitter;
    vtkMTimeType BodiesTime = 0;
    vtkMTimeType SettingsTime = 0;
    /// Fits of points over all effective casters, the same for every camera: by k the k x k points
    /// of a grid, by -level the points that a level of refinement adds.
    std::map<int, vtkSoftShadowSamples> Fits;
    vtkCascadedSoftShadowMaps Maps;
    std::array<Refinement::Plan, MaximumNumberOfCascades> Plans;
    /// As of the frame below, for the tint and the counts.
    std::vector<vtkShadowCascades::Cascade> Cascades;
    vtkTypeInt64 Frame = -1;
  };

  std::map<std::pair<int, int>, EmitterMaps> Emitters; // by light and part
  std::vector<vtkShadowCascades::Cascade> Cascades;    // of the emitter that is drawn
  vtkTypeInt64 Frame = -1;                             // the last one that drew visibility
  std::shared_ptr<vtkShadowQueryReader> Reader = std::make_shared<vtkShadowQueryReader>();
  vtkShadowShader Shader{ vtkCascadedSoftShadowFS };
  vtkShadowShader SumsShader{ vtkCascadedSumsFS };
  vtkSoftShadowScreenFilter ScreenFilter;
  vtkCascadedTint Tint;
  Refinement Refiner;
  vtkShadowReceivers* Receivers = nullptr; // the base class's

  /// The cascades of every emitter of the last frame that drew visibility, of one light or (-1) of all.
  std::vector<std::vector<vtkShadowCascades::Cascade>> GetCascades(int light) const;

  /// The cascades of an emitter, in which one of its points may see a shadow.
  void FindCascades(
    vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, EmitterMaps& emitter);

  /// The adaptive plans of the last frame that drew visibility, with what has come back of their counts.
  std::vector<Refinement::Plan*> CollectCounts(const vtkCascadedSoftShadowPass* self);

  /// Joins cascades to a nearer one whose maps show all that theirs would, no coarser.
  void JoinCascades(
    vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, EmitterMaps& emitter);

  /// Texels along an edge that a look into a map of the cascade takes in. On the screen edges are a texel
  /// wide; a hard light's, and those of adaptive points, are sharp.
  static int GetFilterTexels(
    const vtkCascadedSoftShadowPass& self, const vtkShadowEmitter& emitter, size_t cascade);

  const vtkSoftShadowSamples& FitGrid(vtkCascadedSoftShadowPass* self,
    const vtkSoftShadowContext& context, EmitterMaps& emitter, int k);
  const vtkSoftShadowSamples& FitLevel(vtkCascadedSoftShadowPass* self,
    const vtkSoftShadowContext& context, EmitterMaps& emitter, int level);

  /// Draws a cascade whose points are one set.
  void DrawCascade(vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
    vtkCascadedSoftShadowMaps& maps, size_t cascade);

  /// Draws the sums of all cascades, filtered on the screen.
  void DrawScreen(vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
    vtkCascadedSoftShadowMaps& maps);

  /// Draws a cascade's part of the sums. isFirst: nothing has been drawn yet; false afterwards.
  void DrawSums(vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
    vtkCascadedSoftShadowMaps& maps, size_t cascade, bool& isFirst);

  /// Bakes and counts what it takes to draw a set from its sample first on.
  static vtkCascadedSoftShadowMaps::Run Bake(vtkCascadedSoftShadowPass* self,
    const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps, size_t set, size_t first);

  static void SetFade(vtkShaderProgram* program, const vtkShadowCascades::Cascade& cascade);
};

VTK_ABI_NAMESPACE_END
#endif
