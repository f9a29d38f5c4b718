// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Varieties.h"

#include "Props.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkLineSource.h"
#include "vtkMolecule.h"
#include "vtkNew.h"
#include "vtkOpenGLMoleculeMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace SoftShadowsTesting
{
namespace
{

using Props = std::vector<vtkSmartPointer<vtkProp>>;

// The small ball shades the large one: imposters receive what imposters cast.
const Point Centers[2] = { { { -0.2, 0.0, 0.6 } }, { { 0.25, -0.1, 1.3 } } };
const double Radii[2] = { 0.45, 0.25 };
const double StickRadius = 0.2;
const int Resolution = 128;

//------------------------------------------------------------------------------
/// Points with a vertex each: without cells VTK finds no bounds and culls the actor.
vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<Point>& places)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (const Point& place : places)
  {
    const vtkIdType id = points->InsertNextPoint(place.data());
    vertices->InsertNextCell({ id });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> ActorOf(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

//------------------------------------------------------------------------------
/// A tube with caps between the two centres.
vtkSmartPointer<vtkActor> MakeTube(double radius)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(Centers[0].data());
  line->SetPoint2(Centers[1].data());
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(Resolution);
  tube->CappingOn();
  return MakeActor(tube);
}

//------------------------------------------------------------------------------
Props FineBall()
{
  return { MakeSphereActor({ { 0.0, 0.0, 0.9 } }, 0.5, Resolution) };
}

//------------------------------------------------------------------------------
Props SphereImposter()
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(MakePoints({ { { 0.0, 0.0, 0.9 } } }));
  mapper->SetRadius(0.5);
  return { ActorOf(mapper) };
}

//------------------------------------------------------------------------------
Props FineBalls()
{
  return { MakeSphereActor(Centers[0], Radii[0], Resolution),
    MakeSphereActor(Centers[1], Radii[1], Resolution) };
}

//------------------------------------------------------------------------------
/// One mapper, a radius per sphere.
Props SphereImposters()
{
  const auto data = MakePoints({ Centers[0], Centers[1] });
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radii");
  radii->InsertNextValue(static_cast<float>(Radii[0]));
  radii->InsertNextValue(static_cast<float>(Radii[1]));
  data->GetPointData()->AddArray(radii);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray("Radii");
  return { ActorOf(mapper) };
}

//------------------------------------------------------------------------------
Props FineStick()
{
  return { MakeTube(StickRadius) };
}

//------------------------------------------------------------------------------
Props StickImposter()
{
  Point middle;
  float axis[3];
  double squared = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * (Centers[0][i] + Centers[1][i]);
    axis[i] = static_cast<float>(Centers[1][i] - Centers[0][i]);
    squared += axis[i] * axis[i];
  }
  const double length = std::sqrt(squared);
  vtkNew<vtkFloatArray> axes;
  axes->SetName("Axes");
  axes->SetNumberOfComponents(3);
  axes->InsertNextTuple3(axis[0] / length, axis[1] / length, axis[2] / length);
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("Sizes");
  sizes->SetNumberOfComponents(3);
  sizes->InsertNextTuple3(length, StickRadius, StickRadius);
  vtkNew<vtkUnsignedCharArray> colors; // the stick mapper reads them unasked
  colors->SetNumberOfComponents(3);
  colors->InsertNextTuple3(255, 255, 255);
  const auto data = MakePoints({ middle });
  data->GetPointData()->AddArray(axes);
  data->GetPointData()->AddArray(sizes);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetOrientationArray("Axes");
  mapper->SetScaleArray("Sizes");
  return { ActorOf(mapper) };
}

//------------------------------------------------------------------------------
Props BallsAndStick()
{
  return { MakeSphereActor(Centers[0], 0.3, Resolution),
    MakeSphereActor(Centers[1], 0.3, Resolution), MakeTube(0.1) };
}

//------------------------------------------------------------------------------
Props Molecule()
{
  vtkNew<vtkMolecule> molecule;
  for (const Point& center : Centers)
  {
    molecule->AppendAtom(6, center[0], center[1], center[2]);
  }
  molecule->AppendBond(0, 1, 1);
  vtkNew<vtkOpenGLMoleculeMapper> mapper;
  mapper->SetInputData(molecule);
  mapper->SetAtomicRadiusTypeToUnitRadius();
  mapper->SetAtomicRadiusScaleFactor(0.3f);
  mapper->SetBondRadius(0.1f);
  return { ActorOf(mapper) };
}

}

//------------------------------------------------------------------------------
std::vector<Variety> ImposterVarieties()
{
  return {
    { "SphereImposter", FineBall, SphereImposter, 0.03, 0.06 },
    { "SphereImposters", FineBalls, SphereImposters, 0.03, 0.06 },
    { "StickImposter", FineStick, StickImposter, 0.03, 0.06 },
    // VTK lays the bounds of a molecule 3 units around its atoms, and so lies the map.
    { "Molecule", BallsAndStick, Molecule, 0.05, 0.06, 2048 },
  };
}

}
