// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A cone and a sphere on a floor, lit from 64 points of a square lamp: the picture as an application sees it.
#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkSphereSource.h"

namespace
{

//------------------------------------------------------------------------------
void AddActor(vtkRenderer* renderer, vtkPolyDataAlgorithm* source, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  renderer->AddActor(actor);
}

}

//------------------------------------------------------------------------------
int TestSampledSoftShadowPass(int argc, char* argv[])
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.2, 0.3, 0.4);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-3.0, -3.0, 0.0);
  floor->SetPoint1(3.0, -3.0, 0.0);
  floor->SetPoint2(-3.0, 3.0, 0.0);
  AddActor(renderer, floor, 0.9, 0.9, 0.85);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(-0.6, 0.0, 0.8);
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  AddActor(renderer, sphere, 0.8, 0.4, 0.3);
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(0.7, 0.2, 0.5);
  cone->SetDirection(0.0, 0.0, 1.0);
  cone->SetRadius(0.4);
  cone->SetResolution(48);
  AddActor(renderer, cone, 0.3, 0.5, 0.8);

  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(2.0, -1.5, 4.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetConeAngle(60.0);
  lamp->SetSize(0.8, 0.8);
  renderer->AddLight(lamp);

  vtkNew<vtkSampledSoftShadowPass> shadows;
  shadows->SetMapSize(512);
  shadows->SetNumberOfSamples(64);
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(shadows);
  renderer->SetPass(steps);

  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(256, 192);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  renderer->GetActiveCamera()->SetPosition(0.5, -5.0, 3.5);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.3);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();

  const int result = vtkRegressionTestImage(window);
  if (result == vtkRegressionTester::DO_INTERACTOR)
  {
    interactor->Start();
  }
  return !result;
}
