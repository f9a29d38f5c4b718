// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CompareCommand.h"

#include "NumberRange.h"
#include "OutputFiles.h"

#include "DifferencePicture.h"
#include "ErrorReport.h"
#include "PictureFile.h"
#include "ShiftedEdges.h"
#include "Silhouettes.h"
#include "VisibilityFile.h"

#include <algorithm>  // For the fewer lights
#include <filesystem> // For names of pictures
#include <fstream>    // For the report
#include <iostream>   // For the table
#include <memory>     // For the options' life
#include <optional>   // For what may be left out
#include <stdexcept>  // For errors

namespace softshadows
{
namespace
{

struct CompareOptions
{
  std::string Reference;
  std::string Candidate;
  std::optional<int> Light; // all without it
  std::string Picture;
  double Range = DefaultDifferenceRange;
  std::string Report;
  bool LeavesOutEdges = false;
};

//--------------------------------------------------------------------------------------------------
std::string SizeOf(const VisibilityImage& image)
{
  return std::to_string(image.Width) + " x " + std::to_string(image.Height) + " pixels and " +
    std::to_string(image.Visibility.size()) + " light(s)";
}

//--------------------------------------------------------------------------------------------------
void CheckSizes(
  const CompareOptions& options, const VisibilityImage& reference, const VisibilityImage& candidate)
{
  const bool sameLights =
    options.Light || reference.Visibility.size() == candidate.Visibility.size();
  const std::string sizes = options.Reference + " has " + SizeOf(reference) + ", " +
    options.Candidate + " has " + SizeOf(candidate);
  if (reference.Width != candidate.Width || reference.Height != candidate.Height || !sameLights)
  {
    throw std::runtime_error(sizes);
  }
  const int lights =
    static_cast<int>(std::min(reference.Visibility.size(), candidate.Visibility.size()));
  if (options.Light && (*options.Light < 0 || *options.Light >= lights))
  {
    const std::string light = "--light " + std::to_string(*options.Light);
    throw std::runtime_error(
      light + ": must be a whole number from 0 to " + std::to_string(lights - 1) + "; " + sizes);
  }
}

//--------------------------------------------------------------------------------------------------
// With several lights the light's number stands before the ending: diff.png, diff-1.png, ...
std::string PicturePath(const CompareOptions& options, size_t light)
{
  if (light == 0 || options.Light)
  {
    return options.Picture;
  }
  std::filesystem::path path(options.Picture);
  const std::string ending = path.extension().string();
  path.replace_extension();
  return path.string() + "-" + std::to_string(light) + ending;
}

//--------------------------------------------------------------------------------------------------
void WriteReport(const std::string& path, const nlohmann::ordered_json& report)
{
  std::ofstream file(path);
  file << report.dump(2) << '\n';
  file.close();
  if (!file)
  {
    throw std::runtime_error(path + ": cannot be written");
  }
}

//--------------------------------------------------------------------------------------------------
// Adds them to the pixels that are left out, and returns how many it added.
int AddShiftedEdges(int width, int height, const std::vector<float>& truth,
  const std::vector<float>& estimate, std::vector<unsigned char>& leftOut)
{
  const std::vector<unsigned char> edges = FindShiftedEdges(width, height, truth, estimate);
  leftOut.resize(edges.size(), 0);
  int added = 0;
  for (size_t i = 0; i < edges.size(); ++i)
  {
    added += edges[i] != 0 && leftOut[i] == 0 ? 1 : 0;
    leftOut[i] = edges[i] != 0 ? 1 : leftOut[i];
  }
  return added;
}

//--------------------------------------------------------------------------------------------------
void Compare(const CompareOptions& options)
{
  const VisibilityImage reference = ReadVisibility(options.Reference);
  const VisibilityImage candidate = ReadVisibility(options.Candidate);
  CheckSizes(options, reference, candidate);
  std::vector<unsigned char> leftOut;
  if (!reference.Depth.empty())
  {
    leftOut = FindSilhouettes(reference.Width, reference.Height, reference.Depth);
  }

  OutputFiles outputs({ options.Reference, options.Candidate });
  const std::string reportFile = outputs.Add(options.Report);
  nlohmann::ordered_json report = { { "reference", options.Reference },
    { "candidate", options.Candidate }, { "width", reference.Width },
    { "height", reference.Height }, { "lights", nlohmann::ordered_json::array() } };
  const size_t first = options.Light.value_or(0);
  const size_t last = options.Light ? first : reference.Visibility.size() - 1;
  for (size_t light = first; light <= last; ++light)
  {
    const std::vector<float>& truth = reference.Visibility[light];
    const std::vector<float>& estimate = candidate.Visibility[light];
    std::vector<unsigned char> without = leftOut;
    const int edges = options.LeavesOutEdges
      ? AddShiftedEdges(reference.Width, reference.Height, truth, estimate, without)
      : 0;
    const VisibilityErrors errors =
      MeasureErrors(reference.Width, reference.Height, truth, estimate, without);
    std::cout << "Light " << light << '\n';
    PrintErrors(std::cout, errors);
    nlohmann::ordered_json entry = ToJson(errors);
    if (options.LeavesOutEdges)
    {
      entry["shifted_edges"] = edges;
      entry["edges"] = CountEdges(reference.Width, reference.Height, truth);
      std::cout << "Left out at edges: " << edges << " pixels\n";
    }
    entry["light"] = light;
    report["lights"].push_back(entry);
    if (!options.Picture.empty())
    {
      const std::string picture = outputs.Add(PicturePath(options, light));
      const auto colors = DrawDifference(truth, estimate, options.Range);
      outputs.Write([&] { WritePicture(picture, reference.Width, reference.Height, colors); });
    }
  }
  if (!reportFile.empty())
  {
    outputs.Write([&] { WriteReport(reportFile, report); });
  }
  outputs.Commit();
}

}

//--------------------------------------------------------------------------------------------------
void AddCompareCommand(CLI::App& app)
{
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare",
    "Measure how far a visibility is from a reference: RMSE, PSNR, SSIM, leaks, false shadows. "
    "Pixels at silhouettes (from the reference's depth) are left out.");
  command->add_option("REFERENCE", options->Reference, "OpenEXR file with the truth")->required();
  command->add_option("CANDIDATE", options->Candidate, "OpenEXR file to judge")->required();
  command->add_option("--light", options->Light, "Number of the one light to compare, from 0");
  command->add_option("--diff", options->Picture,
    "Write the difference as a picture: blue too dark, red too bright, black where one has no "
    "value. With several lights, one picture each: NAME.png, NAME-1.png, ...");
  command
    ->add_option(
      "--diff-range", options->Range, "The error that has the picture's strongest colour")
    ->check(NumberAboveZero())
    ->capture_default_str();
  command->add_flag("--without-edges", options->LeavesOutEdges,
    "Leave out pixels that lie on the other side of an edge alone: off by more than 0.02, with "
    "a value that the reference has beside them. Between two drivers, not between a technique and "
    "the "
    "truth");
  command->add_option("--report", options->Report, "Write the numbers as JSON");
  command->callback([options] { Compare(*options); });
}

}
