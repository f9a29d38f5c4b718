// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Which sides of what is closed are drawn, and which planes are left out.
#include "CasterHeights.h"

#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkPlaneSource.h"
#include "vtkProperty.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

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
