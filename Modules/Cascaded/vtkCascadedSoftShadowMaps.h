// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedSoftShadowMaps
 * @brief   The depth maps of one emitter's samples: a texture array per resolution.
 *
 * A set is what one cascade looks at in one go: all its samples, or those that a level of refinement
 * adds. The maps of the sets of one resolution lie in one array, in the order in which the sets were
 * added. They are baked when a draw needs them, and kept as long as memory allows.
 */

#ifndef vtkCascadedSoftShadowMaps_h
#define vtkCascadedSoftShadowMaps_h

#include "vtkNew.h"                // For members
#include "vtkShadowTextureArray.h" // For members
#include "vtkSoftShadowSamples.h"  // For samples
#include "vtkSoftShadowsABI.h"     // For the ABI namespace

#include <array>  // For resolutions
#include <vector> // For sets

VTK_ABI_NAMESPACE_BEGIN
class vtkSoftShadowServices;

class vtkCascadedSoftShadowMaps
{
public:
  static constexpr int NumberOfResolutions = 3;

  struct Set
  {
    int Resolution = 0; // which of the arrays
    size_t First = 0;   // of its views in the array's
    int FilterSize = 1;
    vtkSoftShadowSamples Samples;
  };

  /// Samples first to last (exclusive) of a set, in the layers from Layer on of a valid texture. Without
  /// samples that is an empty one.
  struct Run
  {
    size_t First = 0;
    size_t Last = 0;
    size_t Layer = 0;
    vtkShadowTextureArray* Texture = nullptr;
  };

  /// Forgets the sets; mapSize: texels of the highest resolution, each other one has half.
  void Begin(int mapSize);
  size_t Add(int resolution, int filterSize, vtkSoftShadowSamples&& samples);

  const Set& GetSet(size_t index) const { return this->Sets[index]; }
  size_t GetNumberOfSets() const { return this->Sets.size(); }
  int GetMapSize(int resolution) const;

  /**
   * Bakes what it takes to draw a set from its sample first on, times and counts it, and tells how many
   * can be drawn at once. Last is first if nothing can be baked.
   */
  Run Bake(const vtkSoftShadowServices& services, size_t set, size_t first);

private:
  size_t GetBatch(const vtkSoftShadowServices& services, int resolution) const;

  int MapSize = 1024;
  std::array<std::vector<vtkShadowMapView>, NumberOfResolutions> Views;
  std::vector<Set> Sets;
  vtkNew<vtkShadowTextureArray> NoMaps;
};

VTK_ABI_NAMESPACE_END
#endif
