// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightHandle.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkInteractorObserver.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace softshadows
{
namespace
{

constexpr double Yellow[3] = { 1.0, 0.80, 0.15 };
constexpr double BallPixels = 18.0;

//--------------------------------------------------------------------------------------------------
void AddLine(vtkPoints* points, vtkCellArray* lines, const Vector3& from, const Vector3& to)
{
  const vtkIdType ends[2] = { points->InsertNextPoint(from.data()),
    points->InsertNextPoint(to.data()) };
  lines->InsertNextCell(2, ends);
}

//--------------------------------------------------------------------------------------------------
/// The outline of the light, closed: points of its rectangle or disk.
std::vector<Vector3> Outline(vtkAreaLight* light)
{
  constexpr int segments = 48;
  double width[3];
  double height[3];
  double direction[3];
  vtkAreaLight::GetTransformedAxes(light, width, height, direction);
  const double* center = light->GetTransformedPosition();
  const double* size = light->GetSize();
  const bool isDisk = light->GetShape() == vtkAreaLight::DISK;
  const int corners = isDisk ? segments : 4;
  std::vector<Vector3> points;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * (i + (isDisk ? 0.0 : 0.5)) / corners;
    const double stretch = isDisk ? 0.5 : std::sqrt(0.5);
    const double u = stretch * size[0] * std::cos(angle);
    const double v = stretch * size[1] * std::sin(angle);
    Vector3 point;
    for (int k = 0; k < 3; ++k)
    {
      point[k] = center[k] + u * width[k] + v * height[k];
    }
    points.push_back(point);
  }
  return points;
}

}

//--------------------------------------------------------------------------------------------------
LightHandle::LightHandle(
  vtkRenderer* overlay, vtkRenderWindowInteractor* interactor, Observer moved)
  : Overlay(overlay)
  , Moved(std::move(moved))
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Lines);
  this->LineActor->SetMapper(mapper);
  this->LineActor->GetProperty()->SetColor(Yellow[0], Yellow[1], Yellow[2]);
  this->LineActor->GetProperty()->LightingOff();
  this->LineActor->GetProperty()->SetLineWidth(2.0F);
  this->LineActor->PickableOff();
  this->Overlay->AddActor(this->LineActor);

  this->Ball->SetHandleSize(BallPixels);
  this->Ball->TranslationModeOn();
  vtkProperty* property = this->Ball->GetProperty();
  property->SetColor(Yellow[0], Yellow[1], Yellow[2]);
  property->SetAmbient(0.4);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.4);
  this->Ball->GetSelectedProperty()->SetColor(1.0, 1.0, 0.7);
  this->Ball->GetSelectedProperty()->SetAmbient(0.6);

  this->Widget->SetRepresentation(this->Ball);
  this->Widget->SetInteractor(interactor);
  this->Widget->SetDefaultRenderer(overlay);
  this->Widget->EnableAxisConstraintOff(); // its keys are the viewer's
  this->Widget->AllowHandleResizeOff();
  this->Widget->KeyPressActivationOff();
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this, &LightHandle::Dragged);
  this->Widget->AddObserver(vtkCommand::StartInteractionEvent, this, &LightHandle::Started);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this, &LightHandle::Ended);
  this->Widget->On();
}

//--------------------------------------------------------------------------------------------------
LightHandle::~LightHandle()
{
  this->Widget->Off();
  this->Widget->SetInteractor(nullptr);
  this->Overlay->RemoveActor(this->LineActor);
}

//--------------------------------------------------------------------------------------------------
void LightHandle::SetVisible(bool visible)
{
  this->LineActor->SetVisibility(visible);
  if (visible != (this->Widget->GetEnabled() != 0))
  {
    this->Widget->SetEnabled(visible);
  }
}

//--------------------------------------------------------------------------------------------------
void LightHandle::Dragged()
{
  double ball[3];
  this->Ball->GetWorldPosition(ball);
  Vector3 position;
  for (int i = 0; i < 3; ++i)
  {
    // As if the drag were made at the light itself.
    position[i] = this->Focal[i] + (ball[i] - this->Anchor[i]) / this->Share;
  }
  this->Moved(position);
}

//--------------------------------------------------------------------------------------------------
void LightHandle::Update(
  const LightDescription& description, vtkAreaLight* light, vtkCamera* camera, int margin)
{
  this->Focal = description.FocalPoint;
  this->Anchor = this->Focal;
  vtkMath::Subtract(description.Position.data(), this->Focal.data(), this->Way.data());
  if (description.Directional)
  {
    // A sun stands nowhere: its line starts where the camera looks.
    camera->GetFocalPoint(this->Anchor.data());
    constexpr double length = 0.6;
    vtkMath::Normalize(this->Way.data());
    vtkMath::MultiplyScalar(this->Way.data(), length * camera->GetDistance());
  }
  this->FollowCamera(camera);
  if (!this->Dragging) // then it is where the mouse is
  {
    this->PlaceBall(margin);
  }
  this->DrawLines(light, description.Directional);
}

//--------------------------------------------------------------------------------------------------
Vector3 LightHandle::OnWay(double share) const
{
  Vector3 point;
  for (int i = 0; i < 3; ++i)
  {
    point[i] = this->Anchor[i] + share * this->Way[i];
  }
  return point;
}

//--------------------------------------------------------------------------------------------------
void LightHandle::FollowCamera(vtkCamera* camera)
{
  vtkCamera* own = this->Overlay->GetActiveCamera();
  own->DeepCopy(camera);
  double eye[3];
  camera->GetPosition(eye);
  const Vector3 end = this->OnWay(1.0);
  const double farthest = std::sqrt(std::max(vtkMath::Distance2BetweenPoints(eye, end.data()),
                            vtkMath::Distance2BetweenPoints(eye, this->Anchor.data()))) +
    vtkMath::Norm(this->Way.data()) + camera->GetDistance();
  constexpr double nearest = 1e-3; // of the farthest: nothing here hides anything else
  own->SetClippingRange(nearest * farthest, 2.0 * farthest);
}

//--------------------------------------------------------------------------------------------------
bool LightHandle::IsInRoom(const Vector3& point, int margin) const
{
  const int* size = this->Overlay->GetSize();
  double x = point[0];
  double y = point[1];
  double z = point[2];
  vtkCamera* camera = this->Overlay->GetActiveCamera();
  double eye[3];
  double view[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(view);
  double way[3];
  vtkMath::Subtract(point.data(), eye, way);
  if (!camera->GetParallelProjection() && vtkMath::Dot(way, view) <= 0.0)
  {
    return false; // behind the camera
  }
  this->Overlay->WorldToView(x, y, z);
  const double column = 0.5 * (x + 1.0) * size[0];
  const double row = 0.5 * (y + 1.0) * size[1];
  return column > margin && column < size[0] - margin && row > margin && row < size[1] - margin;
}

//--------------------------------------------------------------------------------------------------
void LightHandle::PlaceBall(int margin)
{
  constexpr double step = 0.98;
  constexpr double least = 0.02;
  double share = 1.0;
  while (share > least && !this->IsInRoom(this->OnWay(share), margin))
  {
    share *= step;
  }
  this->Share = share > least ? share : 1.0; // not even its start is in view
  Vector3 place = this->OnWay(this->Share);
  this->Ball->SetWorldPosition(place.data());
  this->Ball->Modified(); // its size is in pixels
}

//--------------------------------------------------------------------------------------------------
void LightHandle::DrawLines(vtkAreaLight* light, bool directional)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  AddLine(points, lines, this->Anchor, this->OnWay(1.0));
  if (!directional && light->GetShape() != vtkAreaLight::POINT)
  {
    const std::vector<Vector3> outline = Outline(light);
    for (std::size_t i = 1; i < outline.size(); ++i)
    {
      AddLine(points, lines, outline[i - 1], outline[i]);
    }
  }
  this->Lines->SetPoints(points);
  this->Lines->SetLines(lines);
  this->Lines->Modified();
}

//--------------------------------------------------------------------------------------------------
Vector2 LightHandle::GetDisplayPosition() const
{
  double ball[4];
  this->Ball->GetWorldPosition(ball);
  double display[3];
  vtkInteractorObserver::ComputeWorldToDisplay(this->Overlay, ball[0], ball[1], ball[2], display);
  return { { display[0], display[1] } };
}

}
