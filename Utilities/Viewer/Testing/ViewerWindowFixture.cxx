// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewerWindowFixture.h"

#include "vtkCommand.h"
#include "vtkUnsignedCharArray.h"

#include <chrono>
#include <thread>

using namespace softshadows;

namespace fs = std::filesystem;

//--------------------------------------------------------------------------------------------------
double Screen::Differing(const Screen& other, const MenuRect& where) const
{
  std::size_t count = 0;
  for (int y = where.Y; y < where.Y + where.Height; ++y)
  {
    for (int x = where.X; x < where.X + where.Width; ++x)
    {
      const std::size_t at = 3 * (static_cast<std::size_t>(y) * this->Width + x);
      count += this->Pixels[at] != other.Pixels[at] ||
          this->Pixels[at + 1] != other.Pixels[at + 1] ||
          this->Pixels[at + 2] != other.Pixels[at + 2]
        ? 1
        : 0;
    }
  }
  return static_cast<double>(count) / (static_cast<double>(where.Width) * where.Height);
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::SetUp()
{
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  this->Folder = fs::path(SOFTSHADOWS_TEST_OUTPUT_DIR) / (std::string("Viewer-") + test->name());
  fs::remove_all(this->Folder);
  fs::create_directories(this->Folder);
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::TearDown()
{
  this->Window.reset();
  if (!this->HasFailure())
  {
    fs::remove_all(this->Folder);
  }
}

//--------------------------------------------------------------------------------------------------
SceneDescription ViewerWindowTest::MakeScene()
{
  SceneDescription scene;
  CameraDescription camera;
  camera.Position = { { 0.0, -9.0, 6.0 } };
  camera.FocalPoint = { { 0.0, 0.0, 0.5 } };
  camera.ViewUp = { { 0.0, 0.0, 1.0 } };
  scene.Camera = camera;
  LightDescription light;
  light.Position = { { -1.5, 0.0, 3.0 } };
  light.Size = { { 0.6, 0.6 } };
  scene.Lights.push_back(light);
  scene.Objects.resize(2);
  scene.Objects[0].Shape =
    PlaneShape{ { { -6.0, -6.0, 0.0 } }, { { 6.0, -6.0, 0.0 } }, { { -6.0, 6.0, 0.0 } }, 1, 1 };
  scene.Objects[1].Shape = BoxShape{ { -0.5, 0.5, -0.5, 0.5, 0.6, 1.4 } };
  return scene;
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::Open(const std::string& technique)
{
  this->State = std::make_unique<ViewerState>(MakeScene(), technique);
  this->State->SetOption("map_size", 256);
  ViewerPaths paths;
  paths.Output = this->Folder.string();
  paths.Stem = "test";
  this->Window = std::make_unique<ViewerWindow>(*this->State, this->Models, paths, Width, Height);
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::Send(unsigned long event, int x, int y)
{
  vtkRenderWindowInteractor* interactor = this->Window->GetInteractor();
  interactor->SetEventInformation(x, y, 0, 0, 0, 0, nullptr);
  interactor->InvokeEvent(event, nullptr);
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::Press(const std::string& key)
{
  vtkRenderWindowInteractor* interactor = this->Window->GetInteractor();
  const char code = key.size() == 1 ? key[0] : '\0';
  interactor->SetKeyEventInformation(0, 0, code, 1, key.c_str());
  interactor->InvokeEvent(vtkCommand::KeyPressEvent, nullptr);
  interactor->InvokeEvent(vtkCommand::CharEvent, nullptr);
  interactor->InvokeEvent(vtkCommand::KeyReleaseEvent, nullptr);
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::Click(int x, int y)
{
  this->Send(vtkCommand::MouseMoveEvent, x, y);
  this->Send(vtkCommand::LeftButtonPressEvent, x, y);
  this->Send(vtkCommand::LeftButtonReleaseEvent, x, y);
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::Click(const ViewerAction& action)
{
  for (const MenuBox& box : this->Frame().GetLayout().GetBoxes())
  {
    if (box.Click == action)
    {
      const MenuRect place = box.Place; // the click makes another layout
      this->Click(place.X + place.Width / 2, place.Y + place.Height / 2);
      return;
    }
  }
  FAIL() << "the menu has no such box";
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::Drag(int fromX, int fromY, int toX, int toY)
{
  constexpr int steps = 4;
  this->Send(vtkCommand::MouseMoveEvent, fromX, fromY);
  this->Send(vtkCommand::LeftButtonPressEvent, fromX, fromY);
  for (int i = 1; i <= steps; ++i)
  {
    this->Send(vtkCommand::MouseMoveEvent, fromX + (toX - fromX) * i / steps,
      fromY + (toY - fromY) * i / steps);
  }
  this->Send(vtkCommand::LeftButtonReleaseEvent, toX, toY);
}

//--------------------------------------------------------------------------------------------------
Screen ViewerWindowTest::Grab()
{
  const int* size = this->Window->GetWindow()->GetActualSize();
  Screen screen;
  screen.Width = size[0];
  screen.Height = size[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetWindow()->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  screen.Pixels.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  return screen;
}

//--------------------------------------------------------------------------------------------------
void ViewerWindowTest::Rest(int raysPerPixel)
{
  const std::string wanted = "with " + std::to_string(raysPerPixel) + " rays";
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (this->Frame().GetStatus().Lines[1].find(wanted) == std::string::npos &&
    std::chrono::steady_clock::now() < deadline)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    this->Window->GetInteractor()->InvokeEvent(vtkCommand::TimerEvent, nullptr);
  }
  ASSERT_NE(this->Frame().GetStatus().Lines[1].find(wanted), std::string::npos)
    << this->Frame().GetStatus().Lines[1];
}
