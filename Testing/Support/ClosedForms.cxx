// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedForms.h"

#include <algorithm>
#include <cmath>

namespace SoftShadowsTesting
{
namespace
{

const double Pi = 3.14159265358979323846;
const double GaussianDeviation = 0.5;

//------------------------------------------------------------------------------
double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

//------------------------------------------------------------------------------
Point Cross(const Point& a, const Point& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

//------------------------------------------------------------------------------
Point Minus(const Point& a, const Point& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

//------------------------------------------------------------------------------
double ClampedAcos(double x)
{
  return std::acos(std::clamp(x, -1.0, 1.0));
}

//------------------------------------------------------------------------------
/// The blocker's bounds on the light's axis as the receiver sees them, in the light's window.
double AxisShare(double receiver, double receiverHeight, const std::array<double, 2>& blocker,
  double blockerHeight, const std::array<double, 2>& light, double lightHeight, Weights weights)
{
  const double magnification = (lightHeight - receiverHeight) / (blockerHeight - receiverHeight);
  const double center = 0.5 * (light[0] + light[1]);
  const double half = 0.5 * (light[1] - light[0]);
  const double low = receiver + magnification * (blocker[0] - receiver);
  const double high = receiver + magnification * (blocker[1] - receiver);
  return WindowShare((low - center) / half, (high - center) / half, weights);
}

}

//------------------------------------------------------------------------------
double WindowShare(double low, double high, Weights weights)
{
  low = std::clamp(low, -1.0, 1.0);
  high = std::clamp(high, -1.0, 1.0);
  if (high <= low)
  {
    return 0.0;
  }
  if (weights == Weights::Mean)
  {
    return 0.5 * (high - low);
  }
  const double unit = 1.0 / (GaussianDeviation * std::sqrt(2.0));
  return (std::erf(high * unit) - std::erf(low * unit)) / (2.0 * std::erf(unit));
}

//------------------------------------------------------------------------------
double DiskShare(double edge)
{
  const double t = std::clamp(edge, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / Pi;
}

//------------------------------------------------------------------------------
double CapShareBelow(double elevation, double halfAngle)
{
  if (elevation >= halfAngle)
  {
    return 0.0;
  }
  if (elevation <= -halfAngle)
  {
    return 1.0;
  }
  // The part below is the intersection of the cap with the half sphere below. By Gauss-Bonnet it is
  // bounded by an arc of the cap's rim (geodesic curvature cot(halfAngle)) and one of a great
  // circle: area = 2 (acos(sin(e) / sin(h)) - cos(h) acos(tan(e) / tan(h))).
  const double rim = ClampedAcos(std::tan(elevation) / std::tan(halfAngle));
  const double corner = ClampedAcos(std::sin(elevation) / std::sin(halfAngle));
  const double versine = 2.0 * std::pow(std::sin(0.5 * halfAngle), 2);
  return (corner - std::cos(halfAngle) * rim) / (Pi * versine);
}

//------------------------------------------------------------------------------
double VisibilityOfRectangle(
  const Point& receiver, const Rectangle& blocker, const Rectangle& light, Weights weights)
{
  const double x =
    AxisShare(receiver[0], receiver[2], blocker.X, blocker.Height, light.X, light.Height, weights);
  const double y =
    AxisShare(receiver[1], receiver[2], blocker.Y, blocker.Height, light.Y, light.Height, weights);
  return 1.0 - x * y;
}

//------------------------------------------------------------------------------
double VisibilityOfDisk(const Point& receiver, double edge, double blockerHeight,
  const Point& diskCenter, double diskRadius)
{
  const double magnification = (diskCenter[2] - receiver[2]) / (blockerHeight - receiver[2]);
  const double edgeOnLight = receiver[0] + magnification * (edge - receiver[0]);
  return 1.0 - DiskShare((edgeOnLight - diskCenter[0]) / diskRadius);
}

//------------------------------------------------------------------------------
double VisibilityOfSun(const Point& receiver, const Point& edgePoint, const Point& edgeDirection,
  const Point& blockedSide, const Point& toSun, double angularDiameter)
{
  // Seen from the receiver the edge is a great circle: directions beyond the plane through receiver
  // and edge are blocked. The normal points away from the blocked side.
  Point normal = Cross(Minus(edgePoint, receiver), edgeDirection);
  const double length = std::sqrt(Dot(normal, normal));
  const double side = Dot(normal, blockedSide) > 0.0 ? -1.0 : 1.0;
  const double sine = side * Dot(normal, toSun) / (length * std::sqrt(Dot(toSun, toSun)));
  const double elevation = std::asin(std::clamp(sine, -1.0, 1.0));
  return 1.0 - CapShareBelow(elevation, 0.5 * angularDiameter);
}

}
