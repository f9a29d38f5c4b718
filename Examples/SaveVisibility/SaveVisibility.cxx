// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// How much of a floor lies in the shadow of a canopy, in square units: visibility as a result, not
// as a picture.
//
// Every point of the lamp throws a hard shadow of the canopy on the floor. Lamp, canopy and floor are
// parallel, so each of these shadows is the canopy scaled by H / (H - h), H the height of the lamp and
// h that of the canopy, and moved; the integral of 1 - visibility over the floor is their mean area,
// (H / (H - h))^2 times the canopy's, whatever its outline. The program checks itself against that.

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkShadowCasters.h"
#include "vtkSmartPointer.h"
#include "vtkTIFFWriter.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

constexpr double LampHeight = 4.0;
constexpr double CanopyHeight = 1.0;
constexpr double CanopyRadius = 0.7;
constexpr int CanopyCorners = 6;
constexpr double ViewAngle = 60.0;    // of the camera from the vertical, degrees
constexpr double ParallelScale = 1.6; // half the height of the view, world units
constexpr int Width = 800;
constexpr int Height = 480;
constexpr double Tolerance = 0.01; // of the shadowed area

vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

void AddFloorAndCanopy(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-4.0, -4.0, 0.0);
  floor->SetPoint1(4.0, -4.0, 0.0);
  floor->SetPoint2(-4.0, 4.0, 0.0);
  AddActor(renderer, floor);

  vtkNew<vtkRegularPolygonSource> canopy;
  canopy->SetNumberOfSides(CanopyCorners);
  canopy->SetRadius(CanopyRadius);
  canopy->SetCenter(0.0, 0.0, CanopyHeight);
  canopy->SetNormal(0.0, 0.0, 1.0);
  canopy->GeneratePolylineOff();
  // Only the floor is measured: pixels that show the canopy have no visibility (NaN).
  vtkShadowCasters::SetReceivesShadow(AddActor(renderer, canopy), false);
}

// Looks past the canopy, so that it hides nothing of its shadow. In a parallel view every pixel shows
// the same area of the floor.
void PlaceCamera(vtkRenderer* renderer)
{
  const double angle = vtkMath::RadiansFromDegrees(ViewAngle);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(ParallelScale);
  camera->SetPosition(0.0, -8.0 * std::sin(angle), 8.0 * std::cos(angle));
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}

struct Areas
{
  double Shadowed = 0.0; // each point counts with the share of the lamp that it does not see
  double Umbra = 0.0;
  double Penumbra = 0.0;
};

Areas Measure(vtkImageData* visibility)
{
  const double edge = 2.0 * ParallelScale / Height;
  const double pixel = edge * edge / std::cos(vtkMath::RadiansFromDegrees(ViewAngle));
  const auto* values = static_cast<const float*>(visibility->GetScalarPointer());
  Areas areas;
  for (vtkIdType i = 0; i < visibility->GetNumberOfPoints(); ++i)
  {
    const double value = values[i];
    if (std::isnan(value))
    {
      continue;
    }
    areas.Shadowed += pixel * (1.0 - value);
    areas.Umbra += value <= 0.0 ? pixel : 0.0;
    areas.Penumbra += value > 0.0 && value < 1.0 ? pixel : 0.0;
  }
  return areas;
}

double ExactShadowedArea()
{
  const double canopy = 0.5 * CanopyCorners * CanopyRadius * CanopyRadius *
    std::sin(2.0 * vtkMath::Pi() / CanopyCorners);
  const double scale = LampHeight / (LampHeight - CanopyHeight);
  return canopy * scale * scale;
}

// FILE.tif with the floats, FILE.png to look at. False if one cannot be written.
bool Save(vtkImageData* visibility, const std::string& file)
{
  vtkNew<vtkTIFFWriter> floats;
  floats->SetInputData(visibility);
  floats->SetFileName((file + ".tif").c_str());
  floats->Write();

  vtkNew<vtkImageShiftScale> gray;
  gray->SetInputData(visibility);
  gray->SetScale(255.0);
  gray->SetOutputScalarTypeToUnsignedChar();
  gray->ClampOverflowOn();
  vtkNew<vtkPNGWriter> picture;
  picture->SetInputConnection(gray->GetOutputPort());
  picture->SetFileName((file + ".png").c_str());
  picture->Write();
  return floats->GetErrorCode() == 0 && picture->GetErrorCode() == 0;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc > 2)
  {
    std::cerr << "usage: SaveVisibility [FILE]    writes FILE.tif and FILE.png\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkRenderer> renderer;
  AddFloorAndCanopy(renderer);

  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(0.0, 0.0, LampHeight);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetShapeToRectangle();
  lamp->SetSize(1.0, 1.0);
  renderer->AddLight(lamp);

  vtkNew<vtkSampledSoftShadowPass> shadows; // converges to the truth
  shadows->SetNumberOfSamples(64);
  shadows->SetMapSize(1024);
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(shadows);
  renderer->SetPass(steps);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  window->AddRenderer(renderer);
  PlaceCamera(renderer);
  window->Render();

  auto visibility = shadows->GetVisibilityImage(lamp);
  if (!visibility || !Save(visibility, argc == 2 ? argv[1] : "visibility"))
  {
    return EXIT_FAILURE;
  }
  const Areas areas = Measure(visibility);
  const double exact = ExactShadowedArea();
  const double error = std::abs(areas.Shadowed / exact - 1.0);
  std::cout << "shadowed " << areas.Shadowed << " square units, exactly " << exact << ", "
            << 100.0 * error << " % off\n"
            << "umbra " << areas.Umbra << ", penumbra " << areas.Penumbra << '\n';
  return error < Tolerance ? EXIT_SUCCESS : EXIT_FAILURE;
}
