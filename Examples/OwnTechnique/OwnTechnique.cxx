// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A technique of one's own on the scene where it is exact: a square above a floor, parallel to the lamp.
// Draws it, and compares the visibility with the closed form along a line through the penumbra.

#include "vtkNearestBlockerSoftShadowPass.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

constexpr double Tolerance = 0.06; // a step of the filter is 1 / 21

// A horizontal square around (0, 0, height).
void AddSquare(vtkRenderer* renderer, double halfEdge, double height)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-halfEdge, -halfEdge, height);
  source->SetPoint1(halfEdge, -halfEdge, height);
  source->SetPoint2(-halfEdge, halfEdge, height);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

// The lamp, of edge 1 at height 4, spreads the edge of the square, at 1 and height 1, into a
// penumbra from 7/6 to 9/6 on the floor.
double ExactVisibility(double x)
{
  return std::min(std::max((x - 7.0 / 6.0) * 3.0, 0.0), 1.0);
}

bool IsExact(vtkRenderer* renderer, vtkImageData* visibility)
{
  double worst = 0.0;
  for (double x = 1.0; x < 1.7; x += 0.05)
  {
    renderer->SetWorldPoint(x, 0.0, 0.0, 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const double value = visibility->GetScalarComponentAsDouble(
      static_cast<int>(display[0]), static_cast<int>(display[1]), 0, 0);
    worst = std::max(worst, std::isnan(value) ? 1.0 : std::abs(value - ExactVisibility(x)));
  }
  std::cout << "largest error along the line: " << worst << '\n';
  return worst <= Tolerance;
}

// False if the file cannot be written.
bool Save(vtkRenderWindow* window, const char* file)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
  return writer->GetErrorCode() == 0;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkRenderer> renderer;
  AddSquare(renderer, 6.0, 0.0);
  AddSquare(renderer, 1.0, 1.0);

  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(0.0, 0.0, 4.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(1.0, 1.0);
  renderer->AddLight(lamp);

  vtkNew<vtkNearestBlockerSoftShadowPass> shadows;
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(shadows);
  renderer->SetPass(steps);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -8.0, 4.0);
  camera->SetFocalPoint(0.0, 0.3, 0.3);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();

  auto visibility = shadows->GetVisibilityImage(lamp);
  const bool good = visibility && IsExact(renderer, visibility);
  const bool saved = argc < 2 || Save(window, argv[1]);
  return good && saved ? EXIT_SUCCESS : EXIT_FAILURE;
}
