// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterClusters.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Point = vtkShadowCasterClusters::Point;
using Cluster = vtkShadowCasterClusters::Cluster;
using Triangles = std::vector<std::uint32_t>; // numbers of triangles

constexpr double FLAT_PART_TOLERANCE = 1e-6; // of the mesh's extent
constexpr double SMALL_ENOUGH = 0.5;         // of the diagonal
constexpr std::size_t MOST_CLUSTERS = 32;    // of a mesh
constexpr int BINS = 16;
constexpr double INFINITE = std::numeric_limits<double>::infinity();

struct Box
{
  double Low[3] = { INFINITE, INFINITE, INFINITE };
  double High[3] = { -INFINITE, -INFINITE, -INFINITE };

  void Add(const double* p)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Low[i] = std::min(this->Low[i], p[i]);
      this->High[i] = std::max(this->High[i], p[i]);
    }
  }
  void Add(const Box& other)
  {
    this->Add(other.Low);
    this->Add(other.High);
  }
  double Diagonal() const
  {
    return this->Low[0] > this->High[0]
      ? 0.0
      : std::sqrt(vtkMath::Distance2BetweenPoints(this->Low, this->High));
  }
};

struct Mesh
{
  const std::vector<double>& Points;
  const std::vector<std::uint32_t>& Indices;

  const double* Corner(std::uint32_t triangle, int corner) const
  {
    return this->Points.data() + 3 * std::size_t(this->Indices[3 * std::size_t(triangle) + corner]);
  }
  Box BoxOf(std::uint32_t triangle) const
  {
    Box box;
    for (int corner = 0; corner < 3; ++corner)
    {
      box.Add(this->Corner(triangle, corner));
    }
    return box;
  }
  Box BoxOf(const Triangles& triangles) const
  {
    Box box;
    for (const std::uint32_t triangle : triangles)
    {
      box.Add(this->BoxOf(triangle));
    }
    return box;
  }
};

struct Plane
{
  Point Base{};
  Point Normal{}; // of length 1

  bool Holds(const Mesh& mesh, std::uint32_t triangle, double tolerance) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      double offset[3];
      vtkMath::Subtract(mesh.Corner(triangle, corner), this->Base.data(), offset);
      if (!(std::abs(vtkMath::Dot(offset, this->Normal.data())) <= tolerance))
      {
        return false;
      }
    }
    return true;
  }
};

// Twice the triangle's area, along its normal.
void FindAreaVector(const Mesh& mesh, std::uint32_t triangle, double area[3])
{
  double u[3];
  double v[3];
  vtkMath::Subtract(mesh.Corner(triangle, 1), mesh.Corner(triangle, 0), u);
  vtkMath::Subtract(mesh.Corner(triangle, 2), mesh.Corner(triangle, 0), v);
  vtkMath::Cross(u, v, area);
}

// A vote by area, after Boyer and Moore: a plane with more than half of it comes out. False if none has.
bool FindMainPlane(const Mesh& mesh, std::uint32_t count, double tolerance, Plane& plane)
{
  double lead = 0.0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    double normal[3];
    FindAreaVector(mesh, i, normal);
    const double area = vtkMath::Normalize(normal);
    if (lead > 0.0)
    {
      lead += plane.Holds(mesh, i, tolerance) ? area : -area;
    }
    if (!(lead > 0.0) && area > 0.0)
    {
      lead = lead < 0.0 ? -lead : area;
      std::copy_n(mesh.Corner(i, 0), 3, plane.Base.begin());
      std::copy_n(normal, 3, plane.Normal.begin());
    }
  }
  return lead > 0.0;
}

// Cuts along the longest edge of the box, between the bins where both halves' boxes are smallest.
bool Halve(const Mesh& mesh, const Triangles& whole, const Box& box, Triangles (&halves)[2])
{
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = box.High[i] - box.Low[i] > box.High[axis] - box.Low[axis] ? i : axis;
  }
  const double extent = box.High[axis] - box.Low[axis];
  const auto binOf = [&](const Box& part)
  {
    const double middle = 0.5 * (part.Low[axis] + part.High[axis]) - box.Low[axis];
    return std::min(std::max(static_cast<int>(BINS * middle / extent), 0), BINS - 1);
  };
  if (!(extent > 0.0))
  {
    return false;
  }
  std::array<Box, BINS> bins;
  for (const std::uint32_t triangle : whole)
  {
    const Box part = mesh.BoxOf(triangle);
    bins[static_cast<std::size_t>(binOf(part))].Add(part);
  }
  int best = 0;
  double least = SMALL_ENOUGH * box.Diagonal();
  for (int cut = 1; cut < BINS; ++cut)
  {
    Box sides[2];
    for (int bin = 0; bin < BINS; ++bin)
    {
      if (bins[static_cast<std::size_t>(bin)].Diagonal() > 0.0)
      {
        sides[bin < cut ? 0 : 1].Add(bins[static_cast<std::size_t>(bin)]);
      }
    }
    const double sum = sides[0].Diagonal() + sides[1].Diagonal();
    if (sides[0].Diagonal() > 0.0 && sides[1].Diagonal() > 0.0 && sum < least)
    {
      least = sum;
      best = cut;
    }
  }
  for (const std::uint32_t triangle : best > 0 ? whole : Triangles())
  {
    halves[binOf(mesh.BoxOf(triangle)) < best ? 0 : 1].push_back(triangle);
  }
  return best > 0;
}

// The boxes that are left when nothing more is won by cutting.
void Cut(const Mesh& mesh, const Triangles& whole, std::vector<Box>& boxes)
{
  const Box box = mesh.BoxOf(whole);
  Triangles halves[2];
  if (boxes.size() + 1 < MOST_CLUSTERS && Halve(mesh, whole, box, halves))
  {
    Cut(mesh, halves[0], boxes);
    Cut(mesh, halves[1], boxes);
  }
  else if (!whole.empty())
  {
    boxes.push_back(box);
  }
}

double SumOfDiagonals(const std::vector<Box>& boxes)
{
  double sum = 0.0;
  for (const Box& box : boxes)
  {
    sum += box.Diagonal();
  }
  return sum;
}

Cluster ToCluster(const Box& box)
{
  Cluster cluster;
  cluster.Bounds = { { box.Low[0], box.High[0], box.Low[1], box.High[1], box.Low[2],
    box.High[2] } };
  return cluster;
}

Cluster ToFlatCluster(const Mesh& mesh, const Triangles& triangles, const Plane& plane)
{
  constexpr int EVEN = 8;
  Cluster cluster = ToCluster(mesh.BoxOf(triangles));
  cluster.Flat = true;
  double axis[3];
  double other[3];
  vtkMath::Subtract(mesh.Corner(triangles[0], 1), mesh.Corner(triangles[0], 0), axis);
  vtkMath::Normalize(axis);
  vtkMath::Cross(plane.Normal.data(), axis, other);
  vtkMath::Normalize(other);
  vtkMath::Cross(other, plane.Normal.data(), axis);
  std::vector<std::array<double, 2>> points;
  points.reserve(3 * triangles.size());
  for (const std::uint32_t triangle : triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      double offset[3];
      vtkMath::Subtract(mesh.Corner(triangle, corner), plane.Base.data(), offset);
      points.push_back({ { vtkMath::Dot(offset, axis), vtkMath::Dot(offset, other) } });
    }
  }
  std::vector<double> angles;
  for (int i = 0; i < EVEN; ++i)
  {
    angles.push_back(0.5 * vtkMath::Pi() * i / EVEN);
  }
  cluster.Corners =
    vtkShadowCasterClusters::FindRectangle(points, angles, plane.Base.data(), axis, other);
  return cluster;
}

// The main plane and what is left of the mesh without it.
bool SplitPlane(const Mesh& mesh, const Triangles& whole, double diagonal,
  std::vector<Cluster>& clusters, std::vector<Box>& boxes)
{
  Plane plane;
  const double tolerance = FLAT_PART_TOLERANCE * diagonal;
  if (!FindMainPlane(mesh, static_cast<std::uint32_t>(whole.size()), tolerance, plane))
  {
    return false;
  }
  Triangles inPlane;
  Triangles rest;
  double areas[2] = { 0.0, 0.0 };
  for (const std::uint32_t triangle : whole)
  {
    double area[3];
    FindAreaVector(mesh, triangle, area);
    const bool holds = plane.Holds(mesh, triangle, tolerance);
    (holds ? inPlane : rest).push_back(triangle);
    areas[holds ? 0 : 1] += vtkMath::Norm(area);
  }
  if (areas[0] < areas[1] || rest.empty())
  {
    return false;
  }
  Cut(mesh, rest, boxes);
  if (!(SumOfDiagonals(boxes) < SMALL_ENOUGH * diagonal))
  {
    return false;
  }
  clusters.push_back(ToFlatCluster(mesh, inPlane, plane));
  return true;
}
}

//------------------------------------------------------------------------------
std::vector<vtkShadowCasterClusters::Cluster> vtkShadowCasterClusters::Find(
  const std::vector<double>& points, const std::vector<std::uint32_t>& indices)
{
  const Mesh mesh{ points, indices };
  Triangles whole(indices.size() / 3);
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    whole[i] = static_cast<std::uint32_t>(i);
  }
  const double diagonal = mesh.BoxOf(whole).Diagonal();
  std::vector<Cluster> clusters;
  std::vector<Box> boxes;
  if (!SplitPlane(mesh, whole, diagonal, clusters, boxes))
  {
    boxes.clear();
    Cut(mesh, whole, boxes);
    if (boxes.size() < 2)
    {
      return {};
    }
  }
  std::transform(boxes.begin(), boxes.end(), std::back_inserter(clusters), ToCluster);
  return clusters;
}

//------------------------------------------------------------------------------
std::array<vtkShadowCasterClusters::Point, 4> vtkShadowCasterClusters::FindRectangle(
  const std::vector<std::array<double, 2>>& points, const std::vector<double>& angles,
  const double base[3], const double axis[3], const double other[3])
{
  std::array<Point, 4> corners{};
  double least = INFINITE;
  for (const double angle : angles)
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    double low[2] = { INFINITE, INFINITE };
    double high[2] = { -INFINITE, -INFINITE };
    for (const auto& p : points)
    {
      const double q[2] = { c * p[0] + s * p[1], c * p[1] - s * p[0] };
      for (int i = 0; i < 2; ++i)
      {
        low[i] = std::min(low[i], q[i]);
        high[i] = std::max(high[i], q[i]);
      }
    }
    const double area = (high[0] - low[0]) * (high[1] - low[1]);
    if (area < least)
    {
      least = area;
      const double u[4] = { low[0], high[0], high[0], low[0] };
      const double v[4] = { low[1], low[1], high[1], high[1] };
      for (std::size_t i = 0; i < 4; ++i)
      {
        const double x = c * u[i] - s * v[i];
        const double y = s * u[i] + c * v[i];
        for (std::size_t k = 0; k < 3; ++k)
        {
          corners[i][k] = base[k] + x * axis[k] + y * other[k];
        }
      }
    }
  }
  return corners;
}

VTK_ABI_NAMESPACE_END
