// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFrustumClip.h"

#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Point = std::array<double, 3>;
using Plane = std::array<double, 4>;

constexpr size_t MaximumVertices = 16; // four corners, and one more per plane of frustum and region

double Distance(const Plane& plane, const Point& p)
{
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

// A convex polygon.
struct Polygon
{
  std::array<Point, MaximumVertices> Vertices;
  size_t Count = 0;

  void Add(const Point& p)
  {
    if (this->Count < MaximumVertices)
    {
      this->Vertices[this->Count++] = p;
    }
  }
};

void Extend(std::pair<double, double>& depths, double depth)
{
  depths.first = std::min(depths.first, depth);
  depths.second = std::max(depths.second, depth);
}

void Extend(std::pair<double, double>& depths, const Polygon& polygon, const Plane& worldToDepth)
{
  for (size_t i = 0; i < polygon.Count; ++i)
  {
    Extend(depths, Distance(worldToDepth, polygon.Vertices[i]));
  }
}

// Leaves the part of the polygon where the plane is not negative.
void Clip(Polygon& polygon, const Plane& plane)
{
  std::array<double, MaximumVertices> inside;
  size_t kept = 0;
  for (size_t i = 0; i < polygon.Count; ++i)
  {
    inside[i] = Distance(plane, polygon.Vertices[i]);
    kept += inside[i] >= 0.0 ? 1 : 0;
  }
  if (kept == polygon.Count)
  {
    return;
  }
  Polygon clipped;
  for (size_t i = 0; kept > 0 && i < polygon.Count; ++i)
  {
    const size_t next = (i + 1) % polygon.Count;
    const Point& a = polygon.Vertices[i];
    const Point& b = polygon.Vertices[next];
    if (inside[i] >= 0.0)
    {
      clipped.Add(a);
    }
    if ((inside[i] >= 0.0) != (inside[next] >= 0.0))
    {
      const double t = inside[i] / (inside[i] - inside[next]);
      clipped.Add(
        { { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) } });
    }
  }
  polygon = clipped;
}

template <typename Planes>
void ClipAll(Polygon& polygon, const Planes& planes)
{
  for (auto plane = planes.begin(); plane != planes.end() && polygon.Count > 0; ++plane)
  {
    Clip(polygon, *plane);
  }
}

// Least and largest value of a linear function in a box.
std::pair<double, double> FindRange(const Plane& plane, const std::array<double, 6>& bounds)
{
  const Point middle = { { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) } };
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    reach += std::abs(plane[axis]) * 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  const double distance = Distance(plane, middle);
  return { distance - reach, distance + reach };
}

// A side of a box.
Polygon FaceOf(const std::array<double, 6>& bounds, int axis, int side)
{
  Polygon face;
  const int around[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  for (const auto& corner : around)
  {
    Point p;
    p[axis] = bounds[2 * axis + side];
    p[u] = bounds[2 * u + corner[0]];
    p[v] = bounds[2 * v + corner[1]];
    face.Add(p);
  }
  return face;
}

} // namespace

//------------------------------------------------------------------------------
vtkShadowFrustumClip::vtkShadowFrustumClip(
  const std::array<double, 16>& worldToClip, const std::array<double, 4>& worldToDepth)
  : WorldToDepth(worldToDepth)
{
  // -w <= x, y, z <= w
  for (size_t plane = 0; plane < this->Planes.size(); ++plane)
  {
    for (size_t i = 0; i < 4; ++i)
    {
      const double row = worldToClip[4 * (plane / 2) + i];
      this->Planes[plane][i] = worldToClip[12 + i] + (plane % 2 == 0 ? row : -row);
    }
  }
  double clipToWorld[16];
  vtkMatrix4x4::Invert(worldToClip.data(), clipToWorld);
  const double corners[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
  for (int edge = 0; edge < 4; ++edge)
  {
    for (int end = 0; end < 2; ++end)
    {
      const double clip[4] = { corners[edge][0], corners[edge][1], end == 0 ? -1.0 : 1.0, 1.0 };
      double world[4];
      vtkMatrix4x4::MultiplyPoint(clipToWorld, clip, world);
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Edges[edge][end][axis] = world[axis] / world[3];
      }
      this->EdgeDepths[edge][end] = Distance(worldToDepth, this->Edges[edge][end]);
    }
  }
}

//------------------------------------------------------------------------------
std::pair<double, double> vtkShadowFrustumClip::GetDepths() const
{
  return { this->EdgeDepths[0][0], this->EdgeDepths[0][1] };
}

//------------------------------------------------------------------------------
Point vtkShadowFrustumClip::CornerAt(int edge, double depth) const
{
  const std::array<double, 2>& depths = this->EdgeDepths[edge];
  const double t = (depth - depths[0]) / (depths[1] - depths[0]);
  Point corner;
  for (int axis = 0; axis < 3; ++axis)
  {
    corner[axis] = (1.0 - t) * this->Edges[edge][0][axis] + t * this->Edges[edge][1][axis];
  }
  return corner;
}

//------------------------------------------------------------------------------
bool vtkShadowFrustumClip::FindDepths(
  const vtkShadowCasters::Body& body, std::pair<double, double>& depths) const
{
  depths = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  // What most bodies need: those aside are out, and those that no plane cuts are in.
  std::array<Plane, 6> cutting;
  size_t count = 0;
  for (const Plane& plane : this->Planes)
  {
    const std::pair<double, double> range = FindRange(plane, body.Bounds);
    if (range.second < 0.0)
    {
      return false;
    }
    if (range.first < 0.0)
    {
      cutting[count++] = plane;
    }
  }
  const std::vector<Plane> planes(cutting.begin(), cutting.begin() + count);
  if (body.Flat)
  {
    this->FindFlatDepths(body, planes, depths);
  }
  else if (planes.empty())
  {
    depths = FindRange(this->WorldToDepth, body.Bounds);
  }
  else
  {
    this->FindBoxDepths(body, planes, depths);
  }
  return depths.first <= depths.second;
}

//------------------------------------------------------------------------------
void vtkShadowFrustumClip::FindFlatDepths(
  const vtkShadowCasters::Body& body, const Region& planes, std::pair<double, double>& depths) const
{
  Polygon seen;
  std::for_each(
    body.Corners.begin(), body.Corners.end(), [&seen](const Point& corner) { seen.Add(corner); });
  ClipAll(seen, planes);
  std::pair<double, double> all = depths;
  Extend(all, seen, this->WorldToDepth);
  if (this->Regions.empty())
  {
    depths = all;
    return;
  }
  for (const Region& region : this->Regions)
  {
    // Further regions can add nothing.
    if (depths.first <= all.first && depths.second >= all.second)
    {
      return;
    }
    Polygon shadowed = seen;
    ClipAll(shadowed, region);
    Extend(depths, shadowed, this->WorldToDepth);
  }
}

//------------------------------------------------------------------------------
// The extreme points of the box within the frustum lie on its faces, or are the frustum's own.
void vtkShadowFrustumClip::FindBoxDepths(
  const vtkShadowCasters::Body& body, const Region& planes, std::pair<double, double>& depths) const
{
  for (int face = 0; face < 6; ++face)
  {
    Polygon polygon = FaceOf(body.Bounds, face / 2, face % 2);
    ClipAll(polygon, planes);
    Extend(depths, polygon, this->WorldToDepth);
  }
  const std::array<double, 6>& bounds = body.Bounds;
  for (int edge = 0; edge < 4; ++edge)
  {
    for (int end = 0; end < 2; ++end)
    {
      const Point& p = this->Edges[edge][end];
      if (p[0] >= bounds[0] && p[0] <= bounds[1] && p[1] >= bounds[2] && p[1] <= bounds[3] &&
        p[2] >= bounds[4] && p[2] <= bounds[5])
      {
        Extend(depths, this->EdgeDepths[edge][end]);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Each corner lies on a face of the frustum's part that is cut by the box, or on one of the box.
std::vector<Point> vtkShadowFrustumClip::FindCorners(
  const std::pair<double, double>& depths, const std::array<double, 6>& bounds) const
{
  std::vector<Plane> part(this->Planes.begin(), this->Planes.begin() + 4);
  part.push_back(this->WorldToDepth);
  part.back()[3] -= depths.first;
  part.push_back({ { -this->WorldToDepth[0], -this->WorldToDepth[1], -this->WorldToDepth[2],
    depths.second - this->WorldToDepth[3] } });
  std::vector<Plane> box;
  for (int axis = 0; axis < 3; ++axis)
  {
    Plane low = { { 0.0, 0.0, 0.0, -bounds[2 * axis] } };
    Plane high = { { 0.0, 0.0, 0.0, bounds[2 * axis + 1] } };
    low[axis] = 1.0;
    high[axis] = -1.0;
    box.push_back(low);
    box.push_back(high);
  }
  std::vector<Point> corners;
  const auto add = [&corners](Polygon polygon, const std::vector<Plane>& planes)
  {
    ClipAll(polygon, planes);
    corners.insert(
      corners.end(), polygon.Vertices.begin(), polygon.Vertices.begin() + polygon.Count);
  };
  for (int face = 0; face < 6; ++face)
  {
    add(FaceOf(bounds, face / 2, face % 2), part);
  }
  Polygon ends[2];
  for (int edge = 0; edge < 4; ++edge)
  {
    const Point corner[4] = { this->CornerAt(edge, depths.first),
      this->CornerAt((edge + 1) % 4, depths.first), this->CornerAt((edge + 1) % 4, depths.second),
      this->CornerAt(edge, depths.second) };
    Polygon side;
    std::for_each(std::begin(corner), std::end(corner), [&side](const Point& p) { side.Add(p); });
    add(side, box);
    ends[0].Add(corner[0]);
    ends[1].Add(corner[3]);
  }
  add(ends[0], box);
  add(ends[1], box);
  return corners;
}
VTK_ABI_NAMESPACE_END
