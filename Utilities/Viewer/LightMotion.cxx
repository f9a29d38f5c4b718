// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LightMotion.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softshadows
{
namespace
{

constexpr double LargestAngularDiameter = 170.0; // vtkAreaLight's own limit

//--------------------------------------------------------------------------------------------------
Vector3 FromFocalPoint(const LightDescription& light)
{
  Vector3 way;
  vtkMath::Subtract(light.Position.data(), light.FocalPoint.data(), way.data());
  return way;
}

//--------------------------------------------------------------------------------------------------
/// Rodrigues' rotation of the way from the focal point about a unit axis.
void Rotate(LightDescription& light, const Vector3& axis, double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const Vector3 way = FromFocalPoint(light);
  Vector3 across;
  vtkMath::Cross(axis.data(), way.data(), across.data());
  const double along = vtkMath::Dot(axis.data(), way.data()) * (1.0 - std::cos(angle));
  for (int i = 0; i < 3; ++i)
  {
    light.Position[i] = light.FocalPoint[i] + way[i] * std::cos(angle) +
      across[i] * std::sin(angle) + axis[i] * along;
  }
}

}

//--------------------------------------------------------------------------------------------------
Vector3 NearestAxis(const Vector3& direction)
{
  int largest = 0;
  for (int i = 1; i < 3; ++i)
  {
    largest = std::abs(direction[i]) > std::abs(direction[largest]) ? i : largest;
  }
  Vector3 axis{ { 0.0, 0.0, 0.0 } };
  axis[largest] = direction[largest] < 0.0 ? -1.0 : 1.0;
  return axis;
}

//--------------------------------------------------------------------------------------------------
void TurnLight(LightDescription& light, const Vector3& up, double degrees)
{
  Rotate(light, up, degrees);
}

//--------------------------------------------------------------------------------------------------
void RaiseLight(LightDescription& light, const Vector3& up, double degrees)
{
  constexpr double highest = 88.0;
  const Vector3 way = FromFocalPoint(light);
  Vector3 axis;
  vtkMath::Cross(way.data(), up.data(), axis.data());
  const double distance = vtkMath::Norm(way.data());
  if (distance == 0.0 || vtkMath::Norm(axis.data()) <= 1e-6 * distance)
  {
    // Straight above: any horizontal axis leads down from there.
    const Vector3 other{ { up[1] + up[2], up[0], 0.0 } };
    vtkMath::Cross(other.data(), up.data(), axis.data());
  }
  vtkMath::Normalize(axis.data());
  const double sine = distance > 0.0 ? vtkMath::Dot(way.data(), up.data()) / distance : 0.0;
  const double now = vtkMath::DegreesFromRadians(std::asin(std::clamp(sine, -1.0, 1.0)));
  // A scene may have its light beyond the limits; it is not pushed back by a motion away from them.
  const double least = std::min(-highest, now);
  const double most = std::max(highest, now);
  Rotate(light, axis, std::clamp(now + degrees, least, most) - now);
}

//--------------------------------------------------------------------------------------------------
void ScaleLightDistance(LightDescription& light, double factor)
{
  if (light.Directional)
  {
    return;
  }
  const Vector3 way = FromFocalPoint(light);
  for (int i = 0; i < 3; ++i)
  {
    light.Position[i] = light.FocalPoint[i] + factor * way[i];
  }
}

//--------------------------------------------------------------------------------------------------
void ScaleLightSize(LightDescription& light, double factor)
{
  if (light.Directional)
  {
    constexpr double first = 0.5;
    const double now = light.AngularDiameter;
    light.AngularDiameter =
      now > 0.0 ? std::min(now * factor, LargestAngularDiameter) : (factor > 1.0 ? first : 0.0);
    return;
  }
  const bool hasExtent =
    light.Shape != LightShape::Point && std::max(light.Size[0], light.Size[1]) > 0.0;
  if (hasExtent)
  {
    light.Size[0] *= factor;
    light.Size[1] *= factor;
  }
  else if (factor > 1.0)
  {
    const Vector3 way = FromFocalPoint(light);
    const double edge = 0.01 * vtkMath::Norm(way.data());
    light.Shape = light.Shape == LightShape::Point ? LightShape::Disk : light.Shape;
    light.Size = { { edge, edge } };
  }
}

//--------------------------------------------------------------------------------------------------
std::string SpellLightSize(const LightDescription& light)
{
  std::ostringstream text;
  text.precision(3);
  if (light.Directional)
  {
    text << light.AngularDiameter << " degrees";
  }
  else if (light.Shape == LightShape::Point)
  {
    text << "point";
  }
  else
  {
    text << light.Size[0] << " x " << light.Size[1];
  }
  return text.str();
}

}
