// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The viewer in a real window: what keys and clicks change on the screen, and what is saved.
#include "ViewerWindowFixture.h"

#include "ErrorMeasures.h"
#include "SceneReader.h"
#include "Silhouettes.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkUnsignedCharArray.h"

#include <OpenImageIO/imagebuf.h>

#include <cmath>

using namespace softshadows;
using Kind = ViewerAction::Kind;

namespace
{

class ViewerWindows : public ViewerWindowTest
{
};

}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, DrawsTheMenuBesideTheScene)
{
  this->Open();
  const Screen with = this->Grab();
  const MenuScale scale(Height);
  const MenuRect menu = { 0, scale.StatusHeight, scale.PanelWidth, Height - scale.StatusHeight };
  this->Press("m");
  const Screen without = this->Grab();
  EXPECT_GT(with.Differing(without, menu), 0.99) << "the scene is where the menu was";
  EXPECT_EQ(this->Frame().GetWidth(), Width);
  // Letters: some of the menu's pixels are nearly white.
  std::size_t bright = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < menu.Width; ++x)
    {
      bright += with.Pixels[3 * (static_cast<std::size_t>(y) * Width + x)] > 200 ? 1 : 0;
    }
  }
  EXPECT_GT(bright, 1000U);
  this->Press("m");
  EXPECT_EQ(this->Grab().Differing(with, menu), 0.0) << "and back";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, KeysAndClicksSwitchTheTechnique)
{
  this->Open();
  const vtkSoftShadowPass* first = this->Frame().GetScene().GetPass();
  EXPECT_TRUE(this->Frame().GetScene().GetPass()->IsA("vtkPercentageCloserSoftShadowPass"));
  this->Press("8");
  EXPECT_TRUE(this->Frame().GetScene().GetPass()->IsA("vtkMarchedSoftShadowPass"));
  EXPECT_NE(this->Frame().GetScene().GetPass(), first);
  EXPECT_EQ(this->Frame().GetStatus().Lines[0].rfind("marched,", 0), 0U);
  this->Click({ Kind::ChooseTechnique, 0, "" });
  EXPECT_TRUE(this->Frame().GetScene().GetPass()->IsA("vtkSampledSoftShadowPass"));
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, SettingsReachThePassThatStays)
{
  this->Open("sampled");
  vtkSoftShadowPass* pass = this->Frame().GetScene().GetPass();
  const Screen before = this->Grab();
  const MenuRect room = this->Frame().GetRoom();
  this->Click({ Kind::SelectOption, 0, "samples" });
  EXPECT_EQ(this->Grab().Differing(before, room), 0.0) << "selecting changes nothing";
  for (int i = 0; i < 3; ++i)
  {
    this->Click({ Kind::StepOption, -1, "samples" });
  }
  EXPECT_EQ(this->Frame().GetScene().GetPass(), pass);
  EXPECT_EQ(this->State->GetTechnique().FindOption("samples").Get(pass), 2.0);
  EXPECT_GT(this->Grab().Differing(before, room), 0.01) << "bands in place of a penumbra";
  this->Click({ Kind::ChooseQuality, 1, "" });
  EXPECT_EQ(this->State->GetTechnique().FindOption("samples").Get(pass), 16.0);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, RedrawsTheMenuWithoutNewShadows)
{
  this->Open();
  vtkSoftShadowPass* pass = this->Frame().GetScene().GetPass();
  const vtkTypeInt64 before = pass->GetStatistics().VisibilityFrames;
  this->Press("h");
  this->Press("Down");
  this->Press("h");
  EXPECT_EQ(pass->GetStatistics().VisibilityFrames, before);
  const vtkTypeInt64 frames = pass->GetStatistics().Frames;
  this->Press("Z"); // means nothing
  EXPECT_EQ(pass->GetStatistics().Frames, frames) << "nothing changed, nothing is drawn";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, AClickOnTheMenuDoesNotTurnTheView)
{
  this->Open();
  vtkCamera* camera = this->Frame().GetScene().GetRenderer()->GetActiveCamera();
  double before[3];
  camera->GetPosition(before);
  this->Drag(20, Height - 10, 120, Height - 200);
  double* after = camera->GetPosition();
  EXPECT_EQ(before[0], after[0]);
  this->Drag(600, 300, 700, 300);
  EXPECT_NE(before[0], camera->GetPosition()[0]) << "on the scene it does";
  this->Press("r");
  EXPECT_DOUBLE_EQ(before[0], camera->GetPosition()[0]);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, ShowsEveryViewOfEveryTechnique)
{
  this->Open();
  for (const Technique& technique : GetTechniques())
  {
    this->State->SetTechnique(static_cast<int>(&technique - GetTechniques().data()));
    this->State->SetOption("map_size", 256);
    this->State->SetView(0);
    this->Frame().Draw();
    const Screen picture = this->Grab();
    for (std::size_t view = 1; view < this->State->GetViews().size(); ++view)
    {
      this->State->SetView(static_cast<int>(view));
      this->Frame().Draw();
      const bool needsReference = this->State->GetView().Shows == DebugView::Source::Error;
      EXPECT_EQ(this->Grab().Differing(picture, this->Frame().GetRoom()) > 0.1, !needsReference)
        << technique.Name << " " << this->State->GetView().Name;
    }
  }
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, ShowsTheErrorOnceTheViewRests)
{
  this->Open();
  EXPECT_TRUE(std::isnan(this->Frame().GetRmse()));
  this->Rest(64);
  const double rmse = this->Frame().GetRmse();

  // The same by hand.
  const VisibilityImage seen = this->Frame().GetVisibility();
  const ReferenceVisibility truth =
    Trace(this->Frame().GetScene().GetRenderer(), seen.Width, seen.Height, 8);
  const VisibilityErrors errors = MeasureErrors(seen.Width, seen.Height, truth.Visibility[0],
    seen.Visibility[0], FindSilhouettes(seen.Width, seen.Height, truth.Depth));
  EXPECT_NEAR(rmse, errors.All.Rmse, 1e-9);
  EXPECT_LT(rmse, 0.05);

  // Another technique is measured against the same reference; whatever moves ends it.
  this->Press("1");
  EXPECT_FALSE(std::isnan(this->Frame().GetRmse()));
  EXPECT_NE(this->Frame().GetRmse(), rmse);
  this->Press("a");
  EXPECT_TRUE(std::isnan(this->Frame().GetRmse()));
}

//--------------------------------------------------------------------------------------------------
// A window that is resized while the scene is drawn: no values of the wrong size are read.
TEST_F(ViewerWindows, SurvivesAResizeDuringADraw)
{
  this->Open();
  this->Rest(16);
  vtkRenderer* renderer = this->Frame().GetScene().GetRenderer();
  vtkRenderWindow* window = this->Window->GetWindow();
  vtkNew<vtkCallbackCommand> resize;
  resize->SetClientData(window);
  resize->SetCallback([](vtkObject*, unsigned long, void* resized, void*)
    { static_cast<vtkRenderWindow*>(resized)->SetSize(640, 480); });
  const unsigned long tag = renderer->AddObserver(vtkCommand::StartEvent, resize);
  this->State->SetView(1);
  EXPECT_NO_THROW(this->Frame().Draw());
  EXPECT_TRUE(std::isnan(this->Frame().GetRmse()));
  renderer->RemoveObserver(tag);
  const int before = this->Frame().GetWidth();
  this->Frame().Draw();
  EXPECT_LT(this->Frame().GetWidth(), before) << "and the next frame has the new size";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, LetsTheRestingPictureConverge)
{
  this->Open("pcss");
  vtkSoftShadowPass* pass = this->Frame().GetScene().GetPass();
  pass->SetProgressiveTolerance(0.05);
  EXPECT_FALSE(pass->GetRefining());
  this->Rest(256); // the noise of fewer rays would be as large as the technique's error
  const double before = this->Frame().GetRmse();
  this->Press("p");
  EXPECT_TRUE(pass->GetRefining());
  for (int i = 0; i < 60 && pass->GetRefining(); ++i)
  {
    this->Window->GetInteractor()->InvokeEvent(vtkCommand::TimerEvent, nullptr);
  }
  EXPECT_FALSE(pass->GetRefining());
  EXPECT_LT(this->Frame().GetRmse(), before) << this->Frame().GetStatus().Lines[0];
  this->Press("p");
  EXPECT_NEAR(this->Frame().GetRmse(), before, 0.1 * before) << "the technique's own again";
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, SavesPictureVisibilityAndScene)
{
  this->Open();
  this->Press("h"); // and the help is not in the picture
  this->Press("d");
  const MenuRect room = this->Frame().GetRoom();
  this->Press("F2");
  EXPECT_NE(this->Frame().GetStatus().Message.find("test-1.png"), std::string::npos);
  this->Press("F3");
  this->Click({ Kind::SaveScene, 0, "" });

  const OIIO::ImageBuf picture((this->Folder / "test-1.png").string());
  EXPECT_EQ(picture.spec().width, room.Width);
  EXPECT_EQ(picture.spec().height, room.Height);
  const VisibilityImage visibility = ReadVisibility((this->Folder / "test-1.exr").string());
  EXPECT_EQ(visibility.Width, room.Width);
  ASSERT_EQ(visibility.Visibility.size(), 1U);
  const std::vector<float> shown = this->Frame().GetVisibility().Visibility[0];
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const float saved = visibility.Visibility[0][i];
    ASSERT_TRUE(saved == shown[i] || (std::isnan(saved) && std::isnan(shown[i]))) << i;
  }

  // The saved scene is what is shown: opened again and drawn off-screen it gives the picture.
  const SceneDescription scene = ReadScene((this->Folder / "test-1.json").string());
  EXPECT_EQ(scene.Lights.at(0).Position, this->State->GetLight().Position);
  ViewerState again(scene, "pcss");
  again.SetOption("map_size", 256);
  this->Window.reset();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(scene.Width, scene.Height);
  ViewedScene viewed(again, this->Models);
  window->AddRenderer(viewed.GetRenderer());
  window->Render();
  std::vector<unsigned char> expected(3 * static_cast<std::size_t>(room.Width) * room.Height);
  picture.get_pixels(OIIO::ROI(), OIIO::TypeDesc::UINT8, expected.data());
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, scene.Width - 1, scene.Height - 1, 1, pixels);
  std::size_t differing = 0;
  for (int y = 0; y < room.Height; ++y)
  {
    for (int x = 0; x < 3 * room.Width; ++x)
    {
      const int a = expected[static_cast<std::size_t>(y) * 3 * room.Width + x];
      const int b =
        pixels->GetValue(static_cast<vtkIdType>(room.Height - 1 - y) * 3 * room.Width + x);
      differing += std::abs(a - b) > 2 ? 1 : 0;
    }
  }
  EXPECT_LT(differing, expected.size() / 2000);
  viewed.Release(window);
}

//--------------------------------------------------------------------------------------------------
TEST_F(ViewerWindows, SaysWhyItCannotSave)
{
  this->Open();
  std::filesystem::remove_all(this->Folder);
  this->Press("F4");
  EXPECT_EQ(this->Frame().GetStatus().Message.rfind("not saved: ", 0), 0U)
    << this->Frame().GetStatus().Message;
}
