// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Thousands of frames in which everything changes: neither memory nor OpenGL objects grow, and OpenGL
// has nothing to complain about.
#include "GLObjectCounter.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include <unistd.h>

using namespace SoftShadowsTesting;

namespace
{

const int FramesPerRound = 40;

//------------------------------------------------------------------------------
/// Resident memory in MiB; 0 where the system does not say.
double GetResidentMemory()
{
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

//------------------------------------------------------------------------------
int CountOpenGLErrors()
{
  int count = 0;
  while (count < 100 && glGetError() != GL_NO_ERROR)
  {
    ++count;
  }
  return count;
}

//------------------------------------------------------------------------------
/// Cheap maps: what is counted does not depend on their size.
vtkSmartPointer<vtkSoftShadowPass> MakeTinyPass(const Technique& technique)
{
  auto pass = technique.Make(Effort::Quick, Weights::Mean);
  pass->SetMapSize(64);
  return pass;
}

//------------------------------------------------------------------------------
/// A round of frames, at whose end all is as at its beginning.
void RenderRound(BallScene& scene, Stage& stage, vtkLight* second)
{
  for (int frame = 0; frame < FramesPerRound; ++frame)
  {
    switch (frame % 8)
    {
      case 0:
        stage.GetWindow().Resize(24, 40);
        break;
      case 1:
        scene.Renderer->AddLight(second);
        break;
      case 2:
        scene.Renderer->RemoveActor(scene.Ball);
        break;
      case 3:
        scene.Lamp->SwitchOff();
        break;
      case 4:
        scene.Renderer->AddActor(scene.Ball);
        scene.Lamp->SwitchOn();
        break;
      case 5:
        stage.GetWindow().Resize(32, 24);
        scene.Ball->AddPosition(0.0, 0.0, 0.01);
        break;
      case 6:
        scene.Renderer->RemoveLight(second);
        break;
      default:
        scene.Renderer->GetActiveCamera()->Azimuth(3.0);
    }
    stage.Render();
  }
  scene.Ball->SetPosition(0.0, 0.0, 0.0);
  scene.Renderer->GetActiveCamera()->Azimuth(-3.0 * FramesPerRound / 8);
}

}

//------------------------------------------------------------------------------
// 8 techniques, 6 rounds of 40 frames each, the pass exchanged and off in between.
TEST(Lifetime, ManyFramesLeaveNothingBehind)
{
  BallScene scene = MakeBallScene();
  const auto second = MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2);
  Stage stage(scene.Renderer, nullptr, 32, 24);
  stage.Render();
  std::vector<GLObjectCounts> counts;
  std::vector<double> memory;
  for (int round = 0; round < 6; ++round)
  {
    for (const Technique& technique : AllTechniques())
    {
      stage.SetPass(MakeTinyPass(technique));
      RenderRound(scene, stage, second);
      stage.SetPass(nullptr);
      stage.Render();
    }
    counts.push_back(CountGLObjects(stage.GetWindow().GetOpenGL()));
    memory.push_back(GetResidentMemory());
    EXPECT_EQ(CountOpenGLErrors(), 0) << "round " << round;
  }
  // The first round fills VTK's cache of shaders and what allocators keep.
  EXPECT_EQ(counts.back(), counts.front());
  EXPECT_LT(memory.back() - memory[1], 8.0) << "MiB in 1280 frames";
}

//------------------------------------------------------------------------------
// One pass of each technique stays while windows come and go.
TEST(Lifetime, WindowsComeAndGo)
{
  std::vector<vtkSmartPointer<vtkSoftShadowPass>> passes;
  for (const Technique& technique : AllTechniques())
  {
    passes.push_back(MakeTinyPass(technique));
  }
  BallScene scene = MakeBallScene();
  const auto second = MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2);
  std::vector<double> memory;
  for (int round = 0; round < 5; ++round)
  {
    for (const auto& pass : passes)
    {
      Stage stage(scene.Renderer, pass, 32, 24);
      RenderRound(scene, stage, second);
      EXPECT_EQ(CountOpenGLErrors(), 0);
    }
    memory.push_back(GetResidentMemory());
  }
  // Windows themselves leave something behind in Mesa: a tenth of a MiB each would not be the passes.
  EXPECT_LT(memory.back() - memory[1], 24.0) << "MiB in 24 windows";
}

//------------------------------------------------------------------------------
// Two windows by turns, with a pass each.
TEST(Lifetime, TwoWindowsByTurns)
{
  for (const Technique& technique : AllTechniques())
  {
    SCOPED_TRACE(technique.Name);
    const BallScene first = MakeBallScene();
    const BallScene other = MakeBallScene(0.8);
    Stage stages[2] = { { first.Renderer, MakeTinyPass(technique), 40, 30 },
      { other.Renderer, MakeTinyPass(technique), 30, 40 } };
    const Picture before = stages[0].RenderVisibility(first.Lamp);
    GLObjectCounts counts[2];
    for (int frame = 0; frame < 10; ++frame)
    {
      stages[0].Render();
      other.Ball->AddPosition(0.02, 0.0, 0.0);
      stages[1].Render();
      if (frame == 1)
      {
        counts[1] = CountGLObjects(stages[1].GetWindow().GetOpenGL());
      }
    }
    EXPECT_EQ(CountGLObjects(stages[1].GetWindow().GetOpenGL()), counts[1]);
    const Picture after = stages[0].RenderVisibility(first.Lamp);
    ASSERT_EQ(after.Values.size(), before.Values.size());
    EXPECT_EQ(CountShadowed(after), CountShadowed(before));
    EXPECT_EQ(CountOpenGLErrors(), 0);
  }
}
