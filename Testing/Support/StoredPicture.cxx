// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StoredPicture.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <stdexcept>

namespace SoftShadowsTesting
{

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
