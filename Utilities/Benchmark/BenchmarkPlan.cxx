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
/// Blocker search and filter, as published for separable soft shadow mapping.
constexpr const char* Kernels[][2] = { { "7", "15" }, { "11", "21" }, { "29", "41" } };

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
void AddTechnique(const KnownTechnique& technique, bool quick, Plan& plan)
{
  const auto add = [&](const TechniqueOptions& options)
  { plan.Add(technique.Name, With(technique, options)); };
  if (technique.Has("samples"))
  {
    for (const char* samples : Samples)
    {
      const bool isWanted = !quick || samples == std::string("1") || samples == std::string("16");
      if (isWanted)
      {
        add({ { "map_size", "1024" }, { "samples", samples } });
      }
    }
  }
  else if (quick)
  {
    add({ { "map_size", "1024" } });
  }
  if (quick)
  {
    return;
  }
  add({});
  add({ { "split", "2" } });
  for (const char* size : MapSizes)
  {
    add({ { "map_size", size } });
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
BenchmarkScene MakeScene(const std::string& name, const SceneDescription& description,
  const std::shared_ptr<ModelStore>& models, bool quick)
{
  BenchmarkScene scene;
  scene.Name = name;
  scene.Width = quick ? 320 : description.Width;
  scene.Height = quick ? 240 : description.Height;
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
  const std::vector<KnownTechnique>& techniques, bool quick)
{
  Plan plan;
  plan.Add("plain", {});
  plan.Add("vtk", { { "map_size", "1024" } });
  for (const char* samples : Samples)
  {
    if (!quick || samples == std::string("4") || samples == std::string("64"))
    {
      plan.Add("rays", { { "samples", samples } });
    }
  }
  for (const KnownTechnique& technique : techniques)
  {
    AddTechnique(technique, quick, plan);
  }
  return plan.Choices;
}

//--------------------------------------------------------------------------------------------------
std::vector<BenchmarkScene> PlanScenes(
  const std::string& folder, const std::vector<std::string>& modelFolders, bool quick)
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
      scenes.push_back(MakeScene(name, ReadScene(file.string()), models, quick));
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
    scenes.push_back(MakeScene(family + std::to_string(count), make(count), models, quick));
    scenes.back().Grows = true;
  };
  for (int count = 10; !quick && count <= 1000; count *= 10)
  {
    addGrowing("actors-", count, MakeManyActors);
  }
  for (int count = 1000; !quick && count <= 1000000; count *= 10)
  {
    addGrowing("triangles-", count, MakeManyTriangles);
  }
  return scenes;
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
