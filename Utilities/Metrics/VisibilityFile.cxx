// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibilityFile.h"

#include "ImageFile.h"

#include <OpenImageIO/imageio.h>

#include <algorithm> // For std::find
#include <stdexcept> // For errors

namespace softshadows
{
namespace
{

const std::string DepthName = "depth";

//--------------------------------------------------------------------------------------------------
[[noreturn]] void Fail(const std::string& path, const std::string& reason)
{
  throw std::runtime_error(path + ": " + reason);
}

//--------------------------------------------------------------------------------------------------
std::string ChannelName(size_t light)
{
  return "V" + std::to_string(light);
}

//--------------------------------------------------------------------------------------------------
// The channel of that name among interleaved ones; empty if there is none.
std::vector<float> TakeChannel(
  const OIIO::ImageSpec& spec, const std::vector<float>& pixels, const std::string& name)
{
  const auto& names = spec.channelnames;
  const auto found = std::find(names.begin(), names.end(), name);
  std::vector<float> channel;
  if (found != names.end())
  {
    channel.reserve(pixels.size() / names.size());
    for (size_t i = found - names.begin(); i < pixels.size(); i += names.size())
    {
      channel.push_back(pixels[i]);
    }
  }
  return channel;
}

}

//--------------------------------------------------------------------------------------------------
VisibilityImage ReadVisibility(const std::string& path)
{
  const auto input = OIIO::ImageInput::open(path);
  if (!input)
  {
    Fail(path, OIIO::geterror());
  }
  const OIIO::ImageSpec& spec = input->spec();
  std::vector<float> pixels(static_cast<size_t>(spec.width) * spec.height * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()))
  {
    Fail(path, input->geterror());
  }
  VisibilityImage image;
  image.Width = spec.width;
  image.Height = spec.height;
  image.Depth = TakeChannel(spec, pixels, DepthName);
  for (;;)
  {
    std::vector<float> channel = TakeChannel(spec, pixels, ChannelName(image.Visibility.size()));
    if (channel.empty())
    {
      break;
    }
    image.Visibility.push_back(std::move(channel));
  }
  if (image.Visibility.empty())
  {
    Fail(path, "has no channel V0, so it holds no visibility");
  }
  return image;
}

//--------------------------------------------------------------------------------------------------
void WriteVisibility(const std::string& path, const VisibilityImage& image)
{
  std::vector<std::string> names;
  std::vector<const std::vector<float>*> channels;
  for (const std::vector<float>& visibility : image.Visibility)
  {
    names.push_back(ChannelName(channels.size()));
    channels.push_back(&visibility);
  }
  if (!image.Depth.empty())
  {
    names.push_back(DepthName);
    channels.push_back(&image.Depth);
  }
  const size_t size = static_cast<size_t>(image.Width) * image.Height;
  std::vector<float> pixels(size * channels.size());
  for (size_t c = 0; c < channels.size(); ++c)
  {
    if (channels[c]->size() != size)
    {
      throw std::invalid_argument(path + ": channel " + names[c] + " has not one value per pixel");
    }
    for (size_t i = 0; i < size; ++i)
    {
      pixels[i * channels.size() + c] = (*channels[c])[i];
    }
  }

  OIIO::ImageSpec spec(
    image.Width, image.Height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = names;
  spec.attribute("compression", "zip");
  WriteImageFile(path, spec, OIIO::TypeDesc::FLOAT, pixels.data());
}

}
