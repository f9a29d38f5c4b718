// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A pass, its renderer and its window die in any order: nothing of another window is touched, nothing
// is left behind and nobody complains.
#include "Faults.h"
#include "GLObjectCounter.h"
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkShadowDepthBakerPass.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 32;
const int Height = 24;

/// What the renderer has to do with the pass when the first of them dies.
enum class Bond
{
  Attached,
  Detached,
  Shared, ///< attached, and another window drew with the same pass before
};

//------------------------------------------------------------------------------
/// A window that outlives all the others, with objects whose names are those of the others, too.
class Bystander
{
public:
  Bystander()
    : Scene(MakeBallScene(0.8))
    , Window(Height, Width)
  {
    this->Window.Add(this->Scene.Renderer);
  }
  ~Bystander()
  {
    this->Scene.Renderer->SetPass(nullptr);
    this->Window.Remove(this->Scene.Renderer);
  }
  Bystander(const Bystander&) = delete;
  Bystander& operator=(const Bystander&) = delete;

  void Use(vtkRenderPass* pass)
  {
    UsePass(this->Scene.Renderer, pass);
    this->Window.Render();
  }

  /// Fills the context with textures, buffers and framebuffers, as an application's own.
  void Begin()
  {
    this->Window.Render();
    for (unsigned int i = 0; i < Own; ++i)
    {
      glGenTextures(1, &this->Textures[i]);
      glBindTexture(GL_TEXTURE_2D_ARRAY, this->Textures[i]);
      glGenBuffers(1, &this->Buffers[i]);
      glBindBuffer(GL_COPY_READ_BUFFER, this->Buffers[i]);
      glGenFramebuffers(1, &this->Framebuffers[i]);
      glGenQueries(1, &this->Queries[i]);
      glGenVertexArrays(1, &this->VertexArrays[i]);
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    this->Window.GetOpenGL()->GetState()->Reset();
    this->Picture = this->Draw();
    this->Objects = CountGLObjects(this->Window.GetOpenGL());
  }

  void MakeCurrent() { this->Window.GetOpenGL()->MakeCurrent(); }

  void ExpectUntouched()
  {
    EXPECT_EQ(CountGLObjects(this->Window.GetOpenGL()), this->Objects);
    EXPECT_TRUE(Matches(this->Draw(), this->Picture, Identical));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    for (unsigned int i = 0; i < Own; ++i)
    {
      glDeleteTextures(1, &this->Textures[i]);
      glDeleteBuffers(1, &this->Buffers[i]);
      glDeleteFramebuffers(1, &this->Framebuffers[i]);
      glDeleteQueries(1, &this->Queries[i]);
      glDeleteVertexArrays(1, &this->VertexArrays[i]);
    }
  }

private:
  static const unsigned int Own = 64;
  BallScene Scene;
  OffscreenWindow Window;
  SoftShadowsTesting::Picture Picture;
  GLObjectCounts Objects;
  unsigned int Textures[Own];
  unsigned int Buffers[Own];
  unsigned int Framebuffers[Own];
  unsigned int Queries[Own];
  unsigned int VertexArrays[Own];

  SoftShadowsTesting::Picture Draw()
  {
    this->Window.Render();
    return this->Window.Read();
  }
};

//------------------------------------------------------------------------------
/// The three that die; Bystander's context is current whenever one does.
class Mortals
{
public:
  Mortals(vtkSmartPointer<vtkRenderPass> pass, Bond bond)
    : Scene(MakeBallScene())
    , Window(std::make_unique<OffscreenWindow>(Width, Height))
    , Pass(std::move(pass))
  {
    this->Window->Add(this->Scene.Renderer);
    this->Window->Render();
    this->Plain = CountGLObjects(this->Window->GetOpenGL());
    UsePass(this->Scene.Renderer, this->Pass);
    this->Window->Render();
    EXPECT_NE(CountGLObjects(this->Window->GetOpenGL()), this->Plain) << "it makes nothing";
    if (bond == Bond::Detached)
    {
      this->Scene.Renderer->SetPass(nullptr);
    }
  }

  /// P, R or W.
  void Kill(char who, Bystander& bystander)
  {
    bystander.MakeCurrent();
    switch (who)
    {
      case 'P':
        this->KillPass(bystander);
        break;
      case 'R':
        if (this->Window)
        {
          this->Window->Remove(this->Scene.Renderer);
        }
        this->Scene = BallScene();
        break;
      default:
        this->Window.reset();
    }
  }

private:
  BallScene Scene;
  std::unique_ptr<OffscreenWindow> Window;
  vtkSmartPointer<vtkRenderPass> Pass;
  GLObjectCounts Plain;

  void KillPass(Bystander& bystander)
  {
    if (this->Scene.Renderer)
    {
      this->Scene.Renderer->SetPass(nullptr);
      if (this->Window)
      {
        this->Window->Render(); // until then mappers hold the pass that they were drawn by
      }
    }
    bystander.MakeCurrent();
    const vtkWeakPointer<vtkRenderPass> weak = this->Pass.GetPointer();
    this->Pass = nullptr;
    EXPECT_TRUE(!weak || (this->Scene.Renderer && !this->Window)) << "somebody holds it";
    this->ExpectNothingLeft();
  }

  /// Programs stay in VTK's cache; what is the scene's goes with its renderer.
  void ExpectNothingLeft()
  {
    if (!this->Window)
    {
      return;
    }
    GLObjectCounts now = CountGLObjects(this->Window->GetOpenGL());
    EXPECT_LE(now.Textures, this->Plain.Textures);
    EXPECT_LE(now.Buffers, this->Plain.Buffers);
    EXPECT_LE(now.Framebuffers, this->Plain.Framebuffers);
    EXPECT_LE(now.Renderbuffers, this->Plain.Renderbuffers);
    EXPECT_LE(now.VertexArrays, this->Plain.VertexArrays);
    EXPECT_LE(now.Queries, this->Plain.Queries);
    EXPECT_LE(now.TextureUnits, this->Plain.TextureUnits);
  }
};

//------------------------------------------------------------------------------
void TryAllOrders(const std::function<vtkSmartPointer<vtkRenderPass>()>& make)
{
  const char* const bonds[] = { "attached", "detached", "shared" };
  for (const Bond bond : { Bond::Attached, Bond::Detached, Bond::Shared })
  {
    std::string order = "PRW";
    do
    {
      SCOPED_TRACE(bonds[static_cast<int>(bond)] + (" " + order));
      Messages messages;
      Bystander bystander;
      {
        vtkSmartPointer<vtkRenderPass> pass = make();
        if (bond == Bond::Shared)
        {
          bystander.Use(pass);
        }
        Mortals mortals(pass, bond);
        if (bond == Bond::Shared)
        {
          bystander.Use(nullptr);
        }
        bystander.Begin();
        pass = nullptr;
        for (const char who : order)
        {
          mortals.Kill(who, bystander);
        }
      }
      bystander.ExpectUntouched();
      EXPECT_EQ(messages.Get(), "");
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

class DeathOrders : public testing::TestWithParam<Technique>
{
};

}

//------------------------------------------------------------------------------
TEST_P(DeathOrders, TouchNothingElse)
{
  TryAllOrders(
    [this]() -> vtkSmartPointer<vtkRenderPass>
    {
      auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
      pass->SetMapSize(64);
      pass->ProgressiveOn();
      return pass;
    });
}

//------------------------------------------------------------------------------
TEST(DeathOrdersOfTheBaker, TouchNothingElse)
{
  TryAllOrders([]() -> vtkSmartPointer<vtkRenderPass>
    { return vtkSmartPointer<vtkShadowDepthBakerPass>::New(); });
}

//------------------------------------------------------------------------------
// Render, another pass, close the window, open another one, let the first pass go.
TEST_P(DeathOrders, DetachedPassLeavesTheNextWindowAlone)
{
  const BallScene first = MakeBallScene();
  auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
  pass->SetMapSize(64);
  {
    OffscreenWindow window(Width, Height);
    window.Add(first.Renderer);
    UsePass(first.Renderer, pass);
    window.Render();
    first.Renderer->SetPass(nullptr);
    window.Remove(first.Renderer);
  }
  const BallScene second = MakeBallScene();
  auto other = this->GetParam().Make(Effort::Quick, Weights::Mean);
  other->SetMapSize(64);
  Stage stage(second.Renderer, other, Width, Height);
  const Picture before = stage.RenderColors();
  const GLObjectCounts objects = CountGLObjects(stage.GetWindow().GetOpenGL());
  pass = nullptr;
  EXPECT_EQ(CountGLObjects(stage.GetWindow().GetOpenGL()), objects);
  EXPECT_TRUE(Matches(stage.RenderColors(), before, Identical));
  other->Modified();
  EXPECT_TRUE(Matches(stage.RenderColors(), before, Identical));
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, DeathOrders, testing::ValuesIn(EveryTechnique()), NameOfTechnique);
