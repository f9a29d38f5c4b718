// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Glyphs, imposters, cuts and holes cast what the same things cast as triangles; what is not known is told.
#include "TracedStage.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkDoubleArray.h"
#include "vtkGlyph3D.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace SoftShadowsTesting;

namespace
{
double Apart(const Picture& first, const Picture& second)
{
  double squares = 0.0;
  for (std::size_t i = 0; i < first.Values.size(); ++i)
  {
    const double change = first.Values[i] - second.Values[i];
    squares += std::isnan(change) ? 0.0 : change * change;
  }
  return std::sqrt(squares / first.Values.size());
}

/// The scene's light and plane, and in place of its blockers what is given.
Picture Shadow(const Scene& scene, vtkActor* caster)
{
  for (vtkActor* blocker : scene.BlockerActors)
  {
    blocker->VisibilityOff();
  }
  caster->AddPosition(0.0, 0.0, 1.0);
  scene.Renderer->AddActor(caster);
  Picture picture;
  {
    TracedStage stage(scene);
    stage.Pass->SetRays(16);
    picture = stage.Render();
  }
  scene.Renderer->RemoveActor(caster);
  return picture;
}

vtkSmartPointer<vtkPolyData> MakePlaces()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(0.35 * (i - 2), 0.1 * i - 0.2, 0.05 * i);
    vectors->InsertNextTuple3(0.3 - 0.1 * i, 0.1 * i, 0.2);
  }
  auto places = vtkSmartPointer<vtkPolyData>::New();
  places->SetPoints(points);
  places->GetPointData()->SetVectors(vectors);
  return places;
}
}

//------------------------------------------------------------------------------
TEST(TracedCasters, GlyphsCastAsTheirTriangles)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  const auto places = MakePlaces();
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkGlyph3D> filter; // makes triangles
  filter->SetInputData(places);
  filter->SetSourceConnection(cone->GetOutputPort());
  filter->SetVectorModeToUseVector();
  filter->SetScaleModeToScaleByVector();
  vtkNew<vtkPolyDataMapper> plainMapper;
  plainMapper->SetInputConnection(filter->GetOutputPort());
  vtkNew<vtkActor> plain;
  plain->SetMapper(plainMapper);

  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetOrientationArray("vectors");
  mapper->SetScaleArray("vectors");
  mapper->SetScaleModeToScaleByMagnitude();
  vtkNew<vtkActor> glyphs;
  glyphs->SetMapper(mapper);

  const Picture expected = Shadow(scene, plain);
  EXPECT_GT(Apart(expected, Shadow(scene, vtkNew<vtkActor>())), 0.05);
  EXPECT_LT(Apart(expected, Shadow(scene, glyphs)), 0.005);
}

//------------------------------------------------------------------------------
TEST(TracedCasters, ClippingPlanesCut)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  const auto make = [](double from)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.5);
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    sphere->SetStartTheta(from);
    sphere->SetEndTheta(180.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    return actor;
  };
  const auto half = make(0.0); // y > 0
  const auto cut = make(-180.0);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 1.0, 0.0);
  cut->GetMapper()->AddClippingPlane(plane);
  EXPECT_LT(Apart(Shadow(scene, half), Shadow(scene, cut)), 0.01);
}

//------------------------------------------------------------------------------
// Where a texture has no alpha VTK draws nothing, and light passes.
TEST(TracedCasters, TexturesWithAlphaHaveHoles)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  const auto make = [](double left)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(left, -0.4, 0.0);
    plane->SetPoint1(0.4, -0.4, 0.0);
    plane->SetPoint2(left, 0.4, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    return actor;
  };
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < 8; ++y)
  {
    for (int x = 0; x < 8; ++x)
    {
      auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      std::fill(texel, texel + 4, static_cast<unsigned char>(255));
      texel[3] = x < 4 ? 0 : 255;
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  const auto holed = make(-0.4);
  holed->SetTexture(texture);
  holed->ForceOpaqueOn();
  const Picture expected = Shadow(scene, make(0.0));
  EXPECT_LT(Apart(expected, Shadow(scene, holed)), 0.005);
  EXPECT_GT(Apart(expected, Shadow(scene, make(-0.4))), 0.05);
}

//------------------------------------------------------------------------------
// A line of a pixel's width casts nothing, and takes nothing away from the faces beside it.
TEST(TracedCasters, FacesCastBesideThinLines)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  const auto make = [](bool line)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->Update();
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(sphere->GetOutput());
    if (line)
    {
      vtkNew<vtkCellArray> lines;
      lines->InsertNextCell({ 0, 1 });
      data->SetLines(lines);
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    return actor;
  };
  EXPECT_LT(Apart(Shadow(scene, make(false)), Shadow(scene, make(true))), 1e-3);
}

//------------------------------------------------------------------------------
TEST(TracedCasters, ReplacedShadersAreTold)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  TracedStage stage(scene);
  vtkNew<vtkTest::ErrorObserver> observer;
  stage.Pass->AddObserver(vtkCommand::WarningEvent, observer);
  stage.Render();
  EXPECT_EQ(stage.Pass->GetCasterReport(), "");
  scene.BlockerActors.front()->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Light::Impl", true, "//VTK::Light::Impl\n", false);
  const Picture without = stage.Render();
  EXPECT_NE(stage.Pass->GetCasterReport(), "");
  EXPECT_TRUE(observer->GetWarning());
  observer->Clear();
  scene.BlockerActors.front()->AddPosition(0.01, 0.0, 0.0);
  stage.Render();
  EXPECT_FALSE(observer->GetWarning()) << "once";
  for (const float v : without.Values)
  {
    EXPECT_TRUE(std::isnan(v) || v == 1.0f);
  }
}
