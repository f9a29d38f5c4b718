// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedImposters.h"

#include "vtkDataArray.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShadowImposters.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Round = vtkTracedRounds::Round;

vtkDataArray* FindArray(vtkPolyData* data, const char* name)
{
  return name ? data->GetPointData()->GetArray(name) : nullptr;
}

void AddSpheres(vtkOpenGLSphereMapper* mapper, vtkPolyData* data, const vtkTracedVector& center,
  std::vector<Round>& rounds)
{
  vtkDataArray* radii = FindArray(data, vtkShadowSphereImposters::Radii(mapper));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Round round;
    vtkTracedVector place;
    data->GetPoint(i, place.data());
    round.Ends[0] = round.Ends[1] = place - center;
    round.Radii[0] = round.Radii[1] = radii ? radii->GetComponent(i, 0) : mapper->GetRadius();
    rounds.push_back(round);
  }
}

bool AddSticks(vtkOpenGLStickMapper* mapper, vtkPolyData* data, const vtkTracedVector& center,
  std::vector<Round>& rounds)
{
  vtkDataArray* sizes = FindArray(data, vtkShadowStickImposters::Sizes(mapper)); // length, radius
  vtkDataArray* axes = FindArray(data, vtkShadowStickImposters::Axes(mapper));
  if (!sizes || sizes->GetNumberOfComponents() < 2 || !axes || axes->GetNumberOfComponents() < 3)
  {
    return false;
  }
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Round round;
    round.Kind = vtkTracedRounds::TUBE;
    vtkTracedVector place;
    data->GetPoint(i, place.data());
    vtkTracedVector axis{ { axes->GetComponent(i, 0), axes->GetComponent(i, 1),
      axes->GetComponent(i, 2) } };
    axis = 0.5 * sizes->GetComponent(i, 0) * axis;
    round.Ends = { { place - center - axis, place - center + axis } };
    round.Radii[0] = round.Radii[1] = sizes->GetComponent(i, 1);
    rounds.push_back(round);
  }
  return true;
}

bool IsFinite(const Round& round)
{
  double sum = round.Radii[0] + round.Radii[1];
  for (const vtkTracedVector& end : round.Ends)
  {
    sum += end[0] + end[1] + end[2];
  }
  return std::isfinite(sum);
}

} // namespace

//------------------------------------------------------------------------------
bool vtkTracedImposters::Find(
  vtkMapper* mapper, std::vector<Round>& rounds, vtkTracedVector& center)
{
  auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(mapper);
  auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper);
  auto* data =
    spheres || sticks ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return false;
  }
  double bounds[6];
  data->GetPoints()->GetBounds(bounds);
  center = { { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) } };
  if (spheres)
  {
    AddSpheres(spheres, data, center, rounds);
  }
  else if (!AddSticks(sticks, data, center, rounds))
  {
    return false;
  }
  rounds.erase(std::remove_if(
                 rounds.begin(), rounds.end(), [](const Round& round) { return !IsFinite(round); }),
    rounds.end());
  return true;
}
VTK_ABI_NAMESPACE_END
