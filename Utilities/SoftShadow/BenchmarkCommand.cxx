// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BenchmarkCommand.h"

#include "VirtualDisplay.h"

#include "BenchmarkMeshes.h"
#include "BenchmarkPlan.h"
#include "BenchmarkReport.h"
#include "HtmlReport.h"
#include "MachineContext.h"
#include "MarkdownReport.h"
#include "PaperTables.h"
#include "PngData.h"
#include "Technique.h"

#include "vtkSoftShadowsVersion.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace softshadows
{
namespace
{

struct BenchmarkOptions
{
  std::string Scenes = SOFTSHADOWS_BENCHMARK_SCENES;
  std::string Output = "softshadow-benchmark";
  std::vector<std::string> ModelFolders;
  std::vector<std::string> Only;
  std::vector<std::string> Techniques;
  std::vector<std::string> Contestants;
  bool Quick = false;
  bool List = false;
  bool NoPictures = false;
  int Rounds = 0;           // 0: by Quick
  double Seconds = 0.0;     // 0: by Quick
  int ReferenceSamples = 0; // 0: by Quick
  std::string MeshFolder;
  std::string Paper;
};

//--------------------------------------------------------------------------------------------------
BenchmarkSettings GetSettings(const BenchmarkOptions& options)
{
  BenchmarkSettings settings;
  settings.Rounds = options.Rounds > 0 ? options.Rounds : (options.Quick ? 3 : 9);
  settings.SecondsPerContestant =
    options.Seconds > 0.0 ? options.Seconds : (options.Quick ? 0.3 : 10.0);
  settings.LongestFrame = options.Quick ? 2.0 : 60.0;
  const int samples =
    options.ReferenceSamples > 0 ? options.ReferenceSamples : (options.Quick ? 256 : 2304);
  settings.ReferenceSamplesPerAxis = static_cast<int>(std::ceil(std::sqrt(double(samples))));
  settings.CacheFolder = options.Output + "/references";
  settings.Pictures = !options.NoPictures;
  return settings;
}

//--------------------------------------------------------------------------------------------------
std::vector<KnownTechnique> ListTechniques()
{
  std::vector<KnownTechnique> known;
  for (const Technique& technique : GetTechniques())
  {
    known.push_back({ technique.Name, {} });
    for (const TechniqueOption& option : technique.Options)
    {
      known.back().Options.push_back(option.Name);
    }
  }
  return known;
}

//--------------------------------------------------------------------------------------------------
// "pcss filter_width=21 search_width=11"
ContestantChoice ParseContestant(const std::string& text)
{
  ContestantChoice choice;
  for (const std::string& word : vtksys::SystemTools::SplitString(text, ' '))
  {
    if (choice.Technique.empty())
    {
      choice.Technique = word;
    }
    else
    {
      choice.Options.insert(SplitOption(word));
    }
  }
  return choice;
}

//--------------------------------------------------------------------------------------------------
std::vector<ContestantChoice> GetChoices(const BenchmarkOptions& options, bool few)
{
  std::vector<ContestantChoice> choices;
  if (options.Contestants.empty() || !options.Techniques.empty())
  {
    choices = SelectTechniques(PlanContestants(ListTechniques(), few), options.Techniques);
  }
  for (const std::string& text : options.Contestants)
  {
    choices.push_back(ParseContestant(text));
  }
  return choices;
}

//--------------------------------------------------------------------------------------------------
// On a terminal passing lines overwrite each other; in a file only what is final is kept.
void ShowLine(const std::string& line, bool isFinal)
{
  static const bool isTerminal = isatty(2) != 0;
  if (isTerminal)
  {
    std::cerr << "\r\x1b[K" << line << (isFinal ? "\n" : "") << std::flush;
  }
  else if (isFinal)
  {
    std::cerr << line << std::endl;
  }
}

//--------------------------------------------------------------------------------------------------
template <typename Write>
void WriteFile(const std::string& path, Write write)
{
  const std::string unfinished = path + ".part";
  std::ofstream file(unfinished, std::ios::binary);
  write(file);
  file.close();
  if (!file)
  {
    throw std::runtime_error(path + ": cannot be written");
  }
  std::filesystem::rename(unfinished, path);
}

//--------------------------------------------------------------------------------------------------
void WriteNumbers(const BenchmarkOptions& options, const BenchmarkResults& results)
{
  WriteFile(options.Output + "/benchmark.json",
    [&](std::ostream& os) { os << ToJson(results).dump(1) << '\n'; });
  WriteFile(options.Output + "/benchmark.csv", [&](std::ostream& os) { WriteCsv(os, results); });
}

//--------------------------------------------------------------------------------------------------
void PrintPlan(const BenchmarkOptions& options, const std::vector<BenchmarkScene>& scenes)
{
  for (const BenchmarkScene& scene : scenes)
  {
    std::cout << scene.Name << (scene.Failure.empty() ? "" : ": " + scene.Failure) << '\n';
  }
  for (const ContestantChoice& choice : GetChoices(options, options.Quick))
  {
    std::cout << "  " << choice.GetName() << '\n';
  }
}

//--------------------------------------------------------------------------------------------------
void WriteDocuments(const BenchmarkOptions& options, const BenchmarkResults& results)
{
  ShowLine("Writing the page", false);
  WriteFile(options.Output + "/benchmark.html", [&](std::ostream& os) { WriteHtml(os, results); });
  std::map<std::string, ColorImage> plots;
  WriteFile(options.Output + "/benchmark.md",
    [&](std::ostream& os) { plots = WriteMarkdown(os, results, "Images"); });
  std::filesystem::create_directories(options.Output + "/Images");
  for (const auto& plot : plots)
  {
    WriteFile(options.Output + "/Images/" + plot.first,
      [&](std::ostream& os) { os << EncodePng(plot.second); });
  }
  ShowLine("Written: benchmark.json, .csv, .html and .md in " + options.Output, true);
}

//--------------------------------------------------------------------------------------------------
void RunPaper(const BenchmarkOptions& options, const std::vector<BenchmarkScene>& scenes,
  const BenchmarkRunner& runner)
{
  std::ostringstream text;
  for (const PaperTable& table : GetPaperTables(options.Paper))
  {
    std::ostringstream one;
    RunPaperTable(one, table, scenes, runner);
    std::cout << one.str() << std::flush;
    text << one.str();
  }
  WriteFile(options.Output + "/paper-" + options.Paper + ".txt",
    [&](std::ostream& os) { os << text.str(); });
}

//--------------------------------------------------------------------------------------------------
void RunBenchmark(const BenchmarkOptions& options)
{
  if (!options.MeshFolder.empty())
  {
    WriteBenchmarkMeshes(options.MeshFolder);
    return;
  }
  std::vector<std::string> folders = options.ModelFolders;
  folders.push_back(options.Output + "/models");
  const std::vector<BenchmarkScene> scenes =
    SelectScenes(PlanScenes(options.Scenes, folders, options.Quick), options.Only);
  if (options.List)
  {
    PrintPlan(options, scenes);
    return;
  }
  std::filesystem::create_directories(options.Output);
  WriteBenchmarkMeshes(options.Output + "/models");

  const VirtualDisplay display; // outlives all windows
  BenchmarkResults results;
  results.Context = DescribeMachine(SOFTSHADOWS_VERSION);
  BenchmarkRunner runner(GetSettings(options),
    [](const std::string& technique, const TechniqueOptions& passOptions)
    {
      return CreatePass(
        FindTechnique(technique), OptionTexts(passOptions.begin(), passOptions.end()));
    });
  runner.SetProgress(ShowLine);
  if (!options.Paper.empty())
  {
    RunPaper(options, scenes, runner);
    return;
  }
  for (const BenchmarkScene& scene : scenes)
  {
    const bool few = options.Quick || scene.Grows;
    results.Scenes.push_back(runner.Run(scene, GetChoices(options, few)));
    WriteNumbers(options, results);
  }
  WriteDocuments(options, results);
}

}

//--------------------------------------------------------------------------------------------------
void AddBenchmarkCommand(CLI::App& app)
{
  auto options = std::make_shared<BenchmarkOptions>();
  CLI::App* command = app.add_subcommand("benchmark",
    "Measure speed and error of every technique in every scene of a folder, against ray tracing. "
    "Writes benchmark.json (Google Benchmark's form), benchmark.csv, benchmark.html and "
    "benchmark.md.");
  const auto addList =
    [command](const std::string& name, std::vector<std::string>& values, const std::string& text)
  { return command->add_option(name, values, text); };
  command->add_option("--scenes", options->Scenes, "Folder of scene files")->capture_default_str();
  command
    ->add_option("--output", options->Output,
      "Folder for the reports, the ray-traced references and the generated meshes")
    ->capture_default_str();
  addList("--models", options->ModelFolders, "Folders in which models of scenes are looked for");
  addList("--only", options->Only, "Names of the scenes to run")->delimiter(',');
  addList("--techniques", options->Techniques,
    "Techniques to run; plain, vtk (vtkShadowMapPass) and rays are techniques too")
    ->delimiter(',');
  addList("--contestant", options->Contestants,
    "A technique with its options, such as \"pcss filter_width=21\"; in place of the plan, or "
    "besides --techniques");
  command->add_flag("--quick", options->Quick, "Small images, few frames, few settings");
  command->add_flag("--list", options->List, "Print the scenes and contestants, and end");
  command->add_flag("--no-pictures", options->NoPictures, "Leave pictures out of the page");
  command->add_option("--rounds", options->Rounds, "Timed frames per contestant and motion")
    ->check(CLI::Range(1, 1000));
  command
    ->add_option("--seconds", options->Seconds,
      "Seconds that a contestant may use for timed frames in a scene")
    ->check(CLI::PositiveNumber);
  command
    ->add_option("--reference-samples", options->ReferenceSamples,
      "Rays per pixel and light of the reference, rounded up to a square")
    ->check(CLI::Range(1, 1 << 20));
  command->add_option("--paper", options->Paper,
    "Run the tables of a paper in place of the plan, and print published and measured figures: "
    "pcss, sssm, cascaded, sbfs or pvssm");
  command->add_option("--write-models", options->MeshFolder,
    "Write the generated meshes that scenes name to a folder, and end");
  command->callback([options] { RunBenchmark(*options); });
}

}
