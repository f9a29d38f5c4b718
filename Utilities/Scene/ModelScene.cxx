// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ModelScene.h"

#include "ModelFile.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <cmath>

namespace softshadows
{
namespace
{

constexpr double GroundEdge = 100.0; // all lengths in radii of the models
constexpr double CameraDistance = 3.5;
constexpr double LightDistance = 4.0;
constexpr double LightEdge = 0.8;
constexpr Vector3 ModelColor{ { 0.80, 0.72, 0.62 } };
constexpr Vector3 GroundColor{ { 0.85, 0.85, 0.85 } };

/// Right, front and up of the models: unit vectors along the axes.
struct Frame
{
  int Right;
  int Front;
  int Up;

  explicit Frame(UpAxis up)
    : Right((static_cast<int>(up) + 2) % 3)
    , Front((static_cast<int>(up) + 1) % 3)
    , Up(static_cast<int>(up))
  {
  }
};

/// The point at a distance from the centre, at degrees to the right of the front and above ground.
Vector3 Around(
  const Vector3& center, const Frame& frame, double distance, double toTheRight, double above)
{
  const double azimuth = vtkMath::RadiansFromDegrees(toTheRight);
  const double elevation = vtkMath::RadiansFromDegrees(above);
  Vector3 point = center;
  point[frame.Right] += distance * std::cos(elevation) * std::sin(azimuth);
  point[frame.Front] += distance * std::cos(elevation) * std::cos(azimuth);
  point[frame.Up] += distance * std::sin(elevation);
  return point;
}

ObjectDescription Ground(const vtkBoundingBox& box, const Frame& frame, double radius)
{
  PlaneShape plane;
  const double half = 0.5 * GroundEdge * radius;
  box.GetCenter(plane.Origin.data());
  plane.Origin[frame.Up] = box.GetMinPoint()[frame.Up];
  plane.Origin[frame.Front] -= half;
  plane.Origin[frame.Right] -= half;
  plane.Point1 = plane.Origin;
  plane.Point2 = plane.Origin;
  // point1 x point2 is up: front, right, up is a right-handed system only in this order.
  plane.Point1[frame.Front] += 2.0 * half;
  plane.Point2[frame.Right] += 2.0 * half;
  ObjectDescription ground;
  ground.Shape = plane;
  ground.Color = GroundColor;
  return ground;
}

}

//--------------------------------------------------------------------------------------------------
SceneDescription SceneAroundModels(
  const std::vector<std::string>& files, UpAxis up, ModelStore& models)
{
  SceneDescription scene;
  vtkBoundingBox box;
  for (const std::string& file : files)
  {
    ObjectDescription object;
    object.Shape = ModelShape{ file, { file, 0, "" } };
    const auto mesh = models.Load(std::get<ModelShape>(object.Shape), scene.Folder);
    if (!mesh->GetPointData()->HasArray(ModelColors))
    {
      object.Color = ModelColor;
    }
    box.AddBounds(mesh->GetBounds());
    scene.Objects.push_back(object);
  }
  const Frame frame(up);
  // A single point would leave nothing to see, and no direction to see it from.
  const double radius = box.GetDiagonalLength() > 0.0 ? 0.5 * box.GetDiagonalLength() : 1.0;
  Vector3 center;
  box.GetCenter(center.data());
  scene.Objects.push_back(Ground(box, frame, radius));

  CameraDescription camera;
  camera.Position = Around(center, frame, CameraDistance * radius, 30.0, 20.0);
  camera.FocalPoint = center;
  camera.ViewUp = { { 0.0, 0.0, 0.0 } };
  camera.ViewUp[frame.Up] = 1.0;
  scene.Camera = camera;

  LightDescription light;
  light.Position = Around(center, frame, LightDistance * radius, -40.0, 50.0);
  light.FocalPoint = center;
  light.ViewUp = camera.ViewUp;
  light.Size = { { LightEdge * radius, LightEdge * radius } };
  scene.Lights.push_back(light);
  return scene;
}

}
