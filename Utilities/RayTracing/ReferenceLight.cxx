// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceLight.h"

#include <algorithm> // For std::max
#include <tuple>     // For std::tie
#include <utility>   // For std::pair

namespace softshadows
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

//--------------------------------------------------------------------------------------------------
// The square [-1, 1]^2 onto the unit disk: squares around the centre become circles.
std::pair<double, double> ToDisk(double u, double v)
{
  if (u == 0.0 && v == 0.0)
  {
    return { 0.0, 0.0 };
  }
  const bool alongU = std::abs(u) > std::abs(v);
  const double radius = alongU ? u : v;
  const double angle = alongU ? (Pi / 4.0) * (v / u) : (Pi / 2.0) - (Pi / 4.0) * (u / v);
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

}

//--------------------------------------------------------------------------------------------------
ReferenceLight::ReferenceLight(
  const vtkShadowEmitter& emitter, const ReferenceGeometry& geometry, bool gaussian)
  : Emitter(emitter)
  , Gaussian(gaussian)
{
  this->Emitter.Center = geometry.ToLocal(emitter.Center);
  this->Emitter.Apex = geometry.ToLocal(emitter.Apex);
  if (!emitter.Directional)
  {
    this->Emitter.HalfSize[0] *= geometry.Scale;
    this->Emitter.HalfSize[1] *= geometry.Scale;
  }
  this->CosineOfCone = std::cos(emitter.ConeAngle * Pi / 180.0);
  this->CosineOfSun = 1.0 / std::sqrt(1.0 + emitter.HalfSize[0] * emitter.HalfSize[0]);
}

//--------------------------------------------------------------------------------------------------
bool ReferenceLight::Reaches(const Vector& point) const
{
  if (this->Emitter.Directional)
  {
    return true;
  }
  const Vector fromApex = point - this->Emitter.Apex;
  if (this->Emitter.HasCone() &&
    Dot(fromApex, this->Emitter.Direction) < this->CosineOfCone * Length(fromApex))
  {
    return false;
  }
  return this->Emitter.Omni || this->Emitter.Shape == vtkShadowEmitter::POINT ||
    Dot(point - this->Emitter.Center, this->Emitter.Direction) > 0.0;
}

//--------------------------------------------------------------------------------------------------
ReferenceLight::Sample ReferenceLight::GetSample(double s, double t) const
{
  double u = 2.0 * s - 1.0;
  double v = 2.0 * t - 1.0;
  if (this->Emitter.Directional)
  {
    return this->GetDirection(u, v);
  }
  if (this->Emitter.Shape == vtkShadowEmitter::DISK)
  {
    std::tie(u, v) = ToDisk(u, v);
  }
  Sample sample;
  sample.Place = this->Emitter.Center + (u * this->Emitter.HalfSize[0]) * this->Emitter.AxisU +
    (v * this->Emitter.HalfSize[1]) * this->Emitter.AxisV;
  sample.Weight = this->Gaussian ? std::exp(-2.0 * (u * u + v * v)) : 1.0;
  return sample;
}

//--------------------------------------------------------------------------------------------------
// The height of a cap is uniform in solid angle, and so is the square of the disk's radius.
ReferenceLight::Sample ReferenceLight::GetDirection(double u, double v) const
{
  const std::pair<double, double> disk = ToDisk(u, v);
  const double squaredRadius = disk.first * disk.first + disk.second * disk.second;
  const double cosine = 1.0 - squaredRadius * (1.0 - this->CosineOfSun);
  const double radius = std::sqrt(squaredRadius);
  const double tangent = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / cosine;
  const double perRadius = radius > 0.0 ? tangent / radius : 0.0;
  const double x = perRadius * disk.first;
  const double y = perRadius * disk.second;
  Sample sample;
  sample.Place =
    Normalized(x * this->Emitter.AxisU + y * this->Emitter.AxisV - this->Emitter.Direction);
  if (this->Gaussian && this->HasExtent())
  {
    const double window = this->Emitter.HalfSize[0];
    sample.Weight = std::exp(-2.0 * (x * x + y * y) / (window * window));
  }
  return sample;
}

}
