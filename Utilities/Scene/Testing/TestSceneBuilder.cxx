// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// From descriptions to VTK's objects.

#include "ModelScene.h"
#include "SceneBuilder.h"
#include "SceneReader.h"
#include "ShapeMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkLightCollection.h"
#include "vtkMassProperties.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowCasters.h"
#include "vtkTriangleFilter.h"

using namespace softshadows;

namespace
{

const std::string Data = SOFTSHADOWS_TEST_DATA_DIR;
constexpr double Pi = 3.14159265358979323846;

BuiltScene Build(const std::string& text)
{
  ModelStore models({ Data });
  return BuildScene(ParseScene(text, "scene.json"), models);
}

vtkSmartPointer<vtkPolyData> MeshOf(const std::string& object)
{
  ModelStore models;
  const SceneDescription scene =
    ParseScene(R"({"version": 1, "objects": [)" + object + "]}", "scene.json");
  return MakeMesh(scene.Objects.at(0).Shape, "", models);
}

double AreaOf(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  mass->Update();
  return mass->GetSurfaceArea();
}

void ExpectBounds(vtkPolyData* mesh, const Box& expected, double tolerance)
{
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(mesh->GetBounds()[i], expected[i], tolerance) << "bound " << i;
  }
}

}

TEST(ShapeMesh, IsVtksSourceInDouble)
{
  const auto plane = MeshOf(R"({"source": "plane", "origin": [1e7, 0.1, 0],
    "point1": [10000002, 0.1, 0], "point2": [1e7, 3.1, 0], "x_resolution": 2})");
  ExpectBounds(plane, { { 1e7, 1e7 + 2, 0.1, 3.1, 0, 0 } }, 1e-8);
  EXPECT_EQ(plane->GetNumberOfPolys(), 2);

  const auto box = MeshOf(R"({"source": "box", "bounds": [0.1, 1, 2, 4, -3, 5]})");
  ExpectBounds(box, { { 0.1, 1, 2, 4, -3, 5 } }, 1e-14);

  const auto sphere = MeshOf(R"({"source": "sphere", "center": [1, 2, 3], "radius": 2,
    "theta_resolution": 128, "phi_resolution": 129})");
  ExpectBounds(sphere, { { -1, 3, 0, 4, 1, 5 } }, 1e-9);
  EXPECT_NEAR(AreaOf(sphere), 4 * Pi * 4, 0.05);

  const auto cylinder = MeshOf(R"({"source": "cylinder", "center": [1, 2, 3], "radius": 0.5,
    "height": 4, "resolution": 256})");
  ExpectBounds(cylinder, { { 0.5, 1.5, 0, 4, 2.5, 3.5 } }, 1e-3);
  EXPECT_NEAR(AreaOf(cylinder), Pi * 4 + 2 * Pi * 0.25, 2e-3) << "around y, with caps";

  const auto cone = MeshOf(R"({"source": "cone", "center": [0, 0, 1], "direction": [0, 0, 1],
    "radius": 0.5, "height": 2, "resolution": 256, "capping": false})");
  ExpectBounds(cone, { { -0.5, 0.5, -0.5, 0.5, 0, 2 } }, 1e-3);
  EXPECT_NEAR(AreaOf(cone), Pi * 0.5 * std::hypot(0.5, 2.0), 2e-3);

  const auto torus = MeshOf(R"({"source": "torus", "ring_radius": 2, "cross_section_radius": 0.5,
    "u_resolution": 200, "v_resolution": 100})");
  ExpectBounds(torus, { { -2.5, 2.5, -2.5, 2.5, -0.5, 0.5 } }, 1e-2);
  EXPECT_NEAR(AreaOf(torus), 4 * Pi * Pi * 2 * 0.5, 0.05);
}

TEST(ShapeMesh, HasVtksDefaults)
{
  ExpectBounds(MeshOf(R"({"source": "plane"})"), { { -0.5, 0.5, -0.5, 0.5, 0, 0 } }, 1e-14);
  ExpectBounds(MeshOf(R"({"source": "box"})"), { { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 } }, 1e-14);
  // What VTK's sources give when nothing but the precision is set.
  EXPECT_EQ(MeshOf(R"({"source": "sphere"})")->GetNumberOfPolys(), 96);
  EXPECT_EQ(MeshOf(R"({"source": "cylinder"})")->GetNumberOfPolys(), 8);
  EXPECT_EQ(MeshOf(R"({"source": "cone"})")->GetNumberOfPolys(), 7);
  ExpectBounds(MeshOf(R"({"source": "cone"})"),
    { { -0.5, 0.5, -0.5, 0.5, -0.5 * std::sqrt(0.75), 0.5 * std::sqrt(0.75) } }, 1e-9);
  ExpectBounds(MeshOf(R"({"source": "torus"})"), { { -1.5, 1.5, -1.5, 1.5, -0.5, 0.5 } }, 2e-2);
}

TEST(SceneBuilder, BuildsLightsInTheirOrder)
{
  const BuiltScene built = Build(R"({"version": 1, "lights": [
    {"position": [2, -2, 4], "focal_point": [1, 0, 0], "view_up": [0, 1, 0], "shape": "disk",
     "size": [0.5, 0.25], "cone_angle": 45, "color": [1, 0.5, 0.25], "intensity": 2},
    {"position": [0, 0, 4], "size": [1, 1]},
    {"position": [0, 0, 4], "shape": "point", "cone_angle": 120},
    {"directional": true, "position": [1, 1, 3], "angular_diameter": 0.53} ]})");
  ASSERT_EQ(built.Lights.size(), 4u);
  EXPECT_EQ(built.Renderer->GetLights()->GetNumberOfItems(), 4);

  vtkAreaLight* disk = built.Lights[0];
  EXPECT_TRUE(disk->LightTypeIsSceneLight());
  EXPECT_TRUE(disk->GetPositional());
  EXPECT_EQ(disk->GetShape(), static_cast<int>(vtkAreaLight::DISK));
  EXPECT_EQ(disk->GetPosition()[2], 4.0);
  EXPECT_EQ(disk->GetFocalPoint()[0], 1.0);
  EXPECT_EQ(disk->GetViewUp()[1], 1.0);
  EXPECT_EQ(disk->GetSize()[0], 0.5);
  EXPECT_EQ(disk->GetSize()[1], 0.25);
  EXPECT_EQ(disk->GetConeAngle(), 45.0);
  EXPECT_EQ(disk->GetDiffuseColor()[1], 0.5);
  EXPECT_EQ(disk->GetSpecularColor()[2], 0.25);
  EXPECT_EQ(disk->GetIntensity(), 2.0);

  EXPECT_EQ(built.Lights[1]->GetShape(), static_cast<int>(vtkAreaLight::RECTANGLE));
  EXPECT_EQ(built.Lights[1]->GetConeAngle(), 90.0);
  EXPECT_EQ(built.Lights[1]->GetViewUp()[0], 0.0) << "left to the light";
  EXPECT_EQ(built.Lights[2]->GetShape(), static_cast<int>(vtkAreaLight::POINT));
  EXPECT_EQ(built.Lights[2]->GetConeAngle(), 90.0);
  EXPECT_FALSE(built.Lights[3]->GetPositional());
  EXPECT_EQ(built.Lights[3]->GetAngularDiameter(), 0.53);
}

TEST(SceneBuilder, BuildsActors)
{
  const BuiltScene built = Build(R"({"version": 1, "objects": [
    {"file": "bunny.ply", "matrix": [2,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1], "color": [0.8, 0.7, 0.6],
     "cast_shadow": false},
    {"source": "box", "receive_shadow": false} ]})");
  ASSERT_EQ(built.Actors.size(), 2u);
  vtkActor* bunny = built.Actors[0];
  EXPECT_EQ(bunny->GetProperty()->GetColor()[1], 0.7);
  EXPECT_EQ(bunny->GetMatrix()->GetElement(0, 0), 2.0);
  EXPECT_EQ(bunny->GetMatrix()->GetElement(1, 3), 6.0);
  EXPECT_FALSE(bunny->GetMapper()->GetScalarVisibility());
  EXPECT_FALSE(vtkShadowCasters::GetCastsShadow(bunny));
  EXPECT_TRUE(vtkShadowCasters::GetReceivesShadow(bunny));
  EXPECT_TRUE(vtkShadowCasters::GetCastsShadow(built.Actors[1]));
  EXPECT_FALSE(vtkShadowCasters::GetReceivesShadow(built.Actors[1]));
}

TEST(SceneBuilder, NamesTheModelThatIsMissing)
{
  try
  {
    Build("{\"version\": 1, \"objects\": [{\"source\": \"box\"},\n{\"file\": \"no.ply\"}]}");
    FAIL();
  }
  catch (const SceneError& error)
  {
    EXPECT_EQ(error.GetPlace().Line, 2);
    EXPECT_EQ(error.GetPlace().Key, "objects[1].file");
  }
}

TEST(SceneBuilder, BuildsCameras)
{
  const BuiltScene perspective = Build(R"({"version": 1, "camera": {"position": [0, -4, 2],
    "focal_point": [0, 0, 1], "view_up": [0, 0, 1], "view_angle": 45}})");
  vtkCamera* camera = perspective.Renderer->GetActiveCamera();
  EXPECT_EQ(camera->GetPosition()[1], -4.0);
  EXPECT_EQ(camera->GetFocalPoint()[2], 1.0);
  EXPECT_EQ(camera->GetViewUp()[2], 1.0);
  EXPECT_EQ(camera->GetViewAngle(), 45.0);
  EXPECT_FALSE(camera->GetParallelProjection());

  const BuiltScene parallel = Build(R"({"version": 1,
    "camera": {"position": [0, 0, 4], "parallel_scale": 2.5}})");
  EXPECT_TRUE(parallel.Renderer->GetActiveCamera()->GetParallelProjection());
  EXPECT_EQ(parallel.Renderer->GetActiveCamera()->GetParallelScale(), 2.5);

  const BuiltScene fitted = Build(R"({"version": 1,
    "objects": [{"source": "box", "bounds": [10, 12, 0, 2, 0, 2]}]})");
  EXPECT_EQ(fitted.Renderer->GetActiveCamera()->GetFocalPoint()[0], 11.0);
}

TEST(CameraClipping, FitsWhatIsInView)
{
  // A box in front of the camera, one beside the view, one behind.
  const BuiltScene built = Build(R"({"version": 1, "image": {"width": 100, "height": 100},
    "camera": {"position": [0, 0, 10], "view_angle": 30}, "objects": [
    {"source": "box", "bounds": [-1, 1, -1, 1, -2, 1]},
    {"source": "box", "bounds": [8, 9, -1, 1, 8, 9]},
    {"source": "box", "bounds": [-1, 1, -1, 1, 12, 13]} ]})");
  double range[2];
  built.Renderer->GetActiveCamera()->GetClippingRange(range);
  EXPECT_NEAR(range[0], 9.0 * 0.99, 1e-9);
  EXPECT_NEAR(range[1], 12.0 * 1.01, 1e-9);
}

TEST(CameraClipping, KeepsTheModelOnAHugeGround)
{
  // The camera looks down by 45 degrees from height 2 on a ground of 2000 x 2000, the view is 30
  // degrees high: the nearest ground seen is at depth 2 sqrt 2 / (1 + tan 15 degrees), the farthest at
  // 2 sqrt 2 / (1 - tan 15 degrees).
  const BuiltScene built = Build(R"({"version": 1, "image": {"width": 100, "height": 100},
    "camera": {"position": [0, -2, 2], "focal_point": [0, 0, 0], "view_up": [0, 0, 1]},
    "objects": [{"source": "plane", "origin": [-1000, -1000, 0], "point1": [1000, -1000, 0],
                 "point2": [-1000, 1000, 0]}]})");
  double range[2];
  built.Renderer->GetActiveCamera()->GetClippingRange(range);
  const double slope = std::tan(Pi / 12.0);
  EXPECT_NEAR(range[0], 0.99 * 2.0 * std::sqrt(2.0) / (1.0 + slope), 1e-9);
  EXPECT_NEAR(range[1], 1.01 * 2.0 * std::sqrt(2.0) / (1.0 - slope), 1e-9);
}

TEST(CameraClipping, FitsAParallelView)
{
  const BuiltScene built = Build(R"({"version": 1, "image": {"width": 200, "height": 100},
    "camera": {"position": [0, 0, 10], "parallel_scale": 1}, "objects": [
    {"source": "box", "bounds": [1.5, 3, 0, 1, 0, 1]},
    {"source": "box", "bounds": [0, 1, 1.5, 3, 8, 9]} ]})");
  double range[2];
  built.Renderer->GetActiveCamera()->GetClippingRange(range);
  EXPECT_NEAR(range[0], 9.0 * 0.99, 1e-9) << "two wide, one high";
  EXPECT_NEAR(range[1], 10.0 * 1.01, 1e-9);
}

TEST(ModelScene, PutsModelsOnAGroundBeforeACameraUnderALight)
{
  for (const UpAxis up : { UpAxis::X, UpAxis::Y, UpAxis::Z })
  {
    const int axis = static_cast<int>(up);
    ModelStore models;
    const SceneDescription scene =
      SceneAroundModels({ Data + "/bunny.ply", Data + "/teapot.obj" }, up, models);
    ASSERT_EQ(scene.Objects.size(), 3u);
    ASSERT_EQ(scene.Lights.size(), 1u);

    double lowest = 1e9;
    Box box{ { 1e9, -1e9, 1e9, -1e9, 1e9, -1e9 } };
    for (int i = 0; i < 2; ++i)
    {
      const double* bounds =
        models.Load(std::get<ModelShape>(scene.Objects[i].Shape), "")->GetBounds();
      lowest = std::min(lowest, bounds[2 * axis]);
      for (int k = 0; k < 3; ++k)
      {
        box[2 * k] = std::min(box[2 * k], bounds[2 * k]);
        box[2 * k + 1] = std::max(box[2 * k + 1], bounds[2 * k + 1]);
      }
    }
    double diagonal = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      diagonal += (box[2 * k + 1] - box[2 * k]) * (box[2 * k + 1] - box[2 * k]);
    }
    const double radius = 0.5 * std::sqrt(diagonal);

    const BuiltScene built = BuildScene(scene, models);
    const double* ground = built.Actors[2]->GetBounds();
    EXPECT_NEAR(ground[2 * axis], lowest, 1e-9);
    EXPECT_NEAR(ground[2 * axis + 1], lowest, 1e-9);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(scene.Camera->FocalPoint[k], 0.5 * (box[2 * k] + box[2 * k + 1]), 1e-9);
      if (k != axis)
      {
        EXPECT_NEAR(ground[2 * k + 1] - ground[2 * k], 100.0 * radius, 1e-6);
      }
    }
    EXPECT_EQ(scene.Camera->ViewUp[axis], 1.0);
    EXPECT_GT(scene.Camera->Position[axis], scene.Camera->FocalPoint[axis]);
    EXPECT_GT(scene.Lights[0].Position[axis], scene.Camera->FocalPoint[axis] + 2.0 * radius);
    EXPECT_NEAR(scene.Lights[0].Size[0], 0.8 * radius, 1e-9);
    double normal[3];
    built.Actors[2]->GetMapper()->Update();
    vtkPolyData::SafeDownCast(built.Actors[2]->GetMapper()->GetInput())
      ->GetPointData()
      ->GetNormals()
      ->GetTuple(0, normal);
    EXPECT_NEAR(normal[axis], 1.0, 1e-6) << "the ground's front is up";
  }
}

TEST(ModelScene, NamesTheModelThatCannotBeRead)
{
  ModelStore models;
  try
  {
    SceneAroundModels({ "no/such.ply" }, UpAxis::Y, models);
    FAIL();
  }
  catch (const SceneError& error)
  {
    EXPECT_NE(std::string(error.what()).find("no/such.ply"), std::string::npos);
  }
}
