// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A frame leaves everything as it was, and a pass that goes leaves nothing behind.
#include "GLObjectCounter.h"
#include "GLStateSnapshot.h"
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"

#include <gtest/gtest.h>

#include <memory>

using namespace SoftShadowsTesting;

namespace
{

//------------------------------------------------------------------------------
/// While one lives nothing is as OpenGL begins, but for what VTK sets for every frame itself.
class UnusualState
{
public:
  UnusualState(vtkOpenGLRenderWindow* window, bool unusual)
    : State(unusual ? window->GetState() : nullptr)
  {
    if (!this->State)
    {
      return;
    }
    this->State->Push();
    this->State->vtkglEnable(GL_BLEND);
    this->State->vtkglBlendFuncSeparate(GL_DST_COLOR, GL_ONE, GL_SRC_ALPHA, GL_ZERO);
    this->State->vtkglBlendEquationSeparate(GL_MAX, GL_MIN);
    this->State->vtkglPointSize(9.0f);
    this->State->vtkglLineWidth(3.0f);
    this->State->vtkglDepthFunc(GL_GREATER);
    this->State->vtkglDepthMask(GL_FALSE);
    this->State->vtkglColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    this->State->vtkglEnable(GL_CULL_FACE);
    this->State->vtkglCullFace(GL_FRONT);
    this->State->vtkglEnable(GL_STENCIL_TEST);
    this->State->vtkglStencilFunc(GL_NEVER, 1, 0xf0);
    this->State->vtkglStencilOp(GL_REPLACE, GL_INCR, GL_DECR);
    this->State->vtkglStencilMask(0x0f);
    this->State->vtkglClearColor(0.1f, 0.2f, 0.3f, 0.4f);
    this->State->vtkglClearDepth(0.25);
    this->State->vtkglActiveTexture(GL_TEXTURE5);
    this->State->vtkglPixelStorei(GL_PACK_ALIGNMENT, 8);
    this->State->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 8);
    this->SetUncached(GL_CW, 7, GL_LINE, GL_FIRST_VERTEX_CONVENTION);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(3.0f, 7.0f);
    glClearStencil(3);
    glGenBuffers(1, &this->Buffer);
    glBindBuffer(GL_UNIFORM_BUFFER, this->Buffer);
    glBufferData(GL_UNIFORM_BUFFER, 16, nullptr, GL_STATIC_DRAW);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, this->Buffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, this->Buffer);
    glGenRenderbuffers(1, &this->Renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, this->Renderbuffer);
  }
  ~UnusualState()
  {
    if (!this->State)
    {
      return;
    }
    this->SetUncached(GL_CCW, 0, GL_FILL, GL_LAST_VERTEX_CONVENTION);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, 0.0f);
    glClearStencil(0);
    glDeleteBuffers(1, &this->Buffer); // and unbinds it
    glDeleteRenderbuffers(1, &this->Renderbuffer);
    this->State->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
    this->State->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    this->State->vtkglPointSize(1.0f);
    this->State->vtkglLineWidth(1.0f);
    this->State->Pop();
  }
  UnusualState(const UnusualState&) = delete;
  UnusualState& operator=(const UnusualState&) = delete;

private:
  vtkOpenGLState* State;
  GLuint Buffer = 0;
  GLuint Renderbuffer = 0;

  void SetUncached(GLenum front, GLint length, GLenum mode, GLenum provoking)
  {
    glFrontFace(front);
    glPixelStorei(GL_PACK_ROW_LENGTH, length);
    glPixelStorei(GL_PACK_SKIP_PIXELS, length);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, length);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, length);
    glPolygonMode(GL_FRONT_AND_BACK, mode);
    glProvokingVertex(provoking);
  }
};

//------------------------------------------------------------------------------
/// Renders another pass and keeps the OpenGL state before and after it.
class ProbePass : public vtkRenderPass
{
public:
  static ProbePass* New();
  vtkTypeMacro(ProbePass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetVTKWindow());
    UnusualState unusual(window, this->Unusual);
    const GLStateSnapshot before(window);
    this->Inner->Render(state);
    if (this->Shadows)
    {
      this->Visibility = PictureOf(this->Shadows->GetVisibilityImage(0));
    }
    this->Difference = before.DifferenceTo(GLStateSnapshot(window));
    this->CacheErrors = StateCacheErrors(window);
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Inner->ReleaseGraphicsResources(window);
  }

  bool Unusual = false;
  vtkSoftShadowPass* Shadows = nullptr; // whose visibility is read in the same state
  Picture Visibility;
  vtkSmartPointer<vtkRenderPass> Inner;
  std::string Difference;
  std::string CacheErrors;
};
vtkStandardNewMacro(ProbePass);

class Hygiene : public testing::TestWithParam<Technique>
{
protected:
  vtkSmartPointer<vtkSoftShadowPass> MakePass() const
  {
    return this->GetParam().Make(Effort::Quick, Weights::Mean);
  }
};

//------------------------------------------------------------------------------
/// A difference without what every mapper leaves behind: its program and, when new, its buffer.
std::string WithoutMappers(std::string difference)
{
  for (const char* name : { "program:", "array buffer:" })
  {
    const std::size_t start = difference.find(name);
    if (start != std::string::npos)
    {
      difference.erase(start, difference.find('\n', start) + 1 - start);
    }
  }
  return difference;
}

//------------------------------------------------------------------------------
/// Times of everything in the scene that belongs to the application.
std::vector<vtkMTimeType> Times(const BallScene& scene, vtkLight* headlight)
{
  return { scene.Renderer->GetActiveCamera()->GetMTime(), scene.Lamp->GetMTime(),
    headlight->GetMTime(), scene.Ball->GetMTime(), scene.Ground->GetMTime(),
    scene.Ball->GetRedrawMTime(), scene.Ground->GetRedrawMTime() };
}

}

//------------------------------------------------------------------------------
TEST_P(Hygiene, OpenGLStateIsRestored)
{
  const BallScene scene = MakeBallScene();
  OffscreenWindow window(100, 75);
  window.Add(scene.Renderer);
  const auto pass = this->MakePass();
  vtkNew<ProbePass> probe;
  probe->Inner = pass;
  UsePass(scene.Renderer, probe);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Ball->AddPosition(0.1, 0.0, 0.0); // bakes, draws receivers and visibility
    window.Render();
    EXPECT_EQ(WithoutMappers(probe->Difference), "") << "frame " << frame;
    EXPECT_EQ(probe->CacheErrors, "") << "frame " << frame;
  }
  pass->ReleaseGraphicsResources(window.Get());
  scene.Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// Whatever an application or an actor left: the same visibility, and all is left as VTK's own opaque pass
// leaves it, whose mappers set what they need.
TEST_P(Hygiene, UnusualStateIsRestoredAndChangesNothing)
{
  const BallScene scene = MakeBallScene();
  OffscreenWindow window(101, 75);
  window.Add(scene.Renderer);
  std::string plain;
  {
    vtkNew<ProbePass> probe;
    probe->Inner = vtkSmartPointer<vtkOpaquePass>::New();
    probe->Unusual = true;
    UsePass(scene.Renderer, probe);
    window.Render();
    window.Render();
    plain = WithoutMappers(probe->Difference);
    scene.Renderer->SetPass(nullptr);
  }
  const Tolerance& tolerance = this->GetParam().IsContinuous ? SameToRounding : Identical;
  Picture expected[3];
  for (const bool unusual : { false, true })
  {
    const auto pass = this->MakePass();
    vtkNew<ProbePass> probe;
    probe->Inner = pass;
    probe->Shadows = pass;
    probe->Unusual = unusual;
    UsePass(scene.Renderer, probe);
    scene.Ball->SetPosition(0.0, 0.0, 0.0);
    for (int frame = 0; frame < 3; ++frame)
    {
      scene.Ball->AddPosition(0.1, 0.0, 0.0); // bakes, draws receivers and visibility
      window.Render();
      EXPECT_EQ(WithoutMappers(probe->Difference), unusual ? plain : "") << "frame " << frame;
      EXPECT_EQ(probe->CacheErrors, "") << "frame " << frame;
      if (unusual)
      {
        EXPECT_TRUE(Matches(probe->Visibility, expected[frame], tolerance)) << "frame " << frame;
      }
      expected[frame] = probe->Visibility;
    }
    pass->ReleaseGraphicsResources(window.Get());
    scene.Renderer->SetPass(nullptr);
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

//------------------------------------------------------------------------------
// After frames with the pass, VTK's own frame draws what it always drew.
TEST_P(Hygiene, LaterFramesAreVtkOwn)
{
  const BallScene scene = MakeBallScene();
  Stage stage(scene.Renderer, nullptr, 100, 75);
  const Picture before = stage.RenderColors();
  stage.SetPass(this->MakePass());
  EXPECT_FALSE(Matches(stage.RenderColors(), before, SameToRounding)) << "there is no shadow";
  stage.SetPass(nullptr);
  EXPECT_TRUE(Matches(stage.RenderColors(), before, Identical));
}

//------------------------------------------------------------------------------
TEST_P(Hygiene, SceneIsNotTouched)
{
  const BallScene scene = MakeBallScene();
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  headlight->SetIntensity(0.1);
  scene.Renderer->AddLight(headlight);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkShadowCasters::RECEIVES_SHADOW(), 1);
  scene.Ball->SetPropertyKeys(keys);
  Stage stage(scene.Renderer, this->MakePass(), 100, 75);
  stage.Render(); // the first frame sets up camera and headlight, as VTK's own does

  const std::vector<vtkMTimeType> times = Times(scene, headlight);
  for (int frame = 0; frame < 2; ++frame)
  {
    stage.Render();
    // Headlights follow the camera: VTK's own light step sets them in every frame.
    std::vector<vtkMTimeType> now = Times(scene, headlight);
    now[2] = times[2];
    EXPECT_EQ(now, times) << "frame " << frame
                          << ": camera, lamp, headlight, ball, ground, redraw of both";
  }
  EXPECT_EQ(scene.Ball->GetPropertyKeys(), keys.Get());
  EXPECT_EQ(keys->GetNumberOfKeys(), 1) << "keys of the pass are left";
  EXPECT_TRUE(
    !scene.Ground->GetPropertyKeys() || scene.Ground->GetPropertyKeys()->GetNumberOfKeys() == 0);
  EXPECT_EQ(scene.Renderer->GetLights()->GetNumberOfItems(), 2);
}

//------------------------------------------------------------------------------
// Programs stay in VTK's cache of shaders by VTK's design, but each only once.
TEST_P(Hygiene, ReleaseLeaksNothing)
{
  const BallScene scene = MakeBallScene();
  Stage stage(scene.Renderer, nullptr, 100, 75);
  stage.Render();
  const GLObjectCounts plain = CountGLObjects(stage.GetWindow().GetOpenGL());
  GLObjectCounts first;
  for (int round = 0; round < 3; ++round)
  {
    stage.SetPass(this->MakePass());
    stage.Render();
    stage.SetPass(nullptr);
    stage.Render();
    GLObjectCounts now = CountGLObjects(stage.GetWindow().GetOpenGL());
    if (round == 0)
    {
      first = now;
    }
    EXPECT_EQ(now, first) << "round " << round;
    now.Programs = plain.Programs;
    now.Shaders = plain.Shaders;
    EXPECT_EQ(now, plain) << "round " << round;
  }
}

//------------------------------------------------------------------------------
TEST_P(Hygiene, ResizeLeaksNothing)
{
  const BallScene scene = MakeBallScene();
  Stage stage(scene.Renderer, this->MakePass(), 100, 75);
  stage.Render();
  const GLObjectCounts before = CountGLObjects(stage.GetWindow().GetOpenGL());
  for (const int width : { 130, 60, 100 })
  {
    stage.GetWindow().Resize(width, 75);
    stage.Render();
    EXPECT_EQ(CountGLObjects(stage.GetWindow().GetOpenGL()), before) << "width " << width;
  }
}

//------------------------------------------------------------------------------
// A release in the middle of a run: the next frame makes everything anew, and the same.
TEST_P(Hygiene, ReleasedPassDrawsAgain)
{
  const BallScene scene = MakeBallScene();
  const auto pass = this->MakePass();
  Stage stage(scene.Renderer, pass, 100, 75);
  const Picture before = stage.RenderVisibility(scene.Lamp);
  const GLObjectCounts objects = CountGLObjects(stage.GetWindow().GetOpenGL());
  pass->ReleaseGraphicsResources(stage.GetWindow().Get());
  EXPECT_NE(CountGLObjects(stage.GetWindow().GetOpenGL()), objects);
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), before, Identical));
  EXPECT_EQ(CountGLObjects(stage.GetWindow().GetOpenGL()), objects);
}

//------------------------------------------------------------------------------
// Techniques by turns, as a user compares them.
TEST(PassSwitching, LeaksNothing)
{
  const BallScene scene = MakeBallScene();
  Stage stage(scene.Renderer, nullptr, 100, 75);
  std::vector<GLObjectCounts> counts;
  for (int round = 0; round < 3; ++round)
  {
    for (const Technique& technique : AllTechniques())
    {
      stage.SetPass(technique.Make(Effort::Quick, Weights::Mean));
      stage.Render();
    }
    counts.push_back(CountGLObjects(stage.GetWindow().GetOpenGL()));
  }
  EXPECT_EQ(counts[1], counts[0]);
  EXPECT_EQ(counts[2], counts[0]);
}

//------------------------------------------------------------------------------
// The pass outlives its window, as in applications that close one view of several.
TEST_P(Hygiene, PassOutlivesItsWindow)
{
  const BallScene scene = MakeBallScene();
  const auto pass = this->MakePass();
  Picture first;
  {
    Stage stage(scene.Renderer, pass, 100, 75);
    first = stage.RenderVisibility(scene.Lamp);
  }
  Stage stage(scene.Renderer, pass, 100, 75);
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), first, Identical));
}

INSTANTIATE_TEST_SUITE_P(Techniques, Hygiene, testing::ValuesIn(EveryTechnique()), NameOfTechnique);
