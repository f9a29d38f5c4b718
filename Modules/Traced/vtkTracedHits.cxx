// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedHits.h"

#include "vtkTracedMesh.h"
#include "vtkTracedRounds.h"
#include "vtkTracedScene.h"
#include "vtkTracedSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

bool IsOwnPlane(const vtkTracedMesh& mesh, unsigned int triangle, const vtkTracedMap& toLocal,
  const vtkTracedHits& hits, unsigned int ray)
{
  const std::array<vtkTracedVector, 3> corners = mesh.GetTriangle(triangle);
  const vtkTracedVector normal =
    vtkTraced::Cross(toLocal.Turn(corners[1] - corners[0]), toLocal.Turn(corners[2] - corners[0]));
  const double length = vtkTraced::Length(normal);
  const double distance =
    std::abs(vtkTraced::Dot(normal, hits.Receivers[ray] - toLocal(corners[0])));
  if (distance <= hits.Tolerances[ray] * length)
  {
    return true;
  }
  double farthest = 0.0;
  for (const vtkTracedVector& corner : corners)
  {
    farthest = std::max(farthest, vtkTraced::Length(toLocal(corner) - hits.Eye));
  }
  return distance <= vtkTracedHits::GetRounding(farthest) * length;
}

bool IsHole(const vtkTracedMesh& mesh, const RTCFilterFunctionNArguments* arguments, unsigned int i,
  const vtkTracedMap& toLocal, const vtkTracedScene& scene)
{
  const unsigned int triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
  const double u = RTCHitN_u(arguments->hit, arguments->N, i);
  const double v = RTCHitN_v(arguments->hit, arguments->N, i);
  const std::array<vtkTracedVector, 3> corners = mesh.GetTriangle(triangle);
  const vtkTracedVector place = (1.0 - u - v) * corners[0] + u * corners[1] + v * corners[2];
  return !mesh.GetSurface()->IsThere(
    scene.ToWorld(toLocal(place)), mesh.GetCorners(triangle), u, v);
}

} // namespace

//------------------------------------------------------------------------------
void vtkTracedHits::Judge(const RTCFilterFunctionNArguments* arguments)
{
  auto& hits = *reinterpret_cast<vtkTracedHits*>(arguments->context);
  const auto& mesh = *static_cast<const vtkTracedMesh*>(arguments->geometryUserPtr);
  for (unsigned int i = 0; i < arguments->N; ++i)
  {
    if (!arguments->valid[i])
    {
      continue;
    }
    const unsigned int ray = RTCRayN_id(arguments->ray, arguments->N, i);
    const unsigned int triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
    const unsigned int instance = RTCHitN_instID(arguments->hit, arguments->N, i, 0);
    const vtkTracedMap& toLocal = hits.Scene->GetToLocal(instance);
    if (IsOwnPlane(mesh, triangle, toLocal, hits, ray) ||
      (mesh.GetSurface() && IsHole(mesh, arguments, i, toLocal, *hits.Scene)))
    {
      arguments->valid[i] = 0;
    }
    else
    {
      hits.Distances[ray] = RTCRayN_tfar(arguments->ray, arguments->N, i);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTracedHits::JudgeRounds(const RTCOccludedFunctionNArguments* arguments)
{
  auto& hits = *reinterpret_cast<vtkTracedHits*>(arguments->context);
  const auto& rounds = *static_cast<const vtkTracedRounds*>(arguments->geometryUserPtr);
  const vtkTracedRounds::Round& round = rounds.GetRound(arguments->primID);
  for (unsigned int i = 0; i < arguments->N; ++i)
  {
    if (!arguments->valid[i])
    {
      continue;
    }
    RTCRayN* rays = arguments->ray;
    const unsigned int n = arguments->N;
    const unsigned int ray = RTCRayN_id(rays, n, i);
    const vtkTracedVector start{ { RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i),
      RTCRayN_org_z(rays, n, i) } };
    const vtkTracedVector way{ { RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i),
      RTCRayN_dir_z(rays, n, i) } };
    if (vtkTracedRounds::IsLeft(round, start, way))
    {
      continue;
    }
    const double hit = vtkTracedRounds::FindHit(round, start, way, RTCRayN_tfar(rays, n, i));
    if (hit > 0.0)
    {
      hits.Distances[ray] = static_cast<float>(hit);
      RTCRayN_tfar(rays, n, i) = -std::numeric_limits<float>::infinity();
    }
  }
}
VTK_ABI_NAMESPACE_END
