// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowBorderGrid
 * @brief   Nested grids of (2^d + 1)^2 points of an emitter, its border included.
 *
 * Weights are those of the trapezoid rule: a point on an edge stands for half a cell, one in a
 * corner for a quarter. They sum to 1 and integrate what is bilinear over the window exactly; with
 * the paper's equal weights the border would count too much and the penumbra would be too wide.
 *
 * A level has all points of the level before. Their weights shrink by one common factor, so a sum
 * over a level is that factor times the sum over the level before plus the new points' share.
 */

#ifndef vtkShadowBorderGrid_h
#define vtkShadowBorderGrid_h

#include "vtkRenderingSoftShadowsCascadedModule.h" // For export macro
#include "vtkShadowLightSampling.h"                // For samples
#include "vtkSoftShadowsABI.h"                     // For the ABI namespace

#include <vector> // For samples

VTK_ABI_NAMESPACE_BEGIN

struct VTKRENDERINGSOFTSHADOWSCASCADED_EXPORT vtkShadowBorderGrid
{
  static constexpr int LargestLevel = 3;

  /// The points that the level adds and their weights in the level.
  std::vector<vtkShadowLightSampling::Sample> Added;
  /// What the weights of all earlier points are multiplied by; 0 on the first level.
  double Keep = 0.0;

  /**
   * level is in [0, LargestLevel]: 4, 9, 25, 81 points. Weights are vtkShadowLightSampling's. An
   * emitter without extent has one point, on level 0. Disks are filled by the equal-area map, turned by pi / 8.
   */
  static vtkShadowBorderGrid Make(const vtkShadowEmitter& emitter, int level, int weights);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowBorderGrid.h
