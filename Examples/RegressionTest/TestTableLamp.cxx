// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// How a VTK image test uses the passes: a scene, vtkRegressionTestImage against a baseline, and, because
// VTK 9.1's comparison does not see a penumbra of the wrong width, the visibility where it is known.

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

constexpr double Tolerance = 0.06; // a step of the filter is 1 / 21

void AddActor(vtkRenderer* renderer, vtkAlgorithm* source, double red, double green, double blue)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  renderer->AddActor(actor);
}

// A floor and a table top of edge 2 at height 1 without legs.
void AddTable(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-5.0, -5.0, 0.0);
  floor->SetPoint1(5.0, -5.0, 0.0);
  floor->SetPoint2(-5.0, 5.0, 0.0);
  AddActor(renderer, floor, 0.9, 0.9, 0.85);
  vtkNew<vtkPlaneSource> top;
  top->SetOrigin(-1.0, -1.0, 1.0);
  top->SetPoint1(1.0, -1.0, 1.0);
  top->SetPoint2(-1.0, 1.0, 1.0);
  AddActor(renderer, top, 0.7, 0.5, 0.3);
}

// Compares the visibility on the floor at (x, 0) with what it must be.
bool Check(vtkRenderer* renderer, vtkImageData* visibility, double x, double expected)
{
  renderer->SetWorldPoint(x, 0.0, 0.0, 1.0);
  renderer->WorldToDisplay();
  const double* display = renderer->GetDisplayPoint();
  const double value = visibility->GetScalarComponentAsDouble(
    static_cast<int>(display[0]), static_cast<int>(display[1]), 0, 0);
  std::cout << "visibility at x = " << x << ": " << value << ", expected " << expected << '\n';
  return std::abs(value - expected) <= Tolerance; // false for NaN
}

} // namespace

int main(int argc, char* argv[])
{
  const bool hasShadows = argc < 2 || std::string(argv[argc - 1]) != "--no-shadows";

  vtkNew<vtkRenderer> renderer;
  AddTable(renderer);
  vtkNew<vtkAreaLight> lamp; // of edge 1, at height 4
  lamp->SetPosition(0.0, 0.0, 4.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(1.0, 1.0);
  renderer->AddLight(lamp);
  vtkNew<vtkPercentageCloserSoftShadowPass> shadows;
  if (hasShadows)
  {
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetOpaquePass(shadows);
    renderer->SetPass(steps);
  }

  // Nothing that differs between machines: a fixed size, no multisampling.
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -9.0, 3.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();

  const int result = vtkRegressionTestImage(window);
  if (result == vtkTesting::DO_INTERACTOR) // argument -I
  {
    interactor->Start();
  }
  bool good = result != vtkTesting::FAILED;
  if (hasShadows)
  {
    // The edge of the table at 1 throws its penumbra from 7/6 to 9/6.
    auto visibility = shadows->GetVisibilityImage(lamp);
    good = good && visibility;
    good = good && Check(renderer, visibility, 1.0, 0.0);
    good = good && Check(renderer, visibility, 4.0 / 3.0, 0.5);
    good = good && Check(renderer, visibility, 1.7, 1.0);
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
