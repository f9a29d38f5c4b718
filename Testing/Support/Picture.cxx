// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
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

//------------------------------------------------------------------------------
Picture ReadPicture(const std::string& path)
{
  auto file = OIIO::ImageInput::open(path);
  if (!file)
  {
    throw std::runtime_error("Cannot read " + path + ": " + OIIO::geterror());
  }
  const OIIO::ImageSpec& spec = file->spec();
  Picture picture(spec.width, spec.height, spec.nchannels);
  const OIIO::stride_t row =
    static_cast<OIIO::stride_t>(sizeof(float)) * spec.width * spec.nchannels;
  float* topRow =
    picture.Values.data() + static_cast<std::size_t>(spec.height - 1) * spec.width * spec.nchannels;
  if (!file->read_image(
        0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, topRow, OIIO::AutoStride, -row))
  {
    throw std::runtime_error("Cannot read " + path + ": " + file->geterror());
  }
  return picture;
}

//------------------------------------------------------------------------------
void WritePicture(const std::string& path, const Picture& picture)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty())
  {
    std::filesystem::create_directories(folder);
  }
  const bool bytes = std::filesystem::path(path).extension() == ".png";
  const OIIO::ImageSpec spec(picture.Width, picture.Height, picture.Channels,
    bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  auto file = OIIO::ImageOutput::create(path);
  const OIIO::stride_t row =
    static_cast<OIIO::stride_t>(sizeof(float)) * picture.Width * picture.Channels;
  const float* topRow = picture.Values.data() +
    static_cast<std::size_t>(picture.Height - 1) * picture.Width * picture.Channels;
  if (!file || !file->open(path, spec) ||
    !file->write_image(OIIO::TypeDesc::FLOAT, topRow, OIIO::AutoStride, -row) || !file->close())
  {
    throw std::runtime_error(
      "Cannot write " + path + ": " + (file ? file->geterror() : OIIO::geterror()));
  }
}

}
