// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBilateralLattice
 * @brief   Few points of a light, spread as a lattice whose cells tile it.
 *
 * n points ((2 i + 1) / n - 1, (2 ((g i + c) mod n) + 1) / n - 1), i in [0, n), of the window
 * [-1, 1]^2: a rank-1 lattice. No two points share a coordinate, so an edge along the light's axes
 * casts n bands of one width, where a grid casts sqrt(n). The generator g and shift c are those
 * whose points keep the greatest distance from each other: a triangle for 3, a rotated quincunx
 * for 5.
 *
 * Moved over one cell of the lattice the points cover the light evenly; a filter as wide as the
 * cell's shadow turns the bands into the true ramp.
 */

#ifndef vtkBilateralLattice_h
#define vtkBilateralLattice_h

#include "vtkRenderingSoftShadowsBilateralModule.h" // For export macro
#include "vtkShadowLightSampling.h"                 // For samples
#include "vtkSoftShadowsABI.h"                      // For the ABI namespace

#include <array>  // For axes
#include <vector> // For samples

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSBILATERAL_EXPORT vtkBilateralLattice
{
public:
  /**
   * count >= 1 points of an emitter, or one if it has no extent. A disk has the points of a
   * sunflower's head, since a lattice does not fit it, and square cells. weights is a
   * vtkShadowLightSampling::WeightsType. Tiled points and cells are contracted so that the points,
   * spread over their cells, have the variance of the emitter, beyond whose border cells reach.
   */
  vtkBilateralLattice(const vtkShadowEmitter& emitter, int count, int weights, bool isTiled);

  /// Window coordinates in [-1, 1]^2 and weights that sum to 1.
  const std::vector<vtkShadowLightSampling::Sample>& GetSamples() const { return this->Samples; }

  /// The two edges of a cell in window coordinates; its area is 4 / count, or pi / count on a disk.
  const std::array<std::array<double, 2>, 2>& GetCell() const { return this->Cell; }

private:
  void Spread(int count);
  void SpreadOverDisk(int count);
  void Contract(double variance);
  void FindCell(int count, int generator);

  std::vector<vtkShadowLightSampling::Sample> Samples;
  std::array<std::array<double, 2>, 2> Cell = { {} };
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkBilateralLattice.h
