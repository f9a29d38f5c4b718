// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFrustumClip.h"

#include "vtkMatrix4x4.h"

#include <algorithm>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Point = std::array<double, 3>;

// Clip coordinates, view depth and the place in the world.
using Vertex = std::array<double, 8>;

double Depth(const std::array<double, 4>& worldToDepth, const Point& p)
{
  return worldToDepth[0] * p[0] + worldToDepth[1] * p[1] + worldToDepth[2] * p[2] + worldToDepth[3];
}

// How far a vertex is inside a plane of the frustum: -w <= x, y, z <= w.
double Inside(const Vertex& vertex, int plane)
{
  return vertex[3] + (plane % 2 == 0 ? 1.0 : -1.0) * vertex[plane / 2];
}

// The part of a convex polygon where inside(vertex) is not negative; inside must be linear.
template <typename Function>
std::vector<Vertex> Clip(const std::vector<Vertex>& polygon, Function inside)
{
  std::vector<Vertex> clipped;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const Vertex& a = polygon[i];
    const Vertex& b = polygon[(i + 1) % polygon.size()];
    const double insideA = inside(a);
    const double insideB = inside(b);
    if (insideA >= 0.0)
    {
      clipped.push_back(a);
    }
    if ((insideA >= 0.0) != (insideB >= 0.0))
    {
      const double t = insideA / (insideA - insideB);
      Vertex vertex;
      std::transform(a.begin(), a.end(), b.begin(), vertex.begin(),
        [t](double from, double to) { return from + t * (to - from); });
      clipped.push_back(vertex);
    }
  }
  return clipped;
}

void Extend(std::pair<double, double>& depths, double depth)
{
  depths.first = std::min(depths.first, depth);
  depths.second = std::max(depths.second, depth);
}

} // namespace

//------------------------------------------------------------------------------
vtkShadowFrustumClip::vtkShadowFrustumClip(
  const std::array<double, 16>& worldToClip, const std::array<double, 4>& worldToDepth)
  : WorldToClip(worldToClip)
  , WorldToDepth(worldToDepth)
{
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
      this->EdgeDepths[edge][end] = Depth(worldToDepth, this->Edges[edge][end]);
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
void vtkShadowFrustumClip::AddPolygon(const std::array<Point, 4>& corners, const Region& region,
  std::pair<double, double>& depths) const
{
  std::vector<Vertex> polygon;
  for (const Point& corner : corners)
  {
    const double point[4] = { corner[0], corner[1], corner[2], 1.0 };
    Vertex vertex;
    vtkMatrix4x4::MultiplyPoint(this->WorldToClip.data(), point, vertex.data());
    vertex[4] = Depth(this->WorldToDepth, corner);
    std::copy(corner.begin(), corner.end(), vertex.begin() + 5);
    polygon.push_back(vertex);
  }
  for (int plane = 0; plane < 6; ++plane)
  {
    polygon = Clip(polygon, [plane](const Vertex& vertex) { return Inside(vertex, plane); });
  }
  for (const std::array<double, 4>& plane : region)
  {
    polygon = Clip(polygon,
      [&plane](const Vertex& vertex) {
        return Depth(plane, { { vertex[5], vertex[6], vertex[7] } });
      });
  }
  for (const Vertex& vertex : polygon)
  {
    Extend(depths, vertex[4]);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowFrustumClip::FindDepths(
  const vtkShadowCasters::Body& body, std::pair<double, double>& depths) const
{
  depths = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  if (body.Flat)
  {
    for (const Region& region : this->Regions)
    {
      this->AddPolygon(body.Corners, region, depths);
    }
    if (this->Regions.empty())
    {
      this->AddPolygon(body.Corners, Region(), depths);
    }
    return depths.first <= depths.second;
  }
  // The extreme points of the box within the frustum lie on its faces, or are the frustum's own.
  const std::array<double, 6>& bounds = body.Bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      std::array<Point, 4> face;
      const int around[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
      for (int i = 0; i < 4; ++i)
      {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        face[i][axis] = bounds[2 * axis + side];
        face[i][u] = bounds[2 * u + around[i][0]];
        face[i][v] = bounds[2 * v + around[i][1]];
      }
      this->AddPolygon(face, Region(), depths);
    }
  }
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
  return depths.first <= depths.second;
}
VTK_ABI_NAMESPACE_END
