// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowProjection.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// A cut by a plane adds at most one corner to a polygon of four.
constexpr int MOST_PLANES = 8;
constexpr int MOST_CORNERS = 4 + MOST_PLANES;

double Evaluate(const std::array<double, 4>& plane, const std::array<double, 3>& p)
{
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}
}

//------------------------------------------------------------------------------
vtkShadowProjection::vtkShadowProjection(const vtkShadowEmitter& emitter, const Window& limit)
  : WorldToEmitter(emitter.WorldToEmitter())
  , Directional(emitter.Directional)
{
  this->Planes.reserve(MOST_PLANES);
  if (std::isfinite(limit[0] + limit[1] + limit[2] + limit[3]))
  {
    this->AddWindow(emitter, limit);
  }
  if (emitter.HasCone())
  {
    this->AddCone(emitter);
  }
}

//------------------------------------------------------------------------------
void vtkShadowProjection::AddWindow(const vtkShadowEmitter& emitter, const Window& limit)
{
  if (emitter.Directional)
  {
    this->Planes.push_back({ { 1.0, 0.0, 0.0, -limit[0] } });
    this->Planes.push_back({ { -1.0, 0.0, 0.0, limit[1] } });
    this->Planes.push_back({ { 0.0, 1.0, 0.0, -limit[2] } });
    this->Planes.push_back({ { 0.0, -1.0, 0.0, limit[3] } });
  }
  else
  {
    this->Planes.push_back({ { 1.0, 0.0, -limit[0], 0.0 } });
    this->Planes.push_back({ { -1.0, 0.0, limit[1], 0.0 } });
    this->Planes.push_back({ { 0.0, 1.0, -limit[2], 0.0 } });
    this->Planes.push_back({ { 0.0, -1.0, limit[3], 0.0 } });
  }
}

//------------------------------------------------------------------------------
// A blocker q of a lit point p lies between p and a point e of the emitter. With o the apex,
// |q - o| <= max |e - o| + z tan(angle) along each axis: a pyramid around the cone, grown by the
// emitter's extent.
void vtkShadowProjection::AddCone(const vtkShadowEmitter& emitter)
{
  const double slope = std::tan(vtkMath::RadiansFromDegrees(emitter.ConeAngle));
  const Point apex = this->ToEmitter(emitter.Apex);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double reach = emitter.HalfSize[axis] + std::abs(apex[axis]);
    for (const double sign : { 1.0, -1.0 })
    {
      Plane plane{ { 0.0, 0.0, slope, reach + sign * apex[axis] - slope * apex[2] } };
      plane[axis] = -sign;
      this->Planes.push_back(plane);
    }
  }
}

//------------------------------------------------------------------------------
vtkShadowProjection::Point vtkShadowProjection::ToEmitter(const Point& world) const
{
  const auto& m = this->WorldToEmitter;
  Point p;
  for (int i = 0; i < 3; ++i)
  {
    p[i] = m[4 * i] * world[0] + m[4 * i + 1] * world[1] + m[4 * i + 2] * world[2] + m[4 * i + 3];
  }
  return p;
}

//------------------------------------------------------------------------------
vtkShadowProjection::Part vtkShadowProjection::Project(const vtkShadowCasters::Body& body) const
{
  Part part;
  std::array<Point, 8> corners;
  const int count = body.Flat ? 4 : 8;
  for (int i = 0; i < count; ++i)
  {
    corners[i] =
      this->ToEmitter(body.Flat ? body.Corners[i]
                                : Point{ { body.Bounds[i & 1], body.Bounds[2 + ((i >> 1) & 1)],
                                    body.Bounds[4 + ((i >> 2) & 1)] } });
  }
  bool inside = true;
  for (const Plane& plane : this->Planes)
  {
    const auto in = std::count_if(corners.begin(), corners.begin() + count,
      [&plane](const Point& p) { return Evaluate(plane, p) >= 0.0; });
    if (in == 0)
    {
      return part;
    }
    inside = inside && in == count;
  }
  if (inside)
  {
    std::for_each(corners.begin(), corners.begin() + count,
      [this, &part](const Point& p) { this->AddPoint(p, part); });
  }
  else if (body.Flat)
  {
    this->AddPolygon(corners.data(), part);
  }
  else
  {
    // Faces of the box as corner numbers, in order around each.
    static const int faces[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
      { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
    for (const auto& face : faces)
    {
      const Point polygon[4] = { corners[face[0]], corners[face[1]], corners[face[2]],
        corners[face[3]] };
      this->AddPolygon(polygon, part);
    }
  }
  return part;
}

//------------------------------------------------------------------------------
// Sutherland and Hodgman's reentrant polygon clipping.
void vtkShadowProjection::AddPolygon(const Point* corners, Part& part) const
{
  std::array<Point, MOST_CORNERS> current{};
  std::array<Point, MOST_CORNERS> next{};
  std::copy_n(corners, 4, current.begin());
  int count = 4;
  for (const Plane& plane : this->Planes)
  {
    int kept = 0;
    for (int i = 0; i < count; ++i)
    {
      const Point& a = current[i];
      const Point& b = current[(i + 1) % count];
      const double da = Evaluate(plane, a);
      const double db = Evaluate(plane, b);
      if (da >= 0.0)
      {
        next[kept++] = a;
      }
      if ((da >= 0.0) != (db >= 0.0))
      {
        const double t = da / (da - db);
        next[kept++] = { { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]),
          a[2] + t * (b[2] - a[2]) } };
      }
    }
    count = kept;
    std::swap(current, next);
  }
  for (int i = 0; i < count; ++i)
  {
    this->AddPoint(current[i], part);
  }
}

//------------------------------------------------------------------------------
void vtkShadowProjection::AddPoint(const Point& point, Part& part) const
{
  double x = point[0];
  double y = point[1];
  if (!this->Directional)
  {
    if (!(point[2] > 0.0))
    {
      return; // the light's centre itself
    }
    x /= point[2];
    y /= point[2];
  }
  if (part.Empty)
  {
    part = { false, { { x, x, y, y } }, point[2], point[2] };
    return;
  }
  part.Extent = { { std::min(part.Extent[0], x), std::max(part.Extent[1], x),
    std::min(part.Extent[2], y), std::max(part.Extent[3], y) } };
  part.Nearest = std::min(part.Nearest, point[2]);
  part.Farthest = std::max(part.Farthest, point[2]);
}

VTK_ABI_NAMESPACE_END
