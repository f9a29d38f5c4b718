// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowLattice
 * @brief   n points of a square, spread as a lattice that keeps them apart from each other.
 *
 * Point i lies at ((2 i + 1) / n - 1, (2 r(i) + 1) / n - 1) of [-1, 1]^2, r a permutation: no two
 * points share a coordinate, so an edge along the square's sides meets n steps of 1 / n, where a grid
 * has sqrt(n) of 1 / sqrt(n). The points are a lattice of N = n, or of N = n + 1 without its origin
 * (a grid of k x k, turned by atan(1 / k), is one), with the generator g: multiples (i, g i) modulo N.
 * N and g are those of the greatest distance between neighbours, for the density; among equals,
 * neighbours lie off the sides and diagonals, where the edges of things are. The points are symmetric
 * about the square's middle.
 *
 * All cells are alike: a filter as wide as the shadow of a cell turns steps into a ramp.
 */

#ifndef vtkShadowLattice_h
#define vtkShadowLattice_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <array> // For points

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowLattice
{
public:
  /// Two vectors.
  using Basis = std::array<std::array<double, 2>, 2>;

  /// Of count points, at least 1.
  explicit vtkShadowLattice(int count);

  /// Point i in [0, count), in [-1, 1]^2.
  std::array<double, 2> GetPoint(int i) const;

  /// The edges of a cell, the shorter one first. Its area is 4 N / n^2, 4 / n or a little more.
  Basis GetCell() const;

  /**
   * The shortest two vectors that span the lattice of all (i, generator i + modulus j), the shorter one
   * first.
   */
  static Basis Reduce(int modulus, int generator);

private:
  int Count;
  int Modulus = 1; // N
  int Generator = 1;
  int First = 0; // the multiple that is point 0
  int Shift = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowLattice.h
