// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A square above a ground plane, lit by a square lamp above both and seen from the side. Beside the
// square the ground is lit, below it is the umbra, and between the two there must be a penumbra.

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <iostream>

namespace
{
constexpr int Width = 320;
constexpr int Height = 240;

/// A horizontal square around (0, 0, height).
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
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetSpecular(0.0);
  renderer->AddActor(actor);
}

/// Red of the pixel that shows a point of the ground, 0 to 255.
int GroundBrightness(vtkRenderWindow* window, vtkRenderer* renderer, double x, double y)
{
  renderer->SetWorldPoint(x, y, 0.0, 1.0);
  renderer->WorldToDisplay();
  const double* display = renderer->GetDisplayPoint();
  const int column = static_cast<int>(display[0]);
  const int row = static_cast<int>(display[1]);
  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(column, row, column, row, 0, pixel);
  return pixel->GetValue(0);
}
}

int main()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  window->AddRenderer(renderer);

  AddSquare(renderer, 4.0, 0.0);
  AddSquare(renderer, 0.5, 1.0);

  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(0.0, 0.0, 4.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(1.0, 1.0);
  renderer->SetAutomaticLightCreation(0);
  renderer->AddLight(lamp);

  vtkNew<vtkPercentageCloserSoftShadowPass> shadows;
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(shadows);
  renderer->SetPass(steps);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -9.0, 3.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();

  // On the ground the square's edge, at 0.5, has its penumbra from 0.5 to 5/6 = 0.83.
  const int umbra = GroundBrightness(window, renderer, 0.2, 0.0);
  const int penumbra = GroundBrightness(window, renderer, 0.667, 0.0);
  const int lit = GroundBrightness(window, renderer, 1.3, 0.0);
  std::cout << "umbra " << umbra << ", penumbra " << penumbra << ", lit " << lit << '\n';
  const bool good = umbra < 8 && lit > 150 && penumbra > lit / 4 && penumbra < 3 * lit / 4;
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
