// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PassImages.h"

#include "vtkImageData.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
std::vector<float> ImageValues(vtkImageData* image, int width, int height)
{
  if (!image)
  {
    return std::vector<float>(
      static_cast<std::size_t>(width) * height, std::numeric_limits<float>::quiet_NaN());
  }
  const int* size = image->GetDimensions();
  if (size[0] != width || size[1] != height)
  {
    throw std::runtime_error("the window has another size than asked for: " +
      std::to_string(size[0]) + " x " + std::to_string(size[1]));
  }
  return TopRowFirst(static_cast<const float*>(image->GetScalarPointer()), width, height);
}

}
