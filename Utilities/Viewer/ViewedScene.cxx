// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewedScene.h"

#include "CameraClipping.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
ViewedScene::ViewedScene(const ViewerState& state, ModelStore& models)
  : Built(BuildScene(state.GetScene(), models))
  , FirstCamera(GetCamera())
  , FirstAspect(static_cast<double>(state.GetScene().Width) / state.GetScene().Height)
{
  if (this->Built.Lights.empty())
  {
    // The pass finds visible points for its lights only; this one is for the depth.
    vtkNew<vtkAreaLight> dark;
    dark->SetPositional(0);
    dark->SetIntensity(0.0);
    this->Built.Renderer->AddLight(dark);
  }
  this->Built.Renderer->SetPass(this->Steps);
  this->Update(state, nullptr);
}

//--------------------------------------------------------------------------------------------------
ViewedScene::~ViewedScene() = default;

//--------------------------------------------------------------------------------------------------
void ViewedScene::Update(const ViewerState& state, vtkWindow* window)
{
  if (state.GetTechniquePlace() != this->TechniquePlace)
  {
    if (this->Pass && window)
    {
      this->Pass->ReleaseGraphicsResources(window);
    }
    this->TechniquePlace = state.GetTechniquePlace();
    this->Pass = state.GetTechnique().Create();
    this->Steps->SetOpaquePass(this->Pass);
  }
  state.Apply(this->Pass);
  // What replaces the visibility in a view shall not converge to a visibility.
  constexpr int pointsPerFrame = 16;
  this->Pass->SetProgressive(state.IsProgressive() && state.GetView().KeepsVisibility());
  this->Pass->SetProgressivePoints(pointsPerFrame);
  const std::vector<LightDescription>& lights = state.GetScene().Lights;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    SetUpLight(lights[i], this->Built.Lights[i]);
  }
}

//--------------------------------------------------------------------------------------------------
void ViewedScene::OpenView(double aspect)
{
  const double stretch = std::max(1.0, this->FirstAspect / aspect);
  CameraDescription& camera = this->FirstCamera;
  const double slope = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera.ViewAngle));
  camera.ViewAngle = 2.0 * vtkMath::DegreesFromRadians(std::atan(stretch * slope));
  if (camera.ParallelScale)
  {
    *camera.ParallelScale *= stretch;
  }
  this->ResetCamera();
}

//--------------------------------------------------------------------------------------------------
CameraDescription ViewedScene::GetCamera() const
{
  vtkCamera* camera = this->Built.Renderer->GetActiveCamera();
  CameraDescription description;
  camera->GetPosition(description.Position.data());
  camera->GetFocalPoint(description.FocalPoint.data());
  camera->GetViewUp(description.ViewUp.data());
  description.ViewAngle = camera->GetViewAngle();
  if (camera->GetParallelProjection())
  {
    description.ParallelScale = camera->GetParallelScale();
  }
  return description;
}

//--------------------------------------------------------------------------------------------------
void ViewedScene::ResetCamera()
{
  vtkCamera* camera = this->Built.Renderer->GetActiveCamera();
  camera->SetPosition(this->FirstCamera.Position.data());
  camera->SetFocalPoint(this->FirstCamera.FocalPoint.data());
  camera->SetViewUp(this->FirstCamera.ViewUp.data());
  camera->SetViewAngle(this->FirstCamera.ViewAngle);
  if (this->FirstCamera.ParallelScale)
  {
    camera->SetParallelScale(*this->FirstCamera.ParallelScale);
  }
}

//--------------------------------------------------------------------------------------------------
void ViewedScene::FitClipping(double aspect)
{
  FitClippingRange(this->Built.Renderer->GetActiveCamera(), this->Built.Actors, aspect);
}

//--------------------------------------------------------------------------------------------------
void ViewedScene::Release(vtkWindow* window)
{
  this->Built.Renderer->SetPass(nullptr);
  this->Pass->ReleaseGraphicsResources(window);
}

}
