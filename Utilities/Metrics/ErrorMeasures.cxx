// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMeasures.h"

#include "StructuralSimilarity.h"

#include <algorithm> // For std::nth_element
#include <cmath>     // For roots and logarithms
#include <limits>    // For NaN
#include <stdexcept> // For bad sizes

namespace softshadows
{
namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

//--------------------------------------------------------------------------------------------------
bool InPenumbra(float truth)
{
  return truth > 0.02F && truth < 0.98F;
}

//--------------------------------------------------------------------------------------------------
class Accumulator
{
public:
  void Add(double truth, double estimate, double ssim)
  {
    const double error = estimate - truth;
    this->Errors.push_back(std::abs(error));
    this->Squares += error * error;
    this->Absolutes += std::abs(error);
    this->Signed += error;
    this->Ssim += ssim;
  }

  ErrorMeasures Finish()
  {
    const double count = static_cast<double>(this->Errors.size());
    ErrorMeasures measures;
    measures.Pixels = static_cast<std::int64_t>(this->Errors.size());
    if (this->Errors.empty())
    {
      measures.Rmse = measures.Mean = measures.Bias = measures.Maximum = NaN;
      measures.Percentile99 = measures.Psnr = measures.Ssim = NaN;
      return measures;
    }
    measures.Rmse = std::sqrt(this->Squares / count);
    measures.Mean = this->Absolutes / count;
    measures.Bias = this->Signed / count;
    measures.Psnr = -20.0 * std::log10(measures.Rmse);
    measures.Ssim = this->Ssim / count;
    measures.Maximum = *std::max_element(this->Errors.begin(), this->Errors.end());
    // In whole numbers: 0.99 is none in binary.
    const size_t rank = (this->Errors.size() * 99 + 99) / 100 - 1;
    std::nth_element(this->Errors.begin(), this->Errors.begin() + rank, this->Errors.end());
    measures.Percentile99 = this->Errors[rank];
    return measures;
  }

private:
  std::vector<double> Errors;
  double Squares = 0.0;
  double Absolutes = 0.0;
  double Signed = 0.0;
  double Ssim = 0.0;
};

//--------------------------------------------------------------------------------------------------
// 1 where both images have a value and the caller wants the pixel; counts all others.
std::vector<unsigned char> FindCompared(const std::vector<float>& truth,
  const std::vector<float>& estimate, const std::vector<unsigned char>& leftOut,
  VisibilityErrors& errors)
{
  std::vector<unsigned char> compared(truth.size(), 0);
  for (size_t i = 0; i < truth.size(); ++i)
  {
    const bool inTruth = !std::isnan(truth[i]);
    const bool inEstimate = !std::isnan(estimate[i]);
    if (inTruth != inEstimate)
    {
      ++(inTruth ? errors.OnlyInTruth : errors.OnlyInEstimate);
    }
    else if (inTruth && !leftOut.empty() && leftOut[i])
    {
      ++errors.LeftOut;
    }
    else
    {
      compared[i] = inTruth ? 1 : 0;
    }
  }
  return compared;
}

//--------------------------------------------------------------------------------------------------
// Images are top row first, tiles start at the bottom. NaN compares with nothing.
double FindWorstTile(int width, int height, const std::vector<float>& truth,
  const std::vector<float>& estimate, const std::vector<unsigned char>& leftOut)
{
  constexpr int edge = 32;
  const int columns = (width + edge - 1) / edge;
  const int rows = (height + edge - 1) / edge;
  std::vector<double> squares(static_cast<size_t>(columns) * rows, 0.0);
  std::vector<int> counts(squares.size(), 0);
  for (size_t i = 0; i < truth.size(); ++i)
  {
    const double error = double(estimate[i]) - truth[i];
    if (std::isnan(error) || (!leftOut.empty() && leftOut[i]))
    {
      continue;
    }
    const size_t row = (height - 1 - i / width) / edge;
    const size_t tile = row * columns + i % width / edge;
    squares[tile] += error * error;
    ++counts[tile];
  }
  double worst = 0.0;
  for (size_t tile = 0; tile < squares.size(); ++tile)
  {
    worst = std::max(worst, squares[tile] / std::max(counts[tile], edge * edge / 4));
  }
  return std::sqrt(worst);
}

}

//--------------------------------------------------------------------------------------------------
VisibilityErrors MeasureErrors(int width, int height, const std::vector<float>& truth,
  const std::vector<float>& estimate, const std::vector<unsigned char>& leftOut)
{
  const size_t size = static_cast<size_t>(width) * height;
  if (truth.size() != size || estimate.size() != size ||
    (!leftOut.empty() && leftOut.size() != size))
  {
    throw std::invalid_argument("the images have not width x height pixels");
  }
  VisibilityErrors errors;
  const std::vector<unsigned char> compared = FindCompared(truth, estimate, leftOut, errors);
  const std::vector<double> ssim =
    StructuralSimilarityMap(width, height, truth, estimate, compared);
  Accumulator all;
  Accumulator penumbra;
  for (size_t i = 0; i < size; ++i)
  {
    if (!compared[i])
    {
      continue;
    }
    all.Add(truth[i], estimate[i], ssim[i]);
    if (InPenumbra(truth[i]))
    {
      penumbra.Add(truth[i], estimate[i], ssim[i]);
    }
    errors.LightLeaks += truth[i] < 0.001F && estimate[i] > 0.1F ? 1 : 0;
    errors.FalseShadows += truth[i] > 0.999F && estimate[i] < 0.9F ? 1 : 0;
  }
  errors.All = all.Finish();
  errors.Penumbra = penumbra.Finish();
  errors.WorstTile = FindWorstTile(width, height, truth, estimate, leftOut);
  errors.WorstTileWithLeftOut = FindWorstTile(width, height, truth, estimate, {});
  return errors;
}

}
