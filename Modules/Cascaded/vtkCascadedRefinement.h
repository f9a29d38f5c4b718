// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedRefinement
 * @brief   Adaptive sampling of the light: finer grids of points while a pixel still changes.
 *
 * Per level, for the pixels of a cascade that have not settled: add the visibility from the level's
 * new points (counted by an occlusion query), join it to what is known, and mark as settled what
 * changed by no more than the tolerance. So every pixel takes the levels it needs, whatever the
 * queries say. These decide how many levels, hence maps, the next frame bakes: all if nothing is
 * known yet, else those that more than a few pixels needed when the last counts came back. Nobody
 * waits for them.
 */

#ifndef vtkCascadedRefinement_h
#define vtkCascadedRefinement_h

#include "vtkCascadedSoftShadowMaps.h" // For maps
#include "vtkNew.h"                    // For members
#include "vtkShadowCascades.h"         // For cascades
#include "vtkShadowFramebuffer.h"      // For members
#include "vtkShadowShader.h"           // For members
#include "vtkShadowTextureArray.h"     // For members
#include "vtkSoftShadowsABI.h"         // For the ABI namespace

#include <vector> // For sets

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowQueries;
class vtkShadowReceivers;
class vtkSoftShadowServices;
struct vtkCascadedPlan;
struct vtkCascadedSettings;

class vtkCascadedRefinement
{
public:
  vtkCascadedRefinement();

  /// Draws sets[0] to sets[count - 1] of a cascade, the levels of its grid.
  void Draw(const vtkSoftShadowServices& services, const vtkCascadedSettings& settings,
    vtkCascadedSoftShadowMaps& maps, const std::vector<size_t>& sets,
    const vtkShadowCascades::Cascade& cascade, vtkCascadedPlan& plan);

  /// Of the shader that looks at the maps.
  void SetDefinitions(const vtkShadowShader::Definitions& definitions)
  {
    this->RefineShader.SetDefinitions(definitions);
  }

  /// Pixels that are too few for another level's maps.
  static vtkTypeInt64 GetFewPixels(vtkShadowReceivers* receivers);

  vtkTypeInt64 GetBytes() const;
  int GetNumberOfBuilds() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Prepare(const vtkSoftShadowServices& services);
  bool Attach(const vtkSoftShadowServices& services, vtkShadowTextureArray* texture);
  bool AddLevel(const vtkSoftShadowServices& services, vtkCascadedSoftShadowMaps& maps, size_t set,
    int level, const vtkShadowCascades::Cascade& cascade, vtkShadowQueries* queries);
  bool Settle(const vtkSoftShadowServices& services, int level, double keep, double tolerance);
  bool CountLeft(const vtkSoftShadowServices& services, int levels,
    const vtkShadowCascades::Cascade& cascade, vtkShadowQueries& queries);

  vtkNew<vtkShadowTextureArray> Added;
  vtkNew<vtkShadowTextureArray> States[2]; // by turns: a level reads the one before
  vtkShadowFramebuffer Framebuffer;
  vtkShadowShader RefineShader;
  vtkShadowShader SettleShader;
  vtkShadowShader EmitShader;
};

VTK_ABI_NAMESPACE_END
#endif
