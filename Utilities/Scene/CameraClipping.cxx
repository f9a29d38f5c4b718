// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CameraClipping.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace softshadows
{
namespace
{

/// x to the right, y up, depth along the direction of view.
using ViewPoint = std::array<double, 3>;

/// Inside where x X + y Y + depth Depth + Offset >= 0.
struct Plane
{
  double X;
  double Y;
  double Depth;
  double Offset;

  double At(const ViewPoint& p) const
  {
    return this->X * p[0] + this->Y * p[1] + this->Depth * p[2] + this->Offset;
  }
};

class DepthRange
{
public:
  DepthRange(vtkCamera* camera, double aspect)
  {
    const bool isParallel = camera->GetParallelProjection() != 0;
    const double height = isParallel
      ? camera->GetParallelScale()
      : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    const double width = height * aspect;
    const double slope = isParallel ? 0.0 : 1.0; // how the edges of the view recede
    const double offset = isParallel ? 1.0 : 0.0;
    this->View = { { { 1, 0, slope * width, offset * width },
      { -1, 0, slope * width, offset * width }, { 0, 1, slope * height, offset * height },
      { 0, -1, slope * height, offset * height }, { 0, 0, 1, 0 } } };
  }

  /// Takes in what the view shows of a convex polygon.
  void Add(const std::vector<ViewPoint>& polygon)
  {
    this->Inside = polygon;
    for (const Plane& plane : this->View)
    {
      this->Cut(plane);
    }
    for (const ViewPoint& p : this->Inside)
    {
      // Written so that numbers that are none change nothing.
      this->Near = p[2] < this->Near ? p[2] : this->Near;
      this->Far = p[2] > this->Far ? p[2] : this->Far;
    }
  }

  double Near = std::numeric_limits<double>::infinity();
  double Far = 0.0;

private:
  std::array<Plane, 5> View;
  std::vector<ViewPoint> Inside;
  std::vector<ViewPoint> Rest;

  void Cut(const Plane& plane)
  {
    this->Rest.clear();
    for (std::size_t i = 0; i < this->Inside.size(); ++i)
    {
      const ViewPoint& p = this->Inside[i];
      const ViewPoint& q = this->Inside[(i + 1) % this->Inside.size()];
      const double atP = plane.At(p);
      const double atQ = plane.At(q);
      if (atP >= 0.0)
      {
        this->Rest.push_back(p);
      }
      if ((atP >= 0.0) != (atQ >= 0.0))
      {
        const double t = atP / (atP - atQ);
        this->Rest.push_back(
          { { p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2]) } });
      }
    }
    this->Inside.swap(this->Rest);
  }
};

void AddActor(vtkActor* actor, vtkMatrix4x4* worldToView, DepthRange& range)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  vtkPolyData* mesh = mapper ? mapper->GetInput() : nullptr;
  if (!mesh || !mesh->GetPoints())
  {
    return;
  }
  vtkNew<vtkMatrix4x4> modelToView;
  vtkMatrix4x4::Multiply4x4(worldToView, actor->GetMatrix(), modelToView);
  std::vector<ViewPoint> points(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double p[4] = { 0, 0, 0, 1 };
    mesh->GetPoint(static_cast<vtkIdType>(i), p);
    modelToView->MultiplyPoint(p, p);
    points[i] = { { p[0], p[1], -p[2] } };
  }

  std::vector<ViewPoint> polygon;
  const auto polys = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    polys->GetCurrentCell(count, corners);
    polygon.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      polygon.push_back(points[static_cast<std::size_t>(corners[i])]);
    }
    range.Add(polygon);
  }
  const auto strips = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    strips->GetCurrentCell(count, corners);
    for (vtkIdType i = 2; i < count; ++i)
    {
      range.Add({ points[static_cast<std::size_t>(corners[i - 2])],
        points[static_cast<std::size_t>(corners[i - 1])],
        points[static_cast<std::size_t>(corners[i])] });
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
void FitClippingRange(
  vtkCamera* camera, const std::vector<vtkSmartPointer<vtkActor>>& actors, double aspect)
{
  DepthRange range(camera, aspect);
  for (const auto& actor : actors)
  {
    AddActor(actor, camera->GetModelViewTransformMatrix(), range);
  }
  if (!(range.Far > 0.0))
  {
    return;
  }
  constexpr double margin = 0.01;
  constexpr double nearestNear = 1e-5;
  const double farthest = range.Far * (1.0 + margin);
  camera->SetClippingRange(std::max(range.Near * (1.0 - margin), farthest * nearestNear), farthest);
}

}
