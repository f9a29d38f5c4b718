// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A bearing block as an assembly of parts, cut open by a section plane, with soft contact shadows. The
// plane clips the housing in its mapper: what is cut away casts no shadow, so light falls into the
// bearing.

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkContourTriangulator.h"
#include "vtkCubeSource.h"
#include "vtkCutter.h"
#include "vtkCylinderSource.h"
#include "vtkDiskSource.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLinearExtrusionFilter.h"
#include "vtkMarchedSoftShadowPass.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

// The shaft lies along x at this height.
constexpr double AxisHeight = 1.25;

// The assembly and what the section plane cuts.
struct Model
{
  vtkNew<vtkAssembly> Parts;
  vtkSmartPointer<vtkPolyDataMapper> Housing;
  vtkSmartPointer<vtkActor> Face; // of the cut
  vtkNew<vtkPlane> Section;

  void SetSection(bool on)
  {
    this->Housing->RemoveAllClippingPlanes();
    if (on)
    {
      this->Housing->AddClippingPlane(this->Section);
    }
    this->Face->SetVisibility(on);
  }
};

vtkSmartPointer<vtkActor> AddPart(
  vtkAssembly* assembly, vtkAlgorithm* source, const double color[3], double gloss)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto part = vtkSmartPointer<vtkActor>::New();
  part->SetMapper(mapper);
  vtkProperty* property = part->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetAmbient(0.25); // shadows are not black
  property->SetDiffuse(0.75);
  property->SetSpecular(gloss);
  property->SetSpecularPower(40.0);
  assembly->AddPart(part);
  return part;
}

void AddBox(vtkAssembly* assembly, double x0, double x1, double y0, double y1, double z0, double z1,
  const double color[3])
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(x0, x1, y0, y1, z0, z1);
  AddPart(assembly, box, color, 0.1);
}

// A cylinder along x, or along z.
void AddCylinder(vtkAssembly* assembly, const double center[3], double radius, double length,
  int sides, bool upright, const double color[3])
{
  vtkNew<vtkCylinderSource> cylinder; // along y
  cylinder->SetRadius(radius);
  cylinder->SetHeight(length);
  cylinder->SetResolution(sides);
  vtkActor* part = AddPart(assembly, cylinder, color, 0.5);
  part->SetPosition(center[0], center[1], center[2]);
  part->SetOrientation(upright ? 90.0 : 0.0, 0.0, upright ? 0.0 : 90.0);
}

// A thick-walled tube around the shaft, in world coordinates.
vtkSmartPointer<vtkAlgorithm> MakeHousing()
{
  vtkNew<vtkDiskSource> ring;
  ring->SetInnerRadius(0.72);
  ring->SetOuterRadius(0.95);
  ring->SetCircumferentialResolution(96);
  vtkNew<vtkLinearExtrusionFilter> tube;
  tube->SetInputConnection(ring->GetOutputPort());
  tube->SetExtrusionTypeToVectorExtrusion();
  tube->SetVector(0.0, 0.0, 1.8);
  vtkNew<vtkPolyDataNormals> smooth;
  smooth->SetInputConnection(tube->GetOutputPort());
  smooth->SetFeatureAngle(30.0);
  vtkNew<vtkTransform> place;
  place->Translate(-0.9, 0.0, AxisHeight);
  place->RotateY(90.0);
  auto placed = vtkSmartPointer<vtkTransformPolyDataFilter>::New();
  placed->SetInputConnection(smooth->GetOutputPort());
  placed->SetTransform(place);
  return placed;
}

// The housing and the face that the section lays bare: clipping a surface leaves it hollow.
void AddHousing(Model& model)
{
  const double paint[3] = { 0.25, 0.42, 0.62 };
  const double bare[3] = { 0.8, 0.35, 0.2 };
  auto housing = MakeHousing();
  model.Housing =
    vtkPolyDataMapper::SafeDownCast(AddPart(model.Parts, housing, paint, 0.2)->GetMapper());
  // Keeps what lies behind the shaft's axis, seen from the camera: n . (p - o) >= 0.
  model.Section->SetOrigin(0.0, 0.0, AxisHeight);
  model.Section->SetNormal(0.0, 1.0, 0.0);
  vtkNew<vtkCutter> cut;
  cut->SetInputConnection(housing->GetOutputPort());
  cut->SetCutFunction(model.Section);
  vtkNew<vtkContourTriangulator> face;
  face->SetInputConnection(cut->GetOutputPort());
  model.Face = AddPart(model.Parts, face, bare, 0.0);
  model.Face->GetProperty()->SetInterpolationToFlat(); // its normals are still the housing's
}

void AddBalls(vtkAssembly* assembly, double x)
{
  const double color[3] = { 0.8, 0.8, 0.82 };
  constexpr int balls = 12;
  for (int i = 0; i < balls; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / balls;
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(0.13);
    ball->SetCenter(x, 0.58 * std::cos(angle), AxisHeight + 0.58 * std::sin(angle));
    ball->SetThetaResolution(32);
    ball->SetPhiResolution(32);
    AddPart(assembly, ball, color, 0.6);
  }
}

void Build(Model& model)
{
  const double iron[3] = { 0.45, 0.47, 0.5 };
  const double steel[3] = { 0.75, 0.75, 0.78 };
  const double brass[3] = { 0.85, 0.68, 0.3 };
  AddBox(model.Parts, -1.6, 1.6, -1.2, 1.2, 0.0, 0.2, iron);
  AddBox(model.Parts, -0.7, 0.7, -0.55, 0.55, 0.2, 0.42, iron);
  const double middle[3] = { 0.0, 0.0, AxisHeight };
  AddCylinder(model.Parts, middle, 0.45, 4.0, 64, false, steel);
  AddBalls(model.Parts, -0.5);
  AddBalls(model.Parts, 0.5);
  for (int i = 0; i < 4; ++i)
  {
    const double bolt[3] = { i % 2 == 0 ? -1.3 : 1.3, i < 2 ? -0.9 : 0.9, 0.27 };
    AddCylinder(model.Parts, bolt, 0.16, 0.14, 6, true, brass);
  }
  AddHousing(model);
}

void AddGround(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-20.0, -20.0, 0.0);
  ground->SetPoint1(20.0, -20.0, 0.0);
  ground->SetPoint2(-20.0, 20.0, 0.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ground->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.9, 0.88);
  actor->GetProperty()->SetAmbient(0.2);
  actor->GetProperty()->SetDiffuse(0.8);
  renderer->AddActor(actor);
}

// A wide lamp above.
void AddLamp(vtkRenderer* renderer)
{
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(-2.0, -3.5, 6.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.5);
  lamp->SetShapeToRectangle();
  lamp->SetSize(2.0, 2.0);
  renderer->AddLight(lamp);
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

// Key x switches the section plane.
void OnKey(vtkObject* caller, unsigned long, void* data, void*)
{
  auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  auto* model = static_cast<Model*>(data);
  if (std::string(interactor->GetKeySym()) == "x")
  {
    model->SetSection(!model->Face->GetVisibility());
    interactor->Render();
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const bool save = argc >= 3 && std::string(argv[1]) == "-o";
  const bool whole = argc == 4 && std::string(argv[3]) == "--whole";
  if (argc != 1 && !(save && (argc == 3 || whole)))
  {
    std::cerr << "usage: CADViewer [-o FILE.png [--whole]]\n";
    return EXIT_FAILURE;
  }
  Model model;
  Build(model);
  model.SetSection(!whole);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.9, 0.92, 0.95);
  renderer->AddActor(model.Parts);
  AddGround(renderer);
  AddLamp(renderer);

  vtkNew<vtkMarchedSoftShadowPass> shadows;
  shadows->SetSplit(2); // four maps: parts that touch each other at many depths
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(shadows);
  renderer->SetPass(steps);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(-2.6, -6.2, 4.0);
  camera->SetFocalPoint(0.0, 0.0, 0.75);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 480);
  window->SetWindowName("CADViewer");
  window->SetOffScreenRendering(save);
  window->AddRenderer(renderer);
  if (save)
  {
    window->Render();
    return Save(window, argv[2]) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  vtkNew<vtkCallbackCommand> onKey;
  onKey->SetCallback(OnKey);
  onKey->SetClientData(&model);
  interactor->AddObserver("KeyPressEvent", onKey);
  window->Render();
  interactor->Start();
  return EXIT_SUCCESS;
}
