// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterBuffer.h"

#include "vtkShadowFailures.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Spans closer than this are uploaded in one call: a call costs more than the copy.
constexpr std::size_t JOIN_DISTANCE = 4096;

bool MakeStore(unsigned int target, GLsizeiptr bytes)
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
  glBufferData(target, bytes, nullptr, GL_DYNAMIC_DRAW);
  if (glGetError() == GL_NO_ERROR)
  {
    return true;
  }
  vtkShadowFailures::Report(
    "no memory for the casters' points (" + std::to_string(bytes >> 20) + " MiB)");
  return false;
}
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::Place(Range& range, std::size_t vertices, std::size_t indices)
{
  if (vertices > range.VertexCapacity || indices > range.IndexCapacity)
  {
    this->Free(range);
    range.FirstVertex = this->Vertices.size() / 3;
    range.VertexCapacity = vertices;
    range.FirstIndex = this->Indices.size();
    range.IndexCapacity = indices;
    this->Vertices.resize(this->Vertices.size() + 3 * vertices);
    this->Indices.resize(this->Indices.size() + indices);
  }
  range.NumberOfVertices = vertices;
  range.NumberOfIndices = indices;
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::Free(Range& range)
{
  this->FreeVertices += range.VertexCapacity;
  this->FreeIndices += range.IndexCapacity;
  range = Range();
}

//------------------------------------------------------------------------------
bool vtkShadowCasterBuffer::IsWasteful() const
{
  return 2 * this->FreeIndices > this->Indices.size() ||
    6 * this->FreeVertices > this->Vertices.size();
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::Clear()
{
  this->Vertices.clear();
  this->Indices.clear();
  this->FreeVertices = 0;
  this->FreeIndices = 0;
  this->DirtyVertices.clear();
  this->DirtyIndices.clear();
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::SetVertices(const Range& range, const float* xyz)
{
  const std::size_t first = 3 * range.FirstVertex;
  std::copy_n(xyz, 3 * range.NumberOfVertices, this->Vertices.data() + first);
  vtkShadowCasterBuffer::Mark(this->DirtyVertices, first, first + 3 * range.NumberOfVertices);
}

//------------------------------------------------------------------------------
const float* vtkShadowCasterBuffer::GetVertices(const Range& range) const
{
  return this->Vertices.data() + 3 * range.FirstVertex;
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::SetIndices(const Range& range, const std::uint32_t* indices)
{
  const auto base = static_cast<std::uint32_t>(range.FirstVertex);
  std::transform(indices, indices + range.NumberOfIndices, this->Indices.data() + range.FirstIndex,
    [base](std::uint32_t index) { return base + index; });
  vtkShadowCasterBuffer::Mark(
    this->DirtyIndices, range.FirstIndex, range.FirstIndex + range.NumberOfIndices);
}

//------------------------------------------------------------------------------
bool vtkShadowCasterBuffer::HasIndices(const Range& range, const std::uint32_t* indices) const
{
  const auto base = static_cast<std::uint32_t>(range.FirstVertex);
  return std::equal(indices, indices + range.NumberOfIndices,
    this->Indices.data() + range.FirstIndex,
    [base](std::uint32_t own, std::uint32_t held) { return base + own == held; });
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::Mark(std::vector<Span>& dirty, std::size_t begin, std::size_t end)
{
  if (!dirty.empty() && begin >= dirty.back().Begin && begin <= dirty.back().End + JOIN_DISTANCE)
  {
    dirty.back().End = std::max(dirty.back().End, end);
  }
  else if (end > begin)
  {
    dirty.push_back({ begin, end });
  }
}

//------------------------------------------------------------------------------
template <typename Value>
bool vtkShadowCasterBuffer::UploadArray(unsigned int target, unsigned int handle,
  const std::vector<Value>& values, std::size_t& capacity, std::vector<Span>& dirty)
{
  if (dirty.empty())
  {
    return true;
  }
  glBindBuffer(target, handle);
  std::size_t changed = 0;
  for (const Span& span : dirty)
  {
    changed += span.End - span.Begin;
  }
  const bool grows = values.size() > capacity;
  if (grows)
  {
    capacity = values.size() + values.size() / 4;
  }
  if (grows || 2 * changed > values.size())
  {
    // A new store, so that the driver need not wait for draws from the old one.
    if (!MakeStore(target, static_cast<GLsizeiptr>(capacity * sizeof(Value))))
    {
      capacity = 0;
      return false;
    }
    dirty.assign(1, { 0, values.size() });
  }
  for (const Span& span : dirty)
  {
    glBufferSubData(target, static_cast<GLintptr>(span.Begin * sizeof(Value)),
      static_cast<GLsizeiptr>((span.End - span.Begin) * sizeof(Value)), values.data() + span.Begin);
  }
  dirty.clear();
  return true;
}

//------------------------------------------------------------------------------
// Expects the vertex array object to be bound: the index buffer's binding is part of it.
bool vtkShadowCasterBuffer::Upload()
{
  return UploadArray(GL_ARRAY_BUFFER, this->VertexBuffer, this->Vertices, this->VertexBufferSize,
           this->DirtyVertices) &&
    UploadArray(GL_ELEMENT_ARRAY_BUFFER, this->IndexBuffer, this->Indices, this->IndexBufferSize,
      this->DirtyIndices);
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::Begin()
{
  this->Draws.clear();
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::Add(const Range& range)
{
  if (range.NumberOfIndices == 0)
  {
    return;
  }
  const std::size_t end = range.FirstIndex + range.NumberOfIndices;
  if (!this->Draws.empty() && this->Draws.back().End == range.FirstIndex)
  {
    this->Draws.back().End = end;
  }
  else
  {
    this->Draws.push_back({ range.FirstIndex, end });
  }
}

//------------------------------------------------------------------------------
int vtkShadowCasterBuffer::Draw(unsigned int location, int instances)
{
  if (this->Draws.empty())
  {
    return 0;
  }
  GLint boundArray = 0;
  GLint boundBuffer = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &boundArray);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &boundBuffer);
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(1, &this->VertexBuffer);
    glGenBuffers(1, &this->IndexBuffer);
    glBindVertexArray(this->VertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, this->VertexBuffer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->IndexBuffer);
  }
  glBindVertexArray(this->VertexArray);
  if (!this->Upload())
  {
    glBindVertexArray(static_cast<GLuint>(boundArray));
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(boundBuffer));
    return 0;
  }
  glBindBuffer(GL_ARRAY_BUFFER, this->VertexBuffer);
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);

  this->Counts.clear();
  this->Offsets.clear();
  for (const Span& draw : this->Draws)
  {
    this->Counts.push_back(static_cast<int>(draw.End - draw.Begin));
    this->Offsets.push_back(reinterpret_cast<const void*>(draw.Begin * sizeof(std::uint32_t)));
  }
  int calls = 1;
  if (instances == 1)
  {
    glMultiDrawElements(GL_TRIANGLES, this->Counts.data(), GL_UNSIGNED_INT, this->Offsets.data(),
      static_cast<GLsizei>(this->Counts.size()));
  }
  else
  {
    for (std::size_t i = 0; i < this->Counts.size(); ++i)
    {
      glDrawElementsInstanced(
        GL_TRIANGLES, this->Counts[i], GL_UNSIGNED_INT, this->Offsets[i], instances);
    }
    calls = static_cast<int>(this->Counts.size());
  }
  glDisableVertexAttribArray(location);
  glBindVertexArray(static_cast<GLuint>(boundArray));
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(boundBuffer));
  return calls;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowCasterBuffer::GetBytes() const
{
  return static_cast<vtkTypeInt64>(
    this->VertexBufferSize * sizeof(float) + this->IndexBufferSize * sizeof(std::uint32_t));
}

//------------------------------------------------------------------------------
void vtkShadowCasterBuffer::ReleaseGraphicsResources()
{
  if (this->VertexArray != 0)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(1, &this->VertexBuffer);
    glDeleteBuffers(1, &this->IndexBuffer);
  }
  this->VertexArray = 0;
  this->VertexBuffer = 0;
  this->IndexBuffer = 0;
  this->VertexBufferSize = 0;
  this->IndexBufferSize = 0;
  // What is held has to go up again if there is another window.
  this->DirtyVertices.assign(1, { 0, this->Vertices.size() });
  this->DirtyIndices.assign(1, { 0, this->Indices.size() });
}

VTK_ABI_NAMESPACE_END
