// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The viewer's window: keys and mouse to the state, the state to the screen.
 */

#ifndef ViewerWindow_h
#define ViewerWindow_h

#include "ViewerFrame.h"
#include "ViewerState.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkCallbackCommand;
class vtkObject;

namespace softshadows
{

/// Where the viewer saves and looks for models.
struct ViewerPaths
{
  std::string Output = ".";              ///< Folder of what is saved.
  std::string Stem = "view";             ///< What names of files start with.
  std::vector<std::string> ModelFolders; ///< Beside the scene's own.
};

/**
 * Frames are drawn only when something changed: an event, or news of the reference, for which a
 * timer runs as long as there is something to wait for.
 */
class ViewerWindow
{
public:
  /**
   * Opens the window; needs a display. Throws SceneError for models and std::runtime_error if there
   * is no usable OpenGL.
   */
  ViewerWindow(ViewerState& state, ModelStore& models, ViewerPaths paths, int width, int height);
  ~ViewerWindow();
  ViewerWindow(const ViewerWindow&) = delete;
  ViewerWindow& operator=(const ViewerWindow&) = delete;

  /// Runs until the window is closed.
  void Run();

  /// Does what a key or a click asks for, and draws what changed by it.
  void Perform(const ViewerAction& action);

  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkRenderWindowInteractor* GetInteractor() { return this->Interactor; }
  ViewerFrame& GetFrame() { return *this->Frame; }

private:
  ViewerState& State;
  ViewerPaths Paths;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Events;
  std::unique_ptr<ViewerFrame> Frame;
  bool NeedsDrawing = false;
  bool PressedOnMenu = false;
  int Timer = 0;        ///< 0: none.
  bool InTimer = false; ///< While the timer's event is handled.

  static void OnEvent(vtkObject* caller, unsigned long event, void* self, void* data);
  bool Handle(unsigned long event); ///< True: nobody else shall have the event.
  void HandleTimer();
  bool HandleMouse(unsigned long event);
  void Draw();
  void Wait();
  void Save(const ViewerAction& action);
  void SaveAs(ViewerAction::Kind what, const std::string& path);
};

}

#endif
