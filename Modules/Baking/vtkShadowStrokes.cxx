// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowStrokes.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShadowStrokeProgram.h"
#include "vtkSmartPointer.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// What a property makes of cells, as VTK's own mapper does.
struct Drawing
{
  explicit Drawing(vtkProperty* property)
    : Dots(property->GetRepresentation() == VTK_POINTS)
    , Wires(property->GetRepresentation() == VTK_WIREFRAME)
    , Vertices(property->GetRepresentation() == VTK_SURFACE && property->GetEdgeVisibility() &&
        property->GetVertexVisibility())
  {
  }
  bool Dots;     // of every cell only its points
  bool Wires;    // of polygons only their edges
  bool Vertices; // of polygons their points too
};

bool HasFaces(vtkPolyData* piece)
{
  return piece->GetNumberOfPolys() > 0 || piece->GetNumberOfStrips() > 0;
}

template <typename Functor>
void ForEachCell(vtkCellArray* cells, vtkIdType numberOfPoints, Functor&& functor)
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
    if (std::all_of(ids, ids + size, [=](vtkIdType id) { return id >= 0 && id < numberOfPoints; }))
    {
      functor(size, ids);
    }
  }
}
}

//------------------------------------------------------------------------------
bool vtkShadowStrokes::AreWide(const std::vector<vtkPolyData*>& pieces, vtkProperty* property)
{
  const Drawing drawing(property);
  const bool wideDots = property->GetPointSize() > 1.0f;
  const bool wideLines = property->GetLineWidth() > 1.0f && !drawing.Dots;
  return std::any_of(pieces.begin(), pieces.end(),
    [&](vtkPolyData* piece)
    {
      const bool faces = HasFaces(piece);
      const bool lines = piece->GetNumberOfLines() > 0;
      const bool dots = piece->GetNumberOfVerts() > 0 || (drawing.Dots && (lines || faces)) ||
        (drawing.Vertices && faces);
      return (wideDots && dots) || (wideLines && (lines || (drawing.Wires && faces)));
    });
}

//------------------------------------------------------------------------------
void vtkShadowStrokes::Build(const std::vector<vtkPolyData*>& pieces, vtkProperty* property)
{
  const Drawing drawing(property);
  this->PointSize = property->GetPointSize();
  this->LineWidth = property->GetLineWidth();
  this->Spheres = property->GetRenderPointsAsSpheres();
  this->Tubes = property->GetRenderLinesAsTubes() && this->LineWidth > 1.0;
  this->Ends.clear();
  std::vector<char> isDone;
  for (vtkPolyData* piece : pieces)
  {
    vtkPoints* points = piece->GetPoints();
    isDone.assign(static_cast<std::size_t>(piece->GetNumberOfPoints()), 0);
    this->AddDots(points, piece->GetVerts(), isDone);
    if (drawing.Dots)
    {
      this->AddDots(points, piece->GetLines(), isDone);
    }
    if (drawing.Dots || drawing.Vertices)
    {
      this->AddDots(points, piece->GetPolys(), isDone);
      this->AddDots(points, piece->GetStrips(), isDone);
    }
  }
  this->NumberOfDots = static_cast<int>(this->Ends.size() / 6);
  for (vtkPolyData* piece : pieces)
  {
    vtkPoints* points = piece->GetPoints();
    if (!drawing.Dots)
    {
      this->AddLines(points, piece->GetLines(), false, false);
    }
    if (drawing.Wires)
    {
      this->AddLines(points, piece->GetPolys(), true, false);
      this->AddLines(points, piece->GetStrips(), false, true);
    }
  }
  this->NumberOfLines = static_cast<int>(this->Ends.size() / 6) - this->NumberOfDots;
}

//------------------------------------------------------------------------------
void vtkShadowStrokes::AddStroke(vtkPoints* points, vtkIdType a, vtkIdType b)
{
  double ends[6];
  points->GetPoint(a, ends);
  points->GetPoint(b, ends + 3);
  if (std::all_of(ends, ends + 6, [](double c) { return std::isfinite(c); }))
  {
    this->Ends.insert(this->Ends.end(), ends, ends + 6);
  }
}

//------------------------------------------------------------------------------
void vtkShadowStrokes::AddDots(vtkPoints* points, vtkCellArray* cells, std::vector<char>& isDone)
{
  ForEachCell(cells, static_cast<vtkIdType>(isDone.size()),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        char& done = isDone[static_cast<std::size_t>(ids[i])];
        if (!done)
        {
          done = 1;
          this->AddStroke(points, ids[i], ids[i]);
        }
      }
    });
}

//------------------------------------------------------------------------------
void vtkShadowStrokes::AddLines(vtkPoints* points, vtkCellArray* cells, bool closed, bool strips)
{
  ForEachCell(cells, points ? points->GetNumberOfPoints() : 0,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i + 1 < size; ++i)
      {
        this->AddStroke(points, ids[i], ids[i + 1]);
        if (strips && i + 2 < size)
        {
          this->AddStroke(points, ids[i], ids[i + 2]);
        }
      }
      if (closed && size > 2)
      {
        this->AddStroke(points, ids[size - 1], ids[0]);
      }
    });
}

//------------------------------------------------------------------------------
bool vtkShadowStrokes::Place(const std::array<double, 16>& m)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  this->IsUploaded = false;
  this->Bounds = { { infinity, -infinity, infinity, -infinity, infinity, -infinity } };
  const auto transform = [&m](const double* p, double* q)
  {
    for (int i = 0; i < 3; ++i)
    {
      q[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
    }
  };
  double q[3];
  for (std::size_t k = 0; k < this->Ends.size(); k += 3)
  {
    transform(&this->Ends[k], q);
    for (int i = 0; i < 3; ++i)
    {
      this->Bounds[2 * i] = std::min(this->Bounds[2 * i], q[i]);
      this->Bounds[2 * i + 1] = std::max(this->Bounds[2 * i + 1], q[i]);
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Center[i] = 0.5 * (this->Bounds[2 * i] + this->Bounds[2 * i + 1]);
  }
  if (!std::isfinite(this->Center[0] + this->Center[1] + this->Center[2]))
  {
    return false; // also if there is nothing
  }
  this->Local.resize(this->Ends.size());
  for (std::size_t k = 0; k < this->Ends.size(); k += 3)
  {
    transform(&this->Ends[k], q);
    for (int i = 0; i < 3; ++i)
    {
      this->Local[k + i] = static_cast<float>(q[i] - this->Center[i]);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::array<double, 6> vtkShadowStrokes::FindBounds(const vtkShadowScreen& screen) const
{
  const double pixels = std::max(this->NumberOfDots > 0 ? this->PointSize : 0.0,
    this->NumberOfLines > 0 ? this->LineWidth : 0.0);
  const double reach = 0.5 * pixels * screen.FindLargest(this->Bounds);
  std::array<double, 6> bounds = this->Bounds;
  for (int i = 0; i < 6; ++i)
  {
    bounds[i] += i % 2 == 0 ? -reach : reach;
  }
  return bounds;
}

//------------------------------------------------------------------------------
void vtkShadowStrokes::Upload(unsigned int location)
{
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(1, &this->VertexBuffer);
  }
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->VertexBuffer);
  if (!this->IsUploaded)
  {
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->Local.size() * sizeof(float)),
      this->Local.data(), GL_STATIC_DRAW);
    this->IsUploaded = true;
  }
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

//------------------------------------------------------------------------------
int vtkShadowStrokes::Draw(vtkShadowStrokeProgram& program, const vtkShadowScreen& screen)
{
  GLint boundArray = 0;
  GLint boundBuffer = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &boundArray);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &boundBuffer);
  this->Upload(program.GetLocation());
  program.SetPlace(this->Center, screen);
  int calls = 0;
  if (this->NumberOfDots > 0)
  {
    program.SetKind(true, this->Spheres, this->PointSize);
    glDrawArrays(GL_LINES, 0, 2 * this->NumberOfDots);
    ++calls;
  }
  if (this->NumberOfLines > 0)
  {
    program.SetKind(false, this->Tubes, this->LineWidth);
    glDrawArrays(GL_LINES, 2 * this->NumberOfDots, 2 * this->NumberOfLines);
    ++calls;
  }
  glBindVertexArray(static_cast<GLuint>(boundArray));
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(boundBuffer));
  return calls;
}

//------------------------------------------------------------------------------
void vtkShadowStrokes::ReleaseGraphicsResources()
{
  if (this->VertexArray != 0)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(1, &this->VertexBuffer);
    this->VertexArray = 0;
    this->VertexBuffer = 0;
  }
  this->IsUploaded = false;
}

VTK_ABI_NAMESPACE_END
