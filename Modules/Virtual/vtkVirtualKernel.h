// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualKernel
 * @brief   The filter of one pixel: the light's image convolved with the pixel's footprint.
 *
 * L. Shen et al., "Predicted Virtual Soft Shadow Maps with High Quality Filtering", 2011, sections
 * 4.1 and 4.2. Both filters are parallelograms with half axes u and v; taken as ellipsoid Gaussians
 * of variance M M^T, M = [u v], their convolution is the Gaussian of the summed variance. It is
 * turned back by Cholesky into a parallelogram with one axis along the map's, and evaluated strip
 * by strip: every strip one texel wide counts as an axis-aligned box, whose overlap with a texel is
 * exact. A texel is a square of constant depth.
 *
 * Beyond the paper: strips run along the longer side of the kernel (the paper: always along s), so
 * a kernel leans by at most one texel per strip and thin ones keep their length; and a disk light
 * has strips as high as its mean chord in the strip (the paper knows rectangles only).
 *
 * The shaders compute the same with the text of GetShaderText.
 */

#ifndef vtkVirtualKernel_h
#define vtkVirtualKernel_h

#include "vtkRenderingSoftShadowsVirtualModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                    // For the ABI namespace

#include <array>      // For vectors
#include <functional> // For the map

VTK_ABI_NAMESPACE_BEGIN

/// A symmetric 2 x 2 matrix in squared lengths of the map: { ss, st, tt }.
using vtkVirtualVariance = std::array<double, 3>;

struct VTKRENDERINGSOFTSHADOWSVIRTUAL_EXPORT vtkVirtualKernel
{
  /// Strips run along t (columns), or, if Transposed, along s (rows).
  bool Transposed = false;
  /// Half extent across the strips, how far the end at +Along leans, half extent of a strip.
  double Along = 0.0;
  double Lean = 0.0;
  double Across = 0.0;
  bool Disk = false;
  /// Weights exp(-2 (x^2 + y^2)) over the whole light's window, else 1; and what of that window the
  /// kernel stands for: middle and half size in (s, t).
  bool Gaussian = false;
  std::array<double, 4> Window = { { 0.0, 0.0, 1.0, 1.0 } };

  /// Half axes no smaller than this many texels: a point is looked up, not integrated.
  static constexpr double LeastHalfExtent = 2e-3;

  /// Half axes u and v to variance, M M^T.
  static vtkVirtualVariance Variance(
    const std::array<double, 2>& u, const std::array<double, 2>& v);

  /**
   * The variance of the light's kernel (half extents, aligned with the map) and a footprint's. A
   * disk's half extent stands for 1/4 of its square, a parallelogram's for 1/3: the footprint counts
   * 4/3 beside a disk.
   */
  static vtkVirtualVariance Convolve(
    const std::array<double, 2>& lightHalfExtent, bool disk, const vtkVirtualVariance& footprint);

  /// The kernel of a variance; texelsPerUnit scales lengths of the variance to texels, per axis.
  static vtkVirtualKernel FromVariance(
    const vtkVirtualVariance& variance, bool disk, const std::array<double, 2>& texelsPerUnit);

  /// In square texels, weighted.
  double GetArea() const;

  /// The same of a kernel whose half extents are 1.
  static double GetWindowArea(bool disk, bool gaussian, const std::array<double, 4>& window);

  ///@{
  /**
   * Overlap in square texels of texel (i, j), the square [i, i + 1] x [j, j + 1], with the kernel
   * around (s, t), both in texels, weighted.
   */
  double GetOverlap(double s, double t, int i, int j) const;
  ///@}

  /**
   * The sum of overlaps times lit(i, j), and of the overlaps, over texels in [0, width) x [0,
   * height).
   */
  std::array<double, 2> Filter(
    double s, double t, int width, int height, const std::function<double(int, int)>& lit) const;

  /// GLSL of the same: see glsl/vtkVirtualKernel.glsl.
  static const char* GetShaderText();

private:
  struct Strip
  {
    double Width; // of the overlap, reduced as the strip is smeared
    double Low;
    double High;
    double Middle;
    double WindowSlope; // how much of the window a texel is
  };
  double GetTexelOverlap(const Strip& strip, int index) const;
  Strip GetStrip(double along, double across, int index) const;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualKernel.h
