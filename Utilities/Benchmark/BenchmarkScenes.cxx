// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkScenes.h"

#include "SceneBuilder.h"

#include <cmath> // For rows of boxes

namespace softshadows
{
namespace
{

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
BenchmarkScene MakeGridScene()
{
  SceneDescription grid = MakeStage();
  grid.Camera->Position = { { 0.0, -6.0, 1.5 } };
  // The floor fills the picture: supersampling would also smooth the edges of what is beside it.
  grid.Camera->FocalPoint = { { 0.0, 0.0, -0.52 } };
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
std::vector<BenchmarkScene> MakeGrowingScenes()
{
  const auto models = std::make_shared<ModelStore>();
  std::vector<BenchmarkScene> scenes;
  const auto add = [&](const std::string& family, int count, SceneDescription (*make)(int))
  {
    scenes.push_back(MakeScene(family + std::to_string(count), make(count), models));
    scenes.back().Grows = true;
    scenes.back().Share = 1.0;
  };
  for (int count = 10; count <= 1000; count *= 10)
  {
    add("actors-", count, MakeManyActors);
  }
  for (int count = 1000; count <= 1000000; count *= 10)
  {
    add("triangles-", count, MakeManyTriangles);
  }
  return scenes;
}

}
