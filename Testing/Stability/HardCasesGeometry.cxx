// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces and views that shadow maps are bad at, and data that has no good answer.
#include "HardCases.h"
#include "HardScenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkReverseSense.h"

#include <cmath>
#include <limits>

namespace SoftShadowsTesting
{
namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
HardScene Finish(const BasicScene& scene)
{
  scene.Renderer->ResetCameraClippingRange();
  return scene;
}

//------------------------------------------------------------------------------
/// The ground scene with one more mesh.
HardScene WithMesh(vtkPolyData* mesh)
{
  BasicScene scene = MakeGroundScene();
  scene.Renderer->AddActor(MakeMeshActor(mesh));
  return Finish(scene);
}

//------------------------------------------------------------------------------
/// The basic scene with one more mesh, which is not to be noticed.
HardScene WithNonsense(vtkPolyData* mesh)
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->AddActor(MakeMeshActor(mesh));
  // The camera's range is not what is tested, and VTK takes it from all bounds.
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 20.0);
  return scene;
}

//------------------------------------------------------------------------------
/// A sun 0.1 degrees over the ground, a low wall in its way.
HardScene GrazingLight()
{
  BasicScene scene = MakeGroundScene();
  scene.Renderer->RemoveAllLights();
  const double angle = vtkMath::RadiansFromDegrees(0.1);
  const auto sun = MakeSun({ { std::cos(angle), 0.0, std::sin(angle) } }, 0.53);
  scene.Renderer->AddLight(sun);
  scene.Renderer->AddActor(MakeBoxActor({ { 0.9, 1.0, -0.5, 0.5, 0.0, 0.006 } }));
  HardScene result = Finish(scene);
  result.Light = sun;
  return result;
}

//------------------------------------------------------------------------------
HardScene GrazingView()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, -5.0, 0.05);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.01, 20.0);
  return scene;
}

//------------------------------------------------------------------------------
HardScene LightNearlyTouching()
{
  BasicScene scene = MakeBasicScene();
  scene.Lamp->SetPosition(-0.6, -0.7, 0.05);
  scene.Lamp->SetFocalPoint(-0.6, 0.0, 0.4);
  scene.Lamp->SetSize(0.05, 0.05);
  return scene;
}

//------------------------------------------------------------------------------
HardScene LightInsideMesh()
{
  BasicScene scene = MakeBasicScene();
  scene.Lamp->SetPosition(-0.6, -0.1, 0.7);
  scene.Lamp->SetFocalPoint(-0.6, -0.1, 0.0);
  scene.Lamp->SetSize(0.1, 0.1);
  return scene;
}

//------------------------------------------------------------------------------
HardScene LightLargerThanScene()
{
  BasicScene scene = MakeBasicScene();
  scene.Lamp->SetSize(12.0, 12.0);
  return scene;
}

//------------------------------------------------------------------------------
/// Sheets edge-on to the light, standing and lying, and one across.
HardScene ThinSheets()
{
  BasicScene scene = MakeGroundScene();
  for (const double x : { -0.8, -0.3, 0.2 })
  {
    scene.Renderer->AddActor(
      MakeQuadActor({ { { { x, -0.6, 0.0 } }, { { 0.0, 1.2, 0.0 } }, { { 0.0, 0.0, 0.4 } } } }));
  }
  scene.Renderer->AddActor(
    MakeQuadActor({ { { { 0.4, -0.6, 0.6 } }, { { 0.4, 0.0, 0.1 } }, { { 0.0, 1.0, 0.0 } } } }));
  return Finish(scene);
}

//------------------------------------------------------------------------------
/// Two grounds in one plane, and the lid of a box in the plane of a sheet.
HardScene Coplanar()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->AddActor(MakeGroundActor(2.0));
  scene.Renderer->AddActor(
    MakeQuadActor({ { { { 0.1, -0.5, 0.5 } }, { { 0.5, 0.0, 0.0 } }, { { 0.0, 0.5, 0.0 } } } }));
  return scene;
}

//------------------------------------------------------------------------------
/// Triangles a thousand times as long as wide.
HardScene Needles()
{
  std::vector<Point> corners;
  for (int i = 0; i < 40; ++i)
  {
    const double y = -0.7 + 0.035 * i;
    const Point needle[3] = { { { -1.0, y, 0.4 } }, { { 0.9, y + 0.3, 0.7 } },
      { { 0.9, y + 0.32, 0.7 } } };
    corners.insert(corners.end(), needle, needle + 3);
  }
  return WithMesh(MakeTriangles(corners));
}

//------------------------------------------------------------------------------
HardScene ZeroArea()
{
  return WithNonsense(MakeTriangles({ { { 0.0, 0.0, 2.0 } }, { { 0.0, 0.0, 2.0 } },
    { { 0.0, 0.0, 2.0 } }, { { -1.0, 0.0, 2.0 } }, { { 0.0, 0.0, 2.0 } }, { { 1.0, 0.0, 2.0 } } }));
}

//------------------------------------------------------------------------------
/// A ball whose triangles share no point, each given twice.
HardScene DuplicatePoints()
{
  const auto ball = MakeSphere({ { -0.6, -0.1, 0.7 } }, 0.4);
  std::vector<Point> corners;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (int copy = 0; copy < 2; ++copy)
  {
    for (vtkIdType cell = 0; cell < ball->GetNumberOfCells(); ++cell)
    {
      ball->GetCellPoints(cell, count, ids);
      for (vtkIdType k = 0; k < count; ++k)
      {
        corners.push_back({});
        ball->GetPoint(ids[k], corners.back().data());
      }
    }
  }
  return WithMesh(MakeTriangles(corners));
}

//------------------------------------------------------------------------------
HardScene NotFinite(double value)
{
  return WithNonsense(
    MakeTriangles({ { { value, 0.0, 2.0 } }, { { 0.5, value, 2.0 } }, { { 0.0, 0.5, value } },
      { { value, value, value } }, { { -0.5, 0.0, 2.0 } }, { { 0.5, 0.0, 2.0 } } }));
}

//------------------------------------------------------------------------------
HardScene EmptyAndInvisible()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->AddActor(MakeMeshActor(vtkNew<vtkPolyData>()));
  scene.Renderer->AddActor(vtkNew<vtkActor>());
  vtkNew<vtkActor> unconnected;
  unconnected->SetMapper(vtkNew<vtkPolyDataMapper>());
  unconnected->SetVisibility(false); // visible, VTK itself complains
  scene.Renderer->AddActor(unconnected);
  const auto invisible = MakeBoxActor({ { -1.0, 1.0, -1.0, 1.0, 1.5, 2.0 } });
  invisible->SetVisibility(false);
  scene.Renderer->AddActor(invisible);
  return scene;
}

//------------------------------------------------------------------------------
HardScene SinglePoint()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 1.5);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return WithNonsense(data); // no cell: nothing is drawn, nothing is cast
}

//------------------------------------------------------------------------------
/// The basic scene, its bodies' properties and meshes changed.
HardScene Changed(const std::function<void(vtkActor*)>& change)
{
  BasicScene scene = MakeBasicScene();
  change(scene.Ball);
  change(scene.Box);
  return scene;
}

//------------------------------------------------------------------------------
HardScene InsideOut()
{
  return Changed(
    [](vtkActor* actor)
    {
      auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
      vtkNew<vtkReverseSense> reverse;
      reverse->SetInputData(mapper->GetInput());
      reverse->ReverseCellsOn();
      reverse->ReverseNormalsOn();
      reverse->Update();
      mapper->SetInputData(reverse->GetOutput());
    });
}

//------------------------------------------------------------------------------
HardScene WithoutNormals()
{
  return Changed(
    [](vtkActor* actor)
    {
      auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
      vtkNew<vtkPolyData> bare;
      bare->ShallowCopy(mapper->GetInput());
      bare->GetPointData()->SetNormals(nullptr);
      mapper->SetInputData(bare);
    });
}

//------------------------------------------------------------------------------
/// Over 10^6 triangles, each far smaller than a pixel.
HardScene MillionTriangles()
{
  return WithMesh(MakeSphere({ { -0.1, 0.0, 0.7 } }, 0.5, 710));
}

//------------------------------------------------------------------------------
/// One triangle as ground, ten thousand times the size of what stands on it.
HardScene HugeTriangle()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->RemoveActor(scene.Ground);
  scene.Renderer->AddActor(MakeMeshActor(
    MakeTriangles({ { { -1e4, -1e4, 0.0 } }, { { 2e4, -1e4, 0.0 } }, { { -1e4, 2e4, 0.0 } } })));
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 20.0);
  return scene;
}

//------------------------------------------------------------------------------
/// Plates one above the other with gaps that the lamp sees past.
HardScene Stack()
{
  BasicScene scene = MakeGroundScene();
  for (int i = 0; i < 4; ++i)
  {
    const double x = -0.9 + 0.3 * i;
    scene.Renderer->AddActor(MakeQuadActor(
      { { { { x, -0.5, 0.3 + 0.4 * i } }, { { 0.5, 0.0, 0.0 } }, { { 0.0, 0.9, 0.0 } } } }));
  }
  return Finish(scene);
}

}

//------------------------------------------------------------------------------
const std::vector<HardCase>& GeometryCases()
{
  const auto culled = [](bool back)
  {
    return [back]
    {
      return Changed(
        [back](vtkActor* actor)
        {
          actor->GetProperty()->SetBackfaceCulling(back);
          actor->GetProperty()->SetFrontfaceCulling(!back);
        });
    };
  };
  const auto shaded = [](int interpolation)
  {
    return [interpolation]
    {
      return Changed([interpolation](vtkActor* actor)
        { actor->GetProperty()->SetInterpolation(interpolation); });
    };
  };
  static const std::vector<HardCase> cases = {
    { "GrazingLight", "a sun 0.1 degrees over the ground and a wall of 0.006", GrazingLight },
    { "GrazingView", "a camera half a degree over the ground", GrazingView },
    { "LightNearlyTouching", "a lamp of 0.05 that close to the ground", LightNearlyTouching },
    { "LightInsideMesh", "a lamp inside a closed ball", LightInsideMesh },
    { "LightLargerThanScene", "a lamp of 12 over a scene of 2", LightLargerThanScene },
    { "ThinSheets", "sheets without thickness, edge-on to the lamp", ThinSheets },
    { "Coplanar", "surfaces that overlap in one plane", Coplanar },
    { "Needles", "forty triangles, 2 long and 0.02 wide", Needles },
    { "StackOfPlates", "four plates the lamp sees past", Stack },
    { "ZeroArea", "triangles without area", ZeroArea },
    { "DuplicatePoints", "no point shared, every triangle twice", DuplicatePoints },
    { "NaNPoints", "", [] { return NotFinite(NaN); } },
    { "InfinitePoints", "", [] { return NotFinite(Infinity); } },
    { "EmptyAndInvisible", "actors with no data, no mapper, no visibility", EmptyAndInvisible },
    { "SinglePoint", "a data set of one point", SinglePoint },
    { "InsideOut", "normals and sides reversed", InsideOut },
    { "BackfaceCulling", "", culled(true) },
    { "FrontfaceCulling", "the bodies' insides are seen", culled(false), false, 0.1 },
    { "NoNormals", "", WithoutNormals },
    { "FlatShading", "", shaded(VTK_FLAT) },
    { "SmoothShading", "", shaded(VTK_PHONG) },
    { "MillionTriangles", "a ball of 1006780 triangles", MillionTriangles, false, 0.02,
      Effort::Quick },
    { "HugeTriangle", "the ground one triangle of 3e4", HugeTriangle },
  };
  return cases;
}

}
