// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a frame may do, counted: nothing is built, baked or allocated that did not change.
#include "GLObjectCounter.h"
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 100;
const int Height = 75;

//------------------------------------------------------------------------------
/// What the pass counted between two moments.
struct Work
{
  vtkTypeInt64 MapsBaked;
  vtkTypeInt64 ShaderBuilds;
  vtkTypeInt64 MapperShaderBuilds;
  vtkTypeInt64 Allocations;
  vtkTypeInt64 VisibilityFrames;
};

//------------------------------------------------------------------------------
Work WorkSince(vtkSoftShadowPass* pass, const vtkSoftShadowStatistics& before)
{
  const vtkSoftShadowStatistics& now = pass->GetStatistics();
  return { now.MapsBaked - before.MapsBaked, now.ShaderBuilds - before.ShaderBuilds,
    now.MapperShaderBuilds - before.MapperShaderBuilds, now.Allocations - before.Allocations,
    now.VisibilityFrames - before.VisibilityFrames };
}

class Counts : public testing::TestWithParam<Technique>
{
protected:
  void SetUp() override
  {
    this->Pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    this->Scene = MakeBallScene();
  }

  /// Renders and returns what the frame did.
  Work Frame(Stage& stage)
  {
    const vtkSoftShadowStatistics before = this->Pass->GetStatistics();
    stage.Render();
    return WorkSince(this->Pass, before);
  }

  vtkSmartPointer<vtkSoftShadowPass> Pass;
  BallScene Scene;
};

//------------------------------------------------------------------------------
void ExpectNothingBuilt(const Work& work, const std::string& what)
{
  EXPECT_EQ(work.ShaderBuilds, 0) << what;
  EXPECT_EQ(work.MapperShaderBuilds, 0) << what;
  EXPECT_EQ(work.Allocations, 0) << what;
}

//------------------------------------------------------------------------------
/// Boxes that share nothing but their data: an actor and a mapper each. All are in view: a mapper
/// builds its program when it is seen for the first time.
std::vector<vtkSmartPointer<vtkActor>> AddThousandActors(vtkRenderer* renderer)
{
  const auto box = MakeQuads(BoxQuads({ { -0.02, 0.02, -0.02, 0.02, 0.0, 0.04 } }));
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int i = 0; i < 1000; ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(box);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->SetPosition(0.05 * (i % 40) - 1.0, 0.06 * ((i / 40) % 25) - 0.7, 0.02 + 0.0005 * i);
    renderer->AddActor(actor);
    actors.push_back(actor);
  }
  return actors;
}

}

//------------------------------------------------------------------------------
// An assembly pokes matrices into its parts whenever it is drawn, which is no change of the scene.
TEST_P(Counts, AssemblyAtRestCostsNothing)
{
  this->Scene.Renderer->RemoveActor(this->Scene.Ground);
  const Quad ground = { { -2.0, -2.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 } };
  this->Scene.Renderer->AddViewProp(MakeReceiver(Drawing::Assembly, ground));
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  stage.Render();
  stage.Render();
  const Work work = this->Frame(stage);
  EXPECT_EQ(work.VisibilityFrames, 0);
  EXPECT_EQ(work.MapsBaked, 0);
}

//------------------------------------------------------------------------------
TEST_P(Counts, ThousandActorsAndAMovingCamera)
{
  const auto actors = AddThousandActors(this->Scene.Renderer);
  this->Scene.Renderer->ResetCameraClippingRange();
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Work first = this->Frame(stage);
  EXPECT_EQ(first.MapsBaked > 0, this->GetParam().HasMaps);
  EXPECT_GT(first.ShaderBuilds, 0);
  EXPECT_GE(first.MapperShaderBuilds, 1000);
  EXPECT_GT(first.Allocations, 0);
  const GLObjectCounts objects = CountGLObjects(stage.GetWindow().GetOpenGL());
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Scene.Renderer->GetActiveCamera()->Azimuth(7.0);
    this->Scene.Renderer->ResetCameraClippingRange();
    const Work work = this->Frame(stage);
    EXPECT_EQ(work.VisibilityFrames, 1);
    EXPECT_EQ(work.MapsBaked, 0) << "frame " << frame;
    ExpectNothingBuilt(work, "frame " + std::to_string(frame));
  }
  EXPECT_EQ(objects, CountGLObjects(stage.GetWindow().GetOpenGL()));

  // One of them moves: every map once, and no program.
  actors[123]->AddPosition(0.05, 0.0, 0.0);
  const Work moved = this->Frame(stage);
  EXPECT_EQ(moved.MapsBaked, first.MapsBaked);
  ExpectNothingBuilt(moved, "moved actor");
  EXPECT_EQ(this->Frame(stage).MapsBaked, 0) << "the frame after the move";
}

//------------------------------------------------------------------------------
TEST_P(Counts, StillFrameDrawsNoVisibility)
{
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  this->Frame(stage);
  const Picture visibility = stage.RenderVisibility(this->Scene.Lamp);
  const Work work = this->Frame(stage);
  EXPECT_EQ(work.VisibilityFrames, 0);
  EXPECT_EQ(work.MapsBaked, 0);
  ExpectNothingBuilt(work, "still frame");
  EXPECT_TRUE(Matches(visibility, stage.RenderVisibility(this->Scene.Lamp), Identical));
}

//------------------------------------------------------------------------------
TEST_P(Counts, OneBakeForEachChangeOfACaster)
{
  auto* source = vtkSphereSource::SafeDownCast(this->Scene.Ball->GetMapper()->GetInputAlgorithm());
  ASSERT_NE(source, nullptr);
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Work first = this->Frame(stage);
  ASSERT_EQ(first.MapsBaked > 0, this->GetParam().HasMaps);

  this->Scene.Ball->AddPosition(0.2, 0.0, 0.1);
  EXPECT_EQ(this->Frame(stage).MapsBaked, first.MapsBaked) << "moved";
  EXPECT_EQ(this->Frame(stage).MapsBaked, 0) << "after the move";

  source->SetRadius(0.4);
  EXPECT_EQ(this->Frame(stage).MapsBaked, first.MapsBaked) << "mapper's input changed";
  EXPECT_EQ(this->Frame(stage).MapsBaked, 0) << "after the change";

  this->Scene.Ball->VisibilityOff();
  const Work hidden = this->Frame(stage);
  EXPECT_EQ(hidden.MapsBaked, 0) << "nothing casts: nothing is baked";
  this->Scene.Ball->VisibilityOn();
  EXPECT_LE(this->Frame(stage).MapsBaked, first.MapsBaked) << "visible again";
}

//------------------------------------------------------------------------------
TEST_P(Counts, ColoursBakeNothing)
{
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  this->Frame(stage);
  this->Scene.Ball->GetProperty()->SetColor(1.0, 0.0, 0.0);
  this->Scene.Lamp->SetColor(1.0, 0.9, 0.8);
  this->Scene.Lamp->SetIntensity(0.7);
  EXPECT_LE(this->Frame(stage).ShaderBuilds, 0);
  EXPECT_EQ(this->Frame(stage).MapsBaked, 0);
}

//------------------------------------------------------------------------------
TEST_P(Counts, OneBakeForAMovedLight)
{
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Work first = this->Frame(stage);
  this->Scene.Lamp->SetPosition(1.0, 1.2, 4.0);
  const Work moved = this->Frame(stage);
  EXPECT_EQ(moved.MapsBaked, first.MapsBaked);
  ExpectNothingBuilt(moved, "moved light");
  EXPECT_EQ(this->Frame(stage).MapsBaked, 0) << "after the move";
}

//------------------------------------------------------------------------------
TEST_P(Counts, NoCasterNoMap)
{
  this->Scene.Renderer->RemoveActor(this->Scene.Ball);
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Work first = this->Frame(stage);
  EXPECT_EQ(first.MapsBaked, 0);
  const Picture visibility = stage.RenderVisibility(this->Scene.Lamp);
  EXPECT_EQ(CountShadowed(visibility), 0);
  EXPECT_LT(CountWithoutValue(visibility), Width * Height / 2);
}

INSTANTIATE_TEST_SUITE_P(Techniques, Counts, testing::ValuesIn(AllTechniques()), NameOfTechnique);
