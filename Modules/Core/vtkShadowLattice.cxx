// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLattice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

double Dot(const std::array<double, 2>& u, const std::array<double, 2>& v)
{
  return u[0] * v[0] + u[1] * v[1];
}

// How far apart neighbours are: their squared distance, in units of what a square lattice of the same
// density has; then how far off the sides and the diagonals, in steps of the permutation.
std::pair<double, double> RankOf(int modulus, int generator)
{
  const std::array<double, 2> nearest = vtkShadowLattice::Reduce(modulus, generator)[0];
  const double x = std::abs(nearest[0]);
  const double y = std::abs(nearest[1]);
  return { Dot(nearest, nearest) / modulus, std::min(std::min(x, y), std::abs(x - y)) };
}

} // namespace

//------------------------------------------------------------------------------
vtkShadowLattice::vtkShadowLattice(int count)
  : Count(std::max(count, 1))
{
  std::pair<double, double> best(-1.0, 0.0);
  for (int modulus = this->Count; modulus <= this->Count + 1; ++modulus)
  {
    for (int generator = 1; generator < std::max(modulus, 2); ++generator)
    {
      if (std::gcd(generator, modulus) != 1)
      {
        continue;
      }
      const auto rank = RankOf(modulus, generator);
      if (rank > best)
      {
        best = rank;
        this->Modulus = modulus;
        this->Generator = generator;
      }
    }
  }
  if (this->Modulus > this->Count)
  {
    // Without the origin the multiples 1 ... n are symmetric as they are.
    this->First = 1;
    this->Shift = -1;
    return;
  }
  // Point n - 1 - i is opposite to point i if twice the shift is g - 1, modulo n.
  const int twice = this->Generator - 1;
  this->Shift = (twice % 2 == 0 ? twice : twice + this->Count) / 2;
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkShadowLattice::GetPoint(int i) const
{
  const long long multiple = static_cast<long long>(this->Generator) * (i + this->First);
  const auto row = this->First > 0 ? multiple % this->Modulus + this->Shift
                                   : (multiple + this->Shift) % this->Modulus;
  return { { (2.0 * i + 1.0) / this->Count - 1.0,
    (2.0 * static_cast<double>(row) + 1.0) / this->Count - 1.0 } };
}

//------------------------------------------------------------------------------
vtkShadowLattice::Basis vtkShadowLattice::GetCell() const
{
  Basis cell = vtkShadowLattice::Reduce(this->Modulus, this->Generator);
  for (std::array<double, 2>& edge : cell)
  {
    edge = { { 2.0 * edge[0] / this->Count, 2.0 * edge[1] / this->Count } };
  }
  return cell;
}

//------------------------------------------------------------------------------
vtkShadowLattice::Basis vtkShadowLattice::Reduce(int modulus, int generator)
{
  // Gauss's reduction of the basis (1, g), (0, N).
  std::array<double, 2> a = { { 1.0, static_cast<double>(generator) } };
  std::array<double, 2> b = { { 0.0, static_cast<double>(modulus) } };
  while (true)
  {
    if (Dot(a, a) > Dot(b, b))
    {
      std::swap(a, b);
    }
    // Rounded with ties downwards: to the nearest, ties would swing for ever.
    const double steps = std::ceil(Dot(a, b) / Dot(a, a) - 0.5);
    if (steps == 0.0)
    {
      return { { a, b } };
    }
    b = { { b[0] - steps * a[0], b[1] - steps * a[1] } };
  }
}
VTK_ABI_NAMESPACE_END
