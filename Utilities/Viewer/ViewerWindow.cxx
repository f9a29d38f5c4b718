// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewerWindow.h"

#include "KeyBindings.h"
#include "PictureFile.h"
#include "ScopedFlag.h"
#include "ViewerFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkObjectFactory.h"

#include <exception>
#include <stdexcept>

namespace softshadows
{
namespace
{

using Kind = ViewerAction::Kind;

constexpr float BeforeWidgets = 10.0F; // priority: the menu lies above the scene and its handles
constexpr unsigned long TimerMilliseconds = 100;

//--------------------------------------------------------------------------------------------------
/// The mouse of VTK's trackball without VTK's keys.
class CameraStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static CameraStyle* New();
  vtkTypeMacro(CameraStyle, vtkInteractorStyleTrackballCamera);
  void OnChar() override {}
};
vtkStandardNewMacro(CameraStyle);

}

//--------------------------------------------------------------------------------------------------
ViewerWindow::ViewerWindow(
  ViewerState& state, ModelStore& models, ViewerPaths paths, int width, int height)
  : State(state)
  , Paths(std::move(paths))
  , Frame(std::make_unique<ViewerFrame>(state, models, Window))
{
  this->Window->SetSize(width, height);
  this->Window->SetWindowName(("SoftShadows: " + this->Paths.Stem).c_str());
  if (!this->Window->SupportsOpenGL())
  {
    throw std::runtime_error("OpenGL 3.2 is needed, and the display does not have it");
  }
  this->Interactor->SetRenderWindow(this->Window);
  vtkNew<CameraStyle> style;
  style->AutoAdjustCameraClippingRangeOff(); // the frame fits it to what is in view
  style->SetDefaultRenderer(this->Frame->GetScene().GetRenderer());
  this->Interactor->SetInteractorStyle(style);
  this->Interactor->SetLightFollowCamera(0);
  this->Interactor->EnableRenderOff(); // RenderEvent draws: all frames go one way
  this->Events->SetClientData(this);
  this->Events->SetCallback(&ViewerWindow::OnEvent);
  for (const unsigned long event : { vtkCommand::KeyPressEvent, vtkCommand::LeftButtonPressEvent,
         vtkCommand::LeftButtonDoubleClickEvent, vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::MouseMoveEvent, vtkCommand::MouseWheelForwardEvent,
         vtkCommand::MouseWheelBackwardEvent, vtkCommand::RenderEvent, vtkCommand::TimerEvent })
  {
    this->Interactor->AddObserver(event, this->Events, BeforeWidgets);
  }
  this->State.SetObserver([this](ViewerState::Change) { this->NeedsDrawing = true; });
  this->Interactor->Initialize();
  this->Frame->AddHandle(this->Interactor);
  this->Draw();
}

//--------------------------------------------------------------------------------------------------
ViewerWindow::~ViewerWindow()
{
  this->State.SetObserver({});
  this->Interactor->RemoveObserver(this->Events);
  this->Frame.reset();
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::Run()
{
  this->Interactor->Start();
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::OnEvent(vtkObject*, unsigned long event, void* self, void*)
{
  auto* window = static_cast<ViewerWindow*>(self);
  window->Events->SetAbortFlag(window->Handle(event) ? 1 : 0);
}

//--------------------------------------------------------------------------------------------------
bool ViewerWindow::Handle(unsigned long event)
{
  if (!this->Window->GetGenericWindowId())
  {
    return false; // a timer may fire once more after the window was closed
  }
  switch (event)
  {
    case vtkCommand::RenderEvent:
      this->Draw();
      return false;
    case vtkCommand::TimerEvent:
      this->HandleTimer();
      return false;
    case vtkCommand::KeyPressEvent:
    {
      const char* key = this->Interactor->GetKeySym();
      const ViewerAction action = FindAction(key ? key : "");
      this->Perform(action);
      return action.Is != Kind::None;
    }
    default:
      return this->HandleMouse(event);
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::HandleTimer()
{
  const ScopedFlag inTimer(this->InTimer);
  if (this->Frame->Rest())
  {
    this->Draw();
  }
  this->Wait();
}

//--------------------------------------------------------------------------------------------------
bool ViewerWindow::HandleMouse(unsigned long event)
{
  const int* place = this->Interactor->GetEventPosition();
  const MenuLayout& layout = this->Frame->GetLayout();
  const bool isOnMenu = layout.Covers(place[0], place[1]);
  switch (event)
  {
    case vtkCommand::LeftButtonPressEvent:
    case vtkCommand::LeftButtonDoubleClickEvent:
      this->PressedOnMenu = isOnMenu;
      if (isOnMenu)
      {
        this->Perform(ViewerAction(layout.GetAction(place[0], place[1])));
      }
      return isOnMenu;
    case vtkCommand::LeftButtonReleaseEvent:
    {
      const bool wasOnMenu = this->PressedOnMenu;
      this->PressedOnMenu = false;
      return wasOnMenu;
    }
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent:
      if (isOnMenu)
      {
        this->Perform(
          { Kind::StepSelection, event == vtkCommand::MouseWheelForwardEvent ? -1 : 1, "" });
      }
      return isOnMenu;
    default:
      return this->PressedOnMenu; // a drag that began on the menu moves nothing
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::Perform(const ViewerAction& action)
{
  switch (action.Is)
  {
    case Kind::None:
      return;
    case Kind::Quit:
      this->Interactor->TerminateApp();
      return;
    case Kind::ResetCamera:
      this->Frame->GetScene().ResetCamera();
      this->NeedsDrawing = true;
      break;
    case Kind::SavePicture:
    case Kind::SaveVisibility:
    case Kind::SaveScene:
      this->Save(action);
      this->NeedsDrawing = true;
      break;
    default:
      this->Frame->SetMessage({});
      this->State.Perform(action);
  }
  if (this->NeedsDrawing)
  {
    this->Draw();
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::Draw()
{
  this->NeedsDrawing = false;
  this->Frame->Draw();
  this->Wait();
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::Wait()
{
  const bool isWaiting = this->Frame->IsWaiting();
  if (isWaiting && this->Timer == 0)
  {
    this->Timer = this->Interactor->CreateRepeatingTimer(TimerMilliseconds);
  }
  else if (!isWaiting && this->Timer != 0 && !this->InTimer)
  {
    // Not in its own event: VTK walks its list of timers then. The next frame that a key or the mouse
    // asks for ends it.
    this->Interactor->DestroyTimer(this->Timer);
    this->Timer = 0;
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::Save(const ViewerAction& action)
{
  const char* ending = action.Is == Kind::SavePicture ? ".png" : ".exr";
  ending = action.Is == Kind::SaveScene ? ".json" : ending;
  const std::string path = FreeFileName(this->Paths.Output, this->Paths.Stem, ending);
  try
  {
    this->SaveAs(action.Is, path);
    this->Frame->SetMessage("saved " + path);
  }
  catch (const std::exception& error)
  {
    this->Frame->SetMessage(std::string("not saved: ") + error.what());
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerWindow::SaveAs(ViewerAction::Kind what, const std::string& path)
{
  ViewerFrame& frame = *this->Frame;
  if (what == Kind::SavePicture)
  {
    const std::vector<unsigned char> picture = frame.GetPicture();
    WritePicture(path, frame.GetWidth(), frame.GetHeight(), picture);
  }
  else if (what == Kind::SaveVisibility)
  {
    WriteVisibility(path, frame.GetVisibility());
  }
  else
  {
    this->State.SetCamera(frame.GetScene().GetCamera());
    this->State.SetImageSize(frame.GetWidth(), frame.GetHeight());
    SaveScene(path, this->State.GetScene(), this->Paths.ModelFolders);
  }
}

}
