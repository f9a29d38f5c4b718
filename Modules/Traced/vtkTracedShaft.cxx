// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedShaft.h"

#include "vtkTracedHits.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double Single = 1.2e-7; // what single precision tells apart, of a size
}

//------------------------------------------------------------------------------
double vtkTracedBox::GetDoubt() const
{
  double size = vtkTraced::Length(this->Center);
  for (const vtkTracedVector& axis : this->HalfAxes)
  {
    size = std::max(size, vtkTraced::Length(axis));
  }
  return Single * size;
}

//------------------------------------------------------------------------------
void vtkTracedBounds::Add(const vtkTracedVector& point)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Low[i] = std::min(this->Low[i], point[i]);
    this->High[i] = std::max(this->High[i], point[i]);
  }
}

//------------------------------------------------------------------------------
void vtkTracedShaft::AddReceiver(
  const vtkTracedVector& place, const vtkTracedVector& normal, double precision)
{
  const vtkTracedVector start = place + precision * normal;
  if (this->IsEmpty)
  {
    this->IsEmpty = false;
    this->Up = normal;
    this->Height = vtkTraced::Dot(normal, start);
    this->Precision = precision;
  }
  this->Precision = std::min(this->Precision, precision);
  this->Places.Add(place);
  this->Receivers.Add(start);
  this->Height = std::min(this->Height, vtkTraced::Dot(this->Up, start));
}

//------------------------------------------------------------------------------
double vtkTracedShaft::GetReach() const
{
  double squares = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double reach = std::max(-this->Receivers.Low[i], this->Receivers.High[i]);
    squares += reach * reach;
  }
  return std::sqrt(squares);
}

//------------------------------------------------------------------------------
void vtkTracedShaft::AddPlane(const vtkTracedVector& normal, double offset)
{
  const double scale = 1.0 / vtkTraced::Length(normal);
  this->Planes[this->Count++] = { scale * normal, scale * offset };
}

//------------------------------------------------------------------------------
void vtkTracedShaft::AddSides(const vtkTracedBounds& end)
{
  for (int i = 0; i < 3; ++i)
  {
    vtkTracedVector normal{};
    normal[i] = 1.0;
    this->AddPlane(normal, std::max(this->Receivers.High[i], end.High[i]));
    normal[i] = -1.0;
    this->AddPlane(normal, -std::min(this->Receivers.Low[i], end.Low[i]));
  }
}

//------------------------------------------------------------------------------
// Seen along each axis the boxes are rectangles. Where the one reaches farther along the first side and
// the other along the second, the line through both corners bounds the hull.
void vtkTracedShaft::AddBridges(const vtkTracedBounds& end)
{
  const auto corner = [](const vtkTracedBounds& box, int axis, double sign)
  { return sign > 0.0 ? box.High[axis] : box.Low[axis]; };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    for (int side = 0; side < 4; ++side)
    {
      const double signA = side & 1 ? 1.0 : -1.0;
      const double signB = side & 2 ? 1.0 : -1.0;
      const double startA = corner(this->Receivers, a, signA);
      const double startB = corner(this->Receivers, b, signB);
      const double wayA = corner(end, a, signA) - startA;
      const double wayB = corner(end, b, signB) - startB;
      const bool first = signA * wayA > 0.0;
      if (first != (signB * wayB > 0.0))
      {
        const double sign = first ? signA * signB : -signA * signB;
        vtkTracedVector normal{};
        normal[a] = -sign * wayB;
        normal[b] = sign * wayA;
        this->AddPlane(normal, normal[a] * startA + normal[b] * startB);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkTracedShaft::EndAt(const vtkTracedBounds& light)
{
  this->Count = 0;
  double lowest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    lowest += this->Up[i] * (this->Up[i] > 0.0 ? light.Low[i] : light.High[i]);
  }
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    size = std::max(
      { size, -this->Receivers.Low[i], this->Receivers.High[i], -light.Low[i], light.High[i] });
  }
  this->Doubt = Single * size;
  this->AddPlane(-1.0 * this->Up, -std::min(this->Height, lowest));
  this->AddBridges(light);
  this->AddSides(light);
}

//------------------------------------------------------------------------------
void vtkTracedShaft::EndAlong(const vtkTracedBounds& directions, double length)
{
  vtkTracedBounds end;
  for (int i = 0; i < 3; ++i)
  {
    end.Low[i] = this->Receivers.Low[i] + length * directions.Low[i];
    end.High[i] = this->Receivers.High[i] + length * directions.High[i];
  }
  this->EndAt(end);
}

//------------------------------------------------------------------------------
bool vtkTracedShaft::IsOutside(const vtkTracedBox& box) const
{
  const double doubt = this->Doubt + box.GetDoubt();
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Plane& plane = this->Planes[i];
    double nearest = vtkTraced::Dot(plane.Normal, box.Center);
    for (const vtkTracedVector& axis : box.HalfAxes)
    {
      nearest -= std::abs(vtkTraced::Dot(plane.Normal, axis));
    }
    if (nearest > plane.Offset + doubt)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// What is flat and has all receivers in its plane does not block them, see vtkTracedHits. Of a vast ground
// single precision could not tell that it is under them.
bool vtkTracedShaft::IsOwnPlane(const vtkTracedBox& box, const vtkTracedVector& eye) const
{
  const vtkTracedVector zero{};
  const auto flat = std::find(box.HalfAxes.begin(), box.HalfAxes.end(), zero);
  if (flat == box.HalfAxes.end())
  {
    return false;
  }
  const std::size_t axis = static_cast<std::size_t>(flat - box.HalfAxes.begin());
  const vtkTracedVector normal =
    vtkTraced::Cross(box.HalfAxes[(axis + 1) % 3], box.HalfAxes[(axis + 2) % 3]);
  const vtkTracedVector middle = 0.5 * (this->Places.Low + this->Places.High);
  double farthest = std::abs(vtkTraced::Dot(normal, middle - box.Center));
  for (int i = 0; i < 3; ++i)
  {
    farthest += 0.5 * std::abs(normal[i]) * (this->Places.High[i] - this->Places.Low[i]);
  }
  const double corner = vtkTraced::Length(box.Center - eye) +
    vtkTraced::Length(box.HalfAxes[(axis + 1) % 3] + box.HalfAxes[(axis + 2) % 3]);
  return farthest <=
    std::max(this->Precision, vtkTracedHits::GetRounding(corner)) * vtkTraced::Length(normal);
}

//------------------------------------------------------------------------------
bool vtkTracedShaft::Misses(
  const std::vector<vtkTracedBox>& boxes, const vtkTracedVector& eye) const
{
  return std::all_of(boxes.begin(), boxes.end(),
    [this, &eye](const vtkTracedBox& box)
    { return this->IsOutside(box) || this->IsOwnPlane(box, eye); });
}
VTK_ABI_NAMESPACE_END
