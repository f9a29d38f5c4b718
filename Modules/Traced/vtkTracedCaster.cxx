// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedCaster.h"

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkShadowStrokes.h"
#include "vtkTracedDevice.h"
#include "vtkTracedGlyphs.h"
#include "vtkTracedImposters.h"
#include "vtkTracedMesh.h"
#include "vtkTracedSurface.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// Embree inverts an instance's matrix in single precision: one that flattens its model cannot be had.
bool IsInvertible(const std::array<double, 16>& matrix)
{
  constexpr double flattest = 1e-4;
  const vtkTracedMap map = vtkTraced::MapOf(matrix);
  double longest = 0.0;
  for (const vtkTracedVector& column : map.Columns)
  {
    longest = std::max(longest, vtkTraced::Length(column));
  }
  const double volume =
    vtkTraced::Dot(map.Columns[0], vtkTraced::Cross(map.Columns[1], map.Columns[2]));
  return std::abs(volume) > flattest * longest * longest * longest;
}

bool HasReplacedShader(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
    shaders->HasFragmentShaderCode() || shaders->HasGeometryShaderCode();
}

// Half of what a number of pixels is at a place in the world.
double RadiusAt(const vtkShadowScreen& screen, const vtkTracedVector& place, double pixels)
{
  const std::array<double, 4>& p = screen.Plane;
  return 0.5 * pixels *
    std::max(p[0] * place[0] + p[1] * place[1] + p[2] * place[2] + p[3], screen.Least);
}

} // namespace

//------------------------------------------------------------------------------
vtkTracedCaster::vtkTracedCaster(std::shared_ptr<vtkTracedDevice> device)
  : Device(std::move(device))
{
}

//------------------------------------------------------------------------------
vtkTracedCaster::~vtkTracedCaster() = default;

//------------------------------------------------------------------------------
vtkTracedCaster::Work vtkTracedCaster::Update(const vtkShadowCasterShape& shape)
{
  Work work;
  const bool moved = this->Matrix != shape.Matrix;
  const bool bakes = !IsInvertible(shape.Matrix);
  if (this->Time != shape.Time || bakes != this->IsBaked ||
    (moved && (this->IsBaked || this->IsFixed)))
  {
    this->Time = shape.Time;
    this->IsBaked = bakes;
    this->Build(shape, work);
  }
  work.Moved = moved || work.Built + work.Refitted > 0;
  if (work.Moved)
  {
    this->Matrix = shape.Matrix;
    this->Place(shape);
  }
  return work;
}

//------------------------------------------------------------------------------
void vtkTracedCaster::Build(const vtkShadowCasterShape& shape, Work& work)
{
  this->Glyphs.clear();
  this->Sources.clear();
  this->Reason.clear();
  this->IsFixed = shape.Strokes != nullptr;
  auto* actor = vtkActor::SafeDownCast(shape.Prop);
  const bool isReplaced = actor && HasReplacedShader(actor);
  const bool isKnown = shape.IsPlain || !shape.Pieces.empty();
  const bool hasFaces = actor && actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
  if (shape.Triangles->GetNumberOfVertices() > 0 && !isReplaced)
  {
    this->BuildTriangles(shape, *shape.Triangles, work);
  }
  else if (!shape.IsPlain && isKnown && hasFaces)
  {
    // Beside thin lines and points, which no map could be fitted to.
    vtkShadowCasterGeometry faces;
    faces.Build(shape.Pieces);
    this->BuildTriangles(shape, faces, work);
  }
  else
  {
    work.Built += this->Mesh ? 1 : 0;
    this->Mesh.reset();
  }
  if (shape.Strokes)
  {
    this->BuildStrokes(shape, work);
    return;
  }
  work.Built += this->Rounds ? 1 : 0;
  this->Rounds.reset();
  if (isReplaced)
  {
    this->Reason = "its shader is replaced";
    work.Built += 1;
  }
  else if (!isKnown)
  {
    this->BuildFromMapper(shape, work);
  }
}

//------------------------------------------------------------------------------
void vtkTracedCaster::BuildTriangles(
  const vtkShadowCasterShape& shape, const vtkShadowCasterGeometry& triangles, Work& work)
{
  if (!this->Mesh)
  {
    this->Mesh = std::make_shared<vtkTracedMesh>(this->Device);
  }
  const vtkTracedMesh::WorkType done =
    this->Mesh->Take(triangles, this->IsBaked ? shape.Matrix.data() : nullptr);
  auto* actor = vtkActor::SafeDownCast(shape.Prop);
  this->Mesh->SetSurface(
    shape.IsPlain || !actor ? nullptr : vtkTracedSurface::Of(actor, triangles));
  // Another surface is another body, too.
  work.Built += done == vtkTracedMesh::BUILT || !shape.IsPlain ? 1 : 0;
  work.Refitted += done == vtkTracedMesh::REFITTED ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkTracedCaster::TakeRounds(
  std::vector<vtkTracedRounds::Round> rounds, const vtkTracedVector& center, Work& work)
{
  if (!this->Rounds)
  {
    this->Rounds = std::make_shared<vtkTracedRounds>(this->Device);
  }
  this->Rounds->Take(std::move(rounds), center);
  ++work.Built;
}

//------------------------------------------------------------------------------
void vtkTracedCaster::BuildStrokes(const vtkShadowCasterShape& shape, Work& work)
{
  const vtkShadowStrokes& strokes = *shape.Strokes;
  const std::vector<float>& ends = strokes.GetEnds();
  std::vector<vtkTracedRounds::Round> rounds(ends.size() / 6);
  for (std::size_t i = 0; i < rounds.size(); ++i)
  {
    vtkTracedRounds::Round& round = rounds[i];
    const bool isDot = i < static_cast<std::size_t>(strokes.GetNumberOfDots());
    round.Kind = isDot ? (strokes.HasSpheres() ? vtkTracedRounds::SPHERE : vtkTracedRounds::SQUARE)
                       : (strokes.HasTubes() ? vtkTracedRounds::TUBE : vtkTracedRounds::BAND);
    for (std::size_t end = 0; end < 2; ++end)
    {
      const float* p = ends.data() + 6 * i + 3 * end;
      round.Ends[end] = { { p[0], p[1], p[2] } };
      round.Radii[end] = RadiusAt(shape.Screen, strokes.GetCenter() + round.Ends[end],
        isDot ? strokes.GetPointSize() : strokes.GetLineWidth());
    }
  }
  this->TakeRounds(std::move(rounds), strokes.GetCenter(), work);
}

//------------------------------------------------------------------------------
void vtkTracedCaster::BuildFromMapper(const vtkShadowCasterShape& shape, Work& work)
{
  auto* actor = vtkActor::SafeDownCast(shape.Prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  const std::string name = mapper ? mapper->GetClassName() : shape.Prop->GetClassName();
  std::vector<vtkTracedRounds::Round> rounds;
  vtkTracedVector center{};
  ++work.Built;
  if (vtkTracedImposters::Find(mapper, rounds, center))
  {
    this->TakeRounds(std::move(rounds), center, work);
  }
  else if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    if (!vtkTracedGlyphs::Find(glyphs, this->Device, this->Sources, this->Glyphs))
    {
      this->Reason = "its glyphs are of a kind that is not known";
    }
  }
  else
  {
    this->Reason = "only " + name + " knows what it draws";
  }
}

//------------------------------------------------------------------------------
void vtkTracedCaster::Place(const vtkShadowCasterShape& shape)
{
  this->Placements.clear();
  const vtkTracedMap toWorld = vtkTraced::MapOf(shape.Matrix);
  const auto add = [this](const std::shared_ptr<const vtkTracedBody>& body, vtkTracedMap map)
  {
    if (body && body->GetScene())
    {
      // The middle of the body is moved in double: what is large cancels.
      map.Offset = map(body->GetCenter());
      this->Placements.push_back({ body, map });
    }
  };
  add(this->Mesh, this->IsBaked ? vtkTracedMap() : toWorld);
  add(this->Rounds, this->IsFixed ? vtkTracedMap() : toWorld);
  for (const vtkTracedPlacement& glyph : this->Glyphs)
  {
    vtkTracedMap map;
    for (int i = 0; i < 3; ++i)
    {
      map.Columns[i] = toWorld.Turn(glyph.ToWorld.Columns[i]);
    }
    map.Offset = toWorld(glyph.ToWorld.Offset);
    add(glyph.Body, map);
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTracedCaster::GetBytes() const
{
  vtkTypeInt64 bytes = this->Mesh ? this->Mesh->GetBytes() : 0;
  bytes += this->Rounds ? this->Rounds->GetBytes() : 0;
  for (const auto& source : this->Sources)
  {
    bytes += source->GetBytes();
  }
  return bytes;
}
VTK_ABI_NAMESPACE_END
