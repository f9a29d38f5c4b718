// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What casts follows the scene, and only what changes is done anew.
#include "CasterHeights.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPoints.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

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
TEST(ShadowCasters, KeysOfVTKCountWhereThereIsNoneOfOurs)
{
  static vtkInformationIntegerKey* occluder =
    vtkInformationIntegerKey::MakeKey("OCCLUDER", "vtkShadowMapBakerPass");
  static vtkInformationIntegerKey* receiver =
    vtkInformationIntegerKey::MakeKey("RECEIVER", "vtkShadowMapBakerPass");
  BakingScene scene;
  auto actor = MakeActor(MakeBox(-0.5, 0.5, -0.5, 0.5, 0.5));
  scene.Renderer->AddActor(actor);
  vtkNew<vtkInformation> keys;
  const auto expect = [&](bool casts, bool receives, const char* what)
  {
    actor->SetPropertyKeys(keys);
    EXPECT_EQ(Heights(scene).IsEmptyAt(0.0, 0.0), !casts) << what;
    EXPECT_EQ(vtkShadowCasters::GetCastsShadow(actor), casts) << what;
    EXPECT_EQ(vtkShadowCasters::GetReceivesShadow(actor), receives) << what;
  };
  expect(true, true, "none");
  keys->Set(receiver, 1);
  expect(false, true, "a receiver");
  keys->Set(occluder, 0);
  expect(true, true, "both, whatever their values");
  keys->Remove(receiver);
  expect(true, false, "an occluder");
  keys->Set(vtkShadowCasters::RECEIVES_SHADOW(), 1);
  expect(true, true, "ours first, of receiving");
  keys->Set(vtkShadowCasters::CASTS_SHADOW(), 0);
  expect(false, true, "ours first, of casting");
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
