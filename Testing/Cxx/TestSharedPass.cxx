// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// One pass object for several renderers: each frame is that of a pass of its own.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 80;
const int Height = 60;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakePass(const Technique& technique)
{
  auto pass = technique.Make(Effort::Quick, Weights::Mean);
  pass->SetMapSize(128);
  return pass;
}

//------------------------------------------------------------------------------
/// Unlike MakeBallScene in light and casters, so that nothing can be mistaken for the other's.
BallScene MakeOtherScene()
{
  BallScene scene = MakeBallScene(0.8);
  scene.Ball->SetPosition(0.4, 0.2, 0.3);
  scene.Renderer->AddLight(MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2));
  return scene;
}

//------------------------------------------------------------------------------
Picture DrawAlone(const BallScene& scene, vtkSoftShadowPass* pass, int width, int height)
{
  Stage stage(scene.Renderer, pass, width, height);
  return stage.RenderColors();
}

//------------------------------------------------------------------------------
/// Colours of a window's half.
Picture CutHalf(const Picture& whole, int half)
{
  Picture part(whole.Width / 2, whole.Height, 3);
  for (int y = 0; y < part.Height; ++y)
  {
    const auto row = whole.Values.begin() + (y * whole.Width + half * part.Width) * 3;
    std::copy(row, row + part.Width * 3, part.Values.begin() + y * part.Width * 3);
  }
  return part;
}

class SharedPass : public testing::TestWithParam<Technique>
{
};

}

//------------------------------------------------------------------------------
TEST_P(SharedPass, TwoRenderersInAWindow)
{
  const BallScene scenes[2] = { MakeBallScene(), MakeOtherScene() };
  Picture expected[2];
  for (int i = 0; i < 2; ++i)
  {
    expected[i] = DrawAlone(scenes[i], MakePass(this->GetParam()), Width, Height);
    scenes[i].Renderer->SetViewport(0.5 * i, 0.0, 0.5 * (i + 1), 1.0);
  }
  ASSERT_FALSE(Matches(expected[0], expected[1], SameButForEdges));

  const auto pass = MakePass(this->GetParam());
  OffscreenWindow window(2 * Width, Height);
  for (const BallScene& scene : scenes)
  {
    window.Add(scene.Renderer);
    UsePass(scene.Renderer, pass);
  }
  for (int frame = 0; frame < 3; ++frame)
  {
    window.Render();
    const Picture whole = window.Read();
    for (int i = 0; i < 2; ++i)
    {
      EXPECT_TRUE(Matches(CutHalf(whole, i), expected[i], SameButForEdges)) << frame << " " << i;
    }
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  pass->ReleaseGraphicsResources(window.Get());
  for (const BallScene& scene : scenes)
  {
    scene.Renderer->SetPass(nullptr);
    window.Remove(scene.Renderer);
  }
}

//------------------------------------------------------------------------------
// The windows draw by turns, and the second goes before the first: what it releases is its own.
TEST_P(SharedPass, TwoWindows)
{
  const BallScene scenes[2] = { MakeBallScene(), MakeOtherScene() };
  const int sizes[2][2] = { { Width, Height }, { Height, Width } };
  Picture expected[2];
  for (int i = 0; i < 2; ++i)
  {
    expected[i] = DrawAlone(scenes[i], MakePass(this->GetParam()), sizes[i][0], sizes[i][1]);
  }
  const auto pass = MakePass(this->GetParam());
  std::unique_ptr<OffscreenWindow> windows[2];
  for (int i = 0; i < 2; ++i)
  {
    windows[i] = std::make_unique<OffscreenWindow>(sizes[i][0], sizes[i][1]);
    windows[i]->Add(scenes[i].Renderer);
    UsePass(scenes[i].Renderer, pass);
  }
  const auto expectRight = [&](int i, const char* when)
  {
    windows[i]->Render();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << when << i;
    EXPECT_TRUE(Matches(windows[i]->Read(), expected[i], SameButForEdges)) << when << i;
  };
  for (const char* when : { "first frame of ", "second frame of " })
  {
    expectRight(0, when);
    expectRight(1, when);
  }
  expectRight(0, "before the other window goes ");
  scenes[1].Renderer->SetPass(nullptr);
  windows[1]->Remove(scenes[1].Renderer);
  windows[1].reset();
  expectRight(0, "after the other window went ");
  scenes[0].Renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(windows[0]->Get());
  windows[0]->Remove(scenes[0].Renderer);
}

//------------------------------------------------------------------------------
// A window that never drew with the pass, or no longer does, may still tell it to release.
TEST_P(SharedPass, ReleaseInAnotherWindow)
{
  const BallScene scenes[2] = { MakeBallScene(), MakeOtherScene() };
  OffscreenWindow bystander(Width, Height);
  bystander.Add(scenes[1].Renderer);
  bystander.Render();
  Stage stage(scenes[0].Renderer, MakePass(this->GetParam()), Width, Height);
  const Picture before = stage.RenderColors();
  bystander.Render(); // its context is current
  const Picture untouched = bystander.Read();
  stage.GetPass()->ReleaseGraphicsResources(bystander.Get());
  EXPECT_TRUE(bystander.Get()->IsCurrent());
  bystander.Render();
  EXPECT_TRUE(Matches(bystander.Read(), untouched, Identical));
  EXPECT_TRUE(Matches(stage.RenderColors(), before, Identical));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  bystander.Remove(scenes[1].Renderer);
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, SharedPass, testing::ValuesIn(AllTechniques()), NameOfTechnique);
