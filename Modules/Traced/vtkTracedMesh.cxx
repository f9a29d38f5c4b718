// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedMesh.h"

#include "vtkMatrix4x4.h"
#include "vtkShadowCasterGeometry.h"
#include "vtkTracedDevice.h"
#include "vtkTracedEmbree.h"
#include "vtkTracedHits.h"
#include "vtkTracedSurface.h"

#include <algorithm>
#include <cstring>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTracedMesh::vtkTracedMesh(std::shared_ptr<vtkTracedDevice> device)
  : vtkTracedBody(std::move(device))
{
}

//------------------------------------------------------------------------------
vtkTracedMesh::~vtkTracedMesh() = default;

//------------------------------------------------------------------------------
void vtkTracedMesh::SetSurface(std::unique_ptr<const vtkTracedSurface> surface)
{
  this->Surface = std::move(surface);
}

//------------------------------------------------------------------------------
void vtkTracedMesh::Clear()
{
  this->ReleaseScene();
  this->Geometry = nullptr;
  this->Vertices = nullptr;
  this->Indices = nullptr;
  this->NumberOfVertices = this->NumberOfIndices = 0;
}

//------------------------------------------------------------------------------
bool vtkTracedMesh::IsSame(
  const std::uint32_t* indices, std::size_t vertices, std::size_t count) const
{
  return this->Scene && this->NumberOfVertices == vertices && this->NumberOfIndices == count &&
    std::memcmp(this->Indices, indices, count * sizeof(std::uint32_t)) == 0;
}

//------------------------------------------------------------------------------
void vtkTracedMesh::Allocate(std::size_t vertices, std::size_t indices)
{
  this->MakeScene();
  this->Geometry = rtcNewGeometry(this->Device->GetHandle(), RTC_GEOMETRY_TYPE_TRIANGLE);
  this->Vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
    this->Geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
  this->Indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(this->Geometry,
    RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), indices / 3));
  rtcSetGeometryOccludedFilterFunction(this->Geometry, vtkTracedHits::Judge);
  rtcSetGeometryUserData(this->Geometry, this);
  rtcAttachGeometry(this->Scene, this->Geometry);
  rtcReleaseGeometry(this->Geometry); // the scene keeps it
  this->NumberOfVertices = vertices;
  this->NumberOfIndices = indices;
}

//------------------------------------------------------------------------------
vtkTracedMesh::WorkType vtkTracedMesh::Take(
  const vtkShadowCasterGeometry& triangles, const double* matrix)
{
  const std::vector<std::uint32_t>& indices = triangles.GetIndices();
  const std::size_t vertices = triangles.GetNumberOfVertices();
  std::array<double, 16> identity;
  vtkMatrix4x4::Identity(identity.data());
  const double* transform = matrix ? matrix : identity.data();
  std::vector<float> points(3 * vertices);
  double bounds[6];
  const vtkTracedVector zero{};
  if (indices.empty() || !triangles.Transform(transform, zero.data(), points.data(), bounds))
  {
    this->Clear();
    return BUILT;
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
  }
  triangles.Transform(transform, this->Center.data(), points.data(), bounds);
  const bool refits = this->IsSame(indices.data(), vertices, indices.size());
  if (refits && std::memcmp(this->Vertices, points.data(), points.size() * sizeof(float)) == 0)
  {
    return KEPT;
  }
  if (!refits)
  {
    this->Allocate(vertices, indices.size());
  }
  if (!this->Vertices || !this->Indices)
  {
    this->Device->HasFailed();
    this->Clear();
    return BUILT;
  }
  std::copy(points.begin(), points.end(), this->Vertices);
  if (refits)
  {
    rtcSetGeometryBuildQuality(this->Geometry, RTC_BUILD_QUALITY_REFIT);
    rtcUpdateGeometryBuffer(this->Geometry, RTC_BUFFER_TYPE_VERTEX, 0);
  }
  else
  {
    std::copy(indices.begin(), indices.end(), this->Indices);
  }
  rtcCommitGeometry(this->Geometry);
  this->CommitScene();
  return refits ? REFITTED : BUILT;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTracedMesh::GetBytes() const
{
  // Embree's tree takes about as much again and half as much per triangle as its points and indices.
  constexpr vtkTypeInt64 treePerTriangle = 56;
  return static_cast<vtkTypeInt64>(12 * this->NumberOfVertices + 4 * this->NumberOfIndices) +
    treePerTriangle * static_cast<vtkTypeInt64>(this->NumberOfIndices / 3);
}
VTK_ABI_NAMESPACE_END
