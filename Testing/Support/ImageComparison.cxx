// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageComparison.h"
#include "StoredPicture.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cmath>
#include <filesystem>

namespace SoftShadowsTesting
{

// The same code on the same input in the same process: not one bit differs.
const Tolerance Identical = { "Identical", 0.0, 0.0, 0.0, 0.0 };

// Two ways to the same number that differ in the order of operations: at most one step of 8 bits.
const Tolerance SameToRounding = { "SameToRounding", 1.001 / 255.0, 1.001 / 255.0, 0.0,
  1.001 / 255.0 };

// Visibilities of the same points, computed from coordinates that differ by roundings: where a light
// sample's shadow ends within that rounding, one sample's weight may go over.
const Tolerance SameButForFlips = { "SameButForFlips", 0.25, 1.001 / 255.0, 0.002, 0.002 };

// The same, but for pixels on the silhouette of geometry, where a rounding moves a point from one
// surface to another.
const Tolerance SameButForEdges = { "SameButForEdges", 1.0, 1.001 / 255.0, 0.005, 0.02 };

// A stored picture, drawn by another driver: measured to fail on a penumbra of the wrong width.
const Tolerance BaselinePicture = { "BaselinePicture", 0.5, 4.0 / 255.0, 0.001, 0.004 };

namespace
{

//------------------------------------------------------------------------------
bool SameShape(const Picture& first, const Picture& second)
{
  return first.Width == second.Width && first.Height == second.Height &&
    first.Channels == second.Channels;
}

//------------------------------------------------------------------------------
std::string ShapeOf(const Picture& picture)
{
  return std::to_string(picture.Width) + "x" + std::to_string(picture.Height) + "x" +
    std::to_string(picture.Channels);
}

//------------------------------------------------------------------------------
/// OpenImageIO's view of the picture, without its NaNs; rows stay in VTK's order.
OIIO::ImageBuf BufferOf(Picture& picture)
{
  for (float& value : picture.Values)
  {
    value = std::isnan(value) ? 0.0f : value;
  }
  const OIIO::ImageSpec spec(
    picture.Width, picture.Height, picture.Channels, OIIO::TypeDesc::FLOAT);
  return OIIO::ImageBuf(spec, picture.Values.data());
}

//------------------------------------------------------------------------------
int CountNaNsInOneOnly(const Picture& first, const Picture& second)
{
  int count = 0;
  for (std::size_t i = 0; i < first.Values.size(); ++i)
  {
    count += std::isnan(first.Values[i]) != std::isnan(second.Values[i]) ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
Picture AbsoluteDifference(const Picture& first, const Picture& second)
{
  Picture result(first.Width, first.Height, first.Channels);
  for (std::size_t i = 0; i < result.Values.size(); ++i)
  {
    result.Values[i] = std::abs(first.Values[i] - second.Values[i]);
  }
  return result;
}

}

//------------------------------------------------------------------------------
Difference Compare(const Picture& first, const Picture& second, const Tolerance& tolerance)
{
  Difference difference;
  difference.NaNsInOneOnly = CountNaNsInOneOnly(first, second);
  Picture copies[2] = { first, second };
  const OIIO::ImageBuf buffers[2] = { BufferOf(copies[0]), BufferOf(copies[1]) };
  const float limit = static_cast<float>(tolerance.PixelLimit);
  const auto result = OIIO::ImageBufAlgo::compare(buffers[0], buffers[1], limit, limit);
  difference.Maximum = result.maxerror;
  difference.RootMeanSquare = result.rms_error;
  difference.ShareOff = static_cast<double>(result.nfail) /
    (static_cast<double>(first.Width) * static_cast<double>(first.Height));
  difference.X = result.maxx;
  difference.Y = result.maxy;
  difference.Channel = result.maxc;
  if (!first.Values.empty())
  {
    difference.First = first.At(result.maxx, result.maxy, result.maxc);
    difference.Second = second.At(result.maxx, result.maxy, result.maxc);
  }
  return difference;
}

//------------------------------------------------------------------------------
testing::AssertionResult Matches(
  const Picture& first, const Picture& second, const Tolerance& tolerance)
{
  if (!SameShape(first, second))
  {
    return testing::AssertionFailure()
      << "sizes differ: " << ShapeOf(first) << " and " << ShapeOf(second);
  }
  const Difference d = Compare(first, second, tolerance);
  const bool same = d.NaNsInOneOnly == 0 && d.Maximum <= tolerance.Maximum &&
    d.ShareOff <= tolerance.ShareOff && d.RootMeanSquare <= tolerance.RootMeanSquare;
  return (same ? testing::AssertionSuccess() : testing::AssertionFailure())
    << ShapeOf(first) << " pictures, tolerance " << tolerance.Name << ": maximum " << d.Maximum
    << " (at most " << tolerance.Maximum << ") at (" << d.X << ", " << d.Y << ") channel "
    << d.Channel << ", values " << d.First << " and " << d.Second << "; off by more than "
    << tolerance.PixelLimit << ": " << 100.0 * d.ShareOff << " % (at most "
    << 100.0 * tolerance.ShareOff << " %); root mean square " << d.RootMeanSquare << " (at most "
    << tolerance.RootMeanSquare << "); NaN in one only: " << d.NaNsInOneOnly;
}

//------------------------------------------------------------------------------
testing::AssertionResult MatchesBaseline(const Picture& picture, const std::string& name,
  const std::string& baselineFolder, const std::string& outputFolder, const Tolerance& tolerance)
{
  const std::string baseline = baselineFolder + "/" + name;
  const std::string written = outputFolder + "/" + name;
  if (!std::filesystem::exists(baseline))
  {
    WritePicture(written, picture);
    return testing::AssertionFailure() << "There is no baseline " << baseline
                                       << ". If the picture is right, copy it there: " << written;
  }
  const Picture expected = ReadPicture(baseline);
  const testing::AssertionResult result = Matches(picture, expected, tolerance);
  if (result)
  {
    return result;
  }
  WritePicture(written, picture);
  if (SameShape(picture, expected))
  {
    WritePicture(outputFolder + "/difference-" + name, AbsoluteDifference(picture, expected));
  }
  return testing::AssertionFailure()
    << result.message() << "\nbaseline: " << baseline << "\npicture: " << written;
}

}
