// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewerFrame.h"

#include "DifferencePicture.h"
#include "PassImages.h"
#include "ScopedFlag.h"
#include "VisibilityPicture.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace softshadows
{
namespace
{

using Source = DebugView::Source;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// How long nothing moves before the reference is traced, and between two reports of its progress.
constexpr std::chrono::milliseconds RestTime{ 400 };
constexpr std::chrono::milliseconds NewsTime{ 1000 };

//--------------------------------------------------------------------------------------------------
void Append(std::vector<double>& all, const double* values, int count)
{
  all.insert(all.end(), values, values + count);
}

}

//--------------------------------------------------------------------------------------------------
ViewerFrame::ViewerFrame(ViewerState& state, ModelStore& models, vtkRenderWindow* window)
  : State(state)
  , Window(window)
  , Scene(state, models)
  , Image(Above)
  , Painter(Menu)
  , Rmse(NaN)
{
  this->Window->SetMultiSamples(0); // a pixel is its centre, as in the reference
  this->Window->SetNumberOfLayers(3);
  int layer = 0;
  for (vtkRenderer* renderer : { this->Scene.GetRenderer(), this->Above.Get(), this->Menu.Get() })
  {
    renderer->SetLayer(layer);
    renderer->SetInteractive(layer == 0);
    this->Window->AddRenderer(renderer);
    ++layer;
  }
  this->Above->AddObserver(vtkCommand::StartEvent, this, &ViewerFrame::SceneDrawn);
  this->Layout = std::make_unique<MenuLayout>(state, this->Status, 1, 1);
}

//--------------------------------------------------------------------------------------------------
ViewerFrame::~ViewerFrame()
{
  // While the context lives.
  this->Handle.reset();
  this->Scene.Release(this->Window);
  this->Window->RemoveRenderer(this->Menu);
  this->Window->RemoveRenderer(this->Above);
  this->Window->RemoveRenderer(this->Scene.GetRenderer());
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::AddHandle(vtkRenderWindowInteractor* interactor)
{
  if (this->State.HasLight())
  {
    this->Handle = std::make_unique<LightHandle>(this->Above, interactor,
      [this](const Vector3& position) { this->State.SetLightPosition(position); });
  }
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::Draw()
{
  if (this->Drawing)
  {
    return;
  }
  const ScopedFlag drawing(this->Drawing);
  const bool isFirst = this->Width == 0;
  this->FitRoom();
  if (isFirst)
  {
    this->Scene.OpenView(static_cast<double>(this->Width) / this->Height);
  }
  this->Scene.Update(this->State, this->Window);
  if (this->LastPass != this->Scene.GetPass())
  {
    this->LastPass = this->Scene.GetPass();
    this->Times.Reset();
  }
  this->Scene.FitClipping(static_cast<double>(this->Width) / this->Height);
  this->NoteMoves();
  this->UpdateHandle();
  this->Window->WaitForCompletion();
  this->Times.Begin();
  this->Window->Render();
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::FitRoom()
{
  const int* size = this->Window->GetActualSize();
  this->WindowSize = { { size[0], size[1] } };
  this->Room = GetSceneRoom(this->State, size[0], size[1]);
  const double left = static_cast<double>(this->Room.X) / size[0];
  const double bottom = static_cast<double>(this->Room.Y) / size[1];
  this->Scene.GetRenderer()->SetViewport(left, bottom, 1.0, 1.0);
  this->Above->SetViewport(left, bottom, 1.0, 1.0);
  // The pixels that VTK makes of the fractions.
  this->Scene.GetRenderer()->GetTiledSizeAndOrigin(
    &this->Width, &this->Height, &this->Room.X, &this->Room.Y);
  this->Room.Width = this->Width;
  this->Room.Height = this->Height;
}

//--------------------------------------------------------------------------------------------------
bool ViewerFrame::HasRoomsSize()
{
  int size[2];
  int origin[2];
  this->Scene.GetRenderer()->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  return size[0] == this->Width && size[1] == this->Height;
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::NoteMoves()
{
  std::vector<double> pose = { static_cast<double>(this->Width),
    static_cast<double>(this->Height) };
  const CameraDescription camera = this->Scene.GetCamera();
  Append(pose, camera.Position.data(), 3);
  Append(pose, camera.FocalPoint.data(), 3);
  Append(pose, camera.ViewUp.data(), 3);
  pose.push_back(camera.ViewAngle);
  pose.push_back(camera.ParallelScale.value_or(0.0));
  for (const LightDescription& light : this->State.GetScene().Lights)
  {
    Append(pose, light.Position.data(), 3);
    Append(pose, light.Size.data(), 2);
    pose.push_back(light.AngularDiameter);
    pose.push_back(static_cast<double>(light.Shape));
  }
  const bool isOtherLight = !this->Meter.IsFor(this->State.HasGaussianWeights());
  if (pose != this->Pose || (this->Meter.IsStarted() && isOtherLight))
  {
    this->Pose = pose;
    this->LastMove = Clock::now();
    this->Meter.Cancel();
    this->MeasuredWith.reset();
    this->Rmse = NaN;
  }
}

//--------------------------------------------------------------------------------------------------
bool ViewerFrame::IsWaiting() const
{
  if (this->State.IsProgressive() && this->Scene.GetPass()->GetRefining())
  {
    return true;
  }
  return this->State.HasLight() &&
    (!this->Meter.IsStarted() || this->Meter.IsRunning() ||
      this->Meter.IsRunning() != this->ShownRunning ||
      this->Meter.GetReference() != this->MeasuredWith);
}

//--------------------------------------------------------------------------------------------------
bool ViewerFrame::Rest()
{
  const Clock::time_point now = Clock::now();
  if (!this->Meter.IsStarted())
  {
    if (!this->State.HasLight() || this->Pose.empty() || now - this->LastMove < RestTime)
    {
      return false;
    }
    this->Meter.Start(
      this->Scene.GetRenderer(), this->Width, this->Height, this->State.HasGaussianWeights());
    this->LastNews = now;
  }
  if (this->State.IsProgressive() && this->Scene.GetPass()->GetRefining())
  {
    return true;
  }
  // A trace that failed ends without another reference.
  const bool hasNews = this->Meter.IsRunning() != this->ShownRunning ||
    this->Meter.GetReference() != this->MeasuredWith;
  if (hasNews || now - this->LastNews >= NewsTime)
  {
    this->LastNews = now;
    return true;
  }
  return false;
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::SceneDrawn()
{
  this->Window->WaitForCompletion();
  const bool isNew = this->Times.End(this->Scene.GetPass());
  if (isNew)
  {
    this->MeasuredWith.reset();
  }
  this->Visibility.clear();
  if (!this->HasRoomsSize())
  {
    this->Rmse = NaN;
    this->Image.Hide();
    return;
  }
  this->UpdateError();
  this->UpdateImage();
  this->UpdateMenu();
}

//--------------------------------------------------------------------------------------------------
std::vector<float> ViewerFrame::ReadVisibility(int light)
{
  return ImageValues(this->Scene.GetPass()->GetVisibilityImage(this->Scene.GetLight(light)),
    this->Width, this->Height);
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::UpdateError()
{
  this->ShownRunning = this->Meter.IsRunning(); // before the reference: its end is then news
  const auto reference = this->Meter.GetReference();
  if (!reference)
  {
    this->Rmse = NaN;
    return;
  }
  if (!this->State.GetView().KeepsVisibility())
  {
    this->Rmse = NaN;
  }
  else
  {
    this->Visibility = this->ReadVisibility(this->State.GetLightPlace());
    this->Rmse = this->Meter.Measure(this->State.GetLightPlace(), this->Visibility);
  }
  this->MeasuredWith = reference;
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::UpdateImage()
{
  const Source source = this->State.GetView().Shows;
  const auto reference = this->Meter.GetReference();
  if (source == Source::Picture || !this->State.HasLight() ||
    (source == Source::Error && !reference))
  {
    this->Image.Hide();
    return;
  }
  std::vector<float> values = this->Visibility;
  if (values.empty())
  {
    values = this->ReadVisibility(this->State.GetLightPlace());
  }
  std::vector<unsigned char> rgb;
  switch (source)
  {
    case Source::Penumbra:
      rgb = DrawPenumbra(values);
      break;
    case Source::Error:
      rgb = DrawDifference(reference->Images.Visibility[this->State.GetLightPlace()], values);
      break;
    default:
      rgb = DrawGrey(values);
  }
  this->Image.Show(rgb, this->Width, this->Height);
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::UpdateMenu()
{
  std::string error = "the error against ray tracing follows when the view rests";
  if (!this->State.HasLight())
  {
    error = "the scene has no light";
  }
  else if (this->Meter.IsStarted())
  {
    error = this->Meter.Spell(this->Rmse);
  }
  this->Status.Lines = { this->State.GetTechnique().Name + ", " + std::to_string(this->Width) +
      " x " + std::to_string(this->Height) + " pixels: " + this->Times.Spell(),
    error };
  if (this->State.IsProgressive() && this->State.GetView().KeepsVisibility())
  {
    this->Status.Lines.front() += this->SpellProgress();
  }
  if (!this->State.IsMenuOpen())
  {
    this->Status.Lines.back() += "   (m menu, h help)";
  }
  this->Layout = std::make_unique<MenuLayout>(
    this->State, this->Status, this->WindowSize[0], this->WindowSize[1]);
  this->Painter.Update(*this->Layout);
}

//--------------------------------------------------------------------------------------------------
std::string ViewerFrame::SpellProgress() const
{
  vtkSoftShadowPass* pass = this->Scene.GetPass();
  char text[64];
  std::snprintf(text, sizeof(text), "; %s, estimated error %.3f",
    pass->GetRefining() ? "converging" : (pass->GetConverged() ? "converged" : "as far as maps go"),
    pass->GetEstimatedError());
  return text;
}

//--------------------------------------------------------------------------------------------------
void ViewerFrame::UpdateHandle()
{
  if (!this->Handle)
  {
    return;
  }
  const MenuScale scale(this->WindowSize[1]);
  this->Handle->SetVisible(this->State.IsHandleShown());
  this->Handle->Update(this->State.GetLight(), this->Scene.GetLight(this->State.GetLightPlace()),
    this->Scene.GetRenderer()->GetActiveCamera(), 2 * scale.Row);
}

//--------------------------------------------------------------------------------------------------
std::vector<unsigned char> ViewerFrame::GetPicture()
{
  this->Painter.SetVisible(false); // a message may lie over the scene
  const bool handleWasShown = this->Handle && this->State.IsHandleShown();
  if (handleWasShown)
  {
    this->State.Perform({ ViewerAction::Kind::ToggleHandle, 0, "" });
  }
  this->Draw();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(this->Room.X, this->Room.Y, this->Room.X + this->Width - 1,
    this->Room.Y + this->Height - 1, 1, pixels);
  this->Painter.SetVisible(true);
  if (handleWasShown)
  {
    this->State.Perform({ ViewerAction::Kind::ToggleHandle, 0, "" });
  }
  return TopRowFirst(pixels->GetPointer(0), 3 * this->Width, this->Height);
}

//--------------------------------------------------------------------------------------------------
VisibilityImage ViewerFrame::GetVisibility()
{
  // Some views replace the visibility by what they show.
  const int view = this->State.GetViewPlace();
  this->State.SetView(0);
  this->Draw();
  VisibilityImage image;
  image.Width = this->Width;
  image.Height = this->Height;
  for (int i = 0; i < this->Scene.GetNumberOfLights(); ++i)
  {
    image.Visibility.push_back(this->ReadVisibility(i));
  }
  image.Depth = ImageValues(this->Scene.GetPass()->GetDepthImage(), this->Width, this->Height);
  this->State.SetView(view);
  return image;
}

}
