// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPlan.h"

#include "SceneBuilder.h"
#include "SceneReader.h"

#include <algorithm>  // For selections
#include <cmath>      // For rows of boxes
#include <filesystem> // For scene files
#include <set>        // For names
#include <stdexcept>  // For unknown names

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
void AddFew(const KnownTechnique& technique, Plan& plan)
{
  TechniqueOptions options = With(technique, { { "map_size", "1024" } });
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
void AddMain(const KnownTechnique& technique, Plan& plan)
{
  const auto add = [&](const TechniqueOptions& options)
  { plan.Add(technique.Name, With(technique, options)); };
  if (technique.Name == "sampled")
  {
    for (const char* samples : Samples)
    {
      add({ { "map_size", "1024" }, { "samples", samples } });
    }
    return;
  }
  add({});
  if (std::find(std::begin(Rivals), std::end(Rivals), technique.Name) != std::end(Rivals))
  {
    return;
  }
  if (technique.Has("samples"))
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
  for (const auto& kernel : Kernels)
  {
    if (technique.Has("search_width") && technique.Has("filter_width"))
    {
      add({ { "search_width", kernel[0] }, { "filter_width", kernel[1] } });
    }
  }
  if (technique.Has("split") && !technique.Has("samples"))
  {
    add({ { "split", "2" } });
  }
}

//--------------------------------------------------------------------------------------------------
void AddMapSizes(const KnownTechnique& technique, Plan& plan)
{
  const bool isRival =
    std::find(std::begin(Rivals), std::end(Rivals), technique.Name) != std::end(Rivals);
  for (const char* size : MapSizes)
  {
    TechniqueOptions options{ { "map_size", size } };
    if (technique.Name == "sampled")
    {
      options["samples"] = "16";
    }
    if (!isRival)
    {
      plan.Add(technique.Name, With(technique, options));
    }
  }
}

//--------------------------------------------------------------------------------------------------
BenchmarkScene MakeScene(const std::string& name, const SceneDescription& description,
  const std::shared_ptr<ModelStore>& models)
{
  BenchmarkScene scene;
  scene.Name = name;
  scene.Width = description.Width;
  scene.Height = description.Height;
  scene.Make = [description, models] { return BuildScene(description, *models).Renderer; };
  return scene;
}

//--------------------------------------------------------------------------------------------------
// A ground, a camera and a light above a place of about 2 x 2 x 1.
SceneDescription MakeStage()
{
  SceneDescription stage;
  stage.Camera = CameraDescription();
  stage.Camera->Position = { { 2.5, -4.0, 3.0 } };
  stage.Camera->ViewUp = { { 0.0, 0.0, 1.0 } };
  LightDescription light;
  light.Position = { { 1.5, 1.0, 4.0 } };
  light.Size = { { 0.4, 0.4 } };
  light.ConeAngle = 50.0;
  stage.Lights.push_back(light);
  PlaneShape ground;
  ground.Origin = { { -20.0, -20.0, 0.0 } };
  ground.Point1 = { { 20.0, -20.0, 0.0 } };
  ground.Point2 = { { -20.0, 20.0, 0.0 } };
  stage.Objects.emplace_back();
  stage.Objects.back().Shape = ground;
  return stage;
}

//--------------------------------------------------------------------------------------------------
SceneDescription MakeManyActors(int actors)
{
  SceneDescription scene = MakeStage();
  const int row = static_cast<int>(std::ceil(std::sqrt(actors)));
  for (int i = 0; i < actors; ++i)
  {
    const double x = 2.0 * (i % row + 0.5) / row - 1.0;
    const double y = 2.0 * (i / row + 0.5) / row - 1.0;
    const double half = 0.35 / row;
    const double height = 0.2 + 0.6 * ((i * 7) % 10) / 10.0;
    scene.Objects.emplace_back();
    scene.Objects.back().Shape =
      BoxShape{ { { x - half, x + half, y - half, y + half, 0.1, height } } };
  }
  return scene;
}

//--------------------------------------------------------------------------------------------------
SceneDescription MakeManyTriangles(int triangles)
{
  SceneDescription scene = MakeStage();
  SphereShape sphere;
  sphere.Center = { { 0.0, 0.0, 0.8 } };
  sphere.Radius = 0.6;
  sphere.ThetaResolution = static_cast<int>(std::lround(std::sqrt(triangles)));
  sphere.PhiResolution = sphere.ThetaResolution / 2 + 2;
  scene.Objects.emplace_back();
  scene.Objects.back().Shape = sphere;
  return scene;
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
    size == PlanSize::Few ? AddFew(technique, plan) : AddMain(technique, plan);
  }
  for (const char* samples : Samples)
  {
    if (size != PlanSize::Few || samples == std::string("16"))
    {
      plan.Add("rays", { { "samples", samples } });
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
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".json")
    {
      files.push_back(entry.path());
    }
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
  const auto addGrowing = [&](const std::string& family, int count, SceneDescription (*make)(int))
  {
    scenes.push_back(MakeScene(family + std::to_string(count), make(count), models));
    scenes.back().Grows = true;
  };
  for (int count = 10; count <= 1000; count *= 10)
  {
    addGrowing("actors-", count, MakeManyActors);
  }
  for (int count = 1000; count <= 1000000; count *= 10)
  {
    addGrowing("triangles-", count, MakeManyTriangles);
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
BenchmarkScene MakeGridScene()
{
  SceneDescription grid = MakeStage();
  grid.Camera->Position = { { 0.0, -6.0, 1.5 } };
  grid.Camera->FocalPoint = { { 0.0, 0.0, 0.5 } };
  grid.Lights[0].Position = { { 0.0, 0.0, 30.0 } };
  grid.Lights[0].Size = { { 0.001, 0.001 } };
  grid.Lights[0].ConeAngle = 60.0;
  for (int i = -40; i <= 40; ++i)
  {
    const double at = 0.25 * i;
    for (const BoxShape& bar : { BoxShape{ { { at - 0.04, at + 0.04, -10.0, 10.0, 2.0, 2.02 } } },
           BoxShape{ { { -10.0, 10.0, at - 0.04, at + 0.04, 2.0, 2.02 } } } })
    {
      grid.Objects.emplace_back();
      grid.Objects.back().Shape = bar;
    }
  }
  BenchmarkScene scene = MakeScene("grid", grid, std::make_shared<ModelStore>());
  scene.Grows = true;
  return scene;
}

//--------------------------------------------------------------------------------------------------
double ShareOfTime(const std::vector<BenchmarkScene>& scenes, size_t next, double secondsLeft)
{
  double shares = 0.0;
  for (size_t i = next; i < scenes.size(); ++i)
  {
    shares += scenes[i].Grows ? 1.0 : 3.0;
  }
  return shares > 0.0 ? secondsLeft * (scenes[next].Grows ? 1.0 : 3.0) / shares : 0.0;
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
