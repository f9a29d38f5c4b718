// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterEntry.h"

#include "vtkActor.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProp3D.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
std::array<double, 3> TransformPoint(const std::array<double, 16>& m, const double p[3])
{
  std::array<double, 3> q;
  for (int i = 0; i < 3; ++i)
  {
    q[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
  }
  return q;
}

// The box of a transformed box.
std::array<double, 6> TransformBounds(const std::array<double, 16>& m, const double bounds[6])
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 6> box{ { infinity, -infinity, infinity, -infinity, infinity, -infinity } };
  for (int corner = 0; corner < 8; ++corner)
  {
    const double p[3] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + ((corner >> 2) & 1)] };
    const auto q = TransformPoint(m, p);
    for (int i = 0; i < 3; ++i)
    {
      box[2 * i] = std::min(box[2 * i], q[i]);
      box[2 * i + 1] = std::max(box[2 * i + 1], q[i]);
    }
  }
  return box;
}

bool IsSame(const vtkShadowCasters::Body& a, const vtkShadowCasters::Body& b)
{
  return a.Bounds == b.Bounds && a.Flat == b.Flat && (!a.Flat || a.Corners == b.Corners);
}

bool IsFinite(const double* values, int count)
{
  return std::all_of(values, values + count, [](double v) { return std::isfinite(v); });
}
}

//------------------------------------------------------------------------------
vtkShadowCasterEntry::Change vtkShadowCasterEntry::Refresh(const vtkShadowCasterSource& source,
  const std::array<double, 16>& matrix, bool casts, bool receives)
{
  Change change;
  change.Looks = this->Look != source.Look || this->Matrix != matrix;
  this->Look = source.Look;
  this->Pieces = source.IsKnown ? source.Pieces : std::vector<vtkPolyData*>();
  if (this->Signature != source.Signature || this->Route != source.Route)
  {
    this->Signature = source.Signature;
    this->StampShape();
    // A prop drawn by its mapper may look different although its box stays.
    change.Casters =
      this->Body.Casts && (this->Route != source.Route || this->HasOwnDraws() || source.HasStrokes);
    this->Route = source.Route;
    this->TakeStrokes(source);
    this->Reshaped = true;
    this->Moved = true;
    this->UnchangedUpdates = 0;
    this->Orientation = 0;
    this->Geometry.Clear();
    if (source.IsHull)
    {
      this->Geometry.Build(source.Pieces);
    }
  }
  if (this->Matrix != matrix)
  {
    this->Matrix = matrix;
    this->Moved = true;
    change.Casters = change.Casters || (this->Body.Casts && this->HasOwnDraws());
  }
  if (this->Body.Casts != casts || this->Body.Receives != receives)
  {
    change.Bodies = true;
    change.Casters = change.Casters || this->Body.Casts != casts;
    this->Moved = this->Moved || this->Body.Casts != casts;
    this->Body.Casts = casts;
    this->Body.Receives = receives;
  }
  this->FindFacing();
  return change;
}

//------------------------------------------------------------------------------
void vtkShadowCasterEntry::StampShape()
{
  vtkTimeStamp stamp;
  stamp.Modified();
  this->ShapeTime = stamp.GetMTime();
  this->Number = this->Number == 0 ? this->ShapeTime : this->Number; // no two are stamped at a time
}

//------------------------------------------------------------------------------
vtkShadowCasterShape vtkShadowCasterEntry::GetShape() const
{
  vtkShadowCasterShape shape;
  shape.Number = this->Number;
  shape.Time = this->ShapeTime;
  shape.Matrix = this->Matrix;
  shape.Prop = this->Prop;
  shape.Triangles = &this->Geometry;
  shape.Pieces = this->Pieces;
  shape.Strokes = this->Strokes.get();
  shape.Screen = this->Screen;
  shape.IsPlain = this->IsInBuffer();
  return shape;
}

//------------------------------------------------------------------------------
void vtkShadowCasterEntry::TakeStrokes(const vtkShadowCasterSource& source)
{
  if (!source.HasStrokes)
  {
    this->ReleaseGraphicsResources();
    this->Strokes.reset();
    return;
  }
  if (!this->Strokes)
  {
    this->Strokes = std::make_unique<vtkShadowStrokes>();
  }
  this->Strokes->Build(source.Pieces, vtkActor::SafeDownCast(this->Prop)->GetProperty());
}

//------------------------------------------------------------------------------
void vtkShadowCasterEntry::ReleaseGraphicsResources()
{
  if (this->Strokes)
  {
    this->Strokes->ReleaseGraphicsResources();
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterEntry::ForgetRange()
{
  this->Range = vtkShadowCasterBuffer::Range();
  this->Reshaped = true;
  this->Moved = true;
}

//------------------------------------------------------------------------------
vtkShadowCasterEntry::Change vtkShadowCasterEntry::Place(vtkShadowCasterBuffer& buffer,
  const std::array<double, 3>& origin, const vtkShadowScreen& screen, std::vector<float>& scratch)
{
  Change change;
  const bool follows = this->Strokes && !(this->Screen == screen);
  this->Screen = screen;
  if (follows)
  {
    this->StampShape();
  }
  if (!this->Moved)
  {
    if (follows && this->HasBody)
    {
      const auto old = this->Body.Bounds;
      this->AddStrokeBounds();
      this->FindParts();
      change.Casters = this->Body.Casts;
      change.Bodies = old != this->Body.Bounds;
    }
    return change;
  }
  this->Moved = false;
  const bool hadBody = this->HasBody;
  const std::vector<vtkShadowCasters::Body> old = this->Parts;
  this->HasBody = this->FindBody(origin, scratch);
  this->FindParts();
  // What only receives has no copy to compare with.
  change.Bodies = !this->Body.Casts || hadBody != this->HasBody ||
    !std::equal(old.begin(), old.end(), this->Parts.begin(), this->Parts.end(), IsSame);
  if (this->DrawsFromBuffer())
  {
    change.Casters = this->Write(buffer, scratch).Casters;
  }
  else
  {
    change.Casters = this->Range.NumberOfIndices > 0;
    buffer.Free(this->Range);
    this->Reshaped = true;
  }
  change.Casters = change.Casters || (this->Body.Casts && hadBody != this->HasBody);
  return change;
}

//------------------------------------------------------------------------------
// Looking for closed surfaces pays where the same triangles are drawn many times: not if they
// change all the time, and not if they are so many that the search would be felt.
void vtkShadowCasterEntry::FindFacing()
{
  constexpr int PATIENCE = 2;
  constexpr std::size_t MOST_INDICES = 3 * 300000;
  if (this->UnchangedUpdates <= PATIENCE && ++this->UnchangedUpdates == PATIENCE &&
    this->IsInBuffer() && this->Geometry.GetIndices().size() <= MOST_INDICES)
  {
    this->Orientation = this->Geometry.FindOrientation();
  }
  this->Facing = this->Orientation;
  if (this->Orientation != 0)
  {
    const auto& m = this->Matrix;
    const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) -
      m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
    this->Facing *= determinant > 0.0 ? 1 : (determinant < 0.0 ? -1 : 0);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowCasterEntry::FindBody(
  const std::array<double, 3>& origin, std::vector<float>& scratch)
{
  this->Body.Flat = false;
  this->HasTriangles = false;
  if (!IsFinite(this->Matrix.data(), 16))
  {
    return false;
  }
  if (this->Geometry.GetNumberOfVertices() > 0)
  {
    if (scratch.size() < 3 * this->Geometry.GetNumberOfVertices())
    {
      scratch.resize(3 * this->Geometry.GetNumberOfVertices());
    }
    if (!this->Geometry.Transform(
          this->Matrix.data(), origin.data(), scratch.data(), this->Body.Bounds.data()))
    {
      return false;
    }
    this->HasTriangles = true;
    this->TriangleBounds = this->Body.Bounds;
  }
  if (this->Strokes && this->Strokes->Place(this->Matrix))
  {
    this->AddStrokeBounds();
    return true;
  }
  if (this->HasTriangles)
  {
    this->FindPlane();
    return true;
  }
  if (this->IsInBuffer())
  {
    return false; // neither triangles nor strokes: nothing to see
  }
  double bounds[6];
  if (vtkShadowCasterSource::GetModelBounds(this->Prop, bounds))
  {
    this->Body.Bounds = TransformBounds(this->Matrix, bounds);
    return IsFinite(this->Body.Bounds.data(), 6);
  }
  const double* found = vtkActor::SafeDownCast(this->Prop) ? nullptr : this->Prop->GetBounds();
  if (!found || !vtkMath::AreBoundsInitialized(found) || !IsFinite(found, 6))
  {
    return false;
  }
  std::copy_n(found, 6, this->Body.Bounds.data());
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowCasterEntry::AddStrokeBounds()
{
  auto& box = this->Body.Bounds;
  box = this->Strokes->FindBounds(this->Screen);
  for (int i = 0; this->HasTriangles && i < 6; i += 2)
  {
    box[i] = std::min(box[i], this->TriangleBounds[i]);
    box[i + 1] = std::max(box[i + 1], this->TriangleBounds[i + 1]);
  }
}

//------------------------------------------------------------------------------
// A plane stays a plane under the matrix, unless that flattens it further.
bool vtkShadowCasterEntry::SetCorners(const std::array<std::array<double, 3>, 4>& corners,
  const std::array<double, 16>& matrix, vtkShadowCasters::Body& body)
{
  for (std::size_t i = 0; i < 4; ++i)
  {
    body.Corners[i] = TransformPoint(matrix, corners[i].data());
  }
  double u[3];
  double v[3];
  vtkMath::Subtract(body.Corners[2].data(), body.Corners[0].data(), u);
  vtkMath::Subtract(body.Corners[3].data(), body.Corners[1].data(), v);
  vtkMath::Cross(u, v, body.Normal.data());
  const double extent = vtkMath::Dot(u, u) + vtkMath::Dot(v, v);
  body.Flat = vtkMath::Normalize(body.Normal.data()) > 1e-12 * extent;
  body.Offset = vtkMath::Dot(body.Normal.data(), body.Corners[0].data());
  return body.Flat;
}

//------------------------------------------------------------------------------
void vtkShadowCasterEntry::FindPlane()
{
  if (this->Geometry.IsFlat())
  {
    SetCorners(this->Geometry.GetCorners(), this->Matrix, this->Body);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterEntry::FindParts()
{
  this->Parts.clear();
  if (!this->HasBody)
  {
    return;
  }
  if (this->Strokes)
  {
    this->Parts.push_back(this->Body); // strokes may lie anywhere
    return;
  }
  for (const vtkShadowCasterClusters::Cluster& cluster : this->Geometry.GetClusters())
  {
    vtkShadowCasters::Body part = this->Body;
    part.Bounds = TransformBounds(this->Matrix, cluster.Bounds.data());
    for (std::size_t i = 0; i < 6; i += 2)
    {
      // The box of a turned box is larger than it need be, but nothing lies outside the whole.
      part.Bounds[i] = std::max(part.Bounds[i], this->Body.Bounds[i]);
      part.Bounds[i + 1] = std::min(part.Bounds[i + 1], this->Body.Bounds[i + 1]);
    }
    if (cluster.Flat)
    {
      SetCorners(cluster.Corners, this->Matrix, part);
    }
    this->Parts.push_back(part);
  }
  if (this->Parts.empty())
  {
    this->Parts.push_back(this->Body);
  }
}

//------------------------------------------------------------------------------
// What looks modified is often the same: colours, a prop set to where it was. Comparing costs less
// than baking.
vtkShadowCasterEntry::Change vtkShadowCasterEntry::Write(
  vtkShadowCasterBuffer& buffer, const std::vector<float>& scratch)
{
  Change change;
  const std::size_t vertices = this->Geometry.GetNumberOfVertices();
  const auto& indices = this->Geometry.GetIndices();
  const bool fits =
    this->Range.NumberOfVertices == vertices && this->Range.NumberOfIndices == indices.size();
  if (!fits)
  {
    buffer.Place(this->Range, vertices, indices.size());
  }
  if (!fits || (this->Reshaped && !buffer.HasIndices(this->Range, indices.data())))
  {
    buffer.SetIndices(this->Range, indices.data());
    change.Casters = true;
  }
  if (!fits ||
    std::memcmp(buffer.GetVertices(this->Range), scratch.data(), 3 * vertices * sizeof(float)) != 0)
  {
    buffer.SetVertices(this->Range, scratch.data());
    change.Casters = true;
  }
  this->Reshaped = false;
  return change;
}

VTK_ABI_NAMESPACE_END
