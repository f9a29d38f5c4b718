// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceGeometry.h"

#include "ReferenceSurfaces.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationKeyLookup.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProp.h>
#include <vtkRenderer.h>

#include <algorithm> // For std::max
#include <limits>    // For the precision of numbers

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
bool IsFinite(const Vector& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

//--------------------------------------------------------------------------------------------------
// A surface's own matrix, taken to local coordinates. The origin is subtracted from the translation
// before anything is multiplied: what is large in both cancels exactly.
class ToLocalTransform
{
public:
  ToLocalTransform(const std::array<double, 16>& toWorld, const Vector& origin, double scale)
    : Matrix(toWorld)
    , Scale(scale)
  {
    for (int row = 0; row < 3; ++row)
    {
      this->Matrix[4 * row + 3] -= origin[row];
    }
  }

  Vector operator()(const Vector& p) const
  {
    Vector result;
    for (int row = 0; row < 3; ++row)
    {
      const double* m = this->Matrix.data() + 4 * row;
      result[row] = this->Scale * (m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3]);
    }
    return result;
  }

  /// The most that one unit of any coordinate can become.
  double Stretch() const
  {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
    {
      const double* m = this->Matrix.data() + column;
      largest = std::max(largest, Length({ { m[0], m[4], m[8] } }));
    }
    return this->Scale * largest;
  }

private:
  std::array<double, 16> Matrix;
  double Scale;
};

//--------------------------------------------------------------------------------------------------
// One of vtkShadowCasters' keys, found by name: whoever could have set it has loaded that library.
bool IsSwitchedOn(vtkProp* prop, const char* name)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  auto* key =
    vtkInformationIntegerKey::SafeDownCast(vtkInformationKeyLookup::Find(name, "vtkShadowCasters"));
  return !keys || !key || !keys->Has(key) || keys->Get(key) != 0;
}

//--------------------------------------------------------------------------------------------------
vtkBoundingBox WorldBounds(const std::vector<ReferenceSurface>& surfaces)
{
  vtkBoundingBox box;
  for (const ReferenceSurface& surface : surfaces)
  {
    const ToLocalTransform toWorld(surface.ToWorld, { { 0.0, 0.0, 0.0 } }, 1.0);
    double bounds[6];
    surface.Triangles->GetBounds(bounds);
    for (int corner = 0; corner < 8; ++corner)
    {
      Vector world = toWorld(
        { { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)] } });
      if (IsFinite(world))
      {
        box.AddPoint(world.data());
      }
    }
  }
  return box;
}

//--------------------------------------------------------------------------------------------------
double PointPrecision(vtkPolyData* data)
{
  double bounds[6];
  data->GetBounds(bounds);
  double largest = 0.0;
  for (double bound : bounds)
  {
    largest = std::max(largest, std::abs(bound));
  }
  const bool isDouble = data->GetPoints()->GetDataType() == VTK_DOUBLE;
  return largest *
    (isDouble ? std::numeric_limits<double>::epsilon() : std::numeric_limits<float>::epsilon());
}

//--------------------------------------------------------------------------------------------------
void AppendPoints(vtkPoints* points, const ToLocalTransform& toLocal, std::vector<Vector>& all)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vector p;
    points->GetPoint(i, p.data());
    all.push_back(toLocal(p));
  }
}

//--------------------------------------------------------------------------------------------------
// Triangles without area or with a point that is no number neither show nor block anything.
void AppendTriangles(
  vtkPolyData* data, unsigned int object, size_t firstPoint, ReferenceGeometry& geometry)
{
  vtkSmartPointer<vtkCellArrayIterator> cells;
  cells.TakeReference(data->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    if (count != 3)
    {
      continue;
    }
    ReferenceGeometry::Triangle triangle;
    for (int corner = 0; corner < 3; ++corner)
    {
      triangle.Points[corner] = static_cast<unsigned int>(firstPoint + ids[corner]);
    }
    triangle.Object = object;
    const Vector area = geometry.AreaVector(triangle);
    if (IsFinite(area) && Length(area) > 0.0)
    {
      geometry.Triangles.push_back(triangle);
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
ReferenceGeometry::ReferenceGeometry(vtkRenderer* renderer)
{
  const std::vector<ReferenceSurface> surfaces = CollectSurfaces(renderer);
  const vtkBoundingBox box = WorldBounds(surfaces);
  if (box.IsValid())
  {
    box.GetCenter(this->Origin.data());
    const double radius = 0.5 * box.GetDiagonalLength();
    this->Scale = radius > 0.0 ? 1.0 / radius : 1.0;
  }
  for (const ReferenceSurface& surface : surfaces)
  {
    const ToLocalTransform toLocal(surface.ToWorld, this->Origin, this->Scale);
    if (this->Objects.size() <= surface.Object)
    {
      this->Objects.resize(surface.Object + 1);
    }
    Object& object = this->Objects[surface.Object];
    object.Prop = surface.Prop;
    object.Casts = IsSwitchedOn(surface.Prop, "CASTS_SHADOW");
    object.Receives = surface.Lit && IsSwitchedOn(surface.Prop, "RECEIVES_SHADOW");
    object.Precision =
      std::max(object.Precision, PointPrecision(surface.Triangles) * toLocal.Stretch());
    const size_t firstPoint = this->Points.size();
    AppendPoints(surface.Triangles->GetPoints(), toLocal, this->Points);
    AppendTriangles(surface.Triangles, surface.Object, firstPoint, *this);
  }
}

//--------------------------------------------------------------------------------------------------
Vector ReferenceGeometry::AreaVector(const Triangle& triangle) const
{
  const Vector& origin = this->Points[triangle.Points[0]];
  return Cross(
    this->Points[triangle.Points[1]] - origin, this->Points[triangle.Points[2]] - origin);
}

}
