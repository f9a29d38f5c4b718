// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Props that draw another level of detail while one interacts: receivers and picture show the same
// level in every frame, and a camera that comes to rest leaves no coarse shadow behind.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkImageData.h"
#include "vtkLODActor.h"
#include "vtkLODProp3D.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkQuadricLODActor.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 96;
const int Height = 72;
const double StillRate = 1e-4;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyDataMapper> MakeBallMapper(int resolution)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 0.0, 0.9);
  ball->SetRadius(0.5);
  ball->SetThetaResolution(resolution);
  ball->SetPhiResolution(resolution);
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(ball->GetOutputPort());
  return mapper;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkProp> MakeLODActor()
{
  auto actor = vtkSmartPointer<vtkLODActor>::New();
  actor->SetMapper(MakeBallMapper(200));
  actor->AddLODMapper(MakeBallMapper(5));
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkProp> MakeQuadricLODActor()
{
  auto actor = vtkSmartPointer<vtkQuadricLODActor>::New();
  actor->SetMapper(MakeBallMapper(64));
  return actor;
}

//------------------------------------------------------------------------------
/// The ball scene, the ball exchanged, in a window with an interactor, drawn at any rate.
class LevelScene
{
public:
  explicit LevelScene(vtkProp* body)
    : Scene(MakeBallScene())
    , StageOfIt(this->Scene.Renderer, MakePass(), Width, Height)
  {
    this->Scene.Renderer->RemoveActor(this->Scene.Ball);
    this->Scene.Renderer->AddViewProp(body);
    this->Interactor->SetRenderWindow(this->StageOfIt.GetWindow().Get());
    this->SetRate(StillRate);
  }

  static vtkSmartPointer<vtkSoftShadowPass> MakePass()
  {
    return AllTechniques()[1].Make(Effort::Quick, Weights::Mean);
  }

  void SetRate(double framesPerSecond)
  {
    // vtkQuadricLODActor compares the time it gets with the interactor's rate.
    this->Interactor->SetDesiredUpdateRate(framesPerSecond < 1.0 ? 75.0 : framesPerSecond);
    this->StageOfIt.GetWindow().Get()->SetDesiredUpdateRate(framesPerSecond);
  }

  Picture Draw() { return this->StageOfIt.RenderVisibility(this->Scene.Lamp); }

  /// What a pass draws that has seen nothing before.
  Picture DrawFresh()
  {
    this->StageOfIt.SetPass(MakePass());
    return this->Draw();
  }

  /// Pixels where only one of the receivers and the picture has a surface.
  int CountUnlikeReceivers()
  {
    const Picture depth = PictureOf(this->StageOfIt.GetPass()->GetDepthImage());
    vtkNew<vtkFloatArray> z;
    this->StageOfIt.GetWindow().Get()->GetZbufferData(0, 0, Width - 1, Height - 1, z);
    int count = 0;
    for (vtkIdType i = 0; i < z->GetNumberOfTuples(); ++i)
    {
      const bool seen = z->GetValue(i) < 1.0f;
      count += seen == std::isnan(depth.Values[static_cast<std::size_t>(i)]) ? 1 : 0;
    }
    return count;
  }

  BallScene Scene;
  Stage StageOfIt;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;
};

}

//------------------------------------------------------------------------------
// The last frame of an interaction and the still one after it have the same camera, and nothing has
// changed but the time that props are given.
TEST(LevelsOfDetail, ARestingCameraHasTheShadowsOfTheFineLevel)
{
  LevelScene scene(MakeQuadricLODActor());
  const Picture still = scene.Draw();
  scene.SetRate(75.0);
  const Picture moving = scene.Draw();
  EXPECT_GT(Compare(still, moving, SameButForEdges).RootMeanSquare, 0.02) << "there is one level";
  EXPECT_TRUE(Matches(moving, scene.DrawFresh(), Identical));
  scene.SetRate(StillRate);
  EXPECT_TRUE(Matches(scene.Draw(), still, Identical));
  scene.SetRate(75.0);
  EXPECT_TRUE(Matches(scene.Draw(), moving, Identical));
}

//------------------------------------------------------------------------------
// What VTK's own frame shows at that rate, and the receivers: the same body.
TEST(LevelsOfDetail, ReceiversShowTheLevelThatIsDrawn)
{
  for (const auto& make : { MakeLODActor, MakeQuadricLODActor })
  {
    const auto body = make();
    SCOPED_TRACE(body->GetClassName());
    LevelScene scene(body);
    scene.Scene.Renderer->RemoveActor(scene.Scene.Ground); // silhouettes against nothing
    for (const double rate : { StillRate, 75.0, StillRate, 1e9, StillRate })
    {
      scene.SetRate(rate);
      scene.Draw(); // vtkLODActor tries levels that it has no time of
      scene.Draw();
      EXPECT_EQ(scene.CountUnlikeReceivers(), 0) << "rate " << rate;
    }
  }
}

//------------------------------------------------------------------------------
// A frame in which nothing changes its level is drawn once.
TEST(LevelsOfDetail, AtRestNothingIsDrawnAgain)
{
  LevelScene scene(MakeQuadricLODActor());
  const auto count = [&scene]
  { return scene.StageOfIt.GetPass()->GetStatistics().VisibilityFrames; };
  for (const double rate : { StillRate, StillRate, 75.0, 75.0, StillRate })
  {
    scene.SetRate(rate);
    scene.Draw(); // vtkQuadricLODActor makes its level of detail, and has changed in the next frame
  }
  const vtkTypeInt64 frames = count();
  scene.Draw();
  scene.Draw();
  EXPECT_EQ(count(), frames);
  scene.SetRate(75.0);
  scene.Draw();
  scene.Draw();
  EXPECT_EQ(count(), frames + 1);
}

//------------------------------------------------------------------------------
// vtkLODProp3D draws and casts the level that is selected, from the frame on in which it is.
TEST(LevelsOfDetail, ALevelThatIsSelectedCastsAtOnce)
{
  auto body = vtkSmartPointer<vtkLODProp3D>::New();
  const auto fineMapper = MakeBallMapper(64);
  const auto coarseMapper = MakeBallMapper(5);
  const int fine = body->AddLOD(fineMapper, 0.0);
  const int coarse = body->AddLOD(coarseMapper, 0.0);
  body->AutomaticLODSelectionOff();
  body->SetSelectedLODID(fine);
  LevelScene scene(body);
  const Picture first = scene.Draw();
  body->SetSelectedLODID(coarse);
  const Picture second = scene.Draw();
  EXPECT_GT(Compare(first, second, SameButForEdges).RootMeanSquare, 0.02);
  EXPECT_TRUE(Matches(second, scene.DrawFresh(), SameToRounding));
  body->SetSelectedLODID(fine);
  EXPECT_TRUE(Matches(scene.Draw(), first, SameToRounding));
}

//------------------------------------------------------------------------------
// The frame in which a resting picture would be done is the one in which another level appears: it is
// not done.
TEST(LevelsOfDetail, AMeanOfTheLevelBeforeIsNoNews)
{
  LevelScene scene(MakeQuadricLODActor());
  for (const double rate : { StillRate, 75.0, StillRate, StillRate })
  {
    scene.SetRate(rate);
    scene.Draw(); // the level of detail is made, and all is as at rest
  }
  vtkSoftShadowPass* pass = scene.StageOfIt.GetPass();
  pass->ProgressiveOn();
  pass->SetProgressiveTolerance(1.0);
  pass->SetProgressivePoints(1024);
  int news = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&news);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  pass->AddObserver(vtkSoftShadowPass::ConvergedEvent, counter);
  scene.Draw();
  scene.SetRate(75.0);
  scene.Draw();
  EXPECT_TRUE(pass->GetRefining());
  EXPECT_EQ(news, 0);
  scene.Draw();
  EXPECT_TRUE(pass->GetConverged());
  EXPECT_EQ(news, 1);
}
