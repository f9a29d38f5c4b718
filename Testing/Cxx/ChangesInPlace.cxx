// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChangesInPlace.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIdList.h"
#include "vtkLODProp3D.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
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

#include <ostream>

namespace SoftShadowsTesting
{
namespace
{

using Change = std::function<void()>;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSphereSource> MakeBall(double radius = 0.5, double x = 0.0)
{
  auto ball = vtkSmartPointer<vtkSphereSource>::New();
  ball->SetCenter(x, 0.0, 0.9);
  ball->SetRadius(radius);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  return ball;
}

//------------------------------------------------------------------------------
/// The ball's data, without a pipeline that could make it anew.
vtkSmartPointer<vtkPolyData> MakeBallData(double x = 0.0)
{
  const auto ball = MakeBall(0.5, x);
  ball->Update();
  return ball->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> Add(BallScene& scene, vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> AddData(BallScene& scene, vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  return Add(scene, mapper);
}

//------------------------------------------------------------------------------
/// A ball cut by a plane of its mapper.
template <typename Functor>
SceneChange OfPlane(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    const auto actor = AddData(scene, MakeBallData());
    auto plane = vtkSmartPointer<vtkPlane>::New();
    plane->SetOrigin(0.0, 0.0, 0.9);
    plane->SetNormal(-1.0, 0.0, 0.2);
    actor->GetMapper()->AddClippingPlane(plane);
    return [=] { change(actor->GetMapper(), plane.Get()); };
  };
}

//------------------------------------------------------------------------------
template <typename Functor>
SceneChange OfData(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    const auto data = MakeBallData();
    AddData(scene, data);
    return [=] { change(data.Get()); };
  };
}

//------------------------------------------------------------------------------
void RaisePoints(vtkPolyData* data)
{
  vtkPoints* points = data->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double* p = points->GetPoint(i);
    points->GetData()->SetTuple3(i, p[0] + 0.4, p[1], p[2]);
  }
}

//------------------------------------------------------------------------------
/// Triangles of one side become those of the other, so that half of the ball is gone.
void FoldCells(vtkPolyData* data)
{
  vtkCellArray* cells = data->GetPolys();
  vtkNew<vtkIdList> ids;
  const vtkIdType count = cells->GetNumberOfCells();
  for (vtkIdType i = 0; i < count / 2; ++i)
  {
    cells->GetCellAtId(count - 1 - i, ids);
    cells->ReplaceCellAtId(i, ids);
  }
  cells->Modified();
}

//------------------------------------------------------------------------------
/// Two glyphs of one shape, scaled by an array.
template <typename Functor>
SceneChange OfGlyphs(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-0.4, 0.0, 0.0);
    points->InsertNextPoint(0.4, 0.0, 0.0);
    vtkNew<vtkFloatArray> sizes;
    sizes->SetName("Sizes");
    sizes->InsertNextValue(0.5f);
    sizes->InsertNextValue(0.7f);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->GetPointData()->AddArray(sizes);
    const auto shape = MakeBall(0.5);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetSourceConnection(shape->GetOutputPort());
    mapper->SetScaleArray("Sizes");
    mapper->SetScaleModeToScaleByMagnitude();
    Add(scene, mapper);
    return [=] { change(data.Get(), shape.Get()); };
  };
}

//------------------------------------------------------------------------------
SceneChange ImposterSizes()
{
  return [](BallScene& scene) -> Change
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.9);
    vtkNew<vtkCellArray> vertices;
    vertices->InsertNextCell({ 0 });
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    auto radii = vtkSmartPointer<vtkFloatArray>::New();
    radii->SetName("Radii");
    radii->InsertNextValue(0.4f);
    data->GetPointData()->AddArray(radii);
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetScaleArray("Radii");
    Add(scene, mapper);
    return [=]
    {
      radii->SetValue(0, 0.6f);
      radii->Modified();
    };
  };
}

//------------------------------------------------------------------------------
/// Two balls as blocks. With an unlike prop in it the composite is drawn by its mapper alone.
template <typename Functor>
SceneChange OfBlocks(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    const auto first = MakeBallData(-0.4);
    const auto second = MakeBallData(0.5);
    vtkNew<vtkMultiBlockDataSet> inner;
    inner->SetBlock(0, second);
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, first);
    blocks->SetBlock(1, inner);
    auto mapper = vtkSmartPointer<CompositeMapper>::New();
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    mapper->SetCompositeDataDisplayAttributes(attributes);
    mapper->SetInputDataObject(blocks);
    Add(scene, mapper);
    return [=] { change(mapper.Get(), second.Get()); };
  };
}

//------------------------------------------------------------------------------
/// Levels of detail: one is a ball, the other a smaller one.
template <typename Functor>
SceneChange OfLevels(Functor change)
{
  return [change](BallScene& scene) -> Change
  {
    const auto ball = MakeBall();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    auto property = vtkSmartPointer<vtkProperty>::New();
    auto prop = vtkSmartPointer<vtkLODProp3D>::New();
    const int level = prop->AddLOD(mapper, property, 0.0);
    vtkNew<vtkPolyDataMapper> small;
    small->SetInputData(MakeBallData(0.6));
    const int other = prop->AddLOD(small, 0.0);
    prop->AutomaticLODSelectionOff();
    prop->SetSelectedLODID(level);
    scene.Renderer->AddViewProp(prop);
    return [=] { change(prop.Get(), ball.Get(), property.Get(), other); };
  };
}

}

//------------------------------------------------------------------------------
std::vector<ChangeInPlace> ChangesOfMappers()
{
  return {
    { "PlaneOrigin",
      OfPlane([](vtkMapper*, vtkPlane* plane) { plane->SetOrigin(0.3, 0.0, 0.9); }) },
    { "PlaneNormal",
      OfPlane([](vtkMapper*, vtkPlane* plane) { plane->SetNormal(1.0, 0.0, 0.2); }) },
    { "PlaneAdded",
      OfPlane(
        [](vtkMapper* mapper, vtkPlane*)
        {
          vtkNew<vtkPlane> plane;
          plane->SetOrigin(0.0, 0.0, 0.9);
          plane->SetNormal(0.0, 1.0, 0.0);
          mapper->GetClippingPlanes()->AddItem(plane);
        }) },
    { "PlanesRemoved",
      OfPlane(
        [](vtkMapper* mapper, vtkPlane*) { mapper->GetClippingPlanes()->RemoveAllItems(); }) },
    { "PointsArray",
      OfData(
        [](vtkPolyData* data)
        {
          RaisePoints(data);
          data->GetPoints()->GetData()->Modified();
        }) },
    { "Cells", OfData([](vtkPolyData* data) { FoldCells(data); }) },
    { "GlyphShape", OfGlyphs([](vtkPolyData*, vtkSphereSource* shape) { shape->SetRadius(0.8); }) },
    { "GlyphPoints",
      OfGlyphs(
        [](vtkPolyData* data, vtkSphereSource*)
        {
          data->GetPoints()->SetPoint(1, 0.8, 0.5, 0.2);
          data->GetPoints()->GetData()->Modified();
        }) },
    { "GlyphSizes",
      OfGlyphs(
        [](vtkPolyData* data, vtkSphereSource*)
        {
          vtkDataArray* sizes = data->GetPointData()->GetArray("Sizes");
          sizes->SetComponent(0, 0, 1.2);
          sizes->Modified();
        }) },
    { "ImposterSizes", ImposterSizes() },
    { "BlockVisibility",
      OfBlocks(
        [](CompositeMapper* mapper, vtkPolyData*) { mapper->SetBlockVisibility(2, false); }) },
    { "BlockOpacity",
      OfBlocks([](CompositeMapper* mapper, vtkPolyData*) { mapper->SetBlockOpacity(1, 0.3); }) },
    { "BlockPoints",
      OfBlocks(
        [](CompositeMapper*, vtkPolyData* data)
        {
          RaisePoints(data);
          data->GetPoints()->Modified();
        }) },
    { "LevelInput",
      OfLevels(
        [](vtkLODProp3D*, vtkSphereSource* ball, vtkProperty*, int) { ball->SetRadius(0.3); }) },
    { "LevelProperty",
      OfLevels([](vtkLODProp3D*, vtkSphereSource*, vtkProperty* property, int)
        { property->SetRepresentationToWireframe(); }) },
    { "LevelSelected",
      OfLevels([](vtkLODProp3D* prop, vtkSphereSource*, vtkProperty*, int other)
        { prop->SetSelectedLODID(other); }) },
  };
}

//------------------------------------------------------------------------------
const std::vector<ChangeInPlace>& AllChangesInPlace()
{
  static const std::vector<ChangeInPlace> changes = []
  {
    std::vector<ChangeInPlace> all = ChangesOfMappers();
    const std::vector<ChangeInPlace> others = ChangesOfActors();
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }();
  return changes;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const ChangeInPlace& change)
{
  return os << change.Name;
}

}
