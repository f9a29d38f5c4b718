// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What casts, and when it changes.
#include "BakingScene.h"

#include "vtkAppendPolyData.h"
#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// A parallel view straight down over [-2, 2]^2 from z = 5, 16 texels to the unit.
vtkShadowMapView MakeView()
{
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.0, 0.0, 5.0, true);
  view.Window = { { -2.0, 2.0, -2.0, 2.0 } };
  view.Near = 1.0;
  view.Far = 9.0;
  return view;
}
constexpr int RESOLUTION = 64;

vtkSmartPointer<vtkPolyData> MakeBox(double x0, double x1, double y0, double y1, double top)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(x0, x1, y0, y1, top - 0.5, top);
  box->Update();
  return box->GetOutput();
}

// The heights seen, NaN where there is nothing.
class Heights
{
public:
  explicit Heights(BakingScene& scene)
    : Depths(scene.BakeDepths(MakeView(), RESOLUTION))
  {
  }
  double At(double x, double y) const
  {
    const auto i = static_cast<size_t>((x + 2.0) * 16.0);
    const auto j = static_cast<size_t>((y + 2.0) * 16.0);
    const float depth = this->Depths[j * RESOLUTION + i];
    return depth < 1.0f ? 4.0 - 8.0 * depth : std::numeric_limits<double>::quiet_NaN();
  }
  bool IsEmptyAt(double x, double y) const { return std::isnan(this->At(x, y)); }
  bool operator==(const Heights& other) const { return this->Depths == other.Depths; }

private:
  std::vector<float> Depths;
};

vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
}

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
TEST(ShadowCasters, BothSidesCastWhateverIsCulled)
{
  BakingScene scene;
  vtkNew<vtkPlaneSource> plane;
  auto actor = scene.AddActor(plane);
  for (const bool front : { false, true })
  {
    actor->SetOrientation(front ? 0.0 : 180.0, 0.0, 0.0); // the culled side towards the light
    actor->GetProperty()->SetFrontfaceCulling(front);
    actor->GetProperty()->SetBackfaceCulling(!front);
    EXPECT_NEAR(Heights(scene).At(0.1, 0.1), 0.0, 1e-5) << front;
    actor->GetProperty()->SetVertexVisibility(true); // through its mapper now
    EXPECT_NEAR(Heights(scene).At(0.1, 0.1), 0.0, 1e-5) << front;
    EXPECT_EQ(scene.Casters->GetNumberOfMapperCasters(), 1);
    EXPECT_EQ(actor->GetProperty()->GetFrontfaceCulling(), front);
    actor->GetProperty()->SetVertexVisibility(false);
  }
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
  vtkNew<vtkCompositePolyDataMapper2> mapper;
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
TEST(ShadowCasters, OnlyVisibleOpaqueCastersCast)
{
  BakingScene scene;
  auto actor = MakeActor(MakeBox(-0.5, 0.5, -0.5, 0.5, 0.5));
  scene.Renderer->AddActor(actor);
  EXPECT_FALSE(Heights(scene).IsEmptyAt(0.0, 0.0));
  actor->SetVisibility(false);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(0.0, 0.0));
  EXPECT_TRUE(scene.Casters->GetBodies().empty());
  actor->SetVisibility(true);
  actor->GetProperty()->SetOpacity(0.5);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(0.0, 0.0));
  actor->GetProperty()->SetOpacity(1.0);
  vtkShadowCasters::SetCastsShadow(actor, false);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(0.0, 0.0));
  ASSERT_EQ(scene.Casters->GetBodies().size(), 1u) << "it still receives";
  EXPECT_FALSE(scene.Casters->GetBodies()[0].Casts);
  EXPECT_TRUE(scene.Casters->GetBodies()[0].Receives);
  vtkShadowCasters::SetCastsShadow(actor, true);
  vtkShadowCasters::SetReceivesShadow(actor, false);
  EXPECT_FALSE(Heights(scene).IsEmptyAt(0.0, 0.0));
  EXPECT_FALSE(scene.Casters->GetBodies()[0].Receives);
  EXPECT_EQ(actor->GetPropertyKeys()->GetNumberOfKeys(), 2);
  scene.Renderer->RemoveActor(actor);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(0.0, 0.0));
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, BakeWhenWhatCastsChangesAndOnlyThen)
{
  BakingScene scene;
  auto data = MakeBox(-0.5, 0.5, -0.5, 0.5, 0.5);
  auto actor = MakeActor(data);
  auto other = MakeActor(MakeBox(1.0, 1.5, 1.0, 1.5, 0.5));
  scene.Renderer->AddActor(actor);
  scene.Renderer->AddActor(other);
  const std::vector<vtkShadowMapView> views{ MakeView() };
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 1);
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 0) << "still";
  scene.Renderer->ResetCamera();
  scene.Window.Render();
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 0) << "the camera moved";
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 0) << "a colour changed";
  actor->SetPosition(0.1, 0.0, 0.0);
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 1) << "an actor moved";
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 0);
  data->GetPoints()->SetPoint(0, -0.6, -0.5, 0.0);
  data->GetPoints()->Modified();
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 1) << "the mapper's input changed in place";
  vtkPolyDataMapper::SafeDownCast(actor->GetMapper())
    ->SetInputData(MakeBox(-0.5, 0.5, -0.5, 0.5, 0.75));
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 1) << "the mapper has another input";
  vtkShadowCasters::SetCastsShadow(other, false);
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 1) << "one casts no longer";
  const auto bodies = scene.Casters->GetBodiesTime();
  other->SetPosition(0.1, 0.0, 0.0);
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 0) << "what casts nothing moved";
  EXPECT_GT(scene.Casters->GetBodiesTime(), bodies) << "but the fit may change";
  scene.Renderer->RemoveActor(other);
  EXPECT_EQ(scene.Bake(views, RESOLUTION), 0) << "what casts nothing left";
}

//------------------------------------------------------------------------------
TEST(ShadowCasters, ComingAndGoingLeavesTheRestAsItIs)
{
  BakingScene scene;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int i = 0; i < 12; ++i)
  {
    const double x = -1.9 + 0.3 * i;
    actors.push_back(MakeActor(MakeBox(x, x + 0.2, -0.5, 0.5, 0.1 * (i + 1))));
    scene.Renderer->AddActor(actors.back());
  }
  const Heights before(scene);
  for (const int i : { 0, 3, 4, 5, 6, 7, 8, 11 })
  {
    scene.Renderer->RemoveActor(actors[static_cast<size_t>(i)]);
  }
  const Heights fewer(scene);
  for (int i = 0; i < 12; ++i)
  {
    const bool gone = i == 0 || (i >= 3 && i <= 8) || i == 11;
    EXPECT_EQ(fewer.IsEmptyAt(-1.8 + 0.3 * i, 0.0), gone) << i;
  }
  for (const auto& actor : actors)
  {
    if (!scene.Renderer->HasViewProp(actor))
    {
      scene.Renderer->AddActor(actor);
    }
  }
  EXPECT_TRUE(Heights(scene) == before);
  EXPECT_EQ(scene.Casters->GetNumberOfTriangles(), 12 * 12);
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

//------------------------------------------------------------------------------
TEST(ShadowCasters, PlanesThatShadowNothingAreLeftOut)
{
  BakingScene scene;
  scene.Casters->EffectiveOnlyOn();
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.0, -2.0, 0.0);
  plane->SetPoint1(2.0, -2.0, 0.0);
  plane->SetPoint2(-2.0, 2.0, 0.0);
  scene.AddActor(plane);
  auto box = MakeActor(MakeBox(-0.5, 0.5, -0.5, 0.5, 0.5)); // from 0 to 0.5
  scene.Renderer->AddActor(box);
  {
    const Heights heights(scene);
    EXPECT_NEAR(heights.At(0.0, 0.0), 0.5, 1e-5);
    EXPECT_TRUE(heights.IsEmptyAt(1.5, 1.5));
  }
  box->SetPosition(0.0, 0.0, -0.1);
  EXPECT_NEAR(Heights(scene).At(1.5, 1.5), 0.0, 1e-5) << "the box dips into the plane";
  vtkShadowCasters::SetReceivesShadow(box, false);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(1.5, 1.5)) << "and receives nothing";
  scene.Casters->EffectiveOnlyOff();
  EXPECT_NEAR(Heights(scene).At(1.5, 1.5), 0.0, 1e-5) << "everything is asked for";
  scene.Casters->EffectiveOnlyOn();
  vtkShadowCasters::SetReceivesShadow(box, true);
  box->SetPosition(0.0, 0.0, 0.0);
  EXPECT_TRUE(Heights(scene).IsEmptyAt(1.5, 1.5));

  // From below the plane does shadow the box.
  vtkShadowMapView below = MakeView();
  below.Emitter = MakeDownwardEmitter(0.0, 0.0, -5.0, true);
  below.Emitter.Direction[2] = 1.0;
  below.Emitter.AxisU[0] = -1.0;
  EXPECT_LT(scene.BakeDepths(below, RESOLUTION)[0], 1.0f);
  // A light that is on both sides of it shines on the box through no plane.
  below.Emitter.Direction = { { 1.0, 0.0, 0.0 } };
  below.Emitter.AxisU = { { 0.0, -1.0, 0.0 } };
  below.Emitter.AxisV = { { 0.0, 0.0, 1.0 } };
  below.Emitter.HalfSize = { { 0.1, 0.1 } };
  below.Emitter.Center = { { -5.0, 0.0, 0.0 } };
  EXPECT_EQ(scene.Bake({ below }, RESOLUTION), 1);
}

//------------------------------------------------------------------------------
// Only the side towards the light is drawn of what is closed, and the map is the same.
TEST(ShadowCasters, ClosedSurfacesCastTheSameFromOneSide)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(16);
  vtkNew<vtkCubeSource> cube; // each corner three times
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkCylinderSource> open;
  open->CappingOff();
  vtkNew<vtkAppendPolyData> mixed; // parts that turn different ways, the outer one inwards
  mixed->AddInputConnection(cube->GetOutputPort());
  mixed->AddInputConnection(reversed->GetOutputPort());
  vtkNew<vtkPlaneSource> plane;
  const std::vector<std::pair<vtkAlgorithm*, bool>> shapes{ { sphere, true }, { cube, true },
    { reversed, true }, { open, false }, { mixed, false }, { plane, false } };
  for (const auto& shape : shapes)
  {
    for (const bool mirrored : { false, true })
    {
      BakingScene scene;
      auto actor = scene.AddActor(shape.first);
      vtkNew<vtkTransform> place;
      place->RotateWXYZ(40.0, 1.0, 0.3, 0.2);
      place->Scale(mirrored ? -1.5 : 1.5, 1.5, 1.2);
      actor->SetUserTransform(place);
      vtkShadowMapView view = MakeView();
      view.Emitter.Directional = false;
      view.Window = { { -0.3, 0.3, -0.3, 0.3 } };
      const auto both = scene.BakeDepths(view, RESOLUTION);
      ASSERT_EQ(scene.Casters->GetNumberOfClosedCasters(), 0) << "not looked at yet";
      scene.Casters->Update(scene.Renderer);
      scene.Casters->Update(scene.Renderer);
      EXPECT_EQ(scene.Casters->GetNumberOfClosedCasters(), shape.second ? 1 : 0)
        << shape.first->GetClassName();
      view.Near -= 1e-9; // bakes again
      const auto one = scene.BakeDepths(view, RESOLUTION);
      int covered = 0;
      for (size_t i = 0; i < both.size(); ++i)
      {
        ASSERT_NEAR(one[i], both[i], 1e-6) << shape.first->GetClassName() << " " << i;
        covered += both[i] < 1.0f ? 1 : 0;
      }
      EXPECT_GT(covered, 300);

      view.Emitter.Center = { { 0.0, 0.0, 0.0 } }; // inside
      view.Near = 0.01;
      const auto inside = scene.BakeDepths(view, RESOLUTION);
      EXPECT_EQ(inside[RESOLUTION * RESOLUTION / 2 + RESOLUTION / 2] < 1.0f, shape.first != plane);
    }
  }
}
