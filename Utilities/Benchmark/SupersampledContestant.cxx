// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SupersampledContestant.h"

#include "vtkSoftShadowPass.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath> // For pixels without a value

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
SupersampledContestant::SupersampledContestant(const SceneFactory& makeScene, int width, int height,
  int factor, const vtkSmartPointer<vtkSoftShadowPass>& pass)
  : TechniqueContestant(makeScene, factor * width, factor * height, pass)
  , Width(width)
  , Height(height)
  , Factor(factor)
{
}

//--------------------------------------------------------------------------------------------------
std::vector<std::vector<float>> SupersampledContestant::GetVisibility()
{
  std::vector<std::vector<float>> images;
  for (const std::vector<float>& fine : TechniqueContestant::GetVisibility())
  {
    const size_t pixels = static_cast<size_t>(this->Width) * this->Height;
    std::vector<float> sums(pixels, 0.0F);
    std::vector<float> counts(pixels, 0.0F);
    for (size_t i = 0; i < fine.size(); ++i)
    {
      const size_t row = i / (static_cast<size_t>(this->Factor) * this->Width) / this->Factor;
      const size_t column = i % (static_cast<size_t>(this->Factor) * this->Width) / this->Factor;
      if (!std::isnan(fine[i]))
      {
        sums[row * this->Width + column] += fine[i];
        counts[row * this->Width + column] += 1.0F;
      }
    }
    for (size_t i = 0; i < pixels; ++i)
    {
      sums[i] /= counts[i]; // NaN where no sample has a value
    }
    images.push_back(std::move(sums));
  }
  return images;
}

//--------------------------------------------------------------------------------------------------
ColorImage SupersampledContestant::GetPicture()
{
  const ColorImage fine = TechniqueContestant::GetPicture();
  ColorImage image{ this->Width, this->Height, {} };
  const int samples = this->Factor * this->Factor;
  for (int row = 0; row < this->Height; ++row)
  {
    for (int value = 0; value < 3 * this->Width; ++value)
    {
      int sum = samples / 2;
      for (int i = 0; i < samples; ++i)
      {
        const int y = row * this->Factor + i / this->Factor;
        const int x = value / 3 * this->Factor + i % this->Factor;
        sum += fine.Pixels[3 * (static_cast<size_t>(y) * fine.Width + x) + value % 3];
      }
      image.Pixels.push_back(static_cast<unsigned char>(sum / samples));
    }
  }
  return image;
}

}
