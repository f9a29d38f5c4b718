// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkScenes.h"

#include "SceneBuilder.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkTubeFilter.h>

#include <memory> // For the models
#include <vector> // For tubes

namespace softshadows
{
namespace
{

constexpr int Rows = 25; // of as many units
constexpr double Spacing = 0.8;

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTube(
  const double from[3], const double to[3], double radius, int sides, int rings)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(from[0], from[1], from[2]);
  line->SetPoint2(to[0], to[1], to[2]);
  line->SetResolution(rings);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(sides);
  tube->CappingOn();
  vtkNew<vtkTriangleFilter> triangles; // from strips
  triangles->SetInputConnection(tube->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

//--------------------------------------------------------------------------------------------------
// A vessel between four posts, a wheel on top of it and a pipe to the next: 2720 triangles.
vtkSmartPointer<vtkPolyData> MakeUnit()
{
  vtkNew<vtkAppendPolyData> unit;
  vtkNew<vtkSphereSource> vessel;
  vessel->SetCenter(0.0, 0.0, 0.32);
  vessel->SetRadius(0.2);
  vessel->SetThetaResolution(24);
  vessel->SetPhiResolution(16);
  unit->AddInputConnection(vessel->GetOutputPort());
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(0.12);
  torus->SetCrossSectionRadius(0.012);
  vtkNew<vtkParametricFunctionSource> wheel;
  wheel->SetParametricFunction(torus);
  wheel->SetUResolution(40);
  wheel->SetVResolution(12);
  vtkNew<vtkTransform> up;
  up->Translate(0.0, 0.0, 0.62);
  vtkNew<vtkTransformPolyDataFilter> lifted;
  lifted->SetTransform(up);
  lifted->SetInputConnection(wheel->GetOutputPort());
  unit->AddInputConnection(lifted->GetOutputPort());
  std::vector<vtkSmartPointer<vtkPolyData>> tubes;
  for (int i = 0; i < 4; ++i)
  {
    const double x = i % 2 ? 0.22 : -0.22;
    const double y = i / 2 ? 0.22 : -0.22;
    const double from[3] = { x, y, 0.0 };
    const double to[3] = { x, y, 0.5 };
    tubes.push_back(MakeTube(from, to, 0.015, 12, 4));
  }
  const double stem[3] = { 0.0, 0.0, 0.5 };
  const double top[3] = { 0.0, 0.0, 0.62 };
  tubes.push_back(MakeTube(stem, top, 0.01, 10, 2));
  const double left[3] = { -0.5 * Spacing, 0.1, 0.72 };
  const double right[3] = { 0.5 * Spacing, 0.1, 0.72 };
  tubes.push_back(MakeTube(left, right, 0.025, 16, 8));
  const double front[3] = { 0.1, -0.5 * Spacing, 0.78 };
  const double back[3] = { 0.1, 0.5 * Spacing, 0.78 };
  tubes.push_back(MakeTube(front, back, 0.02, 16, 8));
  for (const auto& tube : tubes)
  {
    unit->AddInputData(tube);
  }
  unit->Update();
  return unit->GetOutput();
}

//--------------------------------------------------------------------------------------------------
SceneDescription DescribeHall()
{
  SceneDescription hall;
  hall.Camera = CameraDescription();
  hall.Camera->Position = { { 0.4, -9.0, 1.6 } };
  hall.Camera->FocalPoint = { { 0.0, -5.0, 0.3 } };
  hall.Camera->ViewUp = { { 0.0, 0.0, 1.0 } };
  LightDescription light;
  light.Position = { { 5.0, 3.0, 12.0 } };
  light.Size = { { 0.5, 0.5 } };
  light.ConeAngle = 70.0;
  hall.Lights.push_back(light);
  PlaneShape floor;
  floor.Origin = { { -20.0, -20.0, 0.0 } };
  floor.Point1 = { { 20.0, -20.0, 0.0 } };
  floor.Point2 = { { -20.0, 20.0, 0.0 } };
  hall.Objects.emplace_back();
  hall.Objects.back().Shape = floor;
  return hall;
}

}

//--------------------------------------------------------------------------------------------------
BenchmarkScene MakePlantScene()
{
  BenchmarkScene scene;
  scene.Name = "plant";
  const auto models = std::make_shared<ModelStore>();
  scene.Make = [models]
  {
    vtkSmartPointer<vtkRenderer> renderer = BuildScene(DescribeHall(), *models).Renderer;
    const vtkSmartPointer<vtkPolyData> unit = MakeUnit();
    for (int i = 0; i < Rows * Rows; ++i)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(unit);
      mapper->ScalarVisibilityOff();
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetPosition(Spacing * (i % Rows - Rows / 2), Spacing * (i / Rows - Rows / 2), 0.0);
      renderer->AddActor(actor);
    }
    return renderer;
  };
  scene.Grows = true;
  return scene;
}

}
