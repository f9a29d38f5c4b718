// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterBuffer
 * @brief   One vertex and one index buffer shared by all casters, and the draw calls from them.
 *
 * Every caster owns a range. A copy on the CPU lets a whole frame's changes go up in few calls.
 * Buffers grow and never shrink; the room of casters that left is reclaimed by Clear.
 */

#ifndef vtkShadowCasterBuffer_h
#define vtkShadowCasterBuffer_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For counts

#include <cstddef> // For sizes
#include <cstdint> // For indices
#include <vector>  // For the copies

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowCasterBuffer
{
public:
  struct Range
  {
    std::size_t FirstVertex = 0;
    std::size_t NumberOfVertices = 0;
    std::size_t VertexCapacity = 0;
    std::size_t FirstIndex = 0;
    std::size_t NumberOfIndices = 0;
    std::size_t IndexCapacity = 0;
  };

  /// Gives the range room for that many, at its old place if that is large enough.
  void Place(Range& range, std::size_t vertices, std::size_t indices);
  /// Gives the room back.
  void Free(Range& range);
  /// More than half of the buffer is room given back: time to Clear and to place everything anew.
  bool IsWasteful() const;
  /// Forgets all ranges; keeps memory and OpenGL objects.
  void Clear();

  ///@{
  /// Writes a range: 3 floats per vertex; indices counted from the range's first vertex.
  void SetVertices(const Range& range, const float* xyz);
  void SetIndices(const Range& range, const std::uint32_t* indices);
  const float* GetVertices(const Range& range) const;
  bool HasIndices(const Range& range, const std::uint32_t* indices) const;
  ///@}

  ///@{
  /**
   * Drawing: Begin, Add what is to be drawn (neighbours are joined), then Draw with a program in
   * use whose attribute at that location takes the vertices. Draw uploads what was written and
   * returns the number of OpenGL draw calls: one, or with several instances one per span.
   */
  void Begin();
  void Add(const Range& range);
  int Draw(unsigned int location, int instances = 1);
  ///@}

  /// Bytes of the OpenGL buffers.
  vtkTypeInt64 GetBytes() const;

  void ReleaseGraphicsResources();

private:
  struct Span
  {
    std::size_t Begin;
    std::size_t End;
  };

  bool Upload();
  static void Mark(std::vector<Span>& dirty, std::size_t begin, std::size_t end);
  template <typename Value>
  static bool UploadArray(unsigned int target, unsigned int handle,
    const std::vector<Value>& values, std::size_t& capacity, std::vector<Span>& dirty);

  std::vector<float> Vertices;        // 3 per vertex
  std::vector<std::uint32_t> Indices; // absolute
  std::size_t FreeIndices = 0;
  std::size_t FreeVertices = 0;
  std::vector<Span> DirtyVertices; // in floats
  std::vector<Span> DirtyIndices;

  std::vector<Span> Draws; // joined index spans
  std::vector<int> Counts;
  std::vector<const void*> Offsets;

  unsigned int VertexBuffer = 0;
  unsigned int IndexBuffer = 0;
  unsigned int VertexArray = 0;
  std::size_t VertexBufferSize = 0; // in elements
  std::size_t IndexBufferSize = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterBuffer.h
