// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What casts stands where the prop is drawn, in whatever way it is put together.
#include "CasterHeights.h"

#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkTransform.h"
#include "vtkVersionMacros.h"

#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 3)
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
TEST(ShadowCasters, UserMatricesAndMirrorsApply)
{
  BakingScene scene;
  auto actor = MakeActor(MakeBox(0.2, 1.0, 0.2, 0.6, 0.5));
  scene.Renderer->AddActor(actor);
  actor->SetPosition(0.5, 0.0, 0.0);
  vtkNew<vtkMatrix4x4> mirror;
  mirror->SetElement(0, 0, -1.0);
  mirror->SetElement(2, 3, 1.0);
  actor->SetUserMatrix(mirror);
  const Heights heights(scene);
  EXPECT_NEAR(heights.At(-1.1, 0.4), 1.5, 1e-5);
  EXPECT_TRUE(heights.IsEmptyAt(1.1, 0.4));
  EXPECT_TRUE(heights.IsEmptyAt(-0.5, 0.4)) << "x from -1.5 to -0.7";
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, AssembliesCastWhereTheirPartsAre)
{
  BakingScene scene;
  vtkNew<vtkAssembly> inner;
  vtkNew<vtkAssembly> outer;
  auto part = MakeActor(MakeBox(-0.2, 0.2, -0.2, 0.2, 0.5));
  auto other = MakeActor(MakeBox(-0.2, 0.2, -0.2, 0.2, 1.0));
  part->SetPosition(1.0, 0.0, 0.0);
  other->SetPosition(-1.0, 0.0, 0.0);
  inner->AddPart(part);
  inner->AddPart(other);
  inner->SetPosition(0.0, 1.0, 0.0);
  outer->AddPart(inner);
  outer->SetPosition(0.0, 0.0, 0.25);
  scene.Renderer->AddActor(outer);
  {
    const Heights heights(scene);
    EXPECT_NEAR(heights.At(1.0, 1.0), 0.75, 1e-5);
    EXPECT_NEAR(heights.At(-1.0, 1.0), 1.25, 1e-5);
    EXPECT_TRUE(heights.IsEmptyAt(0.0, 1.0));
    EXPECT_TRUE(heights.IsEmptyAt(1.0, 0.0));
  }
  const auto time = scene.Casters->GetCastersTime();
  scene.Window.Render(); // VTK's own frame modifies every part of an assembly
  EXPECT_EQ(scene.Bake({ MakeView() }, RESOLUTION), 0);
  EXPECT_EQ(scene.Casters->GetCastersTime(), time);

  part->GetProperty()->SetVertexVisibility(true); // through its mapper
  EXPECT_NEAR(Heights(scene).At(1.0, 1.0), 0.75, 1e-5);
  EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 1);
  other->SetVisibility(false);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(-1.0, 1.0));
  outer->SetVisibility(false);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(1.0, 1.0));
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, BlocksCastAsTheyAreSeen)
{
  BakingScene scene;
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> nested;
  blocks->SetBlock(0, MakeBox(-1.5, -0.5, -0.5, 0.5, 0.5));
  nested->SetBlock(0, MakeBox(0.5, 1.5, -0.5, 0.5, 1.0));
  nested->SetBlock(1, MakeBox(0.5, 1.5, 1.0, 1.5, 1.5));
  blocks->SetBlock(1, nested);
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);

  const Heights all(scene);
  EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 0);
  EXPECT_NEAR(all.At(-1.0, 0.0), 0.5, 1e-5);
  EXPECT_NEAR(all.At(1.0, 0.0), 1.0, 1e-5);
  EXPECT_NEAR(all.At(1.0, 1.25), 1.5, 1e-5);

  attributes->SetBlockVisibility(nested, false);
  attributes->SetBlockVisibility(nested->GetBlock(1), true);
  mapper->Modified();
  const Heights some(scene);
  EXPECT_NEAR(some.At(-1.0, 0.0), 0.5, 1e-5);
  EXPECT_TRUE(some.IsEmptyAt(1.0, 0.0)) << "hidden with its parent";
  EXPECT_NEAR(some.At(1.0, 1.25), 1.5, 1e-5) << "shown against its parent";

  nested->SetBlock(1, MakeBox(0.5, 1.5, 1.0, 1.5, 1.75));
  attributes->SetBlockVisibility(nested->GetBlock(1), true);
  EXPECT_NEAR(Heights(scene).At(1.0, 1.25), 1.75, 1e-5) << "another block";
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, StripsAndPolygonsCast)
{
  BakingScene scene;
  vtkNew<vtkPoints> points;
  const double corners[6][2] = { { -1, -1 }, { -1, 0 }, { 0, -1 }, { 0, 0 }, { 1, -1 }, { 1, 0 } };
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner[0], corner[1], 0.5);
  }
  points->InsertNextPoint(-1.0, 0.5, 1.0);
  points->InsertNextPoint(1.0, 0.5, 1.0);
  points->InsertNextPoint(1.0, 1.0, 1.0);
  points->InsertNextPoint(0.0, 1.5, 1.0);
  points->InsertNextPoint(-1.0, 1.0, 1.0);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 6, 7, 8, 9, 10 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetStrips(strips);
  data->SetPolys(polygons);
  scene.Renderer->AddActor(MakeActor(data));
  const Heights heights(scene);
  EXPECT_EQ(scene.Casters->GetNumberOfTriangles(), 4 + 3);
  for (const double x : { -0.9, -0.4, 0.1, 0.6 })
  {
    EXPECT_NEAR(heights.At(x, -0.5), 0.5, 1e-5) << x;
    EXPECT_NEAR(heights.At(x, 0.8), 1.0, 1e-5) << x;
  }
  EXPECT_NEAR(heights.At(0.0, 1.3), 1.0, 1e-5);
  EXPECT_TRUE(heights.IsEmptyAt(0.9, 1.3));
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, WithoutSenseWithoutHarm)
{
  BakingScene scene;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(-1.0, -1.0, 0.5);
  points->InsertNextPoint(1.0, -1.0, 0.5);
  points->InsertNextPoint(0.0, 1.0, 0.5);
  points->InsertNextPoint(nan, 0.0, 3.0);
  points->InsertNextPoint(infinity, 0.0, 3.0);
  points->InsertNextPoint(1e6, 1e6, 1e6); // used by nothing
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 1, 3 });
  triangles->InsertNextCell({ 4, 1, 2 });
  triangles->InsertNextCell({ 0, 0, 1 });
  triangles->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  scene.Renderer->AddActor(MakeActor(data));
  vtkNew<vtkActor> empty; // no mapper
  scene.Renderer->AddActor(empty);
  scene.Renderer->AddActor(MakeActor(vtkNew<vtkPolyData>()));
  auto broken = MakeActor(MakeBox(-0.5, 0.5, -0.5, 0.5, 2.0));
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, nan);
  broken->SetUserMatrix(matrix);
  scene.Renderer->AddActor(broken);

  const Heights heights(scene);
  EXPECT_NEAR(heights.At(0.0, 0.0), 0.5, 1e-5);
  ASSERT_EQ(scene.Casters->GetBodies().size(), 1u);
  const auto& body = scene.Casters->GetBodies()[0];
  EXPECT_EQ(body.Bounds, (std::array<double, 6>{ { -1.0, 1.0, -1.0, 1.0, 0.5, 0.5 } }));
  EXPECT_TRUE(body.Flat);
  EXPECT_NEAR(std::abs(body.Normal[2]), 1.0, 1e-12);
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, OnlyFlatPropsDoNotRise)
{
  BakingScene scene;
  auto plane = scene.AddActor(vtkNew<vtkPlaneSource>());
  const auto cube = scene.AddActor(vtkNew<vtkCubeSource>());
  EXPECT_TRUE(std::isinf(scene.Casters->GetLargestRise(plane)));
  scene.Casters->Update(scene.Renderer);
  EXPECT_NEAR(scene.Casters->GetLargestRise(plane), 1.414e-6, 1e-9);
  EXPECT_TRUE(std::isinf(scene.Casters->GetLargestRise(cube)));
  plane->GetProperty()->SetVertexVisibility(true);
  plane->GetProperty()->SetEdgeVisibility(true);
  plane->GetProperty()->SetPointSize(5.0f);
  scene.Casters->Update(scene.Renderer);
  EXPECT_TRUE(std::isinf(scene.Casters->GetLargestRise(plane))) << "vertices may lie anywhere";
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, FlatBodiesHaveTheirTrueCorners)
{
  BakingScene scene;
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(3, 2);
  auto actor = scene.AddActor(plane);
  vtkNew<vtkTransform> place;
  place->Translate(1e5, -2e5, 3e5);
  place->RotateWXYZ(37.0, 1.0, 2.0, 3.0);
  place->Scale(2.0, 5.0, 1.0);
  actor->SetUserTransform(place);
  scene.Casters->Update(scene.Renderer);
  ASSERT_EQ(scene.Casters->GetBodies().size(), 1u);
  const auto& body = scene.Casters->GetBodies()[0];
  ASSERT_TRUE(body.Flat);
  for (const double x : { -0.5, 0.5 })
  {
    for (const double y : { -0.5, 0.5 })
    {
      const double local[3] = { x, y, 0.0 };
      double corner[3];
      place->TransformPoint(local, corner);
      double nearest = 1.0;
      for (const auto& found : body.Corners)
      {
        nearest = std::min(nearest,
          std::abs(found[0] - corner[0]) + std::abs(found[1] - corner[1]) +
            std::abs(found[2] - corner[2]));
      }
      EXPECT_LT(nearest, 1e-6);
      EXPECT_NEAR(
        body.Normal[0] * corner[0] + body.Normal[1] * corner[1] + body.Normal[2] * corner[2],
        body.Offset, 1e-6);
    }
  }
}
