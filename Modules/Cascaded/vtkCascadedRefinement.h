// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedSoftShadowPass::Refinement
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

#include "vtkCascadedSoftShadowMaps.h"
#include "vtkCascadedSoftShadowPass.h"
#include "vtkNew.h" // For members
#include "vtkShadowBorderGrid.h"
#include "vtkShadowCascades.h"
#include "vtkShadowFramebuffer.h"
#include "vtkShadowQueryReader.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array> // For counts

VTK_ABI_NAMESPACE_BEGIN

class vtkCascadedSoftShadowPass::Refinement
{
public:
  Refinement();

  /// How finely one cascade of one emitter is sampled, and what the queries said about it.
  struct Plan
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
    std::array<unsigned int, MaximumCounts> Queries = { {} };
    int Pending = 0; // queries in flight
    /// Pixels need more levels than the last draw had. Until the next one.
    bool WantsMore = false;

    /// The last level to draw.
    int GetLastLevel() const;
    /// Reads the queries if all of them are there.
    void Collect(vtkShadowQueryReader& reader, vtkTypeInt64 fewPixels);
    /// The points that all pixels together looked at.
    vtkTypeInt64 GetNumberOfPixelSamples() const;
    void ReleaseGraphicsResources();
  };

  /// Draws sets[0] to sets[count - 1] of a cascade, the levels of its grid.
  void Draw(vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
    vtkCascadedSoftShadowMaps& maps, const std::vector<size_t>& sets,
    const vtkShadowCascades::Cascade& cascade, Plan& plan);

  /// Of the shader that looks at the maps.
  void SetDefinitions(const vtkShadowShader::Definitions& definitions)
  {
    this->RefineShader.SetDefinitions(definitions);
  }

  vtkTypeInt64 GetBytes() const;
  int GetNumberOfBuilds() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Prepare(const vtkSoftShadowContext& context);
  bool Attach(const vtkSoftShadowContext& context, vtkShadowTextureArray* texture);
  bool AddLevel(vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
    vtkCascadedSoftShadowMaps& maps, size_t set, int level,
    const vtkShadowCascades::Cascade& cascade, unsigned int query);
  bool Settle(const vtkSoftShadowContext& context, int level, double keep, double tolerance);
  bool CountLeft(vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context, int levels,
    const vtkShadowCascades::Cascade& cascade, unsigned int query);

  vtkNew<vtkShadowTextureArray> Added;
  vtkNew<vtkShadowTextureArray> States[2]; // by turns: a level reads the one before
  vtkShadowFramebuffer Framebuffer;
  vtkShadowShader RefineShader;
  vtkShadowShader SettleShader;
  vtkShadowShader EmitShader;
};

VTK_ABI_NAMESPACE_END
#endif
