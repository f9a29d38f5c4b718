// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Times and judges every technique at its defaults on a machine that has a graphics card and nothing
 * installed: the benchmark's scenes, VTK's plain frame and its own shadows beside them. References are
 * carried along, since ray tracing takes minutes and an image library is large; see gpu-bundle.sh.
 *
 * Usage: SoftShadowsCardCheck FOLDER [option...]
 * The folder has Scenes/, Models/ and References/. Prints a table, and writes results.json into the
 * folder of --output, in the form of the benchmark's.
 */

#include "BenchmarkMeshes.h"
#include "BenchmarkPlan.h"
#include "BenchmarkReport.h"
#include "BenchmarkRunner.h"
#include "BenchmarkTechniques.h"
#include "MachineContext.h"
#include "RawVisibility.h"

#include "vtkSoftShadowsVersion.h"

#include <vtkAutoInit.h>

#include <CLI/CLI.hpp>

#include <algorithm>  // For choices
#include <chrono>     // For the time that is left
#include <cmath>      // For roots
#include <cstdio>     // For the table
#include <filesystem> // For folders
#include <fstream>    // For the results
#include <iostream>   // For messages
#include <stdexcept>  // For references of another size

VTK_MODULE_INIT(vtkRenderingOpenGL2);

using namespace softshadows;

namespace
{

struct Options
{
  std::string Folder;
  std::string Output = ".";
  std::vector<int> Size = { 1920, 1080 };
  int Rounds = 9;
  double Seconds = 240.0;
  int Samples = 256;
  bool MakesReferences = false;
  std::vector<std::string> Only;
};

//--------------------------------------------------------------------------------------------------
Options ReadOptions(CLI::App& app, int argc, char** argv)
{
  Options options;
  app.add_option("folder", options.Folder, "Has Scenes, Models and References")
    ->required()
    ->check(CLI::ExistingDirectory);
  app.add_option("--size", options.Size, "Width and height in pixels")
    ->expected(2)
    ->take_last()
    ->check(CLI::Range(16, 16384));
  app.add_option("--rounds", options.Rounds, "Frames of each kind")->check(CLI::Range(1, 1000));
  app.add_option("--seconds", options.Seconds, "Time for all scenes")->check(CLI::Range(1.0, 1e6));
  app.add_option("--samples", options.Samples, "Rays per light and pixel of references")
    ->check(CLI::Range(1, 65536));
  app.add_option("--only", options.Only, "Names of scenes");
  app.add_option("-o,--output", options.Output, "Folder of the results");
  app.add_flag("--references", options.MakesReferences, "Trace the references, and end");
  app.parse(argc, argv);
  return options;
}

//--------------------------------------------------------------------------------------------------
std::string NameReference(const Options& options, const ReferenceRequest& request)
{
  const char* kind = request.SamplesPerAxis == 1 ? "hard" : "soft";
  return options.Folder + "/References/" + request.Scene + '-' + kind + ".raw";
}

//--------------------------------------------------------------------------------------------------
// Traced, and kept in the folder.
ReferenceSource TraceReferences(const Options& options)
{
  return [options](vtkRenderer* renderer, const ReferenceRequest& request,
           const std::function<void(double)>& progress)
  {
    VisibilityImage image = TraceReference(renderer, request, progress);
    WriteRawVisibility(NameReference(options, request), image);
    return image;
  };
}

//--------------------------------------------------------------------------------------------------
ReferenceSource ReadReferences(const Options& options)
{
  return
    [options](vtkRenderer*, const ReferenceRequest& request, const std::function<void(double)>&)
  {
    const std::string path = NameReference(options, request);
    VisibilityImage image = ReadRawVisibility(path);
    if (image.Width != request.Width || image.Height != request.Height)
    {
      throw std::runtime_error(path + ": has " + std::to_string(image.Width) + " x " +
        std::to_string(image.Height) + " pixels, not those of --size");
    }
    return image;
  };
}

//--------------------------------------------------------------------------------------------------
std::vector<BenchmarkScene> GetScenes(const Options& options, const std::string& meshes)
{
  std::vector<BenchmarkScene> scenes;
  for (BenchmarkScene& scene :
    PlanScenes(options.Folder + "/Scenes", { options.Folder + "/Models", meshes }))
  {
    if (!scene.Grows)
    {
      scene.Width = options.Size[0];
      scene.Height = options.Size[1];
      scenes.push_back(std::move(scene));
    }
  }
  return SelectScenes(scenes, options.Only);
}

//--------------------------------------------------------------------------------------------------
double SumOfSteps(const ContestantResult& result)
{
  double sum = 0.0;
  for (const auto& step : result.Steps)
  {
    sum += step.second;
  }
  return sum;
}

//--------------------------------------------------------------------------------------------------
void PrintScene(const SceneResult& scene)
{
  if (!scene.Failure.empty())
  {
    std::printf("| %s | %s | | | | | |\n", scene.Name.c_str(), scene.Failure.c_str());
  }
  for (const ContestantResult& result : scene.Contestants)
  {
    std::printf("| %s | %s |", scene.Name.c_str(), result.Name.c_str());
    if (!result.Failure.empty())
    {
      std::printf(" %s | | | | |\n", result.Failure.c_str());
      continue;
    }
    for (const Motion motion : AllMotions)
    {
      std::printf(" %.2f |", result.Times[static_cast<size_t>(motion)].Median());
    }
    std::printf(" %.2f |", SumOfSteps(result));
    result.HasErrors() ? std::printf(" %.4f |\n", result.Rmse) : std::printf(" |\n");
  }
  std::fflush(stdout);
}

//--------------------------------------------------------------------------------------------------
// The error of a visibility that is 1 everywhere.
double ErrorOfLight(const VisibilityImage& truth)
{
  double squares = 0.0;
  double pixels = 0.0;
  for (const std::vector<float>& values : truth.Visibility)
  {
    for (const float value : values)
    {
      squares += std::isnan(value) ? 0.0 : (1.0 - value) * (1.0 - value);
      pixels += std::isnan(value) ? 0.0 : 1.0;
    }
  }
  return std::sqrt(squares / std::max(pixels, 1.0));
}

//--------------------------------------------------------------------------------------------------
// Soft shadows are nearer to the truth than half of what no shadows are. The limit finds what is wrong
// altogether; figures tell the rest.
bool IsWrong(const ContestantResult& result, double errorOfLight)
{
  return result.Technique != "vtk" && std::isnan(result.RmseToHard) && result.HasErrors() &&
    !(result.Rmse <= 0.5 * errorOfLight);
}

//--------------------------------------------------------------------------------------------------
bool HasFailed(const SceneResult& scene, double errorOfLight)
{
  const auto hasFailed = [errorOfLight](const ContestantResult& result)
  {
    const bool isLeftOut = result.Failure.rfind("left out", 0) == 0;
    if (IsWrong(result, errorOfLight))
    {
      std::fprintf(stderr, "%s has an error of %.3f; without shadows it would be %.3f\n",
        result.Name.c_str(), result.Rmse, errorOfLight);
      return true;
    }
    return !result.Failure.empty() && !isLeftOut;
  };
  return !scene.Failure.empty() ||
    std::count_if(scene.Contestants.begin(), scene.Contestants.end(), hasFailed) > 0;
}

//--------------------------------------------------------------------------------------------------
int Run(const Options& options)
{
  const std::string meshes = options.Output + "/meshes";
  std::filesystem::create_directories(meshes);
  WriteBenchmarkMeshes(meshes);
  const std::vector<BenchmarkScene> scenes = GetScenes(options, meshes);
  const std::vector<ContestantChoice> choices =
    PlanContestants(ListTechniques(), PlanSize::Defaults);

  BenchmarkSettings settings;
  settings.Rounds = options.Rounds;
  settings.JudgesPictures = false;
  settings.Pictures = false;
  settings.LongestFrame = 10.0;
  settings.ReferenceSamplesPerAxis = static_cast<int>(std::ceil(std::sqrt(options.Samples)));
  BenchmarkRunner runner(settings, CreateContestantPass,
    options.MakesReferences ? TraceReferences(options) : ReadReferences(options));
  if (options.MakesReferences)
  {
    std::filesystem::create_directories(options.Folder + "/References");
    runner.SetProgress(
      [](const std::string& line, bool isFinal)
      {
        if (isFinal)
        {
          std::cerr << line << '\n';
        }
      });
    return std::all_of(scenes.begin(), scenes.end(),
             [&](const BenchmarkScene& scene) { return runner.Prepare(scene, choices); })
      ? 0
      : 1;
  }

  BenchmarkResults results;
  results.Context = DescribeMachine(SOFTSHADOWS_VERSION);
  std::printf(
    "%s, VTK %s, %d x %d pixels\n\n| scene | contestant | still ms | camera ms | light ms | "
    "steps ms, light | RMSE |\n| --- | --- | ---: | ---: | ---: | ---: | ---: |\n",
    results.Context.Renderer.c_str(), results.Context.VtkVersion.c_str(), options.Size[0],
    options.Size[1]);
  const auto start = std::chrono::steady_clock::now();
  bool failed = false;
  for (size_t i = 0; i < scenes.size(); ++i)
  {
    const std::chrono::duration<double> used = std::chrono::steady_clock::now() - start;
    settings.SecondsPerScene =
      ShareOfTime(scenes, i, std::max(1.0, options.Seconds - used.count()));
    runner.SetSettings(settings);
    results.Scenes.push_back(runner.Run(scenes[i], choices));
    PrintScene(results.Scenes.back());
    const ReferenceRequest soft{ scenes[i].Name, 0, 0, settings.ReferenceSamplesPerAxis, false };
    const bool isBroken = !results.Scenes.back().Failure.empty();
    const double errorOfLight =
      isBroken ? 0.0 : ErrorOfLight(ReadRawVisibility(NameReference(options, soft)));
    failed = HasFailed(results.Scenes.back(), errorOfLight) || failed;
    // What was measured stays, whatever happens next.
    std::ofstream file(options.Output + "/results.json");
    file << ToJson(results).dump(1) << '\n';
    if (!file)
    {
      throw std::runtime_error(options.Output + "/results.json: cannot be written");
    }
  }
  return failed ? 1 : 0;
}

//--------------------------------------------------------------------------------------------------
int Run(int argc, char** argv)
{
  CLI::App app("Times and judges every technique at its defaults, with references carried along.");
  try
  {
    return Run(ReadOptions(app, argc, argv));
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error);
  }
}

}

//--------------------------------------------------------------------------------------------------
int main(int argc, char** argv)
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << "SoftShadowsCardCheck: " << error.what() << '\n';
    return 1;
  }
}
