// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneBuilder.h"

#include "CameraClipping.h"
#include "ModelFile.h"
#include "ShapeMesh.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowCasters.h"

#include <algorithm>

namespace softshadows
{
namespace
{

constexpr double AmbientPart = 0.15;
constexpr double Background[3] = { 0.90, 0.92, 0.95 };

vtkSmartPointer<vtkActor> BuildActor(
  const ObjectDescription& object, const std::string& sceneFolder, ModelStore& models)
{
  vtkNew<vtkPolyDataMapper> mapper;
  const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(object.Shape, sceneFolder, models);
  mapper->SetInputData(mesh);
  // The object's colour, not the file's, unless the file's are meant as the model's.
  mapper->ScalarVisibilityOff();
  if (!object.Color && mesh->GetPointData()->HasArray(ModelColors))
  {
    mapper->ScalarVisibilityOn();
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(ModelColors);
  }
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(object.Matrix.data());

  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  if (!matrix->IsIdentity())
  {
    actor->SetUserMatrix(matrix);
  }
  vtkProperty* property = actor->GetProperty();
  const Vector3 color = object.Color.value_or(Vector3{ { 1.0, 1.0, 1.0 } });
  property->SetColor(color[0], color[1], color[2]);
  property->SetAmbient(AmbientPart);
  property->SetDiffuse(1.0 - AmbientPart);
  if (!object.CastShadow)
  {
    vtkShadowCasters::SetCastsShadow(actor, false);
  }
  if (!object.ReceiveShadow)
  {
    vtkShadowCasters::SetReceivesShadow(actor, false);
  }
  return actor;
}

vtkSmartPointer<vtkCamera> BuildCamera(const CameraDescription& description)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(description.Position.data());
  camera->SetFocalPoint(description.FocalPoint.data());
  camera->SetViewUp(description.ViewUp.data());
  camera->SetViewAngle(description.ViewAngle);
  if (description.ParallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*description.ParallelScale);
  }
  return camera;
}

}

//--------------------------------------------------------------------------------------------------
void SetUpLight(const LightDescription& description, vtkAreaLight* light)
{
  constexpr double noCone = 90.0;
  light->SetLightTypeToSceneLight();
  light->SetPosition(description.Position.data());
  light->SetFocalPoint(description.FocalPoint.data());
  if (description.ViewUp)
  {
    light->SetViewUp(description.ViewUp->data());
  }
  switch (description.Shape)
  {
    case LightShape::Rectangle:
      light->SetShapeToRectangle();
      break;
    case LightShape::Disk:
      light->SetShapeToDisk();
      break;
    case LightShape::Point:
      light->SetShapeToPoint();
      break;
  }
  // A light has an angle or a size: both would contradict each other.
  light->SetAngularDiameter(description.Directional ? description.AngularDiameter : 0.0);
  light->SetPositional(!description.Directional);
  if (!description.Directional)
  {
    light->SetSize(description.Size.data());
  }
  light->SetConeAngle(std::min(description.ConeAngle, noCone));
  light->SetExponent(0.0); // as bright at the cone's edge as in its middle
  light->SetColor(description.Color[0], description.Color[1], description.Color[2]);
  light->SetIntensity(description.Intensity);
}

//--------------------------------------------------------------------------------------------------
BuiltScene BuildScene(const SceneDescription& scene, ModelStore& models)
{
  BuiltScene built;
  built.Renderer = vtkSmartPointer<vtkRenderer>::New();
  built.Renderer->SetBackground(Background[0], Background[1], Background[2]);
  built.Renderer->AutomaticLightCreationOff();
  built.Renderer->LightFollowCameraOff();
  for (const LightDescription& light : scene.Lights)
  {
    built.Lights.push_back(vtkSmartPointer<vtkAreaLight>::New());
    SetUpLight(light, built.Lights.back());
    built.Renderer->AddLight(built.Lights.back());
  }
  for (const ObjectDescription& object : scene.Objects)
  {
    built.Actors.push_back(BuildActor(object, scene.Folder, models));
    built.Renderer->AddActor(built.Actors.back());
  }
  if (scene.Camera)
  {
    built.Renderer->SetActiveCamera(BuildCamera(*scene.Camera));
  }
  else
  {
    built.Renderer->ResetCamera();
  }
  FitClippingRange(built.Renderer->GetActiveCamera(), built.Actors,
    static_cast<double>(scene.Width) / scene.Height);
  return built;
}

}
