// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedScene.h"

#include "vtkShadowCasterShape.h"
#include "vtkShadowCasters.h"
#include "vtkTracedDevice.h"
#include "vtkTracedEmbree.h"

#include <algorithm>
#include <array>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkTracedScene::~vtkTracedScene()
{
  this->Clear();
}

//------------------------------------------------------------------------------
void vtkTracedScene::Clear()
{
  this->Entries.clear();
  this->ToLocals.clear();
  this->FreeNumbers.clear();
  this->Boxes.clear();
  this->Reasons.clear();
  if (this->Handle)
  {
    rtcReleaseScene(this->Handle);
    this->Handle = nullptr;
  }
  this->Device.reset();
  this->CastersTime = 0;
}

//------------------------------------------------------------------------------
bool vtkTracedScene::Begin()
{
  if (!this->Handle)
  {
    this->Device = vtkTracedDevice::Get();
    if (!this->Device)
    {
      return false;
    }
    this->Handle = rtcNewScene(this->Device->GetHandle());
    rtcSetSceneFlags(this->Handle, RTC_SCENE_FLAG_ROBUST);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkTracedScene::FindFrame(vtkShadowCasters* casters)
{
  double squares = 0.0;
  const vtkTracedVector& origin = casters->GetOrigin();
  for (const vtkShadowCasters::Body& body : casters->GetBodies())
  {
    double distance = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double reach =
        std::max(origin[i] - body.Bounds[2 * i], body.Bounds[2 * i + 1] - origin[i]);
      distance += reach * reach;
    }
    squares = std::max(squares, distance);
  }
  const double scale = squares > 0.0 ? std::exp2(-std::round(0.5 * std::log2(squares))) : 1.0;
  const double change = scale / this->Scale;
  if (origin == this->Origin && change > 0.2 && change < 5.0)
  {
    return false; // it only has to be of about that size
  }
  this->Origin = origin;
  this->Scale = scale;
  return true;
}

//------------------------------------------------------------------------------
bool vtkTracedScene::Update(vtkShadowCasters* casters)
{
  if (this->Handle && this->CastersTime == casters->GetCastersTime())
  {
    return true;
  }
  if (!this->Begin())
  {
    return false;
  }
  const bool framed = this->FindFrame(casters);
  if (this->UpdateEntries(casters, framed) || this->CastersTime == 0)
  {
    rtcCommitScene(this->Handle);
    this->FindBoxes();
    ++this->Work.ScenesBuilt;
  }
  if (this->Device->HasFailed())
  {
    this->Clear();
    return false;
  }
  this->FindReasons();
  this->CastersTime = casters->GetCastersTime();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTracedScene::UpdateEntries(vtkShadowCasters* casters, bool framed)
{
  bool changed = false;
  for (auto& entry : this->Entries)
  {
    entry.second.IsSeen = false;
  }
  for (const vtkShadowCasterShape& shape : casters->GetShapes())
  {
    Entry& entry = this->Entries[shape.Number];
    entry.IsSeen = true;
    if (!entry.Caster)
    {
      entry.Caster = std::make_unique<vtkTracedCaster>(this->Device);
    }
    const vtkTracedCaster::Work work = entry.Caster->Update(shape);
    this->Work.BodiesBuilt += work.Built;
    this->Work.BodiesRefitted += work.Refitted;
    if (framed || work.Moved)
    {
      this->Place(entry);
      changed = true;
    }
  }
  for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
  {
    if (entry->second.IsSeen)
    {
      ++entry;
      continue;
    }
    for (const Instance& instance : entry->second.Instances)
    {
      this->Detach(instance);
    }
    entry = this->Entries.erase(entry);
    changed = true;
  }
  return changed;
}

//------------------------------------------------------------------------------
void vtkTracedScene::Place(Entry& entry)
{
  const std::vector<vtkTracedPlacement>& placements = entry.Caster->GetPlacements();
  while (entry.Instances.size() > placements.size())
  {
    this->Detach(entry.Instances.back());
    entry.Instances.pop_back();
  }
  while (entry.Instances.size() < placements.size())
  {
    entry.Instances.emplace_back();
    this->Attach(entry.Instances.back());
  }
  for (std::size_t i = 0; i < placements.size(); ++i)
  {
    this->Place(placements[i], entry.Instances[i]);
  }
}

//------------------------------------------------------------------------------
void vtkTracedScene::Place(const vtkTracedPlacement& placement, Instance& instance)
{
  vtkTracedMap map = placement.ToWorld;
  for (vtkTracedVector& column : map.Columns)
  {
    column = this->Scale * column;
  }
  map.Offset = this->ToLocal(map.Offset);
  this->ToLocals[instance.Number] = map;
  std::array<float, 12> columns;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    columns[i] = static_cast<float>(i < 9 ? map.Columns[i / 3][i % 3] : map.Offset[i - 9]);
  }
  rtcSetGeometryInstancedScene(instance.Geometry, placement.Body->GetScene());
  rtcSetGeometryTransform(instance.Geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  rtcCommitGeometry(instance.Geometry);
}

//------------------------------------------------------------------------------
void vtkTracedScene::Attach(Instance& instance)
{
  if (this->FreeNumbers.empty())
  {
    instance.Number = static_cast<unsigned int>(this->ToLocals.size());
    this->ToLocals.emplace_back();
  }
  else
  {
    instance.Number = this->FreeNumbers.back();
    this->FreeNumbers.pop_back();
  }
  instance.Geometry = rtcNewGeometry(this->Device->GetHandle(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcAttachGeometryByID(this->Handle, instance.Geometry, instance.Number);
  rtcReleaseGeometry(instance.Geometry); // the scene keeps it
}

//------------------------------------------------------------------------------
void vtkTracedScene::Detach(const Instance& instance)
{
  rtcDetachGeometry(this->Handle, instance.Number);
  this->FreeNumbers.push_back(instance.Number);
}

//------------------------------------------------------------------------------
void vtkTracedScene::FindBoxes()
{
  this->Boxes.clear();
  this->Reach = 0.0;
  for (const auto& entry : this->Entries)
  {
    const std::vector<vtkTracedPlacement>& placements = entry.second.Caster->GetPlacements();
    for (std::size_t i = 0; i < placements.size(); ++i)
    {
      RTCBounds bounds;
      rtcGetSceneBounds(placements[i].Body->GetScene(), &bounds);
      const vtkTracedVector low{ { bounds.lower_x, bounds.lower_y, bounds.lower_z } };
      const vtkTracedVector high{ { bounds.upper_x, bounds.upper_y, bounds.upper_z } };
      const vtkTracedMap& map = this->ToLocals[entry.second.Instances[i].Number];
      vtkTracedBox box;
      box.Center = map(0.5 * (low + high));
      double reach = vtkTraced::Length(box.Center);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        box.HalfAxes[axis] = 0.5 * (high[axis] - low[axis]) * map.Columns[axis];
        reach += vtkTraced::Length(box.HalfAxes[axis]);
      }
      this->Boxes.push_back(box);
      this->Reach = std::max(this->Reach, reach);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTracedScene::FindReasons()
{
  this->Reasons.clear();
  for (const auto& entry : this->Entries)
  {
    const std::string& reason = entry.second.Caster->GetReason();
    if (!reason.empty() &&
      std::find(this->Reasons.begin(), this->Reasons.end(), reason) == this->Reasons.end())
    {
      this->Reasons.push_back(reason);
    }
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTracedScene::GetBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const auto& entry : this->Entries)
  {
    bytes += entry.second.Caster->GetBytes();
  }
  return bytes;
}
VTK_ABI_NAMESPACE_END
