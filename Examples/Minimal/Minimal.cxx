// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A sphere on a plane under a square lamp: a lamp with a size and one pass make the penumbra.

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

void AddActor(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

void AddSphereOnPlane(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-10.0, -10.0, 0.0);
  plane->SetPoint1(10.0, -10.0, 0.0);
  plane->SetPoint2(-10.0, 10.0, 0.0);
  AddActor(renderer, plane);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.0, 0.0, 0.5);
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  AddActor(renderer, sphere);
}

// False if the file cannot be written.
bool Save(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

} // namespace

int main(int argc, char* argv[])
{
  const bool save = argc == 3 && std::string(argv[1]) == "-o";
  if (argc != 1 && !save)
  {
    std::cerr << "usage: Minimal [-o FILE.png]\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkRenderer> renderer;
  AddSphereOnPlane(renderer);

  vtkNew<vtkAreaLight> lamp; // a vtkLight with an extent
  lamp->SetPosition(3, 4, 5);
  lamp->SetFocalPoint(0, 0, 0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(1.0, 1.0); // world units
  renderer->AddLight(lamp);

  vtkNew<vtkPercentageCloserSoftShadowPass> shadows;
  vtkNew<vtkRenderStepsPass> steps; // VTK's own frame around it
  steps->SetOpaquePass(shadows);
  renderer->SetPass(steps);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(2.0, -5.0, 3.0);
  camera->SetFocalPoint(-0.2, -0.3, 0.2);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 480);
  window->SetWindowName("Minimal");
  window->SetOffScreenRendering(save);
  window->AddRenderer(renderer);
  if (save)
  {
    window->Render();
    return Save(window, argv[2]) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  window->Render();
  interactor->Start();
  return EXIT_SUCCESS;
}
