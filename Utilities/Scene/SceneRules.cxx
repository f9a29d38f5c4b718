// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneRules.h"

#include <algorithm>
#include <cmath>

namespace softshadows
{
namespace
{

Vector3 Minus(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// Scaled so that its largest component is 1: no square of it overflows or vanishes.
Vector3 Scaled(const Vector3& v)
{
  const double largest = std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  return largest > 0.0 ? Vector3{ { v[0] / largest, v[1] / largest, v[2] / largest } } : v;
}

double Length(const Vector3& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Are the two parallel, or is one of them null? To 1e-9 of an angle.
bool AreParallel(const Vector3& a, const Vector3& b)
{
  const Vector3 u = Scaled(a);
  const Vector3 v = Scaled(b);
  const Vector3 cross{ { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0] } };
  constexpr double leastSine = 1e-9;
  return Length(cross) <= leastSine * Length(u) * Length(v);
}

}

//--------------------------------------------------------------------------------------------------
void CheckShape(const KeyReader& keys, const ModelShape& model)
{
  if (model.File.empty())
  {
    keys.Fail("file", "is empty; it must name a model");
  }
}

//--------------------------------------------------------------------------------------------------
void CheckShape(const KeyReader& keys, const PlaneShape& plane)
{
  if (AreParallel(Minus(plane.Point1, plane.Origin), Minus(plane.Point2, plane.Origin)))
  {
    keys.Fail(keys.Has("point1") ? "point1"
        : keys.Has("point2")     ? "point2"
                                 : "origin",
      "origin, point1 and point2 lie on one line");
  }
}

//--------------------------------------------------------------------------------------------------
void CheckShape(const KeyReader& keys, const BoxShape& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.Bounds[2 * axis] > box.Bounds[2 * axis + 1])
    {
      keys.Fail("bounds",
        std::string("must be xmin, xmax, ymin, ymax, zmin, zmax; the minimum of ") + "xyz"[axis] +
          " is above the maximum");
    }
  }
}

//--------------------------------------------------------------------------------------------------
void CheckShape(const KeyReader& keys, const SphereShape& sphere)
{
  if (sphere.StartTheta == sphere.EndTheta)
  {
    keys.Fail(keys.Has("end_theta") ? "end_theta" : "start_theta", "start and end are the same");
  }
  if (sphere.StartPhi == sphere.EndPhi)
  {
    keys.Fail(keys.Has("end_phi") ? "end_phi" : "start_phi", "start and end are the same");
  }
}

//--------------------------------------------------------------------------------------------------
void CheckShape(const KeyReader& keys, const ConeShape& cone)
{
  if (cone.Direction == Vector3{ { 0.0, 0.0, 0.0 } })
  {
    keys.Fail("direction", "is null");
  }
}

//--------------------------------------------------------------------------------------------------
void CheckMatrix(const KeyReader& keys, const std::array<double, 16>& matrix)
{
  const double* m = matrix.data();
  if (m[12] != 0.0 || m[13] != 0.0 || m[14] != 0.0 || m[15] != 1.0)
  {
    keys.Fail("matrix",
      "the last row must be 0 0 0 1; the matrix is written row by row, the "
      "translation is the last number of the first three rows");
  }
  // Of the rows scaled to length one: small models are no flat ones.
  Vector3 row[3];
  for (int i = 0; i < 3; ++i)
  {
    row[i] = Scaled({ { m[4 * i], m[4 * i + 1], m[4 * i + 2] } });
  }
  const double determinant = row[0][0] * (row[1][1] * row[2][2] - row[1][2] * row[2][1]) -
    row[0][1] * (row[1][0] * row[2][2] - row[1][2] * row[2][0]) +
    row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0]);
  constexpr double leastDeterminant = 1e-12;
  if (std::abs(determinant) <= leastDeterminant)
  {
    keys.Fail("matrix", "has no inverse");
  }
}

//--------------------------------------------------------------------------------------------------
void CheckDirection(const KeyReader& keys, const Vector3& position, const Vector3& focalPoint)
{
  if (position == focalPoint)
  {
    keys.Fail(keys.Has("focal_point") ? "focal_point" : "position",
      "position and focal_point are the same point");
  }
}

//--------------------------------------------------------------------------------------------------
void CheckViewUp(const KeyReader& keys, const CameraDescription& camera)
{
  if (AreParallel(camera.ViewUp, Minus(camera.FocalPoint, camera.Position)))
  {
    keys.Fail(keys.Has("view_up") ? "view_up" : "position",
      "view_up (0, 1, 0 if left out) is null or along the direction of view");
  }
}

}
