// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DifferencePicture.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <cmath> // For std::isnan

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
std::vector<unsigned char> DrawDifference(
  const std::vector<float>& truth, const std::vector<float>& estimate, double range)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToDiverging();
  colors->AddRGBPoint(-range, 0.230, 0.299, 0.754);
  colors->AddRGBPoint(range, 0.706, 0.016, 0.150);
  std::vector<unsigned char> rgb;
  rgb.reserve(3 * truth.size());
  for (size_t i = 0; i < truth.size(); ++i)
  {
    const bool inTruth = !std::isnan(truth[i]);
    const bool inEstimate = !std::isnan(estimate[i]);
    if (inTruth && inEstimate)
    {
      const unsigned char* color = colors->MapValue(static_cast<double>(estimate[i]) - truth[i]);
      rgb.insert(rgb.end(), color, color + 3);
    }
    else
    {
      rgb.insert(rgb.end(), 3, inTruth == inEstimate ? 128 : 0);
    }
  }
  return rgb;
}

}
