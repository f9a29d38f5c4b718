// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A pass's images as plain arrays.
 */

#ifndef PassImages_h
#define PassImages_h

#include <cstddef>
#include <vector>

class vtkImageData;

namespace softshadows
{

/// VTK's images start at the bottom; the arrays of the utilities at the top.
template <typename T>
std::vector<T> TopRowFirst(const T* pixels, int rowLength, int rows)
{
  std::vector<T> turned;
  turned.reserve(static_cast<std::size_t>(rowLength) * rows);
  for (int row = rows - 1; row >= 0; --row)
  {
    const T* from = pixels + static_cast<std::size_t>(row) * rowLength;
    turned.insert(turned.end(), from, from + rowLength);
  }
  return turned;
}

/**
 * The floats of a one-component image, top row first; NaN everywhere for null. Throws
 * std::runtime_error if the image is of another size.
 */
std::vector<float> ImageValues(vtkImageData* image, int width, int height);

}

#endif
