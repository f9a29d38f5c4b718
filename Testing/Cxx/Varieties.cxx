// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Varieties.h"

#include "Props.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkClipPolyData.h"
#include "vtkCubeSource.h"
#include "vtkElevationFilter.h"
#include "vtkImageData.h"
#include "vtkLODActor.h"
#include "vtkLODProp3D.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataTangents.h"
#include "vtkProperty.h"
#include "vtkQuadricLODActor.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <ostream>

namespace SoftShadowsTesting
{
namespace
{

using Props = std::vector<vtkSmartPointer<vtkProp>>;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSphereSource> MakeBall()
{
  auto ball = vtkSmartPointer<vtkSphereSource>::New();
  ball->SetCenter(0.0, 0.0, 0.9);
  ball->SetRadius(0.5);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  return ball;
}

//------------------------------------------------------------------------------
/// A sheet over the ground: x from -0.7 to right, y from -0.5 to 0.5.
vtkSmartPointer<vtkPlaneSource> MakeSheet(double right = 0.7)
{
  auto sheet = vtkSmartPointer<vtkPlaneSource>::New();
  sheet->SetOrigin(-0.7, -0.5, 0.8);
  sheet->SetPoint1(right, -0.5, 0.8);
  sheet->SetPoint2(-0.7, 0.5, 0.8);
  return sheet;
}

//------------------------------------------------------------------------------
Props PlainBall()
{
  return { MakeActor(MakeBall()) };
}

//------------------------------------------------------------------------------
Props PlainSheet()
{
  return { MakeActor(MakeSheet()) };
}

//------------------------------------------------------------------------------
/// The plain ball, changed.
PropFactory BallWith(const std::function<void(vtkActor*)>& change)
{
  return [change]() -> Props
  {
    const auto actor = MakeActor(MakeBall());
    change(actor);
    return { actor };
  };
}

//------------------------------------------------------------------------------
/// Two texels: the left one as given, the right one transparent if it is to be a hole.
vtkSmartPointer<vtkTexture> MakeTexture(const unsigned char color[3], bool hole)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, hole ? 4 : 3);
  for (int x = 0; x < 2; ++x)
  {
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(x, 0, 0));
    std::copy(color, color + 3, texel);
    if (hole)
    {
      texel[3] = x == 0 ? 255 : 0;
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOff();
  texture->RepeatOff();
  texture->EdgeClampOn();
  return texture;
}

//------------------------------------------------------------------------------
Props TexturedSheet()
{
  const unsigned char color[3] = { 200, 120, 80 };
  const auto actor = MakeActor(MakeSheet());
  actor->SetTexture(MakeTexture(color, false));
  return { actor };
}

//------------------------------------------------------------------------------
Props SheetWithHole()
{
  const unsigned char white[3] = { 255, 255, 255 };
  const auto actor = MakeActor(MakeSheet());
  actor->SetTexture(MakeTexture(white, true));
  return { actor };
}

//------------------------------------------------------------------------------
/// Physically based, with every texture that there is.
Props PhysicallyTexturedSheet()
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(MakeSheet()->GetOutputPort());
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tangents->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  const unsigned char color[3] = { 200, 120, 80 };
  const unsigned char material[3] = { 255, 120, 40 };
  const unsigned char normal[3] = { 128, 128, 255 };
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPBR();
  const auto base = MakeTexture(color, false);
  base->UseSRGBColorSpaceOn();
  property->SetBaseColorTexture(base);
  property->SetORMTexture(MakeTexture(material, false));
  property->SetNormalTexture(MakeTexture(normal, false));
  const auto emission = MakeTexture(material, false);
  emission->UseSRGBColorSpaceOn();
  property->SetEmissiveTexture(emission);
  property->SetAnisotropy(0.5);
  property->SetAnisotropyTexture(MakeTexture(material, false));
  property->SetCoatStrength(0.5);
  property->SetCoatNormalTexture(MakeTexture(normal, false));
  return { actor };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPlane> MakeCut()
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(0.0, 0.0, 0.8);
  plane->SetNormal(0.3, 0.2, -1.0);
  return plane;
}

//------------------------------------------------------------------------------
Props ClippedBall()
{
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputConnection(MakeBall()->GetOutputPort());
  clip->SetClipFunction(MakeCut());
  return { MakeActor(clip) };
}

//------------------------------------------------------------------------------
Props MapperClippedBall()
{
  const auto actor = MakeActor(MakeBall());
  actor->GetMapper()->AddClippingPlane(MakeCut());
  return { actor };
}

//------------------------------------------------------------------------------
Props ScalarBall()
{
  vtkNew<vtkElevationFilter> scalars;
  scalars->SetInputConnection(MakeBall()->GetOutputPort());
  scalars->SetLowPoint(0.0, 0.0, 0.4);
  scalars->SetHighPoint(0.0, 0.0, 1.4);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(scalars->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return { actor };
}

//------------------------------------------------------------------------------
/// A vertex shader that raises a lower ball to its place.
Props DisplacedBall()
{
  const auto ball = MakeBall();
  ball->SetCenter(0.0, 0.0, 0.5);
  const auto actor = MakeActor(ball);
  actor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
    "  vec4 raisedMC = vertexMC + vec4(0.0, 0.0, 0.4, 0.0);\n"
    "  vertexVCVSOutput = MCVCMatrix * raisedMC;\n"
    "  gl_Position = MCDCMatrix * raisedMC;\n",
    false);
  return { actor };
}

//------------------------------------------------------------------------------
Props LevelOfDetailActor()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(MakeBall()->GetOutputPort());
  auto actor = vtkSmartPointer<vtkLODActor>::New();
  actor->SetMapper(mapper);
  return { actor };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSphereSource> MakeCoarseBall()
{
  auto ball = MakeBall();
  ball->SetThetaResolution(6);
  ball->SetPhiResolution(5);
  return ball;
}

//------------------------------------------------------------------------------
Props CoarseBall()
{
  return { MakeActor(MakeCoarseBall()) };
}

//------------------------------------------------------------------------------
Props LevelOfDetailProp(bool fine)
{
  vtkNew<vtkPolyDataMapper> mappers[2];
  mappers[0]->SetInputConnection(MakeCoarseBall()->GetOutputPort());
  mappers[1]->SetInputConnection(MakeBall()->GetOutputPort());
  auto prop = vtkSmartPointer<vtkLODProp3D>::New();
  const int levels[2] = { prop->AddLOD(mappers[0], 0.0), prop->AddLOD(mappers[1], 0.0) };
  prop->AutomaticLODSelectionOff();
  prop->SetSelectedLODID(levels[fine ? 1 : 0]);
  return { prop };
}

//------------------------------------------------------------------------------
Props QuadricLevelOfDetailActor()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(MakeBall()->GetOutputPort());
  auto actor = vtkSmartPointer<vtkQuadricLODActor>::New();
  actor->SetMapper(mapper);
  return { actor };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTransform> MakeMirror()
{
  auto mirror = vtkSmartPointer<vtkTransform>::New();
  mirror->Translate(0.1, 0.0, 0.9);
  mirror->RotateWXYZ(35.0, 0.4, 0.3, 0.5);
  mirror->Scale(-1.3, 0.7, 0.5);
  return mirror;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCubeSource> MakeCube()
{
  auto cube = vtkSmartPointer<vtkCubeSource>::New();
  cube->SetXLength(0.9);
  return cube;
}

//------------------------------------------------------------------------------
Props TransformedCube()
{
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputConnection(MakeCube()->GetOutputPort());
  filter->SetTransform(MakeMirror());
  return { MakeActor(filter) };
}

//------------------------------------------------------------------------------
Props MirroredCube()
{
  const auto actor = MakeActor(MakeCube());
  actor->SetUserMatrix(MakeMirror()->GetMatrix());
  return { actor };
}

//------------------------------------------------------------------------------
Props NestedAssembly()
{
  const auto actor = MakeActor(MakeCube());
  vtkNew<vtkAssembly> inner;
  inner->AddPart(actor);
  inner->SetUserMatrix(MakeMirror()->GetMatrix());
  auto outer = vtkSmartPointer<vtkAssembly>::New();
  outer->AddPart(inner);
  return { outer };
}

//------------------------------------------------------------------------------
std::vector<Variety> PlainVarieties()
{
  return {
    { "Textured", PlainSheet, TexturedSheet },
    { "TextureWithHole", [] { return Props{ MakeActor(MakeSheet(0.0)) }; }, SheetWithHole, 0.02 },
    { "PhysicallyBasedTextures", PlainSheet, PhysicallyTexturedSheet },
    { "MapperClippingPlane", ClippedBall, MapperClippedBall, 0.02 },
    { "ScalarColors", PlainBall, ScalarBall },
    { "VertexShaderReplacement", PlainBall, DisplacedBall, 0.02 },
    { "LODActor", PlainBall, LevelOfDetailActor },
    { "LODProp", PlainBall, [] { return LevelOfDetailProp(true); }, 0.02 },
    { "LODPropCoarse", CoarseBall, [] { return LevelOfDetailProp(false); }, 0.02 },
    { "QuadricLODActor", PlainBall, QuadricLevelOfDetailActor },
    { "MirroringMatrix", TransformedCube, MirroredCube },
    { "NestedAssembly", TransformedCube, NestedAssembly },
    { "VisibleEdges", PlainBall,
      BallWith([](vtkActor* actor) { actor->GetProperty()->EdgeVisibilityOn(); }), 0.02, 0.05 },
    { "Flat", PlainBall,
      BallWith([](vtkActor* actor) { actor->GetProperty()->SetInterpolationToFlat(); }) },
    { "Ambient", PlainBall,
      BallWith([](vtkActor* actor) { actor->GetProperty()->SetAmbient(0.5); }) },
    { "BackfaceProperty", PlainBall,
      BallWith([](vtkActor* actor) { actor->SetBackfaceProperty(vtkNew<vtkProperty>()); }) },
  };
}

}

//------------------------------------------------------------------------------
const std::vector<Variety>& AllVarieties()
{
  static const std::vector<Variety> varieties = []
  {
    std::vector<Variety> all = PlainVarieties();
    for (const std::vector<Variety>& more : { ImposterVarieties(), NewMapperVarieties() })
    {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }();
  return varieties;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Variety& variety)
{
  return os << variety.Name;
}

}
