// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterGeometry.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowCasterOrientation.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr std::uint32_t UNUSED = std::numeric_limits<std::uint32_t>::max();
constexpr double FLAT_TOLERANCE = 1e-6; // of the extent, as vtkShadowCasters::Body promises

template <typename Access, typename Functor>
void Visit(const std::vector<vtkIdType>& ids, std::size_t count, Access&& access, Functor&& functor)
{
  double p[3];
  if (ids.empty())
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      access(static_cast<vtkIdType>(i), p);
      functor(p);
    }
    return;
  }
  for (const vtkIdType id : ids)
  {
    access(id, p);
    functor(p);
  }
}

// Calls functor(double[3]) for the points, reading the usual arrays without virtual calls.
template <typename Functor>
void VisitPoints(
  vtkDataArray* points, const std::vector<vtkIdType>& ids, std::size_t count, Functor&& functor)
{
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(points))
  {
    const float* data = floats->GetPointer(0);
    Visit(
      ids, count,
      [data](vtkIdType i, double* p)
      {
        p[0] = data[3 * i];
        p[1] = data[3 * i + 1];
        p[2] = data[3 * i + 2];
      },
      functor);
  }
  else if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(points))
  {
    const double* data = doubles->GetPointer(0);
    Visit(
      ids, count, [data](vtkIdType i, double* p) { std::copy_n(data + 3 * i, 3, p); }, functor);
  }
  else
  {
    Visit(
      ids, count, [points](vtkIdType i, double* p) { points->GetTuple(i, p); }, functor);
  }
}
}

//------------------------------------------------------------------------------
template <typename Functor>
void vtkShadowCasterGeometry::ForEachVertex(Functor&& functor) const
{
  for (const Piece& piece : this->Pieces)
  {
    VisitPoints(piece.Points, piece.Ids, piece.NumberOfVertices, functor);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::Clear()
{
  this->Pieces.clear();
  this->Indices.clear();
  this->NumberOfVertices = 0;
  this->Flat = false;
  this->Clusters.clear();
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::Build(const std::vector<vtkPolyData*>& pieces)
{
  this->Clear();
  for (vtkPolyData* data : pieces)
  {
    if (data && data->GetPoints() && data->GetNumberOfPoints() > 0)
    {
      this->AddPiece(data);
    }
  }
  this->FindPlane();
  this->FindClusters();
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::FindClusters()
{
  if (!this->Flat && this->NumberOfVertices > 3)
  {
    this->Clusters = vtkShadowCasterClusters::Find(this->GatherPoints(), this->Indices);
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkShadowCasterGeometry::GatherPoints() const
{
  std::vector<double> points;
  points.reserve(3 * this->NumberOfVertices);
  this->ForEachVertex([&points](const double* p) { points.insert(points.end(), p, p + 3); });
  return points;
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::AddPiece(vtkPolyData* data)
{
  Piece piece;
  piece.Points = data->GetPoints()->GetData();
  piece.TextureCoordinates = data->GetPointData()->GetTCoords();
  const vtkIdType count = data->GetNumberOfPoints();

  this->Finite.clear();
  vtkIdType index = 0;
  VisitPoints(piece.Points, piece.Ids, static_cast<std::size_t>(count),
    [this, &index, count](const double* p)
    {
      if (!std::isfinite(p[0] + p[1] + p[2]))
      {
        this->Finite.resize(static_cast<std::size_t>(count), 1);
        this->Finite[static_cast<std::size_t>(index)] = 0;
      }
      ++index;
    });

  const std::size_t firstIndex = this->Indices.size();
  this->AddPolygons(data->GetPolys(), count);
  this->AddStrips(data->GetStrips(), count);
  if (this->Indices.size() > firstIndex)
  {
    this->RenumberPiece(piece, firstIndex, count);
    this->NumberOfVertices += piece.NumberOfVertices;
    this->Pieces.push_back(std::move(piece));
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  const auto finite = [this](vtkIdType id)
  { return this->Finite.empty() || this->Finite[static_cast<std::size_t>(id)] != 0; };
  if (finite(a) && finite(b) && finite(c))
  {
    this->Indices.push_back(static_cast<std::uint32_t>(a));
    this->Indices.push_back(static_cast<std::uint32_t>(b));
    this->Indices.push_back(static_cast<std::uint32_t>(c));
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::AddPolygons(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  this->Indices.reserve(this->Indices.size() +
    3 *
      static_cast<std::size_t>(std::max<vtkIdType>(
        cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells(), 0)));
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cell->GetCurrentCell(size, ids);
    const auto valid = [numberOfPoints](vtkIdType id) { return id >= 0 && id < numberOfPoints; };
    if (!std::all_of(ids, ids + size, valid))
    {
      continue;
    }
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      this->AddTriangle(ids[0], ids[i], ids[i + 1]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::AddStrips(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cell->GetCurrentCell(size, ids);
    const auto valid = [numberOfPoints](vtkIdType id) { return id >= 0 && id < numberOfPoints; };
    if (!std::all_of(ids, ids + size, valid))
    {
      continue;
    }
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      this->AddTriangle(ids[i], ids[i + 1], ids[i + 2]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::RenumberPiece(
  Piece& piece, std::size_t firstIndex, vtkIdType numberOfPoints)
{
  const auto points = static_cast<std::size_t>(numberOfPoints);
  const auto base = static_cast<std::uint32_t>(this->NumberOfVertices);
  this->NewNumber.assign(points, UNUSED);
  std::size_t used = 0;
  for (std::size_t i = firstIndex; i < this->Indices.size(); ++i)
  {
    std::uint32_t& number = this->NewNumber[this->Indices[i]];
    used += number == UNUSED ? 1 : 0;
    number = 0;
  }
  piece.NumberOfVertices = used;
  if (used < points)
  {
    piece.Ids.reserve(used);
  }
  std::uint32_t next = base;
  for (std::size_t i = 0; i < points; ++i)
  {
    if (this->NewNumber[i] != UNUSED)
    {
      this->NewNumber[i] = next++;
      if (used < points)
      {
        piece.Ids.push_back(static_cast<vtkIdType>(i));
      }
    }
  }
  for (std::size_t i = firstIndex; i < this->Indices.size(); ++i)
  {
    this->Indices[i] = this->NewNumber[this->Indices[i]];
  }
}

//------------------------------------------------------------------------------
bool vtkShadowCasterGeometry::Transform(
  const double matrix[16], const double origin[3], float* xyz, double bounds[6]) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[3] = { infinity, infinity, infinity };
  double high[3] = { -infinity, -infinity, -infinity };
  const double m[12] = { matrix[0], matrix[1], matrix[2], matrix[3] - origin[0], //
    matrix[4], matrix[5], matrix[6], matrix[7] - origin[1],                      //
    matrix[8], matrix[9], matrix[10], matrix[11] - origin[2] };
  this->ForEachVertex(
    [&](const double* p)
    {
      const double q[3] = { m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3],
        m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7],
        m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11] };
      for (int i = 0; i < 3; ++i)
      {
        low[i] = std::min(low[i], q[i]);
        high[i] = std::max(high[i], q[i]);
        *xyz++ = static_cast<float>(q[i]);
      }
    });
  bool finite = true;
  for (int i = 0; i < 3; ++i)
  {
    bounds[2 * i] = low[i] + origin[i];
    bounds[2 * i + 1] = high[i] + origin[i];
    // Beyond the range of float the GPU would see infinities; a NaN fails both comparisons.
    finite = finite && low[i] > -std::numeric_limits<float>::max() &&
      high[i] < std::numeric_limits<float>::max();
  }
  return finite;
}

//------------------------------------------------------------------------------
std::vector<float> vtkShadowCasterGeometry::GatherTextureCoordinates() const
{
  std::vector<float> coordinates;
  coordinates.reserve(2 * this->NumberOfVertices);
  for (const Piece& piece : this->Pieces)
  {
    vtkDataArray* values = piece.TextureCoordinates;
    for (std::size_t i = 0; i < piece.NumberOfVertices; ++i)
    {
      const vtkIdType id = piece.Ids.empty() ? static_cast<vtkIdType>(i) : piece.Ids[i];
      for (int k = 0; k < 2; ++k)
      {
        const bool has = values && k < values->GetNumberOfComponents();
        coordinates.push_back(has ? static_cast<float>(values->GetComponent(id, k)) : 0.0f);
      }
    }
  }
  return coordinates;
}

//------------------------------------------------------------------------------
int vtkShadowCasterGeometry::FindOrientation() const
{
  return vtkShadowCasterOrientation::Find(this->GatherPoints(), this->Indices);
}

//------------------------------------------------------------------------------
bool vtkShadowCasterGeometry::FindNormal(std::array<double, 3>& base, std::array<double, 3>& axis,
  std::array<double, 3>& normal, double& extent) const
{
  bool first = true;
  double farthest = 0.0;
  this->ForEachVertex(
    [&](const double* p)
    {
      if (first)
      {
        std::copy_n(p, 3, base.data());
        first = false;
      }
      const double distance = vtkMath::Distance2BetweenPoints(p, base.data());
      if (distance > farthest)
      {
        farthest = distance;
        vtkMath::Subtract(p, base.data(), axis.data());
      }
    });
  extent = std::sqrt(farthest);
  if (!(vtkMath::Normalize(axis.data()) > 0.0))
  {
    return false;
  }
  double widest = 0.0;
  this->ForEachVertex(
    [&](const double* p)
    {
      double offset[3];
      double product[3];
      vtkMath::Subtract(p, base.data(), offset);
      vtkMath::Cross(axis.data(), offset, product);
      const double distance = vtkMath::Dot(product, product);
      if (distance > widest)
      {
        widest = distance;
        std::copy_n(product, 3, normal.data());
      }
    });
  return std::sqrt(widest) > FLAT_TOLERANCE * extent && vtkMath::Normalize(normal.data()) > 0.0;
}

//------------------------------------------------------------------------------
void vtkShadowCasterGeometry::FindPlane()
{
  std::array<double, 3> base{};
  std::array<double, 3> axis{};
  std::array<double, 3> normal{};
  double extent = 0.0;
  this->Flat = this->NumberOfVertices > 2 && this->FindNormal(base, axis, normal, extent);
  if (!this->Flat)
  {
    return;
  }
  double height = 0.0;
  this->ForEachVertex(
    [&](const double* p)
    {
      double offset[3];
      vtkMath::Subtract(p, base.data(), offset);
      height = std::max(height, std::abs(vtkMath::Dot(offset, normal.data())));
    });
  this->Flat = height <= FLAT_TOLERANCE * extent;
  if (this->Flat)
  {
    this->FindCorners(base, axis, normal);
  }
}

//------------------------------------------------------------------------------
// The smallest rectangle among some directions: those of the first edges, which are the true ones
// for rectangles and grids, and eight even ones.
void vtkShadowCasterGeometry::FindCorners(const std::array<double, 3>& base,
  const std::array<double, 3>& axis, const std::array<double, 3>& normal)
{
  constexpr int EVEN = 8;
  constexpr std::size_t EDGES = 12;
  double other[3];
  vtkMath::Cross(normal.data(), axis.data(), other);

  std::vector<std::array<double, 2>> points;
  points.reserve(this->NumberOfVertices);
  this->ForEachVertex(
    [&](const double* p)
    {
      double offset[3];
      vtkMath::Subtract(p, base.data(), offset);
      points.push_back({ { vtkMath::Dot(offset, axis.data()), vtkMath::Dot(offset, other) } });
    });

  std::vector<double> angles;
  for (int i = 0; i < EVEN; ++i)
  {
    angles.push_back(0.5 * vtkMath::Pi() * i / EVEN);
  }
  for (std::size_t i = 0; i + 1 < std::min(this->Indices.size(), EDGES); ++i)
  {
    const auto& a = points[this->Indices[i]];
    const auto& b = points[this->Indices[i + 1]];
    angles.push_back(std::atan2(b[1] - a[1], b[0] - a[0]));
  }

  this->Corners =
    vtkShadowCasterClusters::FindRectangle(points, angles, base.data(), axis.data(), other);
}

VTK_ABI_NAMESPACE_END
