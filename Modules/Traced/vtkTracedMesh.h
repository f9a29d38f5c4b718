// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedMesh
 * @brief   The triangles of one caster in a scene of Embree's of their own.
 *
 * Coordinates are model coordinates relative to the middle of the model (subtracted in double), so that
 * a rigid motion changes nothing here.
 */

#ifndef vtkTracedMesh_h
#define vtkTracedMesh_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedBody.h"

#include <cstdint> // For indices
#include <memory>  // For the surface

struct RTCGeometryTy;

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowCasterGeometry;
class vtkTracedSurface;

class vtkTracedMesh : public vtkTracedBody
{
public:
  explicit vtkTracedMesh(std::shared_ptr<vtkTracedDevice> device);
  ~vtkTracedMesh() override;

  enum WorkType
  {
    KEPT,
    /// The same triangles, their points elsewhere: Embree's tree is fitted to them.
    REFITTED,
    BUILT
  };

  /**
   * Takes triangles in place of what was held; vtkShadowFailures is told if Embree has not the memory.
   * matrix: row-major, to be applied to the points before; null for none.
   */
  WorkType Take(const vtkShadowCasterGeometry& triangles, const double* matrix);

  /// What of the triangles is there; null, the default, for all of them.
  void SetSurface(std::unique_ptr<const vtkTracedSurface> surface);
  const vtkTracedSurface* GetSurface() const { return this->Surface.get(); }

  ///@{
  /// Corners of a triangle, and their numbers.
  const std::uint32_t* GetCorners(unsigned int index) const
  {
    return this->Indices + 3 * static_cast<std::size_t>(index);
  }
  std::array<vtkTracedVector, 3> GetTriangle(unsigned int index) const
  {
    std::array<vtkTracedVector, 3> corners;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const float* p = this->Vertices + 3 * static_cast<std::size_t>(this->GetCorners(index)[i]);
      corners[i] = { { p[0], p[1], p[2] } };
    }
    return corners;
  }
  ///@}

  vtkTypeInt64 GetBytes() const override;

private:
  void Clear();
  bool IsSame(const std::uint32_t* indices, std::size_t vertices, std::size_t count) const;
  void Allocate(std::size_t vertices, std::size_t indices);

  RTCGeometryTy* Geometry = nullptr;
  float* Vertices = nullptr; // Embree's
  std::uint32_t* Indices = nullptr;
  std::size_t NumberOfVertices = 0;
  std::size_t NumberOfIndices = 0;
  std::unique_ptr<const vtkTracedSurface> Surface;
};

VTK_ABI_NAMESPACE_END
#endif
