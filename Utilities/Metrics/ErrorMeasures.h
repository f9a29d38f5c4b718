// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorMeasures.h
 * @brief How far an estimated visibility is from the truth, in numbers.
 *
 * Images are top row first, one float per pixel, NaN where there is no value. A pixel is compared if
 * both images have a value there and it is not left out by the caller (see Silhouettes.h). Where one
 * image alone has a value the pixel is counted, not measured.
 */

#ifndef SoftShadowsMetrics_ErrorMeasures_h
#define SoftShadowsMetrics_ErrorMeasures_h

#include <cstdint> // For counts
#include <vector>  // For images

namespace softshadows
{

/// Measures over a set of pixels. Without pixels every number but Pixels is NaN.
struct ErrorMeasures
{
  std::int64_t Pixels = 0;
  double Rmse = 0.0;
  /// Mean of the absolute errors.
  double Mean = 0.0;
  /// Mean of estimate - truth: above 0 the estimate is too bright.
  double Bias = 0.0;
  double Maximum = 0.0;
  /// Least absolute error that 99 % of the pixels do not exceed (nearest rank).
  double Percentile99 = 0.0;
  /// Decibels, for a peak of 1; infinite for equal images.
  double Psnr = 0.0;
  /// Mean of the SSIM map (see StructuralSimilarity.h).
  double Ssim = 0.0;
};

struct VisibilityErrors
{
  /// All compared pixels.
  ErrorMeasures All;
  /// Those in the truth's penumbra: 0.02 < V < 0.98.
  ErrorMeasures Penumbra;
  /// Light where there is none: truth < 0.001, estimate > 0.1.
  std::int64_t LightLeaks = 0;
  /// Shadow where there is none: truth > 0.999, estimate < 0.9.
  std::int64_t FalseShadows = 0;
  /// Pixels with values in both that the caller left out.
  std::int64_t LeftOut = 0;
  ///@{
  /// Pixels with a value in one image alone.
  std::int64_t OnlyInTruth = 0;
  std::int64_t OnlyInEstimate = 0;
  ///@}
  ///@{
  /**
   * Root mean square error of the worst tile of 32 x 32 pixels, as vtkSoftShadowPass estimates its own:
   * tiles start in the lower left corner, and one with few pixels counts as a quarter full. Over the
   * compared pixels, and with those that the caller left out.
   */
  double WorstTile = 0.0;
  double WorstTileWithLeftOut = 0.0;
  ///@}
};

/**
 * leftOut holds one value per pixel, not 0 to leave it out, or is empty. Throws
 * std::invalid_argument if the numbers of pixels differ from width x height.
 */
VisibilityErrors MeasureErrors(int width, int height, const std::vector<float>& truth,
  const std::vector<float>& estimate, const std::vector<unsigned char>& leftOut = {});

}

#endif
