// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowLightSampling
 * @brief   Points of an emitter with weights that integrate it.
 *
 * Points are window coordinates in [-1, 1]^2. Weights sum to 1. Disks are filled by the equal-area
 * concentric map of Shirley and Chiu 1997, so equal weights are uniform in area; the disks of
 * directional lights so that they are uniform in solid angle.
 */

#ifndef vtkShadowLightSampling_h
#define vtkShadowLightSampling_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkShadowEmitter.h"                  // For the emitter
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <vector> // For samples

VTK_ABI_NAMESPACE_BEGIN

struct VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowLightSampling
{
  enum PatternType
  {
    /// Cell centres of a grid.
    GRID = 0,
    /// One random point in each cell of the grid; the same points in every frame.
    STRATIFIED = 1,
    /// Hammersley's points, (i + 1/2) / n and the radical inverse of i: any count is well spread.
    HAMMERSLEY = 2,
    /// The first points of Sobol's (0, 2)-sequence: every prefix of 2^k points is well spread too.
    SOBOL = 3,
    /// A lattice (vtkShadowLattice), on disks through the map: any count, as good as the grid where edges
    /// run in all directions, and four times as good at 16 points where they run along the light's axes.
    LATTICE = 4
  };

  enum WeightsType
  {
    MEAN = 0,
    /// N(0, 0.5) over the whole light's window [-1, 1]^2; 0.5 is the standard deviation.
    GAUSSIAN = 1
  };

  struct Sample
  {
    double U;
    double V;
    double Weight;
  };

  /**
   * count points on the emitter, one if it has no extent. GRID and STRATIFIED need a count with
   * nearly square factors (edges differing by less than a factor of 2); other counts fall back to
   * HAMMERSLEY.
   */
  static std::vector<Sample> Generate(
    const vtkShadowEmitter& emitter, int count, int pattern, int weights);

  /**
   * Point number index of an endless sequence on the emitter: Sobol's (0, 2)-sequence, each aligned
   * run of 2^k points of which is well spread, its digits scrambled as Owen 1995 has it (by the hash
   * of Laine and Karras 2011), so that runs are as good as independent. Weight is not divided by a
   * sum: 1, or the value of the Gaussian. Without extent all points are the centre.
   */
  static Sample PointOfSequence(const vtkShadowEmitter& emitter, unsigned int index, int weights);

  /// [-1, 1]^2 to the unit disk, equal areas to equal areas (Shirley and Chiu 1997).
  static void MapToDisk(double& u, double& v);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowLightSampling.h
