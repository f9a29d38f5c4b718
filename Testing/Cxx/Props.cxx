// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Props.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkVersionMacros.h"

#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 3)
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

namespace SoftShadowsTesting
{
namespace
{

//------------------------------------------------------------------------------
void MakeMatte(vtkProperty* property)
{
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeMatteActor(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  MakeMatte(actor->GetProperty());
  return actor;
}

//------------------------------------------------------------------------------
/// The quad's halves as two blocks.
vtkSmartPointer<vtkActor> MakeCompositeActor(const Quad& quad)
{
  Quad halves[2] = { quad, quad };
  for (int c = 0; c < 3; ++c)
  {
    halves[0].Edge1[c] *= 0.5;
    halves[1].Edge1[c] *= 0.5;
    halves[1].Origin[c] += halves[0].Edge1[c];
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeQuads({ halves[0] }));
  blocks->SetBlock(1, MakeQuads({ halves[1] }));
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  return MakeMatteActor(mapper);
}

//------------------------------------------------------------------------------
/// The quad, moved to the origin, as the glyph of one point.
vtkSmartPointer<vtkActor> MakeGlyphActor(const Quad& quad)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(quad.Origin.data());
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  const Quad glyph = { { { 0.0, 0.0, 0.0 } }, quad.Edge1, quad.Edge2 };
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceData(MakeQuads({ glyph }));
  mapper->ScalingOff();
  mapper->OrientOff();
  return MakeMatteActor(mapper);
}

//------------------------------------------------------------------------------
void SetUpProperty(Drawing way, vtkProperty* property)
{
  switch (way)
  {
    case Drawing::Specular:
      property->SetColor(0.9, 0.6, 0.4);
      property->SetSpecular(0.5);
      property->SetSpecularPower(5.0);
      break;
    case Drawing::Gouraud:
      property->SetInterpolationToGouraud();
      break;
    case Drawing::PhysicallyBased:
      property->SetInterpolationToPBR();
      property->SetMetallic(0.2);
      property->SetRoughness(0.6);
      break;
    default:
      break;
  }
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeActor(vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  return MakeMatteActor(mapper);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeSphereActor(const Point& center, double radius, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(center[0], center[1], center[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  return MakeActor(source);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeBoxActor(const std::array<double, 6>& bounds)
{
  return MakeQuadActor(BoxQuads(bounds));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeGroundActor(double halfSize, double height)
{
  const Quad ground = { { { -halfSize, -halfSize, height } }, { { 2.0 * halfSize, 0.0, 0.0 } },
    { { 0.0, 2.0 * halfSize, 0.0 } } };
  return MakeQuadActor({ ground });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakeRenderer(const Point& from, const Point& to, double viewAngle)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->AutomaticLightCreationOff();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(from.data());
  camera->SetFocalPoint(to.data());
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(viewAngle);
  return renderer;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAreaLight> MakeLamp(const Point& position, const Point& focalPoint, double size)
{
  auto lamp = vtkSmartPointer<vtkAreaLight>::New();
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(position.data());
  lamp->SetFocalPoint(focalPoint.data());
  lamp->SetShapeToDisk();
  lamp->SetSize(size, size);
  return lamp;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAreaLight> MakeSun(const Point& toSun, double degrees)
{
  auto sun = vtkSmartPointer<vtkAreaLight>::New();
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(toSun.data());
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->PositionalOff();
  sun->SetAngularDiameter(degrees);
  return sun;
}

//------------------------------------------------------------------------------
const std::vector<NamedDrawing>& AllDrawings()
{
  static const std::vector<NamedDrawing> drawings = { { "Plain", Drawing::Plain },
    { "Specular", Drawing::Specular }, { "Gouraud", Drawing::Gouraud },
    { "PhysicallyBased", Drawing::PhysicallyBased }, { "Composite", Drawing::Composite },
    { "Glyph", Drawing::Glyph }, { "Assembly", Drawing::Assembly } };
  return drawings;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkProp> MakeReceiver(Drawing way, const Quad& quad)
{
  if (way == Drawing::Composite)
  {
    return MakeCompositeActor(quad);
  }
  if (way == Drawing::Glyph)
  {
    return MakeGlyphActor(quad);
  }
  auto actor = MakeQuadActor({ quad });
  SetUpProperty(way, actor->GetProperty());
  if (way == Drawing::Assembly)
  {
    auto assembly = vtkSmartPointer<vtkAssembly>::New();
    actor->AddPosition(0.0, 0.0, -1.0);
    assembly->AddPart(actor);
    assembly->AddPosition(0.0, 0.0, 1.0);
    return assembly;
  }
  return actor;
}

//------------------------------------------------------------------------------
BallScene MakeBallScene(double lampSize)
{
  BallScene scene;
  scene.Renderer = MakeRenderer({ { 0.0, -5.0, 4.0 } }, { { 0.0, 0.0, 0.2 } });
  scene.Lamp = MakeLamp({ { 1.5, 1.0, 4.0 } }, { { 0.0, 0.0, 0.0 } }, lampSize);
  scene.Renderer->AddLight(scene.Lamp);
  scene.Ground = MakeGroundActor(6.0);
  scene.Renderer->AddActor(scene.Ground);
  scene.Ball = MakeSphereActor({ { 0.0, 0.0, 0.9 } }, 0.5);
  scene.Renderer->AddActor(scene.Ball);
  scene.Renderer->ResetCameraClippingRange();
  return scene;
}

}
