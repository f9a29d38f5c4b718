// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkOptions.h"

#include "InstalledFiles.h"
#include "NumberRange.h"

#include <cmath>

namespace softshadows
{
namespace
{

/// Of a quick run, which shall end within two minutes with the references and the reports.
constexpr double QuickBudget = 85.0;

//--------------------------------------------------------------------------------------------------
void AddWhat(CLI::App& command, BenchmarkOptions& options)
{
  command.add_option("--scenes", options.Scenes, "Folder of scene files")->capture_default_str();
  command.add_option(
    "--models", options.ModelFolders, "Folders in which models of scenes are looked for");
  command.add_option("--only", options.Only, "Names of the scenes to run")->delimiter(',');
  command
    .add_option("--techniques", options.Techniques,
      "Techniques to run; plain, vtk (vtkShadowMapPass) and rays are techniques too")
    ->delimiter(',');
  command.add_option("--contestant", options.Contestants,
    "A technique with its options, such as \"pcss filter_width=21\"; in place of the plan, or "
    "besides --techniques");
  command
    .add_option("--sweep", options.Sweeps,
      "Names of the scenes in which map sizes are varied too; all by default")
    ->delimiter(',');
  command.add_flag("--quick", options.Quick,
    "A few scenes, small images, one or two settings of each technique; under two minutes");
  command.add_option("--paper", options.Paper,
    "Run the tables of a paper in place of the plan, and write published and measured figures side "
    "by side: pcss, sssm, cascaded, sbfs, pvssm, or estimators");
  command
    .add_option("--paper-scale", options.PaperScale, "Factor on the size of the papers' images")
    ->check(Number(0.05, 4.0));
  command.add_flag("--list", options.List, "Print the scenes and contestants, and end");
  command.add_flag("--references-only", options.ReferencesOnly,
    "Trace the references that the run would read, and end");
  command.add_option("--write-models", options.MeshFolder,
    "Write the generated meshes that scenes name to a folder, and end");
}

//--------------------------------------------------------------------------------------------------
void AddHow(CLI::App& command, BenchmarkOptions& options)
{
  command.add_option("--output", options.Output, "Folder for the reports and the generated meshes")
    ->capture_default_str();
  command.add_option("--references", options.References,
    "Folder for the ray-traced references; references below --output by default");
  command.add_flag("--no-pictures", options.NoPictures, "Leave pictures out of the page");
  command.add_option("--width", options.Width, "Pixels, in place of the scenes' own")
    ->check(WholeNumber(16, 8192));
  command.add_option("--height", options.Height, "Pixels, in place of the scenes' own")
    ->check(WholeNumber(16, 8192));
  command.add_option("--rounds", options.Rounds, "Timed frames per contestant and motion")
    ->check(WholeNumber(1, 1000));
  command
    .add_option(
      "--seconds", options.Seconds, "Seconds that a contestant may use for timed frames in a scene")
    ->check(NumberAboveZero());
  command
    .add_option("--budget", options.Budget,
      "Seconds for the whole run without its references; shared out over the scenes, so that what "
      "comes last in each may be left out")
    ->check(NumberAboveZero());
  command
    .add_option("--reference-samples", options.ReferenceSamples,
      "Rays per pixel and light of the reference, rounded up to a square")
    ->check(WholeNumber(1, 1 << 20));
}

}

//--------------------------------------------------------------------------------------------------
void AddBenchmarkOptions(CLI::App& command, BenchmarkOptions& options)
{
  options.Scenes = FindBenchmarkScenes();
  AddWhat(command, options);
  AddHow(command, options);
}

//--------------------------------------------------------------------------------------------------
double GetBudget(const BenchmarkOptions& options)
{
  return options.Budget > 0.0 || !options.Quick ? options.Budget : QuickBudget;
}

//--------------------------------------------------------------------------------------------------
BenchmarkSettings GetBenchmarkSettings(const BenchmarkOptions& options)
{
  BenchmarkSettings settings;
  settings.Rounds = options.Rounds > 0 ? options.Rounds : (options.Quick ? 3 : 9);
  settings.SecondsPerContestant =
    options.Seconds > 0.0 ? options.Seconds : (options.Quick ? 0.5 : 10.0);
  settings.LongestFrame = options.Quick ? 2.0 : 60.0;
  const int samples =
    options.ReferenceSamples > 0 ? options.ReferenceSamples : (options.Quick ? 256 : 2304);
  settings.ReferenceSamplesPerAxis = static_cast<int>(std::ceil(std::sqrt(double(samples))));
  settings.Pictures = !options.NoPictures;
  return settings;
}

}
