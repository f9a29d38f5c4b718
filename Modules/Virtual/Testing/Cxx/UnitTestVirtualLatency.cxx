// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The grid's way to the CPU: how often it is waited for, and what the grid of the frame before costs.

#include "OffscreenWindow.h"
#include "Picture.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowDriver.h"
#include "vtkVirtualSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

vtkSmartPointer<vtkAreaLight> MakeLight(double x, double y, double size)
{
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetShapeToRectangle();
  light->SetPosition(x, y, 6.0);
  light->SetFocalPoint(0, 0, 0);
  light->SetViewUp(0, 1, 0);
  light->SetSize(size, size);
  return light;
}

// Rows of plates over a floor, from the camera's feet to far away.
class PlatesWindow
{
public:
  explicit PlatesWindow(const std::vector<vtkSmartPointer<vtkAreaLight>>& lights)
    : Window(Width, Height)
  {
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddActor(
      MakeQuadActor({ Quad{ { { -9, -9, 0 } }, { { 18, 0, 0 } }, { { 0, 18, 0 } } } }));
    std::vector<Quad> plates;
    for (int i = 0; i < 64; ++i)
    {
      plates.push_back({ { { i % 8 - 3.9, i / 8 - 3.9, 0.3 + 0.05 * (i % 5) } }, { { 0.5, 0, 0 } },
        { { 0, 0.5, 0 } } });
    }
    this->Renderer->AddActor(MakeQuadActor(plates));
    for (const auto& light : lights)
    {
      this->Renderer->AddLight(light);
    }
    this->Window.Add(this->Renderer);
    UsePass(this->Renderer, this->Pass);
    this->Look(0.0, -4.0);
  }
  ~PlatesWindow()
  {
    this->Pass->ReleaseGraphicsResources(this->Window.Get());
    UsePass(this->Renderer, nullptr);
    this->Window.Remove(this->Renderer);
  }

  void Look(double x, double y)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x, y, 1.2);
    camera->SetFocalPoint(x, y + 4.0, 0);
    camera->SetViewUp(0, 0, 1);
    camera->SetViewAngle(40);
    this->Renderer->ResetCameraClippingRange();
  }

  // Reading waits for the GPU: a fence of this frame is signalled in the next.
  Picture Visibility(int light = 0)
  {
    this->Window.Render();
    return PictureOf(this->Pass->GetVisibilityImage(light));
  }

  // Of all three lights, added to what is there.
  void VisibilitiesTo(std::vector<Picture>& pictures)
  {
    this->Window.Render();
    for (int light = 0; light < 3; ++light)
    {
      pictures.push_back(PictureOf(this->Pass->GetVisibilityImage(light)));
    }
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVirtualSoftShadowPass> Pass;
  OffscreenWindow Window;
};

struct Errors
{
  double RootMeanSquare = 0.0;
  double Maximum = 0.0;
};

Errors Compare(const Picture& picture, const Picture& expected)
{
  Errors errors;
  int pixels = 0;
  for (size_t i = 0; i < expected.Values.size(); ++i)
  {
    if (!std::isnan(expected.Values[i]))
    {
      const double error = picture.Values[i] - expected.Values[i];
      errors.Maximum = std::max(errors.Maximum, std::abs(error));
      errors.RootMeanSquare += error * error;
      ++pixels;
    }
  }
  errors.RootMeanSquare = std::sqrt(errors.RootMeanSquare / std::max(pixels, 1));
  return errors;
}

std::vector<vtkSmartPointer<vtkAreaLight>> ThreeLights()
{
  return { MakeLight(1.5, 1.0, 0.05), MakeLight(-3.0, 0.5, 0.5), MakeLight(0.0, -2.0, 2.0) };
}

// A walk by a twentieth of the nearest distance per frame.
void Step(PlatesWindow& window, int frame)
{
  window.Look(0.05 * frame, -4.0 + 0.06 * frame);
}

void StepLights(const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, int frame)
{
  const double places[3][2] = { { 1.5, 1.0 }, { -3.0, 0.5 }, { 0.0, -2.0 } };
  for (size_t light = 0; light < lights.size(); ++light)
  {
    lights[light]->SetPosition(
      places[light][0] + 0.05 * frame, places[light][1] - 0.02 * frame, 6.0);
  }
}

using StepFunction = std::function<void(int frame)>;

// Every frame after the first step with grids that are waited for, and with finer tiles; then the first
// frames with late ones.
void DrawWaiting(PlatesWindow& window, int frames, const StepFunction& step,
  std::vector<Picture>& exact, std::vector<Picture>& fine)
{
  for (int frame = 1; frame < frames; ++frame)
  {
    step(frame);
    window.VisibilitiesTo(exact);
    window.Pass->SetQuality(8.0);
    window.VisibilitiesTo(fine);
    window.Pass->SetQuality(3.0);
  }
  window.Pass->SetGridLatency(1);
  step(0);
  window.Visibility();
  window.Visibility();
}

// A step that no grid is waited for: it changes what is asked for by less than the neighbours' wishes
// cover.
std::vector<Picture> DrawLate(PlatesWindow& window, int frame, const StepFunction& step)
{
  step(frame);
  std::vector<Picture> late;
  window.VisibilitiesTo(late);
  EXPECT_EQ(window.Pass->GetCount("grid_waits"), 0) << "frame " << frame;
  EXPECT_EQ(window.Pass->GetCount("late_grids"), 3) << "frame " << frame;
  EXPECT_LT(window.Pass->GetLatencyExcess(), 1.1) << "frame " << frame;
  return late;
}
} // namespace

TEST(VirtualLatency, AllLightsOfAFrameAreWaitedForOnce)
{
  PlatesWindow window(ThreeLights());
  for (int frame = 0; frame < 3; ++frame)
  {
    Step(window, frame);
    window.Window.Render();
    EXPECT_EQ(window.Pass->GetCount("grid_waits"), 1) << "frame " << frame;
    EXPECT_EQ(window.Pass->GetCount("late_grids"), 0) << "frame " << frame;
  }
  window.Pass->SetSplit(2); // twelve emitters
  window.Window.Render();
  EXPECT_EQ(window.Pass->GetCount("grid_waits"), 1) << "parts";
}

TEST(VirtualLatency, EmittersThatAreNotPreparedTogetherLookTheSame)
{
  // Kernels of one emitter fit the memory allowed: the others are drawn and waited for by turns.
  PlatesWindow window(ThreeLights());
  window.Pass->SetMapMemory(64);
  window.Pass->SetQuality(0.5);
  window.Visibility();
  EXPECT_EQ(window.Pass->GetCount("grid_waits"), 1);
  std::vector<Picture> together;
  window.VisibilitiesTo(together);
  const int tiles = window.Pass->GetNumberOfTiles();
  window.Pass->SetMapMemory(2); // 0.5 MiB for 0.6 MiB per emitter
  window.Visibility();
  EXPECT_EQ(window.Pass->GetCount("grid_waits"), 3);
  ASSERT_EQ(window.Pass->GetNumberOfTiles(), tiles) << "coarser: nothing to compare";
  for (int light = 0; light < 3; ++light)
  {
    EXPECT_EQ(Compare(window.Visibility(light), together[light]).Maximum, 0.0) << light;
  }
}

TEST(VirtualLatency, AMovingCameraIsNeverWaitedForAndAsRight)
{
  // An edge between pixels falls to one side or the other with the tiles that happen to be planned, so
  // both are held against finer tiles.
  constexpr int Frames = 4;
  PlatesWindow window(ThreeLights());
  std::vector<Picture> exact;
  std::vector<Picture> fine;
  const auto step = [&window](int frame) { Step(window, frame); };
  DrawWaiting(window, Frames, step, exact, fine);
  for (int frame = 1; frame < Frames; ++frame)
  {
    const std::vector<Picture> late = DrawLate(window, frame, step);
    for (int light = 0; light < 3; ++light)
    {
      const size_t index = 3 * (frame - 1) + light;
      const Errors between = Compare(late[light], exact[index]);
      const Errors before = Compare(exact[index], fine[index]);
      const Errors after = Compare(late[light], fine[index]);
      EXPECT_GT(between.Maximum, 0.0) << "frame " << frame << ": the same tiles";
      EXPECT_LT(between.RootMeanSquare, 0.04) << "frame " << frame << " light " << light;
      EXPECT_LT(after.RootMeanSquare, 1.1 * before.RootMeanSquare)
        << "frame " << frame << " light " << light;
    }
    EXPECT_LT(Compare(late[2], exact[3 * (frame - 1) + 2]).Maximum, 0.1) << "frame " << frame;
  }
}

TEST(VirtualLatency, MovingLightsAreNeverWaitedForAndAsRight)
{
  // As above. A step turns a light by half a degree around the scene, and its map with it.
  constexpr int Frames = 4;
  const std::vector<vtkSmartPointer<vtkAreaLight>> lights = ThreeLights();
  PlatesWindow window(lights);
  std::vector<Picture> exact;
  std::vector<Picture> fine;
  const auto step = [&lights](int frame) { StepLights(lights, frame); };
  DrawWaiting(window, Frames, step, exact, fine);
  for (int frame = 1; frame < Frames; ++frame)
  {
    const std::vector<Picture> late = DrawLate(window, frame, step);
    for (int light = 0; light < 3; ++light)
    {
      const size_t index = 3 * (frame - 1) + light;
      const Errors before = Compare(exact[index], fine[index]);
      const Errors after = Compare(late[light], fine[index]);
      EXPECT_GT(Compare(late[light], exact[index]).Maximum, 0.0)
        << "frame " << frame << ": the same tiles";
      EXPECT_LT(after.RootMeanSquare, 1.1 * before.RootMeanSquare)
        << "frame " << frame << " light " << light;
    }
  }
}

TEST(VirtualLatency, CardsAreNotWaitedForUnlessAsked)
{
  const std::vector<vtkSmartPointer<vtkAreaLight>> lights = ThreeLights();
  for (const bool isCard : { true, false })
  {
    vtkShadowDriver::Pretend(isCard ? vtkShadowDriver::CARD : vtkShadowDriver::PROCESSOR);
    PlatesWindow window(lights);
    window.Visibility();
    EXPECT_EQ(window.Pass->GetCount("grid_waits"), 1) << "first frame, card " << isCard;
    for (int frame = 1; frame < 3; ++frame)
    {
      Step(window, frame);
      StepLights(lights, frame);
      window.Visibility();
      EXPECT_EQ(window.Pass->GetCount("grid_waits"), isCard ? 0 : 1) << "card " << isCard;
    }
    window.Pass->SetGridLatency(0);
    Step(window, 3);
    window.Visibility();
    EXPECT_EQ(window.Pass->GetCount("grid_waits"), 1) << "asked, card " << isCard;
  }
  vtkShadowDriver::Pretend(vtkShadowDriver::TOLD_BY_NAME);
}

TEST(VirtualLatency, ALeapOfTheCameraLeavesNoHole)
{
  // What the frame before did not look at has tiles no coarser than the search map.
  PlatesWindow window(ThreeLights());
  std::vector<Picture> exact;
  std::vector<Picture> late;
  window.Look(0.0, 1.0);
  window.VisibilitiesTo(exact);
  window.Pass->SetGridLatency(1);
  window.Look(3.0, -5.0);
  window.Visibility();
  window.Look(0.0, 1.0);
  window.VisibilitiesTo(late);
  EXPECT_EQ(window.Pass->GetCount("grid_waits"), 0);
  for (int light = 0; light < 3; ++light)
  {
    EXPECT_LT(Compare(late[light], exact[light]).RootMeanSquare, 0.04) << "light " << light;
  }
  // The next frame tells: finer texels were asked for, but for no more than that map has.
  window.Visibility();
  EXPECT_GT(window.Pass->GetLatencyExcess(), 1.0);
  EXPECT_LT(window.Pass->GetLatencyExcess(), 100.0);
}

TEST(VirtualLatency, AStillPictureIsTheExactOne)
{
  PlatesWindow window(ThreeLights());
  Step(window, 5);
  std::vector<Picture> exact;
  window.VisibilitiesTo(exact);
  const std::string tiles = window.Pass->GetTileReport();
  window.Pass->SetGridLatency(1);
  for (int frame = 3; frame <= 5; ++frame)
  {
    Step(window, frame);
    window.Visibility();
  }
  EXPECT_NE(window.Pass->GetTileReport(), tiles) << "nothing was late";
  const vtkTypeInt64 drawn = window.Pass->GetStatistics().VisibilityFrames;
  window.Visibility();
  EXPECT_EQ(window.Pass->GetStatistics().VisibilityFrames, drawn + 1) << "is not drawn anew";
  EXPECT_EQ(window.Pass->GetCount("grid_waits"), 0);
  EXPECT_EQ(window.Pass->GetCount("late_grids"), 0);
  EXPECT_EQ(window.Pass->GetTileReport(), tiles);
  for (int light = 0; light < 3; ++light)
  {
    EXPECT_EQ(Compare(window.Visibility(light), exact[light]).Maximum, 0.0) << "light " << light;
  }
  EXPECT_EQ(window.Pass->GetStatistics().VisibilityFrames, drawn + 1) << "is drawn for ever";
}

TEST(VirtualLatency, AMapThatMovedFarIsWaitedFor)
{
  const std::vector<vtkSmartPointer<vtkAreaLight>> lights = ThreeLights();
  PlatesWindow window(lights);
  lights[1]->SetPosition(-3.0, 0.6, 6.0);
  window.Visibility();
  const Picture exact = window.Visibility(1);
  lights[1]->SetPosition(3.0, 0.5, 6.0); // across the scene
  window.Pass->SetGridLatency(1);
  window.Visibility();
  lights[1]->SetPosition(-3.0, 0.6, 6.0);
  const Picture moved = window.Visibility(1);
  EXPECT_EQ(window.Pass->GetCount("grid_waits"), 1);
  EXPECT_EQ(Compare(moved, exact).Maximum, 0.0);
}

TEST(VirtualLatency, AFrameAfterATinyMoveOfTheLightIsThatOfAFreshPass)
{
  // At |x| = |y| a light without an up vector is between two choices of its axes: the least move may
  // turn its rectangle, and with it the map.
  for (const bool hasUp : { true, false })
  {
    const auto light = MakeLight(2.0, 2.0, 1.0);
    light->SetSize(1.2, 0.4);
    light->SetViewUp(0.0, hasUp ? 1.0 : 0.0, 0.0);
    PlatesWindow window({ light });
    const Picture first = window.Visibility();
    light->SetPosition(2.0 + 1e-7, 2.0, 6.0);
    const Picture moved = window.Visibility();
    light->SetPosition(2.0, 2.0, 6.0);
    EXPECT_EQ(Compare(window.Visibility(), first).Maximum, 0.0) << "up " << hasUp;
    if (hasUp)
    {
      EXPECT_LT(Compare(moved, first).RootMeanSquare, 1e-3);
    }
    light->SetPosition(2.0 + 1e-7, 2.0, 6.0);
    PlatesWindow fresh({ light });
    EXPECT_EQ(Compare(moved, fresh.Visibility()).Maximum, 0.0) << "up " << hasUp;
  }
}

TEST(VirtualLatency, LightsThatGoTakeTheirTilesAlong)
{
  const std::vector<vtkSmartPointer<vtkAreaLight>> lights = ThreeLights();
  PlatesWindow window(lights);
  window.Visibility();
  const int tiles = window.Pass->GetNumberOfTiles();
  lights[2]->SwitchOff();
  window.Visibility();
  EXPECT_LT(window.Pass->GetNumberOfTiles(), tiles);
  EXPECT_EQ(window.Pass->GetTileReport().find("light 2"), std::string::npos);
}
