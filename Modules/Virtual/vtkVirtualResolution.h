// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualResolution
 * @brief   How many texels a penumbra needs to look right.
 *
 * L. Shen et al. 2011, section 5.1: a user study asked how many texels a kernel that covers n
 * pixels of the screen must hold for its penumbra to look like one of a fine map. The answers were
 * fitted by cubic polynomials in x = log2(n), one for moving and one for resting shadows. They were
 * measured for n from 1 to a few hundred; n is clamped to that, and no kernel gets less than a texel.
 */

#ifndef vtkVirtualResolution_h
#define vtkVirtualResolution_h

#include "vtkRenderingSoftShadowsVirtualModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                    // For the ABI namespace
#include "vtkVirtualKernel.h"                     // For variances

#include <array> // For vectors

VTK_ABI_NAMESPACE_BEGIN

struct VTKRENDERINGSOFTSHADOWSVIRTUAL_EXPORT vtkVirtualResolution
{
  /// Coefficients of x^0 to x^3, x = log2 n.
  using Polynomial = std::array<double, 4>;
  static constexpr Polynomial Dynamic = { { 0.667, 0.7794, 0.3967, -0.02716 } };
  static constexpr Polynomial Static = { { 0.5477, 1.406, -0.04687, -0.003944 } };

  /// The largest kernel, in pixels, that the study covers.
  static constexpr double LargestKernel = 256.0;

  /// Texels that a kernel of so many pixels needs; at least 1.
  static double GetTexels(double pixels, const Polynomial& polynomial);

  /**
   * Equations 4 and 5: the texel sizes along the map's axes, in the unit of the variance, for a
   * kernel of this variance and a pixel with the half axes u and v (the footprint on the map).
   * quality multiplies the number of texels.
   */
  static std::array<double, 2> GetTexelSize(const vtkVirtualVariance& variance,
    const std::array<double, 2>& u, const std::array<double, 2>& v, const Polynomial& polynomial,
    double quality);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualResolution.h
