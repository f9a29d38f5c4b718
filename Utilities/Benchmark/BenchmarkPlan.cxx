// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPlan.h"

#include "BenchmarkScenes.h"
#include "SceneReader.h"

#include <algorithm>    // For selections
#include <filesystem>   // For scene files
#include <set>          // For names
#include <stdexcept>    // For unknown names
#include <system_error> // For folders that cannot be read

namespace softshadows
{
namespace
{

constexpr const char* MapSizes[] = { "512", "1024", "2048", "4096" };
/// The first is what the reports show pictures of.
constexpr const char* Samples[] = { "16", "1", "4", "64", "256" };
/// For techniques that make more of few samples.
constexpr const char* FewSamples[] = { "4", "16" };
/// Blocker search and filter, as published for separable soft shadow mapping.
constexpr const char* Kernels[][2] = { { "7", "15" }, { "11", "21" }, { "29", "41" } };
/// Rivals of papers, which have one setting.
constexpr const char* Rivals[] = { "ssabss", "fassalss" };
/// Compact, contacts, fine leaves, many depths.
constexpr const char* QuickScenes[] = { "bunny", "assembly", "foliage", "fused" };

//--------------------------------------------------------------------------------------------------
class Plan
{
public:
  void Add(const std::string& technique, const TechniqueOptions& options)
  {
    ContestantChoice choice{ technique, options };
    if (this->Names.insert(choice.GetName()).second)
    {
      this->Choices.push_back(choice);
    }
  }

  /// All that are there so far.
  void MakeEssential()
  {
    for (ContestantChoice& choice : this->Choices)
    {
      choice.IsEssential = true;
    }
  }

  std::vector<ContestantChoice> Choices;

private:
  std::set<std::string> Names;
};

//--------------------------------------------------------------------------------------------------
// Options that every contestant of a technique has, and some more.
TechniqueOptions With(const KnownTechnique& technique, const TechniqueOptions& more)
{
  TechniqueOptions options = more;
  if (technique.Has("weights"))
  {
    options["weights"] = "mean"; // as the reference
  }
  return options;
}

//--------------------------------------------------------------------------------------------------
// Rays through the triangles need none.
bool HasMaps(const KnownTechnique& technique)
{
  return !technique.Has("most_rays");
}

//--------------------------------------------------------------------------------------------------
void AddFew(const KnownTechnique& technique, Plan& plan)
{
  TechniqueOptions options = With(technique, {});
  if (HasMaps(technique))
  {
    options["map_size"] = "1024";
  }
  if (technique.Name == "sampled")
  {
    for (const char* samples : { "16", "1" })
    {
      options["samples"] = samples;
      plan.Add(technique.Name, options);
    }
    return;
  }
  plan.Add(technique.Name, options);
}

//--------------------------------------------------------------------------------------------------
bool IsRival(const KnownTechnique& technique)
{
  return std::find(std::begin(Rivals), std::end(Rivals), technique.Name) != std::end(Rivals);
}

//--------------------------------------------------------------------------------------------------
void AddDefault(const KnownTechnique& technique, Plan& plan)
{
  technique.Name == "sampled" ? AddFew(technique, plan)
                              : plan.Add(technique.Name, With(technique, {}));
}

//--------------------------------------------------------------------------------------------------
void AddVariants(const KnownTechnique& technique, Plan& plan)
{
  const auto add = [&](const TechniqueOptions& options)
  { plan.Add(technique.Name, With(technique, options)); };
  if (IsRival(technique))
  {
    return;
  }
  const bool isSampled = technique.Name == "sampled";
  if (isSampled)
  {
    for (const char* samples : Samples)
    {
      add({ { "map_size", "1024" }, { "samples", samples } });
    }
  }
  if (technique.Has("samples") && !isSampled)
  {
    for (const char* samples : FewSamples)
    {
      add({ { "map_size", "1024" }, { "samples", samples } });
    }
  }
  if (technique.Has("rays") && technique.Has("steps"))
  {
    add({ { "rays", "16" }, { "steps", "8" } });
  }
  if (!HasMaps(technique))
  {
    add({ { "rays", "2" } });
    add({ { "rays", "16" }, { "most_rays", "64" } });
    add({ { "rays", "16" }, { "filter", "off" }, { "adaptive", "off" } });
    return;
  }
  if (technique.Has("split") && !technique.Has("samples"))
  {
    add({ { "split", "2" } });
  }
  for (const auto& kernel : Kernels)
  {
    if (technique.Has("search_width") && technique.Has("filter_width"))
    {
      add({ { "search_width", kernel[0] }, { "filter_width", kernel[1] } });
    }
  }
}

//--------------------------------------------------------------------------------------------------
void AddMapSizes(const KnownTechnique& technique, Plan& plan)
{
  if (IsRival(technique) || !HasMaps(technique))
  {
    return;
  }
  for (const char* size : MapSizes)
  {
    TechniqueOptions options{ { "map_size", size } };
    if (technique.Name == "sampled")
    {
      options["samples"] = "16";
    }
    plan.Add(technique.Name, With(technique, options));
  }
}

//--------------------------------------------------------------------------------------------------
template <typename List, typename GetName>
void CheckNames(
  const List& list, const std::vector<std::string>& names, GetName getName, const std::string& what)
{
  for (const std::string& name : names)
  {
    const bool isKnown = std::any_of(
      list.begin(), list.end(), [&](const auto& item) { return getName(item) == name; });
    if (!isKnown)
    {
      std::set<std::string> all;
      for (const auto& item : list)
      {
        all.insert(getName(item));
      }
      std::string message = "no " + what + " " + name + "; there are";
      for (const std::string& one : all)
      {
        message += ' ' + one;
      }
      throw std::runtime_error(message);
    }
  }
}

//--------------------------------------------------------------------------------------------------
template <typename List, typename GetName>
List Select(
  const List& list, const std::vector<std::string>& names, GetName getName, const std::string& what)
{
  CheckNames(list, names, getName, what);
  List selected;
  for (const auto& item : list)
  {
    if (names.empty() || std::find(names.begin(), names.end(), getName(item)) != names.end())
    {
      selected.push_back(item);
    }
  }
  return selected;
}

}

//--------------------------------------------------------------------------------------------------
bool KnownTechnique::Has(const std::string& option) const
{
  return std::find(this->Options.begin(), this->Options.end(), option) != this->Options.end();
}

//--------------------------------------------------------------------------------------------------
std::vector<ContestantChoice> PlanContestants(
  const std::vector<KnownTechnique>& techniques, PlanSize size)
{
  Plan plan;
  plan.Add("plain", {});
  plan.Add("vtk", { { "map_size", "1024" } });
  for (const KnownTechnique& technique : techniques)
  {
    size == PlanSize::Few ? AddFew(technique, plan) : AddDefault(technique, plan);
  }
  if (size == PlanSize::Defaults)
  {
    plan.MakeEssential();
    return plan.Choices;
  }
  plan.Add("rays", { { "samples", "16" } });
  if (size == PlanSize::Few)
  {
    return plan.Choices;
  }
  plan.MakeEssential();
  for (const char* samples : Samples)
  {
    plan.Add("rays", { { "samples", samples } });
  }
  // First what needs no maps: rays, the peers of those above.
  for (const bool hasMaps : { false, true })
  {
    for (const KnownTechnique& technique : techniques)
    {
      if (HasMaps(technique) == hasMaps)
      {
        AddVariants(technique, plan);
      }
    }
  }
  for (const KnownTechnique& technique : techniques)
  {
    if (size == PlanSize::All)
    {
      AddMapSizes(technique, plan);
    }
  }
  return plan.Choices;
}

//--------------------------------------------------------------------------------------------------
std::vector<BenchmarkScene> PlanScenes(
  const std::string& folder, const std::vector<std::string>& modelFolders)
{
  std::vector<std::filesystem::path> files;
  std::error_code unread;
  const std::filesystem::directory_iterator entries(folder, unread);
  if (unread)
  {
    throw std::runtime_error("the folder of scenes, " + folder + ": " + unread.message());
  }
  for (const auto& entry : entries)
  {
    if (entry.path().extension() == ".json")
    {
      files.push_back(entry.path());
    }
  }
  if (files.empty())
  {
    throw std::runtime_error("the folder of scenes, " + folder + ": there is no scene file in it");
  }
  std::sort(files.begin(), files.end());
  const auto models = std::make_shared<ModelStore>(modelFolders);
  std::vector<BenchmarkScene> scenes;
  for (const std::filesystem::path& file : files)
  {
    const std::string name = file.stem().string();
    try
    {
      scenes.push_back(MakeScene(name, ReadScene(file.string()), models));
    }
    catch (const std::exception& error)
    {
      scenes.emplace_back();
      scenes.back().Name = name;
      scenes.back().Failure = error.what();
    }
  }
  for (const BenchmarkScene& scene : MakeGrowingScenes())
  {
    scenes.push_back(scene);
  }
  return scenes;
}

//--------------------------------------------------------------------------------------------------
std::vector<BenchmarkScene> PlanQuickScenes(const std::vector<BenchmarkScene>& scenes)
{
  const auto isChosen = [](const BenchmarkScene& scene)
  {
    return std::find(std::begin(QuickScenes), std::end(QuickScenes), scene.Name) !=
      std::end(QuickScenes);
  };
  const bool isOurs = std::any_of(scenes.begin(), scenes.end(), isChosen);
  std::vector<BenchmarkScene> few;
  for (const BenchmarkScene& scene : scenes)
  {
    if (isOurs ? isChosen(scene) : !scene.Grows)
    {
      few.push_back(scene);
      few.back().Width = 240;
      few.back().Height = 180;
    }
  }
  return few;
}

//--------------------------------------------------------------------------------------------------
double ShareOfTime(const std::vector<BenchmarkScene>& scenes, size_t next, double secondsLeft)
{
  double shares = 0.0;
  for (size_t i = next; i < scenes.size(); ++i)
  {
    shares += scenes[i].Share;
  }
  return shares > 0.0 ? secondsLeft * scenes[next].Share / shares : 0.0;
}

//--------------------------------------------------------------------------------------------------
std::vector<BenchmarkScene> SelectScenes(
  const std::vector<BenchmarkScene>& scenes, const std::vector<std::string>& names)
{
  return Select(
    scenes, names, [](const BenchmarkScene& scene) { return scene.Name; }, "scene");
}

//--------------------------------------------------------------------------------------------------
std::vector<ContestantChoice> SelectTechniques(
  const std::vector<ContestantChoice>& choices, const std::vector<std::string>& techniques)
{
  return Select(
    choices, techniques, [](const ContestantChoice& choice) { return choice.Technique; },
    "technique");
}

}
