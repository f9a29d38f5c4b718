// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReferenceCommand.h"

#include "NumberRange.h"
#include "OutputFiles.h"
#include "ProgressLine.h"

#include "ReferenceTracer.h"
#include "SceneBuilder.h"
#include "SceneInput.h"
#include "SceneReader.h"
#include "VisibilityFile.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace softshadows
{
namespace
{

struct ReferenceOptions
{
  std::string Scene;
  std::string Output;
  int Samples = 1024;
  int Pilot = 0;
  bool Gaussian = false;
  std::vector<std::string> ModelFolders;
  int Width = 0; // 0: the scene's
  int Height = 0;
};

//--------------------------------------------------------------------------------------------------
// The next number of samples that is a square.
int PerAxis(int samples)
{
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(samples))));
}

//--------------------------------------------------------------------------------------------------
void TraceReference(const ReferenceOptions& options)
{
  if (std::filesystem::path(options.Output).extension() != ".exr")
  {
    throw std::runtime_error("-o " + options.Output + ": must end in .exr");
  }
  OutputFiles outputs({ options.Scene });
  const std::string output = outputs.Add(options.Output);

  ModelStore models(options.ModelFolders);
  const SceneDescription scene = ReadScene(options.Scene);
  const BuiltScene built = BuildScene(scene, models);
  SayWhatIsNotShown(models);
  const int width = options.Width > 0 ? options.Width : scene.Width;
  const int height = options.Height > 0 ? options.Height : scene.Height;
  ReferenceTracer tracer(width, height, PerAxis(options.Samples));
  tracer.SetGaussian(options.Gaussian);
  tracer.SetPilotSamplesPerAxis(options.Pilot > 0 ? PerAxis(options.Pilot) : 0);
  tracer.SetProgress(ShowBar);
  ReferenceVisibility traced = tracer.Trace(built.Renderer);
  const VisibilityImage image = { width, height, std::move(traced.Visibility),
    std::move(traced.Depth) };
  outputs.Write([&] { WriteVisibility(output, image); });
  outputs.Commit();
}

}

//--------------------------------------------------------------------------------------------------
void AddReferenceCommand(CLI::App& app)
{
  auto options = std::make_shared<ReferenceOptions>();
  CLI::App* command = app.add_subcommand(
    "reference", "Ray-trace the exact visibility of every light of a scene file.");
  command->add_option("SCENE.json", options->Scene, "A scene file")->required();
  command
    ->add_option("-o,--output", options->Output,
      "OpenEXR file: channels V0, V1, ... (1 lit, 0 umbra, NaN no value) and depth")
    ->required();
  constexpr int mostSamples = 1 << 20;
  command
    ->add_option("--samples", options->Samples,
      "Rays per pixel and light, rounded up to a square; the error is about 0.3 / samples^0.75")
    ->check(WholeNumber(1, mostSamples))
    ->capture_default_str();
  command
    ->add_option("--pilot", options->Pilot,
      "First so many rays, and all of them only where these disagree: faster, but what is smaller "
      "than their distance on the light may be missed")
    ->check(WholeNumber(1, mostSamples));
  command
    ->add_option("--weights", options->Gaussian, "How the light's points count: mean or gaussian")
    ->transform(CLI::CheckedTransformer(
      std::vector<std::pair<std::string, bool>>{ { "mean", false }, { "gaussian", true } }))
    ->default_str("mean");
  command
    ->add_option("--models", options->ModelFolders,
      "Folder in which models of the scene are looked for, after the scene's own; may be given "
      "again")
    ->type_name("DIR")
    ->allow_extra_args(false);
  constexpr int longestEdge = 16384;
  command->add_option("--width", options->Width, "Pixels, in place of the scene's")
    ->check(WholeNumber(1, longestEdge));
  command->add_option("--height", options->Height, "Pixels, in place of the scene's")
    ->check(WholeNumber(1, longestEdge));
  command->callback([options] { TraceReference(*options); });
}

}
