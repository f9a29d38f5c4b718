// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BenchmarkCommand.h"

#include "ProgressLine.h"
#include "VirtualDisplay.h"

#include "BenchmarkMeshes.h"
#include "BenchmarkOptions.h"
#include "BenchmarkPlan.h"
#include "BenchmarkReport.h"
#include "BenchmarkScenes.h"
#include "BenchmarkTechniques.h"
#include "HtmlReport.h"
#include "MachineContext.h"
#include "MarkdownReport.h"
#include "PaperRun.h"
#include "PngData.h"
#include "ReferenceCache.h"

#include "vtkSoftShadowsVersion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
std::vector<ContestantChoice> GetChoices(const BenchmarkOptions& options, PlanSize size)
{
  std::vector<ContestantChoice> choices;
  if (options.Contestants.empty() || !options.Techniques.empty())
  {
    choices = SelectTechniques(PlanContestants(ListTechniques(), size), options.Techniques);
  }
  for (const std::string& text : options.Contestants)
  {
    choices.push_back(ParseChoice(text));
  }
  return choices;
}

//--------------------------------------------------------------------------------------------------
// Throws for techniques that there are not, before anything is run.
void CheckTechniques(const BenchmarkOptions& options)
{
  std::vector<std::string> names;
  for (const ContestantChoice& choice : GetChoices(options, PlanSize::Main))
  {
    names.push_back(choice.Technique);
  }
  SelectTechniques(PlanContestants(ListTechniques(), PlanSize::Main), names);
}

//--------------------------------------------------------------------------------------------------
PlanSize GetPlanSize(const BenchmarkOptions& options, const BenchmarkScene& scene)
{
  if (options.Quick || scene.Grows)
  {
    return PlanSize::Few;
  }
  const std::vector<std::string>& names = options.Sweeps;
  const bool isSwept =
    names.empty() || std::find(names.begin(), names.end(), scene.Name) != names.end();
  return isSwept ? PlanSize::All : PlanSize::Main;
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
    std::error_code error;
    std::filesystem::remove(unfinished, error);
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
    for (const ContestantChoice& choice : GetChoices(options, GetPlanSize(options, scene)))
    {
      std::cout << "  " << choice.GetName() << '\n';
    }
  }
}

//--------------------------------------------------------------------------------------------------
void WriteDocument(const BenchmarkOptions& options, const BenchmarkResults& results)
{
  ShowLine("Writing the document", false);
  std::map<std::string, ColorImage> plots;
  WriteFile(options.Output + "/benchmark.md",
    [&](std::ostream& os) { plots = WriteMarkdown(os, results, "Images"); });
  std::filesystem::create_directories(options.Output + "/Images");
  for (const auto& plot : plots)
  {
    WriteFile(options.Output + "/Images/" + plot.first,
      [&](std::ostream& os) { os << EncodePng(plot.second); });
  }
}

//--------------------------------------------------------------------------------------------------
std::vector<BenchmarkScene> GetScenes(const BenchmarkOptions& options)
{
  std::vector<std::string> folders = options.ModelFolders;
  folders.push_back(options.Output + "/models");
  std::vector<BenchmarkScene> scenes = PlanScenes(options.Scenes, folders);
  if (!options.Paper.empty())
  {
    scenes.push_back(MakeGridScene());
    scenes.push_back(MakePlantScene());
  }
  if (options.Quick && options.Only.empty())
  {
    scenes = PlanQuickScenes(scenes);
  }
  for (BenchmarkScene& scene : scenes)
  {
    scene.Width = options.Width > 0 ? options.Width : (options.Quick ? 240 : scene.Width);
    const bool isSwept = !options.Sweeps.empty() && GetPlanSize(options, scene) == PlanSize::All;
    scene.Share *= isSwept ? 2.0 : 1.0;
    scene.Height = options.Height > 0 ? options.Height : (options.Quick ? 180 : scene.Height);
  }
  return SelectScenes(scenes, options.Only);
}

//--------------------------------------------------------------------------------------------------
// Seconds until the budget is used up; 0 without one.
class TimeLeft
{
public:
  explicit TimeLeft(double budget)
    : Budget(budget)
  {
  }

  double Get() const
  {
    const std::chrono::duration<double> used = std::chrono::steady_clock::now() - this->Start;
    return this->Budget > 0.0 ? std::max(1.0, this->Budget - used.count()) : 0.0;
  }

private:
  double Budget;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

//--------------------------------------------------------------------------------------------------
void SetSceneTime(BenchmarkRunner& runner, double seconds)
{
  BenchmarkSettings settings = runner.GetSettings();
  settings.SecondsPerScene = seconds;
  runner.SetSettings(settings);
}

//--------------------------------------------------------------------------------------------------
// References are not of the budget's time. A quick run has no budget of the user's: it shall end in
// time with them.
bool PreparesFirst(const BenchmarkOptions& options)
{
  return options.ReferencesOnly || options.Budget > 0.0;
}

//--------------------------------------------------------------------------------------------------
void CheckFailures(size_t failed, size_t all, const std::string& what)
{
  if (failed > 0)
  {
    throw std::runtime_error(
      std::to_string(failed) + " of " + std::to_string(all) + " " + what + " failed");
  }
}

//--------------------------------------------------------------------------------------------------
// Returns the number of tables without references.
size_t PreparePaper(const std::vector<PaperTable>& tables,
  const std::vector<BenchmarkScene>& scenes, const BenchmarkRunner& runner)
{
  return std::count_if(tables.begin(), tables.end(),
    [&](const PaperTable& table) { return !PreparePaperTable(table, scenes, runner); });
}

//--------------------------------------------------------------------------------------------------
// Returns the number of scenes without references.
size_t PrepareScenes(const BenchmarkOptions& options, const std::vector<BenchmarkScene>& scenes,
  const BenchmarkRunner& runner)
{
  return std::count_if(scenes.begin(), scenes.end(),
    [&](const BenchmarkScene& scene)
    { return !runner.Prepare(scene, GetChoices(options, GetPlanSize(options, scene))); });
}

//--------------------------------------------------------------------------------------------------
void RunPaper(const BenchmarkOptions& options, const std::vector<BenchmarkScene>& scenes,
  BenchmarkRunner& runner, const BenchmarkContext& context)
{
  std::vector<PaperTable> tables = GetPaperTables(options.Paper);
  for (PaperTable& table : tables)
  {
    table.Width = static_cast<int>(std::lround(options.PaperScale * table.Width));
    table.Height = static_cast<int>(std::lround(options.PaperScale * table.Height));
  }
  const size_t unprepared = PreparesFirst(options) ? PreparePaper(tables, scenes, runner) : 0;
  if (options.ReferencesOnly)
  {
    CheckFailures(unprepared, tables.size(), "tables");
    return;
  }
  const TimeLeft left(GetBudget(options));
  nlohmann::ordered_json json = { { "context", ToJson(context) } };
  std::ostringstream text;
  size_t failed = 0;
  for (size_t i = 0; i < tables.size(); ++i)
  {
    const double work = std::accumulate(tables.begin() + i, tables.end(), 0.0,
      [](double sum, const PaperTable& table) { return sum + WorkOf(table); });
    SetSceneTime(runner, left.Get() * WorkOf(tables[i]) / work);
    const PaperResult result = RunPaperTable(tables[i], scenes, runner);
    failed += result.Scene.Failure.empty() ? 0 : 1;
    json["tables"].push_back(ToJson(result));
    WritePaperMarkdown(text, result);
    WritePaperMarkdown(std::cout, result);
    std::cout << std::flush;
    const std::string path = options.Output + "/paper-" + options.Paper;
    WriteFile(path + ".md", [&](std::ostream& os) { os << text.str(); });
    WriteFile(path + ".json", [&](std::ostream& os) { os << json.dump(1) << '\n'; });
  }
  CheckFailures(failed, tables.size(), "tables");
}

//--------------------------------------------------------------------------------------------------
void RunScenes(const BenchmarkOptions& options, const std::vector<BenchmarkScene>& scenes,
  BenchmarkRunner& runner, const BenchmarkContext& context)
{
  const size_t unprepared = PreparesFirst(options) ? PrepareScenes(options, scenes, runner) : 0;
  if (options.ReferencesOnly)
  {
    CheckFailures(unprepared, scenes.size(), "scenes");
    return;
  }
  const TimeLeft left(GetBudget(options));
  BenchmarkResults results;
  results.Context = context;
  size_t failed = 0;
  for (size_t i = 0; i < scenes.size(); ++i)
  {
    const auto choices = GetChoices(options, GetPlanSize(options, scenes[i]));
    SetSceneTime(runner, ShareOfTime(scenes, i, left.Get()));
    results.Scenes.push_back(runner.Run(scenes[i], choices));
    failed += results.Scenes.back().Failure.empty() ? 0 : 1;
    // What has been measured so far survives whatever happens next.
    WriteNumbers(options, results);
    if (!scenes[i].Grows || i + 1 == scenes.size())
    {
      WriteDocument(options, results);
    }
  }
  WriteFile(options.Output + "/benchmark.html", [&](std::ostream& os) { WriteHtml(os, results); });
  ShowLine("Written: benchmark.json, .csv, .html and .md in " + options.Output, true);
  CheckFailures(failed, scenes.size(), "scenes");
}

//--------------------------------------------------------------------------------------------------
void RunBenchmark(const BenchmarkOptions& options)
{
  if (!options.MeshFolder.empty())
  {
    WriteBenchmarkMeshes(options.MeshFolder);
    return;
  }
  CheckTechniques(options);
  const std::vector<BenchmarkScene> scenes = GetScenes(options);
  if (options.List)
  {
    PrintPlan(options, scenes);
    return;
  }
  std::filesystem::create_directories(options.Output);
  WriteBenchmarkMeshes(options.Output + "/models");

  const VirtualDisplay display; // outlives all windows
  const BenchmarkContext context = DescribeMachine(SOFTSHADOWS_VERSION);
  BenchmarkRunner runner(GetBenchmarkSettings(options), CreateContestantPass,
    CacheReferences(
      options.References.empty() ? options.Output + "/references" : options.References));
  runner.SetProgress(ShowLine);
  if (options.Paper.empty())
  {
    RunScenes(options, scenes, runner, context);
  }
  else
  {
    RunPaper(options, scenes, runner, context);
  }
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
  AddBenchmarkOptions(*command, *options);
  command->callback([options] { RunBenchmark(*options); });
}

}
