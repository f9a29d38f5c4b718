// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceGeometry.h"

#include "ReferenceSurfaces.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationIterator.h>
#include <vtkInformationKeyLookup.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProp.h>
#include <vtkRenderer.h>

#include <array>  // For terms of a sum
#include <cmath>  // For std::fma
#include <string> // For the names of keys

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
// The sum of products as if computed in twice the precision, then rounded (Ogita, Rump and Oishi
// 2005): large terms may cancel.
double AccurateDot(const std::array<double, 5>& a, const std::array<double, 5>& b)
{
  double sum = 0.0;
  double lost = 0.0;
  for (size_t i = 0; i < a.size(); ++i)
  {
    const double product = a[i] * b[i];
    lost += std::fma(a[i], b[i], -product);
    const double next = sum + product;
    const double added = next - sum;
    lost += (sum - (next - added)) + (product - added);
    sum = next;
  }
  return sum + lost;
}

//--------------------------------------------------------------------------------------------------
// A surface's own matrix, taken to local coordinates. Points are exact numbers. They are taken
// relative to one among them, and so is the translation: what is large in all of them cancels
// before anything is rounded, and what is lost follows the size of what is left.
class ToLocalTransform
{
public:
  ToLocalTransform(
    const std::array<double, 16>& toWorld, const Vector& inner, const Vector& origin, double scale)
    : Matrix(toWorld)
    , Inner(inner)
    , Scale(scale)
  {
    for (int row = 0; row < 3; ++row)
    {
      const double* m = toWorld.data() + 4 * row;
      this->Place[row] = AccurateDot({ { m[0], m[1], m[2], m[3], origin[row] } },
        { { inner[0], inner[1], inner[2], 1.0, -1.0 } });
    }
  }

  Vector operator()(const Vector& p) const
  {
    const Vector d = p - this->Inner;
    Vector result;
    for (int row = 0; row < 3; ++row)
    {
      const double* m = this->Matrix.data() + 4 * row;
      result[row] = this->Scale * (m[0] * d[0] + m[1] * d[1] + m[2] * d[2] + this->Place[row]);
    }
    return result;
  }

private:
  std::array<double, 16> Matrix;
  Vector Inner;
  double Scale;
  Vector Place; // of the inner point, in the world, from the origin
};

//--------------------------------------------------------------------------------------------------
Vector FirstFinitePoint(vtkPoints* points)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vector p;
    points->GetPoint(i, p.data());
    if (IsFinite(p))
    {
      return p;
    }
  }
  return { { 0.0, 0.0, 0.0 } };
}

//--------------------------------------------------------------------------------------------------
// One of VTK's shadows' keys, which programs make by name.
bool HasKey(vtkInformation* keys, const std::string& name)
{
  vtkNew<vtkInformationIterator> iterator;
  iterator->SetInformationWeak(keys);
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkInformationKey* key = iterator->GetCurrentKey();
    if (key->GetName() == name && std::string(key->GetLocation()) == "vtkShadowMapBakerPass")
    {
      return true;
    }
  }
  return false;
}

//--------------------------------------------------------------------------------------------------
// One of vtkShadowCasters' keys, found by name: whoever could have set it has loaded that library.
// Without it one of VTK's shadows, which excludes what it does not name.
bool IsSwitchedOn(
  vtkProp* prop, const char* name, const char* nameOfVTK, const char* otherNameOfVTK)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  auto* key =
    vtkInformationIntegerKey::SafeDownCast(vtkInformationKeyLookup::Find(name, "vtkShadowCasters"));
  if (!keys || (key && keys->Has(key)))
  {
    return !keys || keys->Get(key) != 0;
  }
  return HasKey(keys, nameOfVTK) || !HasKey(keys, otherNameOfVTK);
}

//--------------------------------------------------------------------------------------------------
vtkBoundingBox WorldBounds(const std::vector<ReferenceSurface>& surfaces)
{
  vtkBoundingBox box;
  for (const ReferenceSurface& surface : surfaces)
  {
    constexpr Vector zero{ { 0.0, 0.0, 0.0 } };
    const ToLocalTransform toWorld(
      surface.ToWorld, FirstFinitePoint(surface.Triangles->GetPoints()), zero, 1.0);
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
    vtkPoints* points = surface.Triangles->GetPoints();
    const ToLocalTransform toLocal(
      surface.ToWorld, FirstFinitePoint(points), this->Origin, this->Scale);
    if (this->Objects.size() <= surface.Object)
    {
      this->Objects.resize(surface.Object + 1);
    }
    Object& object = this->Objects[surface.Object];
    object.Prop = surface.Prop;
    object.Casts = IsSwitchedOn(surface.Prop, "CASTS_SHADOW", "OCCLUDER", "RECEIVER");
    object.Receives =
      surface.Lit && IsSwitchedOn(surface.Prop, "RECEIVES_SHADOW", "RECEIVER", "OCCLUDER");
    const size_t firstPoint = this->Points.size();
    AppendPoints(points, toLocal, this->Points);
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
