// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedRounds.h"

#include "vtkTracedDevice.h"
#include "vtkTracedEmbree.h"
#include "vtkTracedHits.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using vtkTraced::Dot;
using Round = vtkTracedRounds::Round;
constexpr double Miss = -1.0;

// The nearest of the solutions of a t^2 + 2 b t + c = 0 that lies ahead; none is a miss.
double FirstRoot(double a, double b, double c)
{
  const double square = b * b - a * c;
  if (!(square >= 0.0) || a == 0.0)
  {
    return Miss;
  }
  const double root = std::sqrt(square);
  const double near = (-b - root) / a;
  return near > 0.0 ? near : (-b + root) / a;
}

double HitSphere(const Round& round, const vtkTracedVector& start, const vtkTracedVector& way)
{
  const vtkTracedVector offset = start - round.Ends[0];
  return FirstRoot(
    Dot(way, way), Dot(offset, way), Dot(offset, offset) - round.Radii[0] * round.Radii[0]);
}

double HitTube(
  const Round& round, const vtkTracedVector& start, const vtkTracedVector& way, double most)
{
  const vtkTracedVector line = round.Ends[1] - round.Ends[0];
  const double square = Dot(line, line);
  if (square == 0.0)
  {
    return Miss;
  }
  const vtkTracedVector offset = start - round.Ends[0];
  // Shares of the line, and what is left across it.
  const double place = Dot(offset, line) / square;
  const double speed = Dot(way, line) / square;
  const vtkTracedVector across = offset - place * line;
  const vtkTracedVector acrossWay = way - speed * line;
  const double growth = round.Radii[1] - round.Radii[0];
  const double radius = round.Radii[0] + growth * place;
  const double a = Dot(acrossWay, acrossWay) - growth * growth * speed * speed;
  const double b = Dot(across, acrossWay) - radius * growth * speed;
  const double c = Dot(across, across) - radius * radius;
  double first = Miss;
  const auto take = [&first, most](double t)
  { first = t > 0.0 && t < most && (first < 0.0 || t < first) ? t : first; };
  const double inside = b * b - a * c;
  for (const double sign : { -1.0, 1.0 })
  {
    const double t = inside >= 0.0 && a != 0.0 ? (-b + sign * std::sqrt(inside)) / a : Miss;
    const double at = place + t * speed;
    if (at >= 0.0 && at <= 1.0)
    {
      take(t);
    }
  }
  for (int end = 0; end < 2 && speed != 0.0; ++end)
  {
    const double t = (end - place) / speed;
    const vtkTracedVector onLid = across + t * acrossWay;
    if (Dot(onLid, onLid) <= round.Radii[end] * round.Radii[end])
    {
      take(t);
    }
  }
  return first;
}

vtkTracedVector AnySide(const vtkTracedVector& direction)
{
  const vtkTracedVector axis = std::abs(direction[0]) < 0.6 ? vtkTracedVector{ { 1.0, 0.0, 0.0 } }
                                                            : vtkTracedVector{ { 0.0, 1.0, 0.0 } };
  const vtkTracedVector side = vtkTraced::Cross(direction, axis);
  return (1.0 / vtkTraced::Length(side)) * side;
}

double HitSquare(const Round& round, const vtkTracedVector& start, const vtkTracedVector& way)
{
  const double length = vtkTraced::Length(way);
  const vtkTracedVector direction = (1.0 / length) * way;
  const vtkTracedVector offset = round.Ends[0] - start;
  const vtkTracedVector side = AnySide(direction);
  const vtkTracedVector other = vtkTraced::Cross(direction, side);
  const double distance = Dot(offset, direction);
  const bool hits = std::abs(Dot(offset, side)) <= round.Radii[0] &&
    std::abs(Dot(offset, other)) <= round.Radii[0] && distance > round.Radii[0];
  return hits ? distance / length : Miss;
}

double HitBand(const Round& round, const vtkTracedVector& start, const vtkTracedVector& way)
{
  const vtkTracedVector line = round.Ends[1] - round.Ends[0];
  const vtkTracedVector offset = round.Ends[0] - start;
  // The places on both lines that are nearest to each other.
  const double ways = Dot(way, way);
  const double lines = Dot(line, line);
  const double mixed = Dot(way, line);
  const double determinant = ways * lines - mixed * mixed;
  if (!(determinant > 1e-12 * ways * lines))
  {
    return Miss; // seen along its length it is nothing
  }
  const double along = (mixed * Dot(way, offset) - ways * Dot(line, offset)) / determinant;
  const double t = (Dot(way, offset) + along * mixed) / ways;
  const vtkTracedVector gap = offset + along * line - t * way;
  const double radius = round.Radii[0] + along * (round.Radii[1] - round.Radii[0]);
  const bool hits = along >= 0.0 && along <= 1.0 && Dot(gap, gap) <= radius * radius &&
    t * std::sqrt(ways) > radius;
  return hits ? t : Miss;
}

void FindBounds(const RTCBoundsFunctionArguments* arguments)
{
  const auto& rounds = *static_cast<const vtkTracedRounds*>(arguments->geometryUserPtr);
  const Round& round = rounds.GetRound(arguments->primID);
  const bool isLong = round.Kind == vtkTracedRounds::TUBE || round.Kind == vtkTracedRounds::BAND;
  // A square's corners are farther from its middle than its edges; floats are rounded.
  const double reach = (round.Kind == vtkTracedRounds::SQUARE ? 1.5 : 1.0) *
    (isLong ? std::max(round.Radii[0], round.Radii[1]) : round.Radii[0]);
  float low[3];
  float high[3];
  for (int i = 0; i < 3; ++i)
  {
    const double a = round.Ends[0][i];
    const double b = isLong ? round.Ends[1][i] : a;
    const double margin = reach + 1e-6 * (std::abs(a) + std::abs(b) + reach);
    low[i] = static_cast<float>(std::min(a, b) - margin);
    high[i] = static_cast<float>(std::max(a, b) + margin);
  }
  RTCBounds* bounds = arguments->bounds_o;
  bounds->lower_x = low[0];
  bounds->lower_y = low[1];
  bounds->lower_z = low[2];
  bounds->upper_x = high[0];
  bounds->upper_y = high[1];
  bounds->upper_z = high[2];
}

} // namespace

//------------------------------------------------------------------------------
double vtkTracedRounds::FindHit(
  const Round& round, const vtkTracedVector& start, const vtkTracedVector& direction, double most)
{
  double t = Miss;
  switch (round.Kind)
  {
    case SPHERE:
      t = HitSphere(round, start, direction);
      break;
    case TUBE:
      t = HitTube(round, start, direction, most);
      break;
    case SQUARE:
      t = HitSquare(round, start, direction);
      break;
    case BAND:
      t = HitBand(round, start, direction);
      break;
  }
  return t > 0.0 && t < most ? t : Miss;
}

//------------------------------------------------------------------------------
bool vtkTracedRounds::IsLeft(
  const Round& round, const vtkTracedVector& start, const vtkTracedVector& direction)
{
  constexpr double surface = 0.98;
  if (round.Kind == SQUARE || round.Kind == BAND)
  {
    return false; // they are not bodies
  }
  const vtkTracedVector offset = start - round.Ends[0];
  if (round.Kind == SPHERE)
  {
    return Dot(offset, direction) > 0.0 && vtkTraced::Length(offset) > surface * round.Radii[0];
  }
  const vtkTracedVector line = round.Ends[1] - round.Ends[0];
  const double square = std::max(Dot(line, line), std::numeric_limits<double>::min());
  const double place = Dot(offset, line) / square;
  const double speed = Dot(direction, line);
  const double lid = (1.0 - surface) * std::max(round.Radii[0], round.Radii[1]) / std::sqrt(square);
  if ((place < lid && speed < 0.0) || (place > 1.0 - lid && speed > 0.0))
  {
    return true;
  }
  const vtkTracedVector across = offset - place * line;
  const double radius = round.Radii[0] + place * (round.Radii[1] - round.Radii[0]);
  return Dot(across, direction) > 0.0 && vtkTraced::Length(across) > surface * radius;
}

//------------------------------------------------------------------------------
void vtkTracedRounds::Take(std::vector<Round> rounds, const vtkTracedVector& center)
{
  this->Rounds = std::move(rounds);
  this->Center = center;
  if (this->Rounds.empty())
  {
    this->ReleaseScene();
    return;
  }
  this->MakeScene();
  RTCGeometry geometry = rtcNewGeometry(this->Device->GetHandle(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(this->Rounds.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(geometry, FindBounds, nullptr);
  rtcSetGeometryOccludedFunction(geometry, vtkTracedHits::JudgeRounds);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(this->Scene, geometry);
  rtcReleaseGeometry(geometry); // the scene keeps it
  this->CommitScene();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTracedRounds::GetBytes() const
{
  constexpr vtkTypeInt64 treePerRound = 64;
  return static_cast<vtkTypeInt64>(this->Rounds.size()) *
    (treePerRound + static_cast<vtkTypeInt64>(sizeof(Round)));
}
VTK_ABI_NAMESPACE_END
