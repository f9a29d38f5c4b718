// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What applications do with windows: pick, capture, show in stereo, close and open again. Shadows
// stay what they are, and what is no shadow is VTK's own.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTexture.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 96;
const int Height = 72;

//------------------------------------------------------------------------------
class Windows : public testing::TestWithParam<Technique>
{
protected:
  vtkSmartPointer<vtkSoftShadowPass> MakePass() const
  {
    auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(128); // a pass is compared with itself
    return pass;
  }

  void TearDown() override { EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)); }
};

//------------------------------------------------------------------------------
/// How many cells of each prop a selector finds in the whole picture.
std::map<vtkProp*, vtkIdType> Select(vtkRenderer* renderer)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, Width - 1, Height - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  std::map<vtkProp*, vtkIdType> found;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
    found[prop] += node->GetSelectionList()->GetNumberOfTuples();
  }
  return found;
}

//------------------------------------------------------------------------------
/// Colours and opacity of a window.
Picture Capture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->SetInputBufferTypeToRGBA();
  capture->ReadFrontBufferOff();
  capture->Update();
  return PictureOf(capture->GetOutput());
}

//------------------------------------------------------------------------------
/// Makes the pixels beside the seams of four tiles black.
void ForgetSeams(Picture& picture)
{
  const int reach = 4; // the edge of a block of pixels that share their rays
  for (int y = 0; y < 2 * Height; ++y)
  {
    for (int x = 0; x < 2 * Width; ++x)
    {
      const bool beside = std::abs(x + 0.5 - Width) < reach || std::abs(y + 0.5 - Height) < reach;
      for (int channel = 0; channel < 3 && beside; ++channel)
      {
        picture.At(x, y, channel) = 0.0f;
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MakeCheckers()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* texels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 48; ++i)
  {
    texels[i] = static_cast<unsigned char>((i * 37) % 256);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

}

//------------------------------------------------------------------------------
// Before the first frame and between frames; the shadows do not notice.
TEST_P(Windows, SelectorsFindWhatTheyFindWithoutShadows)
{
  const BallScene scene = MakeBallScene();
  Stage stage(scene.Renderer, nullptr, Width, Height);
  stage.Render();
  const auto expected = Select(scene.Renderer);
  ASSERT_GT(expected.at(scene.Ball), 100);
  ASSERT_EQ(expected.at(scene.Ground), 1);
  stage.SetPass(this->MakePass());
  EXPECT_EQ(Select(scene.Renderer), expected) << "before the first frame";
  const Picture visibility = stage.RenderVisibility(scene.Lamp);
  const Picture colors = stage.GetWindow().Read();
  EXPECT_GT(CountShadowed(visibility), 100);
  EXPECT_EQ(Select(scene.Renderer), expected) << "after a frame";
  EXPECT_TRUE(Matches(stage.RenderColors(), colors, Identical));
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), visibility, Identical));
}

//------------------------------------------------------------------------------
// The opacity of each pixel, for pictures to be put over others, is that of the plain frame.
TEST_P(Windows, CapturesWithOpacity)
{
  const BallScene scene = MakeBallScene();
  scene.Renderer->RemoveActor(scene.Ground);
  scene.Renderer->AddActor(MakeGroundActor(1.0));
  scene.Renderer->SetBackgroundAlpha(0.0);
  Stage stage(scene.Renderer, nullptr, Width, Height);
  stage.GetWindow().Get()->SetAlphaBitPlanes(1);
  stage.Render();
  const Picture plain = Capture(stage.GetWindow().Get());
  stage.SetPass(this->MakePass());
  stage.Render();
  const Picture shadowed = Capture(stage.GetWindow().Get());
  int transparent = 0;
  int darker = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      EXPECT_EQ(shadowed.At(x, y, 3), plain.At(x, y, 3)) << x << ' ' << y;
      transparent += shadowed.At(x, y, 3) == 0.0f ? 1 : 0;
      darker += shadowed.At(x, y, 0) < plain.At(x, y, 0) - 0.1f ? 1 : 0;
    }
  }
  EXPECT_GT(transparent, 1000);
  EXPECT_GT(darker, 100);
}

//------------------------------------------------------------------------------
// Each eye of a window in two halves is the window that shows that eye alone.
TEST_P(Windows, BothEyesHaveShadows)
{
  const BallScene scene = MakeBallScene();
  Picture eyes[2];
  for (const int eye : { 0, 1 })
  {
    Stage stage(scene.Renderer, this->MakePass(), Width, Height);
    stage.GetWindow().Get()->StereoRenderOn();
    stage.GetWindow().Get()->SetStereoType(eye == 0 ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
    eyes[eye] = stage.RenderColors();
    EXPECT_GT(CountShadowed(PictureOf(stage.GetPass()->GetVisibilityImage(scene.Lamp))), 100);
  }
  EXPECT_FALSE(Matches(eyes[0], eyes[1], SameButForEdges));
  Stage stage(scene.Renderer, this->MakePass(), Width, Height);
  stage.GetWindow().Get()->StereoRenderOn();
  for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT, VTK_STEREO_LEFT })
  {
    stage.GetWindow().Get()->SetStereoType(type);
    EXPECT_TRUE(
      Matches(stage.RenderColors(), eyes[type == VTK_STEREO_LEFT ? 0 : 1], SameButForFlips));
  }
  stage.GetWindow().Get()->SetStereoTypeToRedBlue();
  stage.Render();
  const Picture mixed = stage.RenderColors(); // red is the left eye's, blue the right one's
  int unlike = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const auto grey = [&](const Picture& eye)
      { return (eye.At(x, y, 0) + eye.At(x, y, 1) + eye.At(x, y, 2)) / 3.0f; };
      unlike += std::abs(mixed.At(x, y, 0) - grey(eyes[0])) > 0.03f ? 1 : 0;
      unlike += std::abs(mixed.At(x, y, 2) - grey(eyes[1])) > 0.03f ? 1 : 0;
    }
  }
  EXPECT_LT(unlike, Width * Height / 200);
}

//------------------------------------------------------------------------------
TEST_P(Windows, BackgroundsShine)
{
  const BallScene scene = MakeBallScene();
  scene.Renderer->RemoveActor(scene.Ground);
  scene.Renderer->AddActor(MakeGroundActor(1.0));
  scene.Renderer->SetBackground(0.2, 0.3, 0.4);
  scene.Renderer->SetBackground2(0.9, 0.8, 0.1);
  Stage stage(scene.Renderer, nullptr, Width, Height);
  Picture first;
  for (const bool texture : { false, true })
  {
    stage.SetPass(nullptr);
    scene.Renderer->SetGradientBackground(!texture);
    scene.Renderer->SetTexturedBackground(texture);
    scene.Renderer->SetBackgroundTexture(texture ? MakeCheckers() : nullptr);
    const Picture plain = stage.RenderColors();
    stage.SetPass(this->MakePass());
    const Picture visibility = stage.RenderVisibility(scene.Lamp);
    const Picture colors = stage.GetWindow().Read();
    first = first.Values.empty() ? visibility : first;
    EXPECT_TRUE(Matches(visibility, first, Identical));
    int seen = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        if (std::isnan(visibility.At(x, y)))
        {
          ++seen;
          EXPECT_EQ(colors.At(x, y, 0), plain.At(x, y, 0)) << x << ' ' << y;
        }
      }
    }
    EXPECT_GT(seen, 1000);
  }
}

//------------------------------------------------------------------------------
// A second renderer over the colours, and the depths, of the first.
TEST_P(Windows, BuffersAreKeptForTheNextRenderer)
{
  const BallScene scene = MakeBallScene();
  const BallScene front = MakeBallScene();
  front.Renderer->RemoveActor(front.Ground);
  front.Ball->SetPosition(0.4, 0.0, 0.2);
  front.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  front.Renderer->PreserveColorBufferOn();
  front.Renderer->PreserveDepthBufferOn();
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  window.Add(front.Renderer);
  window.Render();
  const Picture plain = window.Read();
  const auto pass = this->MakePass();
  UsePass(scene.Renderer, pass);
  window.Render();
  const Picture half = window.Read();
  const Picture visibility = PictureOf(pass->GetVisibilityImage(scene.Lamp));
  const auto frontPass = this->MakePass();
  UsePass(front.Renderer, frontPass);
  window.Render();
  EXPECT_TRUE(Matches(PictureOf(pass->GetVisibilityImage(scene.Lamp)), visibility, Identical));
  // The front ball stands alone: the light sees it, it has no shadow but its own.
  const Picture both = window.Read();
  const Difference difference = Compare(both, half, SameButForEdges);
  EXPECT_LT(difference.ShareOff, 0.05);
  EXPECT_GT(Compare(plain, half, SameButForEdges).ShareOff, 0.02);
  pass->ReleaseGraphicsResources(window.Get());
  frontPass->ReleaseGraphicsResources(window.Get());
  scene.Renderer->SetPass(nullptr);
  front.Renderer->SetPass(nullptr);
  window.Remove(front.Renderer);
  window.Remove(scene.Renderer);
}

//------------------------------------------------------------------------------
// The same window object, closed and opened again, behind the screen and before it.
TEST_P(Windows, OpenAgain)
{
  const BallScene scene = MakeBallScene();
  Stage stage(scene.Renderer, this->MakePass(), Width, Height);
  const Picture before = stage.RenderVisibility(scene.Lamp);
  vtkRenderWindow* window = stage.GetWindow().Get();
  window->Finalize();
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), before, Identical)) << "closed";
  window->SetOffScreenRendering(0);
  window->SetSize(Width, Height);
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), before, Identical)) << "on the screen";
  window->SetOffScreenRendering(1);
  window->SetSize(Width, Height);
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), before, Identical)) << "behind it";
}

//------------------------------------------------------------------------------
// A picture in tiles is the picture of a window of that size. Where pixels ask their neighbours, those
// beside a seam between tiles may be off by what the border of any picture costs.
TEST_P(Windows, CaptureInTiles)
{
  const BallScene scene = MakeBallScene();
  Picture expected;
  {
    Stage stage(scene.Renderer, this->MakePass(), 2 * Width, 2 * Height);
    expected = stage.RenderColors();
  }
  Stage stage(scene.Renderer, this->MakePass(), Width, Height);
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(stage.GetWindow().Get());
  capture->SetScale(2);
  capture->ReadFrontBufferOff();
  capture->Update();
  Picture tiles = PictureOf(capture->GetOutput());
  if (const double most = this->GetParam().LargestBorderError)
  {
    EXPECT_LT(Compare(tiles, expected, SameButForEdges).RootMeanSquare, most);
    ForgetSeams(tiles);
    ForgetSeams(expected);
  }
  EXPECT_TRUE(Matches(tiles, expected, SameButForEdges));
}

//------------------------------------------------------------------------------
TEST_P(Windows, MultisamplesChangeNoVisibility)
{
  const BallScene scene = MakeBallScene();
  Picture expected;
  {
    Stage stage(scene.Renderer, this->MakePass(), Width, Height);
    expected = stage.RenderVisibility(scene.Lamp);
  }
  Stage stage(scene.Renderer, this->MakePass(), Width, Height);
  stage.GetWindow().Get()->SetMultiSamples(8);
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), expected, Identical));
}

//------------------------------------------------------------------------------
// The camera rests, the scene does not: each frame is that of a pass that has seen nothing before.
TEST_P(Windows, ChangesUnderARestingCamera)
{
  const BallScene scene = MakeBallScene();
  const auto rectangle = MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2);
  rectangle->SetShapeToRectangle();
  const auto sun = MakeSun({ { 0.5, 0.4, 1.0 } }, 5.0);
  scene.Renderer->RemoveLight(scene.Lamp);
  scene.Renderer->AddLight(rectangle);
  scene.Renderer->AddLight(sun);
  const auto box = MakeBoxActor({ { 0.6, 1.0, -0.4, 0.0, 0.0, 0.8 } });
  scene.Renderer->AddActor(box);
  Stage stage(scene.Renderer, this->MakePass(), Width, Height);
  const Tolerance& same = this->GetParam().IsContinuous ? SameToRounding : Identical;
  const auto expectFresh = [&](const char* what)
  {
    SCOPED_TRACE(what);
    const auto kept = vtkSmartPointer<vtkSoftShadowPass>(stage.GetPass());
    stage.Render();
    const Picture now[2] = { PictureOf(kept->GetVisibilityImage(rectangle)),
      PictureOf(kept->GetVisibilityImage(sun)) };
    stage.SetPass(this->MakePass());
    EXPECT_TRUE(Matches(now[0], stage.RenderVisibility(rectangle), same)) << "rectangle";
    EXPECT_TRUE(Matches(now[1], stage.RenderVisibility(sun), same)) << "sun";
    EXPECT_GT(CountShadowed(now[0]), 50);
    stage.SetPass(kept);
    stage.Render(); // exchanged, it forgot
  };
  stage.Render();
  sun->SetPosition(-0.5, 0.4, 1.0);
  rectangle->SetSize(0.8, 0.1);
  expectFresh("the sun moved, the lamp of another shape");
  box->VisibilityOff();
  expectFresh("the box invisible");
  box->VisibilityOn();
  scene.Ball->GetProperty()->SetOpacity(0.5);
  expectFresh("the box visible, the ball translucent");
}

INSTANTIATE_TEST_SUITE_P(Techniques, Windows, testing::ValuesIn(AllTechniques()), NameOfTechnique);

//------------------------------------------------------------------------------
// Two viewports whose passes split their lights and converge, each for itself.
TEST(Viewports, ConvergeEachForItself)
{
  const auto makePass = []
  {
    auto pass = AllTechniques()[1].Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(64);
    pass->SetMapMemory(1);
    pass->SetSplit(2);
    pass->ProgressiveOn();
    pass->SetProgressiveTolerance(0.1);
    pass->SetProgressivePoints(64);
    return pass;
  };
  const auto rest = [](OffscreenWindow& window, const std::vector<vtkSoftShadowPass*>& passes)
  {
    const auto refining = [&]
    {
      return std::any_of(passes.begin(), passes.end(),
        [](const vtkSoftShadowPass* pass) { return pass->GetRefining(); });
    };
    int frames = 1;
    for (window.Render(); refining() && frames < 100; ++frames)
    {
      window.Render();
    }
    return frames;
  };
  const BallScene scenes[2] = { MakeBallScene(), MakeBallScene(0.8) };
  scenes[1].Ball->SetPosition(0.4, 0.2, 0.3);
  Picture expected[2];
  for (const int i : { 0, 1 })
  {
    const auto pass = makePass();
    Stage stage(scenes[i].Renderer, pass, Width, Height);
    EXPECT_LT(rest(stage.GetWindow(), { pass.Get() }), 100);
    expected[i] = PictureOf(pass->GetVisibilityImage(scenes[i].Lamp));
  }
  OffscreenWindow window(2 * Width, Height);
  vtkSmartPointer<vtkSoftShadowPass> passes[2] = { makePass(), makePass() };
  for (const int i : { 0, 1 })
  {
    scenes[i].Renderer->SetViewport(0.5 * i, 0.0, 0.5 * (i + 1), 1.0);
    window.Add(scenes[i].Renderer);
    UsePass(scenes[i].Renderer, passes[i]);
  }
  EXPECT_LT(rest(window, { passes[0].Get(), passes[1].Get() }), 100);
  for (const int i : { 0, 1 })
  {
    EXPECT_TRUE(Matches(
      PictureOf(passes[i]->GetVisibilityImage(scenes[i].Lamp)), expected[i], SameToRounding));
    passes[i]->ReleaseGraphicsResources(window.Get());
    scenes[i].Renderer->SetPass(nullptr);
    window.Remove(scenes[i].Renderer);
  }
}
