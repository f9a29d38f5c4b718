// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Maps are fitted to parts of a mesh as to meshes of their own.
#include "BakingScene.h"

#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"
#include "vtkShadowMapFitter.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using Body = vtkShadowCasters::Body;

vtkSmartPointer<vtkPlaneSource> MakeGround(int cells)
{
  auto ground = vtkSmartPointer<vtkPlaneSource>::New();
  ground->SetOrigin(-500.0, -500.0, 0.0);
  ground->SetPoint1(500.0, -500.0, 0.0);
  ground->SetPoint2(-500.0, 500.0, 0.0);
  ground->SetResolution(cells, cells);
  return ground;
}

vtkSmartPointer<vtkSphereSource> MakeBall(double x)
{
  auto ball = vtkSmartPointer<vtkSphereSource>::New();
  ball->SetCenter(x, 0.0, 1.0);
  ball->SetRadius(0.5);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  return ball;
}

std::vector<Body> BodiesOf(const std::vector<vtkAlgorithm*>& sources, bool joined)
{
  BakingScene scene;
  vtkNew<vtkAppendPolyData> all;
  for (vtkAlgorithm* source : sources)
  {
    if (joined)
    {
      all->AddInputConnection(source->GetOutputPort());
    }
    else
    {
      scene.AddActor(source);
    }
  }
  if (joined)
  {
    scene.AddActor(all);
  }
  scene.Window.GetOpenGL()->MakeCurrent();
  scene.Casters->Update(scene.Renderer);
  return scene.Casters->GetBodies();
}

vtkShadowMapView FitOf(const std::vector<Body>& bodies)
{
  vtkShadowMapView view;
  EXPECT_TRUE(vtkShadowMapFitter(bodies).Fit(MakeDownwardEmitter(0.3, 0.2, 6.0, false), view));
  return view;
}
}

//------------------------------------------------------------------------------
TEST(ShadowCasterClusters, OneMeshIsFittedAsItsPartsAre)
{
  for (const int cells : { 1, 3, 40 })
  {
    SCOPED_TRACE(cells);
    const auto ground = MakeGround(cells);
    const auto ball = MakeBall(0.0);
    const auto joined = BodiesOf({ ground, ball }, true);
    ASSERT_EQ(joined.size(), 2u);
    EXPECT_EQ(std::count_if(joined.begin(), joined.end(), [](const Body& b) { return b.Flat; }), 1);
    const vtkShadowMapView apart = FitOf(BodiesOf({ ground, ball }, false));
    const vtkShadowMapView fitted = FitOf(joined);
    for (size_t i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(fitted.Window[i], apart.Window[i], 1e-9);
    }
    EXPECT_NEAR(fitted.Near, apart.Near, 1e-9);
    EXPECT_NEAR(fitted.Far, apart.Far, 1e-9);
  }
}

//------------------------------------------------------------------------------
TEST(ShadowCasterClusters, ThingsFarApartArePartsAndWhatIsCompactStaysWhole)
{
  const auto ground = MakeGround(2);
  const auto left = MakeBall(-300.0);
  const auto right = MakeBall(300.0);
  EXPECT_EQ(BodiesOf({ left, right }, true).size(), 2u);
  EXPECT_EQ(BodiesOf({ left, ground, right }, true).size(), 3u);
  EXPECT_EQ(BodiesOf({ left }, true).size(), 1u);
  vtkNew<vtkCubeSource> slab;
  slab->SetBounds(-5.0, 5.0, -5.0, 5.0, -0.5, 0.5);
  EXPECT_EQ(BodiesOf({ slab }, true).size(), 1u);
  const auto near = MakeBall(1.2);
  const auto nearer = MakeBall(0.0);
  EXPECT_EQ(BodiesOf({ near, nearer }, true).size(), 1u) << "nothing is won by cutting";
}

//------------------------------------------------------------------------------
// Parts lie within the whole and hold all of it, wherever the prop is put.
TEST(ShadowCasterClusters, PartsMoveWithTheProp)
{
  BakingScene scene;
  vtkNew<vtkAppendPolyData> all;
  const auto ground = MakeGround(1);
  const auto ball = MakeBall(10.0);
  all->AddInputConnection(ground->GetOutputPort());
  all->AddInputConnection(ball->GetOutputPort());
  const auto actor = scene.AddActor(all);
  scene.Window.GetOpenGL()->MakeCurrent();
  scene.Casters->Update(scene.Renderer);
  actor->SetPosition(7.0, 0.0, 0.0);
  EXPECT_TRUE(scene.Casters->Update(scene.Renderer));
  const auto& bodies = scene.Casters->GetBodies();
  ASSERT_EQ(bodies.size(), 2u);
  const Body& thing = bodies[bodies[0].Flat ? 1 : 0];
  EXPECT_NEAR(thing.Bounds[0], 16.5, 1e-2);
  EXPECT_NEAR(thing.Bounds[1], 17.5, 1e-2);
  EXPECT_FALSE(scene.Casters->Update(scene.Renderer));
  vtkShadowCasters::SetReceivesShadow(actor, false);
  scene.Casters->Update(scene.Renderer);
  for (const Body& body : scene.Casters->GetBodies())
  {
    EXPECT_FALSE(body.Receives);
  }
}
