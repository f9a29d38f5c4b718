// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <stdexcept>

namespace SoftShadowsTesting
{

//------------------------------------------------------------------------------
Picture::Picture(int width, int height, int channels, float value)
  : Width(width)
  , Height(height)
  , Channels(channels)
  , Values(static_cast<std::size_t>(width) * height * channels, value)
{
}

//------------------------------------------------------------------------------
Picture Picture::Part(int x, int y, int width, int height) const
{
  Picture part(width, height, this->Channels);
  for (int row = 0; row < height; ++row)
  {
    const auto first = this->Values.begin() + this->Index(x, y + row, 0);
    std::copy(first, first + width * this->Channels,
      part.Values.begin() + static_cast<std::size_t>(row) * width * this->Channels);
  }
  return part;
}

//------------------------------------------------------------------------------
Picture PictureOf(vtkImageData* image)
{
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    throw std::runtime_error("There is no image.");
  }
  const int type = scalars->GetDataType();
  if (type != VTK_UNSIGNED_CHAR && type != VTK_FLOAT)
  {
    throw std::runtime_error(std::string("Neither bytes nor floats: ") + scalars->GetClassName());
  }
  int size[3];
  image->GetDimensions(size);
  Picture picture(size[0], size[1], scalars->GetNumberOfComponents());
  const double scale = type == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
  for (vtkIdType pixel = 0; pixel < scalars->GetNumberOfTuples(); ++pixel)
  {
    for (int c = 0; c < picture.Channels; ++c)
    {
      picture.Values[pixel * picture.Channels + c] =
        static_cast<float>(scalars->GetComponent(pixel, c) * scale);
    }
  }
  return picture;
}

}
