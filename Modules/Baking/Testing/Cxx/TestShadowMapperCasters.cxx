// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Casters that only their own mappers can draw.
#include "BakingScene.h"
#include "GLObjectCounter.h"
#include "GLStateSnapshot.h"

#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLineSource.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
vtkShadowMapView MakeView(bool directional)
{
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.2, -0.3, 5.0, directional);
  // Turned, and a window off the direction.
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(25.0, 0.3, 1.0, 0.4);
  turn->TransformVector(view.Emitter.AxisU.data(), view.Emitter.AxisU.data());
  turn->TransformVector(view.Emitter.AxisV.data(), view.Emitter.AxisV.data());
  turn->TransformVector(view.Emitter.Direction.data(), view.Emitter.Direction.data());
  const double unit = directional ? 5.0 : 1.0;
  view.Window = { { -0.35 * unit, 0.75 * unit, -0.45 * unit, 0.5 * unit } };
  view.Near = 2.0;
  view.Far = 8.0;
  return view;
}

vtkShadowMapView MakeDownwardView(bool directional)
{
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.0, 0.0, 5.0, directional);
  const double unit = directional ? 5.0 : 1.0;
  view.Window = { { -0.3 * unit, 0.3 * unit, -0.3 * unit, 0.3 * unit } };
  view.Near = 3.0;
  view.Far = 7.0;
  return view;
}

struct Difference
{
  int Texels = 0;    // covered in one map and not in the other
  int Covered = 0;   // in both
  double Most = 0.0; // of the depths
};

Difference Compare(const std::vector<float>& a, const std::vector<float>& b)
{
  Difference difference;
  for (size_t i = 0; i < a.size(); ++i)
  {
    if ((a[i] < 1.0f) != (b[i] < 1.0f))
    {
      ++difference.Texels;
    }
    else if (a[i] < 1.0f)
    {
      ++difference.Covered;
      difference.Most = std::max(difference.Most, std::abs(double(a[i]) - b[i]));
    }
  }
  return difference;
}
}

//------------------------------------------------------------------------------
TEST(ShadowMapperCasters, HaveTheSameDepthAsBufferCasters)
{
  for (const bool directional : { false, true })
  {
    for (const double shift : { 0.0, 1e5 })
    {
      BakingScene scene;
      vtkNew<vtkConeSource> cone;
      cone->SetResolution(24);
      auto actor = scene.AddActor(cone);
      actor->SetPosition(shift, 0.0, 0.2);
      vtkShadowMapView view = MakeView(directional);
      view.Emitter.Center[0] += shift;
      view.Emitter.Apex = view.Emitter.Center;
      const auto buffer = scene.BakeDepths(view, 96);
      EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 0);
      actor->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true, "//VTK::Light::Impl\n", false);
      const auto mapper = scene.BakeDepths(view, 96);
      EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 1);
      const Difference difference = Compare(buffer, mapper);
      EXPECT_GT(difference.Covered, 100);
      EXPECT_LE(difference.Texels, difference.Covered / 100) << directional << " " << shift;
      EXPECT_LT(difference.Most, 2e-5) << directional << " " << shift;
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowMapperCasters, GlyphsCastTheirShapes)
{
  BakingScene scene;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-0.8, -0.5, 0.0);
  points->InsertNextPoint(0.7, 0.4, 0.5);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  const auto glyphs = scene.BakeDepths(MakeDownwardView(false), 64);
  EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 1);

  scene.Renderer->RemoveActor(actor);
  scene.AddActor(sphere)->SetPosition(-0.8, -0.5, 0.0);
  scene.AddActor(sphere)->SetPosition(0.7, 0.4, 0.5);
  const auto spheres = scene.BakeDepths(MakeDownwardView(false), 64);
  const Difference difference = Compare(glyphs, spheres);
  EXPECT_GT(difference.Covered, 100);
  EXPECT_LE(difference.Texels, 4);
  EXPECT_LT(difference.Most, 2e-5);
}

//------------------------------------------------------------------------------
TEST(ShadowMapperCasters, SphereImpostersCastSpheres)
{
  for (const bool directional : { false, true })
  {
    BakingScene scene;
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.25, -0.2, 0.0);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetRadius(0.5);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
    scene.Bake({ MakeDownwardView(directional) }, 64);
    const auto image = scene.Maps->ReadDepth(0);
    ASSERT_EQ(scene.Casters->GetBodies().size(), 1u);
    EXPECT_GE(scene.Casters->GetBodies()[0].Bounds[1], 0.75 - 1e-6) << "the box holds the sphere";
    int hits = 0;
    for (int j = 0; j < 64; ++j)
    {
      for (int i = 0; i < 64; ++i)
      {
        // The ray (x, y, 5) + t (u, v, -1) against the sphere.
        const double u = image->GetOrigin()[0] + i * image->GetSpacing()[0];
        const double v = image->GetOrigin()[1] + j * image->GetSpacing()[1];
        const double origin[3] = { directional ? u - 0.25 : -0.25, directional ? v + 0.2 : 0.2,
          5.0 };
        const double ray[3] = { directional ? 0.0 : u, directional ? 0.0 : v, -1.0 };
        const double a = ray[0] * ray[0] + ray[1] * ray[1] + 1.0;
        const double b = origin[0] * ray[0] + origin[1] * ray[1] + origin[2] * ray[2];
        const double c =
          origin[0] * origin[0] + origin[1] * origin[1] + origin[2] * origin[2] - 0.25;
        const double root = b * b - a * c;
        const double found = image->GetScalarComponentAsDouble(i, j, 0, 0);
        if (root > 0.2)
        {
          EXPECT_NEAR(found, (-b - std::sqrt(root)) / a, 1e-3) << i << ", " << j;
          ++hits;
        }
        else if (root < -0.2)
        {
          EXPECT_TRUE(std::isinf(found)) << i << ", " << j;
        }
      }
    }
    EXPECT_GT(hits, 50);
  }
}

//------------------------------------------------------------------------------
TEST(ShadowMapperCasters, TexturesWithAlphaCastWhatTheyShow)
{
  // Left half opaque, right half cut away.
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 2; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      image->SetScalarComponentFromDouble(i, 0, 0, c, c == 3 && i == 1 ? 0.0 : 255.0);
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  BakingScene scene;
  vtkNew<vtkPlaneSource> plane;
  auto actor = scene.AddActor(plane);
  actor->SetTexture(texture);
  const auto depths = scene.BakeDepths(MakeDownwardView(true), 60); // 20 texels to the unit
  EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 1);
  EXPECT_TRUE(scene.Casters->GetBodies()[0].Flat);
  EXPECT_LT(depths[30 * 60 + 25], 1.0f);
  EXPECT_EQ(depths[30 * 60 + 35], 1.0f);
}

//------------------------------------------------------------------------------
TEST(ShadowMapperCasters, WhatIsNotASurfaceGoesThroughItsMapper)
{
  BakingScene scene;
  vtkNew<vtkCubeSource> cube;
  auto actor = scene.AddActor(cube);
  const auto mapperCasters = [&scene]()
  {
    scene.Bake({ MakeDownwardView(false) }, 60);
    return scene.Casters->GetNumberOfMapperCasters();
  };
  EXPECT_EQ(mapperCasters(), 0);
  actor->GetProperty()->SetRepresentationToWireframe();
  EXPECT_EQ(mapperCasters(), 1);
  const auto wires = scene.BakeDepths(MakeDownwardView(false), 60);
  EXPECT_EQ(wires[30 * 60 + 31], 1.0f) << "nothing between the wires";
  EXPECT_TRUE(std::any_of(wires.begin(), wires.end(), [](float d) { return d < 1.0f; }));
  actor->GetProperty()->SetRepresentationToSurface();
  EXPECT_EQ(mapperCasters(), 0);

  vtkNew<vtkPlane> plane; // keeps x > 0
  plane->SetNormal(1.0, 0.0, 0.0);
  actor->GetMapper()->AddClippingPlane(plane);
  EXPECT_EQ(mapperCasters(), 1);
  const auto half = scene.BakeDepths(MakeDownwardView(false), 60);
  EXPECT_LT(half[30 * 60 + 35], 1.0f);
  EXPECT_EQ(half[30 * 60 + 22], 1.0f);
  actor->GetMapper()->RemoveAllClippingPlanes();
  EXPECT_EQ(mapperCasters(), 0);

  vtkNew<vtkLineSource> line;
  scene.AddActor(line);
  EXPECT_EQ(mapperCasters(), 1);
}

//------------------------------------------------------------------------------
TEST(ShadowMapperCasters, NothingOutsideNotices)
{
  BakingScene scene;
  vtkNew<vtkCubeSource> cube;
  auto plain = scene.AddActor(cube);
  auto special = scene.AddActor(cube);
  special->SetPosition(0.5, 0.5, 0.5);
  special->GetProperty()->SetRepresentationToWireframe();
  special->GetProperty()->BackfaceCullingOn();
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  scene.Renderer->AddLight(light);
  scene.Window.Render();
  vtkOpenGLRenderWindow* window = scene.Window.GetOpenGL();

  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const auto cameraTime = camera->GetMTime();
  const auto lightTime = light->GetMTime();
  const auto propertyTime = special->GetProperty()->GetMTime();
  const auto actorTime = special->GetMTime();
  const auto rendererTime = scene.Renderer->GetMTime();
  const auto* keys = special->GetPropertyKeys();
  const SoftShadowsTesting::GLStateSnapshot before(window);

  vtkShadowMapView view = MakeDownwardView(false);
  for (const bool conservative : { false, true })
  {
    EXPECT_EQ(scene.Bake({ view }, 64, conservative), 1);
    const SoftShadowsTesting::GLStateSnapshot after(window);
    EXPECT_EQ(before.DifferenceTo(after), "") << conservative;
    EXPECT_EQ(SoftShadowsTesting::StateCacheErrors(window), "");
  }
  EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 1);
  EXPECT_EQ(scene.Renderer->GetActiveCamera(), camera);
  EXPECT_EQ(camera->GetMTime(), cameraTime);
  EXPECT_EQ(light->GetMTime(), lightTime);
  EXPECT_EQ(special->GetProperty()->GetMTime(), propertyTime);
  EXPECT_EQ(special->GetMTime(), actorTime);
  EXPECT_EQ(scene.Renderer->GetMTime(), rendererTime);
  EXPECT_EQ(special->GetPropertyKeys(), keys);
}

//------------------------------------------------------------------------------
TEST(ShadowMapperCasters, ReleasesAllOpenGLObjects)
{
  BakingScene scene;
  vtkNew<vtkCubeSource> cube;
  scene.AddActor(cube);
  scene.Window.Render();
  vtkOpenGLRenderWindow* window = scene.Window.GetOpenGL();
  const std::vector<vtkShadowMapView> views{ MakeDownwardView(false), MakeDownwardView(true) };
  scene.Bake(views, 64, false); // shaders stay with the window's cache
  scene.Bake(views, 64, true);
  scene.Release();
  const auto before = SoftShadowsTesting::CountGLObjects(window);
  scene.Bake(views, 64, false);
  scene.Bake(views, 128, true);
  EXPECT_NE(SoftShadowsTesting::CountGLObjects(window), before);
  scene.Release();
  EXPECT_EQ(SoftShadowsTesting::CountGLObjects(window), before);
  EXPECT_EQ(scene.Bake(views, 64, false), 2) << "usable again";
  EXPECT_LT(scene.Maps->GetTexture()->ReadLayer(0)[32 * 64 + 32], 1.0f);
}
