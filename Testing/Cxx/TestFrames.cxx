// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows in the company of VTK's other passes, windows and props: each frame has them, and the rest
// of it is what it is without.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkColorTransferFunction.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkEDLShading.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkToneMappingPass.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 120;
const int Height = 90;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSoftShadowPass> MakePass()
{
  return AllTechniques()[1].Make(Effort::Quick, Weights::Mean);
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
/// Pixels whose sum of channels is more than 0.2 darker.
int CountDarker(const Picture& picture, const Picture& than)
{
  int count = 0;
  for (std::size_t i = 0; i + 2 < picture.Values.size(); i += 3)
  {
    float difference = 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
    {
      difference += than.Values[i + c] - picture.Values[i + c];
    }
    count += difference > 0.2f ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
struct Chain
{
  std::string Name;
  /// The pass for the renderer, the steps among its delegates.
  std::function<vtkSmartPointer<vtkRenderPass>(vtkRenderPass* steps)> Make;
};

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Chain& chain)
{
  return os << chain.Name;
}

//------------------------------------------------------------------------------
template <class Pass>
vtkSmartPointer<vtkRenderPass> Around(vtkRenderPass* steps)
{
  auto pass = vtkSmartPointer<Pass>::New();
  pass->SetDelegatePass(steps);
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderPass> AroundWithSSAO(vtkRenderPass* steps)
{
  auto pass = vtkSmartPointer<vtkSSAOPass>::New();
  pass->SetRadius(0.3);
  pass->SetKernelSize(16);
  pass->SetDelegatePass(steps);
  return pass;
}

class PassChain : public testing::TestWithParam<Chain>
{
};

const std::vector<Chain> Chains = {
  { "None", [](vtkRenderPass* steps) { return vtkSmartPointer<vtkRenderPass>(steps); } },
  { "SSAO", AroundWithSSAO }, { "FXAA", Around<vtkOpenGLFXAAPass> },
  { "SSAA", Around<vtkSSAAPass> }, { "DepthOfField", Around<vtkDepthOfFieldPass> },
  { "ToneMapping", Around<vtkToneMappingPass> }, { "EDL", Around<vtkEDLShading> }
};

}

//------------------------------------------------------------------------------
// The shadow is in the picture that the chain makes, and away from it the picture is the chain's own.
TEST_P(PassChain, ShowsTheShadow)
{
  const BallScene scene = MakeBallScene();
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkRenderStepsPass> plain;
  const auto plainChain = this->GetParam().Make(plain);
  scene.Renderer->SetPass(plainChain);
  window.Render();
  window.Render();
  const Picture without = window.Read();
  plainChain->ReleaseGraphicsResources(window.Get());

  const auto pass = MakePass();
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(pass);
  const auto chain = this->GetParam().Make(steps);
  scene.Renderer->SetPass(chain);
  CountOpenGLErrors();
  window.Render();
  window.Render();
  EXPECT_EQ(CountOpenGLErrors(), 0);
  const Picture with = window.Read();
  const Picture visibility = PictureOf(pass->GetVisibilityImage(scene.Lamp));
  EXPECT_GT(CountShadowed(visibility), 200);
  const double scale = static_cast<double>(visibility.Values.size()) / (Width * Height);
  EXPECT_NEAR(CountDarker(with, without), CountShadowed(visibility) / scale,
    0.5 * CountShadowed(visibility) / scale);
  EXPECT_LT(CountDarker(without, with), 20) << "pixels that are brighter with shadows";
  chain->ReleaseGraphicsResources(window.Get());
  scene.Renderer->SetPass(nullptr);
}

INSTANTIATE_TEST_SUITE_P(VTK, PassChain, testing::ValuesIn(Chains),
  [](const testing::TestParamInfo<Chain>& chain) { return chain.param.Name; });

//------------------------------------------------------------------------------
// VTK's ambient occlusion leaves a framebuffer of three colours bound: every technique must still find
// its own buffers.
TEST(Frames, AmbientOcclusionChangesNoVisibility)
{
  const BallScene scene = MakeBallScene();
  for (const Technique& technique : AllTechniques())
  {
    SCOPED_TRACE(technique.Name);
    Picture expected;
    {
      Stage stage(scene.Renderer, technique.Make(Effort::Quick, Weights::Mean), Width, Height);
      expected = stage.RenderVisibility(scene.Lamp);
    }
    OffscreenWindow window(Width, Height);
    window.Add(scene.Renderer);
    const auto pass = technique.Make(Effort::Quick, Weights::Mean);
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetOpaquePass(pass);
    const auto chain = AroundWithSSAO(steps);
    scene.Renderer->SetPass(chain);
    window.Render();
    EXPECT_TRUE(Matches(PictureOf(pass->GetVisibilityImage(scene.Lamp)), expected, SameToRounding));
    chain->ReleaseGraphicsResources(window.Get());
    scene.Renderer->SetPass(nullptr);
    window.Remove(scene.Renderer);
  }
}

//------------------------------------------------------------------------------
TEST(Frames, MultisampledWindow)
{
  const BallScene scene = MakeBallScene();
  Picture expected;
  {
    Stage stage(scene.Renderer, MakePass(), Width, Height);
    expected = stage.RenderVisibility(scene.Lamp);
  }
  Stage stage(scene.Renderer, MakePass(), Width, Height);
  stage.GetWindow().Get()->SetMultiSamples(8);
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), expected, Identical));
  const Picture with = stage.GetWindow().Read();
  EXPECT_EQ(CountOpenGLErrors(), 0);
  stage.SetPass(nullptr);
  EXPECT_GT(CountDarker(with, stage.RenderColors()), CountShadowed(expected) / 2);
}

//------------------------------------------------------------------------------
// Lights come, go, and are switched between frames: each frame is as if it were the first.
TEST(Frames, LightsComeAndGo)
{
  const BallScene scene = MakeBallScene();
  const auto second = MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2);
  Stage stage(scene.Renderer, MakePass(), Width, Height);
  const auto expectFresh = [&](const char* what, vtkLight* light)
  {
    const Picture now = stage.RenderVisibility(light);
    const Picture colors = stage.GetWindow().Read();
    const auto kept = vtkSmartPointer<vtkSoftShadowPass>(stage.GetPass());
    stage.SetPass(MakePass());
    EXPECT_TRUE(Matches(now, stage.RenderVisibility(light), SameToRounding)) << what;
    EXPECT_TRUE(Matches(colors, stage.GetWindow().Read(), SameToRounding)) << what;
    stage.SetPass(kept);
    stage.Render();
  };
  expectFresh("one lamp", scene.Lamp);
  scene.Renderer->AddLight(second);
  expectFresh("a second lamp", second);
  scene.Lamp->SwitchOff();
  expectFresh("the first lamp off", second);
  EXPECT_EQ(stage.GetPass()->GetVisibilityImage(scene.Lamp).Get(), nullptr);
  scene.Lamp->SwitchOn();
  expectFresh("the first lamp on again", scene.Lamp);
  scene.Renderer->RemoveLight(scene.Lamp);
  expectFresh("the first lamp gone", second);
  second->SetPosition(1.0, -1.0, 3.0);
  expectFresh("the second lamp moved", second);
  EXPECT_EQ(CountOpenGLErrors(), 0);
}

//------------------------------------------------------------------------------
// A translucent prop is drawn over the shadow, sorted or not, and casts nothing.
TEST(Frames, TranslucentPropsWithDepthPeeling)
{
  for (const bool peeling : { false, true })
  {
    const BallScene scene = MakeBallScene();
    scene.Renderer->SetUseDepthPeeling(peeling);
    Stage stage(scene.Renderer, MakePass(), Width, Height);
    const Picture visibility = stage.RenderVisibility(scene.Lamp);
    const Picture without = stage.GetWindow().Read();
    const auto veil =
      MakeQuadActor({ { { { -1.0, -1.5, 1.6 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } } } });
    veil->GetProperty()->SetOpacity(0.5);
    veil->GetProperty()->SetColor(1.0, 0.0, 0.0);
    scene.Renderer->AddActor(veil);
    EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), visibility, Identical));
    EXPECT_GT(Compare(stage.GetWindow().Read(), without, Identical).ShareOff, 0.03) << peeling;
    EXPECT_EQ(CountOpenGLErrors(), 0);
  }
}

//------------------------------------------------------------------------------
// A volume beside the shadow is drawn, and casts nothing.
TEST(Frames, VolumesStay)
{
  const BallScene scene = MakeBallScene();
  Stage stage(scene.Renderer, MakePass(), Width, Height);
  const Picture visibility = stage.RenderVisibility(scene.Lamp);
  const Picture without = stage.GetWindow().Read();
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 8);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(0.8, -0.6, 0.1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(voxels, voxels + 512, static_cast<unsigned char>(200));
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 1.0);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(color);
  scene.Renderer->AddVolume(volume);
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), visibility, Identical));
  EXPECT_GT(Compare(stage.GetWindow().Read(), without, Identical).ShareOff, 0.02);
  EXPECT_EQ(CountOpenGLErrors(), 0);
}

//------------------------------------------------------------------------------
// Wires, lines and points cast what their mappers draw, and harm nothing.
TEST(Frames, WiresLinesAndPointsCast)
{
  const std::vector<std::pair<std::string, std::function<void(vtkProperty*)>>> ways = {
    { "wireframe", [](vtkProperty* p) { p->SetRepresentationToWireframe(); } },
    { "points", [](vtkProperty* p) { p->SetRepresentationToPoints(), p->SetPointSize(5.0f); } },
    { "points as spheres",
      [](vtkProperty* p)
      {
        p->SetRepresentationToPoints();
        p->SetPointSize(9.0f);
        p->RenderPointsAsSpheresOn();
      } },
    { "lines as tubes",
      [](vtkProperty* p)
      {
        p->SetRepresentationToWireframe();
        p->SetLineWidth(4.0f);
        p->RenderLinesAsTubesOn();
      } },
    { "vertices on a surface",
      [](vtkProperty* p)
      {
        p->VertexVisibilityOn();
        p->SetPointSize(3.0f);
      } },
  };
  for (const auto& way : ways)
  {
    SCOPED_TRACE(way.first);
    const BallScene scene = MakeBallScene();
    scene.Renderer->RemoveActor(scene.Ball);
    const auto ball = MakeSphereActor({ { 0.0, 0.0, 0.9 } }, 0.5, 12);
    way.second(ball->GetProperty());
    scene.Renderer->AddActor(ball);
    Stage stage(scene.Renderer, MakePass(), Width, Height);
    const Picture visibility = stage.RenderVisibility(scene.Lamp);
    const auto dimmed = std::count_if(
      visibility.Values.begin(), visibility.Values.end(), [](float v) { return v < 0.97f; });
    EXPECT_GT(dimmed, 100);
    for (const float v : visibility.Values)
    {
      EXPECT_FALSE(v < 0.0f || v > 1.0f) << v;
    }
    EXPECT_EQ(CountOpenGLErrors(), 0);
  }
}
