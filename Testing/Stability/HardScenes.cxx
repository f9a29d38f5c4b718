// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HardScenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

namespace SoftShadowsTesting
{
namespace
{

//------------------------------------------------------------------------------
void PlaceCamera(vtkRenderer* renderer, const Placement& placement)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(placement.ToWorld({ { 0.0, -5.0, 4.0 } }).data());
  camera->SetFocalPoint(placement.ToWorld({ { -0.1, 0.0, 0.1 } }).data());
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeMesh(vtkPolyDataAlgorithm* source, const Placement& placement)
{
  source->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(source->GetOutput());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Point p;
    mesh->GetPoint(i, p.data());
    points->InsertNextPoint(placement.ToWorld(p).data());
  }
  mesh->SetPoints(points);
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeMeshActor(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetDiffuse(1.0);
  actor->GetProperty()->SetSpecular(0.0);
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSphere(
  const Point& center, double radius, int resolution, const Placement& placement)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetCenter(center[0], center[1], center[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  return MakeMesh(source, placement);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTriangles(const std::vector<Point>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    cells->InsertNextCell(3);
    for (std::size_t k = 0; k < 3; ++k)
    {
      cells->InsertCellPoint(points->InsertNextPoint(corners[i + k].data()));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

//------------------------------------------------------------------------------
BasicScene MakeGroundScene()
{
  BasicScene scene;
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();
  scene.Renderer->AutomaticLightCreationOff();
  scene.Ground = MakeGroundActor(6.0);
  scene.Renderer->AddActor(scene.Ground);
  scene.Lamp = MakeLamp({ { 1.2, 0.8, 4.0 } }, { { -0.2, 0.0, 0.2 } }, 0.4);
  scene.Renderer->AddLight(scene.Lamp);
  scene.Light = scene.Lamp;
  PlaceCamera(scene.Renderer, Placement());
  return scene;
}

//------------------------------------------------------------------------------
BasicScene MakeBasicScene(const Placement& placement)
{
  BasicScene scene;
  scene.Renderer = vtkSmartPointer<vtkRenderer>::New();
  scene.Renderer->AutomaticLightCreationOff();
  scene.Ground = MakeQuadActor(
    { { { { -6.0, -6.0, 0.0 } }, { { 12.0, 0.0, 0.0 } }, { { 0.0, 12.0, 0.0 } } } }, placement);
  scene.Ball = MakeMeshActor(MakeSphere({ { -0.6, -0.1, 0.7 } }, 0.4, 24, placement));
  scene.Box = MakeQuadActor(BoxQuads({ { 0.3, 0.7, -0.4, 0.2, 0.0, 0.5 } }), placement);
  for (vtkActor* actor : { scene.Ground.Get(), scene.Ball.Get(), scene.Box.Get() })
  {
    scene.Renderer->AddActor(actor);
  }
  scene.Lamp = MakeLamp(placement.ToWorld({ { 1.2, 0.8, 4.0 } }),
    placement.ToWorld({ { -0.2, 0.0, 0.2 } }), 0.4 * placement.Scale);
  scene.Renderer->AddLight(scene.Lamp);
  scene.Light = scene.Lamp;
  PlaceCamera(scene.Renderer, placement);
  scene.Renderer->ResetCameraClippingRange();
  return scene;
}

}
