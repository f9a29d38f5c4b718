// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Picture.h
 * @brief Pixels as floats: what a window shows, a visibility, a baseline.
 */

#ifndef SoftShadowsTesting_Picture_h
#define SoftShadowsTesting_Picture_h

#include <cstddef> // For size_t
#include <vector>  // For pixels

class vtkImageData;

namespace SoftShadowsTesting
{

/// Bottom row first, as in VTK. Colours lie in [0, 1].
struct Picture
{
  int Width = 0;
  int Height = 0;
  int Channels = 0;
  std::vector<float> Values;

  Picture() = default;
  Picture(int width, int height, int channels, float value = 0.0f);

  float& At(int x, int y, int channel = 0) { return this->Values[this->Index(x, y, channel)]; }
  float At(int x, int y, int channel = 0) const { return this->Values[this->Index(x, y, channel)]; }

  /// The part of width x height pixels with its lower left corner at (x, y).
  Picture Part(int x, int y, int width, int height) const;

private:
  std::size_t Index(int x, int y, int channel) const
  {
    return (static_cast<std::size_t>(y) * this->Width + x) * this->Channels + channel;
  }
};

/// An image of unsigned char (scaled to [0, 1]) or float (as it is). Others throw.
Picture PictureOf(vtkImageData* image);

}

#endif
