// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFile.h"

#include <OpenImageIO/filesystem.h>

#include <cstdio>    // For std::remove
#include <fstream>   // For files
#include <stdexcept> // For errors
#include <vector>    // For bytes

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
[[noreturn]] void Fail(const std::string& path, const std::string& reason)
{
  std::remove(path.c_str());
  throw std::runtime_error(path + ": cannot be written" + (reason.empty() ? "" : ": " + reason));
}

//--------------------------------------------------------------------------------------------------
void WriteBytes(const std::string& path, const std::vector<unsigned char>& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(
    reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file)
  {
    Fail(path, "");
  }
}

//--------------------------------------------------------------------------------------------------
/// For formats that cannot be written to memory: the file must give back every pixel.
void ExpectReadable(const std::string& path)
{
  const auto input = OIIO::ImageInput::open(path);
  if (!input)
  {
    Fail(path, OIIO::geterror());
  }
  const OIIO::ImageSpec& spec = input->spec();
  std::vector<float> pixels(spec.image_pixels() * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()))
  {
    Fail(path, input->geterror());
  }
}

}

//--------------------------------------------------------------------------------------------------
void WriteImageFile(const std::string& path, const OIIO::ImageSpec& spec,
  const OIIO::TypeDesc& type, const void* pixels)
{
  const auto output = OIIO::ImageOutput::create(path);
  if (!output)
  {
    Fail(path, OIIO::geterror());
  }
  OIIO::Filesystem::IOVecOutput memory;
  const bool inMemory = output->supports("ioproxy") && output->set_ioproxy(&memory);
  if (!output->open(path, spec) || !output->write_image(type, pixels) || !output->close())
  {
    Fail(path, output->geterror());
  }
  if (inMemory)
  {
    WriteBytes(path, memory.buffer());
  }
  else
  {
    ExpectReadable(path);
  }
}

}
