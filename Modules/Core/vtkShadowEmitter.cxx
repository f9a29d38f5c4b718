// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowEmitter.h"

#include "vtkAreaLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

double TangentOfHalf(double degrees)
{
  return std::tan(0.5 * vtkMath::RadiansFromDegrees(std::min(degrees, 170.0)));
}

void ReadExtent(vtkLight* light, vtkShadowEmitter& emitter)
{
  vtkAreaLight* area = vtkAreaLight::SafeDownCast(light);
  if (emitter.Directional)
  {
    const double degrees = area ? area->GetAngularDiameter() : vtkAreaLight::GetExtent(light);
    const double tangent = TangentOfHalf(degrees);
    emitter.Shape = vtkShadowEmitter::DISK;
    emitter.HalfSize = { { tangent, tangent } };
  }
  else if (area)
  {
    emitter.Shape = area->GetShape();
    emitter.HalfSize = { { 0.5 * area->GetSize()[0], 0.5 * area->GetSize()[1] } };
  }
  else
  {
    const double radius = 0.5 * vtkAreaLight::GetExtent(light);
    emitter.Shape = vtkShadowEmitter::DISK;
    emitter.HalfSize = { { radius, radius } };
  }
  if (emitter.Shape == vtkShadowEmitter::POINT || !emitter.HasExtent())
  {
    emitter.Shape = vtkShadowEmitter::POINT;
    emitter.HalfSize = { { 0.0, 0.0 } };
  }
}

// What a cell of the window [-1, 1]^2 holds of the emitter.
struct CellMoments
{
  double Weight = 0.0;
  double Mean[2] = { 0.0, 0.0 };
  double Variance[2] = { 0.0, 0.0 };
};

// Midpoint sums; fine enough that a cell's weight is right to 1e-3 of the cell.
CellMoments IntegrateCell(bool disk, bool gaussian, const double low[2], const double step[2])
{
  constexpr int samples = 48;
  CellMoments moments;
  double area = 0.0;
  for (int j = 0; j < samples; ++j)
  {
    for (int i = 0; i < samples; ++i)
    {
      const double p[2] = { low[0] + step[0] * (i + 0.5) / samples,
        low[1] + step[1] * (j + 0.5) / samples };
      const double squared = p[0] * p[0] + p[1] * p[1];
      if (disk && squared > 1.0)
      {
        continue;
      }
      area += 1.0;
      moments.Weight += gaussian ? std::exp(-2.0 * squared) : 1.0;
      for (int axis = 0; axis < 2; ++axis)
      {
        moments.Mean[axis] += p[axis];
        moments.Variance[axis] += p[axis] * p[axis];
      }
    }
  }
  for (int axis = 0; axis < 2 && area > 0.0; ++axis)
  {
    moments.Mean[axis] /= area;
    // A midpoint stands for a small rectangle with a variance of its own; so rectangles are exact.
    const double own = step[axis] * step[axis] / (12.0 * samples * samples);
    moments.Variance[axis] =
      moments.Variance[axis] / area + own - moments.Mean[axis] * moments.Mean[axis];
  }
  return moments;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkShadowEmitter::FromLight(vtkLight* light, vtkShadowEmitter& emitter, std::string& reason)
{
  emitter = vtkShadowEmitter();
  double position[3];
  double focalPoint[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focalPoint);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(position[axis]) || !std::isfinite(focalPoint[axis]))
    {
      reason = "its position or focal point is not finite";
      return false;
    }
  }
  emitter.Directional = !light->GetPositional();
  if (!emitter.Directional && std::isnan(light->GetConeAngle()))
  {
    reason = "its cone angle is not a number";
    return false;
  }
  ReadExtent(light, emitter);
  emitter.ConeAngle =
    emitter.Directional ? 90.0 : std::min(std::max(light->GetConeAngle(), 0.0), 90.0);
  // A plain VTK light without a cone, and a point, shine to all sides; rectangles and disks to one.
  const bool oneSided =
    vtkAreaLight::SafeDownCast(light) && emitter.Shape != vtkShadowEmitter::POINT;
  emitter.Omni = !emitter.Directional && !emitter.HasCone() && !oneSided;
  if (!emitter.Omni && vtkMath::Distance2BetweenPoints(position, focalPoint) == 0.0)
  {
    reason = "its position is its focal point, so it has no direction";
    return false;
  }
  if (!emitter.Directional && emitter.ConeAngle <= 0.0)
  {
    reason = "its cone angle is 0";
    return false;
  }
  vtkAreaLight::GetTransformedAxes(
    light, emitter.AxisU.data(), emitter.AxisV.data(), emitter.Direction.data());
  const double length = vtkMath::Norm(emitter.Direction.data());
  if (!(length > 0.5 && length < 2.0))
  {
    reason = "its position is too far from its focal point for a direction to be computed";
    return false;
  }
  // A directional light is nowhere; its focal point is near what it shines on.
  std::copy_n(emitter.Directional ? focalPoint : position, 3, emitter.Center.begin());
  emitter.Apex = emitter.Center;
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowEmitter> vtkShadowEmitter::Faces() const
{
  if (!this->Omni)
  {
    return { *this };
  }
  std::vector<vtkShadowEmitter> faces;
  const std::array<double, 3> axes[3] = { this->AxisU, this->AxisV, this->Direction };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      vtkShadowEmitter face = *this;
      face.Omni = false;
      face.Face = true;
      for (int i = 0; i < 3; ++i)
      {
        face.Direction[i] = sign * axes[axis][i];
      }
      face.AxisV = axes[(axis + 1) % 3];
      vtkMath::Cross(face.Direction.data(), face.AxisV.data(), face.AxisU.data());
      faces.push_back(face);
    }
  }
  return faces;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowEmitter> vtkShadowEmitter::Split(int countU, int countV, bool gaussian) const
{
  countU = std::max(countU, 1);
  countV = std::max(countV, 1);
  if (!this->HasExtent() || (countU == 1 && countV == 1))
  {
    return { *this };
  }
  std::vector<vtkShadowEmitter> parts;
  const double step[2] = { 2.0 / countU, 2.0 / countV };
  double sum = 0.0;
  for (int j = 0; j < countV; ++j)
  {
    for (int i = 0; i < countU; ++i)
    {
      const double low[2] = { -1.0 + i * step[0], -1.0 + j * step[1] };
      const CellMoments moments = IntegrateCell(this->Shape == DISK, gaussian, low, step);
      if (moments.Weight == 0.0)
      {
        continue;
      }
      vtkShadowEmitter part = this->PointAt(moments.Mean[0], moments.Mean[1], moments.Weight);
      part.Shape = RECTANGLE;
      for (int axis = 0; axis < 2; ++axis)
      {
        // A uniform distribution of half width h has the variance h^2 / 3.
        part.WindowHalfSize[axis] =
          this->WindowHalfSize[axis] * std::sqrt(3.0 * std::max(moments.Variance[axis], 0.0));
        part.HalfSize[axis] =
          this->HalfSize[axis] * std::sqrt(3.0 * std::max(moments.Variance[axis], 0.0));
      }
      sum += moments.Weight;
      parts.push_back(part);
    }
  }
  for (vtkShadowEmitter& part : parts)
  {
    part.Weight *= this->Weight / sum;
  }
  return parts;
}

//------------------------------------------------------------------------------
vtkShadowEmitter vtkShadowEmitter::PointAt(double u, double v, double weight) const
{
  vtkShadowEmitter point = *this;
  const double x = u * this->HalfSize[0];
  const double y = v * this->HalfSize[1];
  for (int i = 0; i < 3; ++i)
  {
    const double offset = x * this->AxisU[i] + y * this->AxisV[i];
    // Tangents of angles turn a directional light, distances move a positional one.
    (this->Directional ? point.Direction : point.Center)[i] -= this->Directional ? offset : -offset;
  }
  if (this->Directional)
  {
    vtkMath::Normalize(point.Direction.data());
    vtkMath::Cross(point.Direction.data(), point.AxisV.data(), point.AxisU.data());
    vtkMath::Normalize(point.AxisU.data());
    vtkMath::Cross(point.AxisU.data(), point.Direction.data(), point.AxisV.data());
  }
  point.Shape = POINT;
  point.HalfSize = { { 0.0, 0.0 } };
  point.Weight = weight;
  point.WindowCenter = { { this->WindowCenter[0] + u * this->WindowHalfSize[0],
    this->WindowCenter[1] + v * this->WindowHalfSize[1] } };
  point.WindowHalfSize = { { 0.0, 0.0 } };
  return point;
}

//------------------------------------------------------------------------------
std::array<double, 16> vtkShadowEmitter::WorldToEmitter() const
{
  std::array<double, 16> matrix = { {} };
  const std::array<double, 3>* axes[3] = { &this->AxisU, &this->AxisV, &this->Direction };
  for (int row = 0; row < 3; ++row)
  {
    std::copy(axes[row]->begin(), axes[row]->end(), matrix.begin() + 4 * row);
    matrix[4 * row + 3] = -vtkMath::Dot(axes[row]->data(), this->Center.data());
  }
  matrix[15] = 1.0;
  return matrix;
}

//------------------------------------------------------------------------------
bool vtkShadowEmitter::operator==(const vtkShadowEmitter& other) const
{
  return this->Shape == other.Shape && this->Directional == other.Directional &&
    this->Omni == other.Omni && this->Face == other.Face && this->Center == other.Center &&
    this->AxisU == other.AxisU && this->AxisV == other.AxisV &&
    this->Direction == other.Direction && this->HalfSize == other.HalfSize &&
    this->Weight == other.Weight && this->Apex == other.Apex &&
    this->ConeAngle == other.ConeAngle && this->WindowCenter == other.WindowCenter &&
    this->WindowHalfSize == other.WindowHalfSize;
}
VTK_ABI_NAMESPACE_END
