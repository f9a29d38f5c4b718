// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualResolution.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
double vtkVirtualResolution::GetTexels(double pixels, const Polynomial& polynomial)
{
  const double x = std::log2(std::min(std::max(pixels, 1.0), LargestKernel));
  const double texels =
    polynomial[0] + x * (polynomial[1] + x * (polynomial[2] + x * polynomial[3]));
  return std::max(texels, 1.0);
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkVirtualResolution::GetTexelSize(const vtkVirtualVariance& variance,
  const std::array<double, 2>& u, const std::array<double, 2>& v, const Polynomial& polynomial,
  double quality)
{
  const double along = std::sqrt(variance[0]);
  const double lean = along > 0.0 ? variance[1] / along : 0.0;
  const double across = std::sqrt(std::max(variance[2] - lean * lean, 0.0));
  // M^-1 e0 and M^-1 e1; a footprint seen edge-on makes the kernel many pixels wide.
  const double determinant = std::max(std::abs(u[0] * v[1] - u[1] * v[0]), 1e-30);
  const double n0 = along * std::hypot(v[1], u[1]) / determinant;
  const double n1 = across * std::hypot(v[0], u[0]) / determinant;
  return { { 2.0 * along / (quality * GetTexels(n0, polynomial)),
    2.0 * across / (quality * GetTexels(n1, polynomial)) } };
}
VTK_ABI_NAMESPACE_END
