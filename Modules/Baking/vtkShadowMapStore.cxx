// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapStore.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowTextureArray.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
struct vtkShadowMapStore::Entry
{
  Key Owner;
  vtkNew<vtkShadowDepthMaps> Depths;
  vtkNew<vtkShadowDepthPyramid> Pyramid;
  vtkTypeInt64 LastUse = 0;

  vtkTypeInt64 GetBytes() const
  {
    return this->Depths->GetTexture()->GetBytes() + this->Pyramid->GetTexture()->GetBytes();
  }

  /// Whether its texture can hold what is asked for without being made anew.
  bool Fits(const Request& request) const
  {
    vtkShadowTextureArray* texture = this->Depths->GetTexture();
    return texture->GetWidth() == request.MapSize &&
      texture->GetLayers() >= static_cast<int>(request.Views.size());
  }

  /// Whether in addition not more than half of it were idle, and what else it has is asked for.
  bool Suits(const Request& request) const
  {
    return this->Fits(request) &&
      this->Depths->GetTexture()->GetLayers() <= 2 * static_cast<int>(request.Views.size()) &&
      (this->Pyramid->GetTexture()->GetHandle() != 0) == request.Pyramid;
  }
};

namespace
{

// Of new textures: a pyramid has 3/4 x 1/2 of the map's edge, rounded up to a power of two; two floats.
vtkTypeInt64 CountBytes(const vtkShadowMapStore::Request& request)
{
  vtkTypeInt64 edge = 1;
  while (edge < request.MapSize)
  {
    edge *= 2;
  }
  const auto layers = static_cast<vtkTypeInt64>(request.Views.size());
  const vtkTypeInt64 depths = 4 * layers * request.MapSize * request.MapSize;
  return depths + (request.Pyramid ? 8 * layers * (3 * edge / 4) * (edge / 2) : 0);
}

} // namespace

//------------------------------------------------------------------------------
vtkShadowMapStore::vtkShadowMapStore() = default;

//------------------------------------------------------------------------------
vtkShadowMapStore::~vtkShadowMapStore() = default;

//------------------------------------------------------------------------------
void vtkShadowMapStore::SetBudget(vtkTypeInt64 bytes)
{
  this->IsBudgetLess =
    this->IsBudgetLess || (bytes > 0 && (this->Budget == 0 || bytes < this->Budget));
  this->Budget = bytes;
}

//------------------------------------------------------------------------------
void vtkShadowMapStore::Begin(vtkRenderer* renderer)
{
  this->FrameBegin = this->Uses;
  std::vector<const vtkLight*> lights;
  vtkLightCollection* all = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  all->InitTraversal(iterator);
  while (const vtkLight* light = all->GetNextLight(iterator))
  {
    lights.push_back(light);
  }
  const auto isGone = [&lights](const std::unique_ptr<Entry>& entry)
  { return std::find(lights.begin(), lights.end(), entry->Owner.Light) == lights.end(); };
  for (const auto& entry : this->Entries)
  {
    this->DrawCalls += isGone(entry) ? entry->Depths->GetNumberOfDrawCalls() : 0;
  }
  this->Entries.erase(
    std::remove_if(this->Entries.begin(), this->Entries.end(), isGone), this->Entries.end());
  this->BeginEmitter();
  while (this->IsBudgetLess && this->GetBytes() > this->Budget)
  {
    this->Remove(this->FindVictim(nullptr, nullptr));
  }
  this->IsBudgetLess = false;
}

//------------------------------------------------------------------------------
void vtkShadowMapStore::BeginEmitter()
{
  this->EmitterBegin = this->Uses;
}

//------------------------------------------------------------------------------
vtkShadowMapStore::Maps vtkShadowMapStore::Bake(
  vtkRenderer* renderer, vtkShadowCasters* casters, const Key& key, const Request& request)
{
  Entry& entry = this->Provide(key, request);
  entry.LastUse = ++this->Uses;
  this->Allocations += entry.Fits(request) ? 0 : 1;
  Maps maps;
  maps.Baked =
    entry.Depths->Bake(renderer, casters, request.Views, request.MapSize, request.Conservative);
  if (maps.Baked < 0)
  {
    maps.Baked = 0;
    return maps;
  }
  if (request.Pyramid)
  {
    entry.Pyramid->Update(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), entry.Depths);
  }
  maps.Depths = entry.Depths;
  maps.Pyramid = entry.Pyramid;
  return maps;
}

//------------------------------------------------------------------------------
vtkShadowMapStore::Entry* vtkShadowMapStore::Find(const Key& key) const
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&key](const std::unique_ptr<Entry>& entry) { return entry->Owner == key; });
  return found == this->Entries.end() ? nullptr : found->get();
}

//------------------------------------------------------------------------------
vtkShadowMapStore::Entry& vtkShadowMapStore::Provide(const Key& key, const Request& request)
{
  Entry* entry = this->Find(key);
  if (entry && entry->Fits(request))
  {
    return *entry;
  }
  const vtkTypeInt64 wanted = CountBytes(request) - (entry ? entry->GetBytes() : 0);
  while (this->Budget > 0 && this->GetBytes() + wanted > this->Budget)
  {
    if (Entry* heir = this->FindVictim(entry, &request))
    {
      this->Remove(entry);
      heir->Owner = key;
      return *heir;
    }
    Entry* victim = this->FindVictim(entry, nullptr);
    if (!victim)
    {
      break; // what is in use stays
    }
    this->Remove(victim);
  }
  if (!entry)
  {
    this->Entries.push_back(std::make_unique<Entry>());
    entry = this->Entries.back().get();
    entry->Owner = key;
  }
  return *entry;
}

//------------------------------------------------------------------------------
vtkShadowMapStore::Entry* vtkShadowMapStore::FindVictim(
  const Entry* wanting, const Request* suiting) const
{
  Entry* oldest = nullptr;
  Entry* newest = nullptr;
  for (const auto& entry : this->Entries)
  {
    if (entry.get() == wanting || entry->LastUse > this->EmitterBegin ||
      (suiting && !entry->Suits(*suiting)))
    {
      continue;
    }
    if (entry->LastUse <= this->FrameBegin && (!oldest || entry->LastUse < oldest->LastUse))
    {
      oldest = entry.get();
    }
    if (!newest || entry->LastUse > newest->LastUse)
    {
      newest = entry.get();
    }
  }
  return oldest ? oldest : newest;
}

//------------------------------------------------------------------------------
void vtkShadowMapStore::Remove(const Entry* removed)
{
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [removed](const std::unique_ptr<Entry>& entry) { return entry.get() == removed; });
  if (found != this->Entries.end())
  {
    this->DrawCalls += (*found)->Depths->GetNumberOfDrawCalls();
    this->Entries.erase(found); // textures free themselves
  }
}

//------------------------------------------------------------------------------
void vtkShadowMapStore::Release(const Key& key)
{
  this->Remove(this->Find(key));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowMapStore::GetBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const auto& entry : this->Entries)
  {
    bytes += entry->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowMapStore::GetNumberOfDrawCalls() const
{
  vtkTypeInt64 calls = this->DrawCalls;
  for (const auto& entry : this->Entries)
  {
    calls += entry->Depths->GetNumberOfDrawCalls();
  }
  return calls;
}

//------------------------------------------------------------------------------
void vtkShadowMapStore::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& entry : this->Entries)
  {
    this->DrawCalls += entry->Depths->GetNumberOfDrawCalls();
    entry->Depths->ReleaseGraphicsResources(window);
    entry->Pyramid->ReleaseGraphicsResources(window);
  }
  this->Entries.clear();
}
VTK_ABI_NAMESPACE_END
