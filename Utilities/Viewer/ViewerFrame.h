// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the viewer in three layers: the scene; over it, in the same room, view and light handle;
 * over the whole window menu and status. Shadow passes see the lowest alone.
 */

#ifndef ViewerFrame_h
#define ViewerFrame_h

#include "ErrorMeter.h"
#include "FrameClock.h"
#include "LightHandle.h"
#include "MenuLayout.h"
#include "MenuPainter.h"
#include "ViewImage.h"
#include "ViewedScene.h"
#include "ViewerState.h"
#include "VisibilityFile.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

class vtkRenderWindowInteractor;

namespace softshadows
{

class ViewerFrame
{
public:
  /// State and window outlive the frame. Throws SceneError for models.
  ViewerFrame(ViewerState& state, ModelStore& models, vtkRenderWindow* window);
  ~ViewerFrame();
  ViewerFrame(const ViewerFrame&) = delete;
  ViewerFrame& operator=(const ViewerFrame&) = delete;

  /// The light's handle needs the window's interactor.
  void AddHandle(vtkRenderWindowInteractor* interactor);

  /// Draws all anew. Not while it draws: then nothing happens.
  void Draw();

  ///@{
  /// Starts the error's reference once camera and lights have rested for a while.
  /// Whether there is anything to wait for.
  bool IsWaiting() const;
  /// True if there is news to be drawn.
  bool Rest();
  ///@}

  ///@{
  /// What the scene's room shows, without the handle; draws frames.
  std::vector<unsigned char> GetPicture(); ///< RGB, top row first.
  VisibilityImage GetVisibility();
  ///@}

  /// Line of the last thing done.
  void SetMessage(const std::string& message) { this->Status.Message = message; }

  ViewedScene& GetScene() { return this->Scene; }
  const MenuLayout& GetLayout() const { return *this->Layout; }
  const MenuStatus& GetStatus() const { return this->Status; }
  const LightHandle* GetHandle() const { return this->Handle.get(); }
  ///@{
  /// Of the scene, in pixels.
  const MenuRect& GetRoom() const { return this->Room; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  ///@}
  /// Of the selected light in the last frame; NaN while there is no reference.
  double GetRmse() const { return this->Rmse; }

private:
  using Clock = std::chrono::steady_clock;

  ViewerState& State;
  vtkRenderWindow* Window;
  ViewedScene Scene;
  vtkNew<vtkRenderer> Above;
  vtkNew<vtkRenderer> Menu;
  ViewImage Image;
  MenuPainter Painter;
  std::unique_ptr<LightHandle> Handle;
  std::unique_ptr<MenuLayout> Layout;
  MenuStatus Status;
  FrameClock Times;
  ErrorMeter Meter;

  std::array<int, 2> WindowSize{ { 0, 0 } };
  MenuRect Room; ///< The scene's, in the window.
  int Width = 0; ///< The scene's.
  int Height = 0;
  bool Drawing = false;
  vtkSoftShadowPass* LastPass = nullptr;
  std::vector<double> Pose; ///< Of camera and lights in the last frame.
  Clock::time_point LastMove;
  Clock::time_point LastNews;
  std::vector<float> Visibility; ///< Of the selected light in the last frame, if it was needed.
  double Rmse;
  bool ShownRunning = false; ///< Whether the reference was being traced in the last frame.
  std::shared_ptr<const BackgroundReference::Result> MeasuredWith;

  void FitRoom();
  bool HasRoomsSize(); ///< False if the window became another while it was drawn.
  void NoteMoves();
  void SceneDrawn(); ///< And the layers above not yet.
  void UpdateError();
  void UpdateImage();
  void UpdateMenu();
  std::string SpellProgress() const;
  void UpdateHandle();
  std::vector<float> ReadVisibility(int light);
};

}

#endif
