// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterList.h"

#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowSides.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkShadowCasterList::Note(const vtkShadowCasterEntry::Change& change)
{
  this->Changes.Casters = this->Changes.Casters || change.Casters;
  this->Changes.Bodies = this->Changes.Bodies || change.Bodies;
  this->Changes.Looks = this->Changes.Looks || change.Looks;
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::ForgetReceivers()
{
  this->MustCollect = true;
  for (vtkShadowCasterEntry& entry : this->Entries)
  {
    entry.HasReceivers = { { true, true } };
  }
}

//------------------------------------------------------------------------------
vtkShadowCasterEntry::Change vtkShadowCasterList::Update(vtkRenderer* renderer, bool findReceivers)
{
  this->Changes = { false, this->MustCollect, false };
  this->MustCollect = false;
  this->VisitProps(renderer);
  this->FindScreen(renderer);
  this->PlaceEntries();
  if ((this->Changes.Bodies || this->Changes.Casters) && this->MoveOrigin())
  {
    std::for_each(this->Entries.begin(), this->Entries.end(),
      [](vtkShadowCasterEntry& entry) { entry.Touch(); });
    this->PlaceEntries();
  }
  if (this->Buffer.IsWasteful())
  {
    this->Buffer.Clear();
    std::for_each(this->Entries.begin(), this->Entries.end(),
      [](vtkShadowCasterEntry& entry) { entry.ForgetRange(); });
    this->PlaceEntries();
  }
  this->CollectRises();
  if (this->Changes.Bodies)
  {
    this->CollectBodies();
    if (findReceivers)
    {
      this->FindReceiversOfPlanes();
    }
  }
  return this->Changes;
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::CollectRises()
{
  constexpr double TOLERANCE = 1e-6; // as vtkShadowCasters::Body promises
  this->Rises.clear();
  for (const vtkShadowCasterEntry& entry : this->Entries)
  {
    if (entry.IsFlat())
    {
      const double extent = std::sqrt(vtkMath::Distance2BetweenPoints(
        entry.Body.Corners[0].data(), entry.Body.Corners[2].data()));
      this->Rises.emplace_back(entry.Prop, TOLERANCE * extent);
    }
  }
  std::sort(this->Rises.begin(), this->Rises.end());
}

//------------------------------------------------------------------------------
double vtkShadowCasterList::GetLargestRise(const vtkProp* prop) const
{
  // A part of several assemblies comes several times.
  const std::pair<const vtkProp*, double> past(prop, std::numeric_limits<double>::infinity());
  const auto next = std::upper_bound(this->Rises.begin(), this->Rises.end(), past);
  return next != this->Rises.begin() && (next - 1)->first == prop ? (next - 1)->second
                                                                  : past.second;
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::VisitProps(vtkRenderer* renderer)
{
  this->Cursor = 0;
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    this->VisitProp(prop);
  }
  this->RemoveEntries(this->Cursor, this->Entries.size());
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::VisitProp(vtkProp* prop)
{
  if (!prop->GetVisibility())
  {
    return;
  }
  if (!prop->IsA("vtkAssembly") && !prop->IsA("vtkPropAssembly"))
  {
    this->VisitLeaf(prop, nullptr, prop);
    return;
  }
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    if (node->GetViewProp()->GetVisibility())
    {
      this->VisitLeaf(node->GetViewProp(), node->GetMatrix(), prop);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::VisitLeaf(vtkProp* leaf, vtkMatrix4x4* matrix, vtkProp* top)
{
  auto* prop = vtkProp3D::SafeDownCast(leaf);
  if (!prop)
  {
    return;
  }
  this->Source.Inspect(prop);
  if (this->Source.Route == vtkShadowCasterSource::NONE)
  {
    return;
  }
  if (!matrix)
  {
    prop->GetMatrix(this->Matrix);
  }
  std::array<double, 16> elements;
  std::copy_n((matrix ? matrix : this->Matrix.GetPointer())->GetData(), 16, elements.begin());
  vtkShadowCasterEntry& entry = this->FindEntry(prop);
  entry.IsLeaf = matrix != nullptr;
  // An assembly gives its own keys to its parts whenever it is rendered, so only its own count.
  this->Note(entry.Refresh(this->Source, elements, vtkShadowCasters::GetCastsShadow(top),
    vtkShadowCasters::GetReceivesShadow(top)));
}

//------------------------------------------------------------------------------
// Props come in the same order in every frame, so the next entry is the prop's own unless props came
// or went.
vtkShadowCasterEntry& vtkShadowCasterList::FindEntry(vtkProp3D* prop)
{
  const auto next = this->Entries.begin() + static_cast<std::ptrdiff_t>(this->Cursor);
  const auto found = std::find_if(next, this->Entries.end(),
    [prop](const vtkShadowCasterEntry& entry) { return entry.Prop == prop; });
  if (found == this->Entries.end())
  {
    this->Entries.emplace(next)->Prop = prop;
  }
  else
  {
    this->RemoveEntries(this->Cursor, static_cast<std::size_t>(found - this->Entries.begin()));
  }
  return this->Entries[this->Cursor++];
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::RemoveEntries(std::size_t first, std::size_t last)
{
  for (std::size_t i = first; i < last; ++i)
  {
    vtkShadowCasterEntry& entry = this->Entries[i];
    this->Note({ entry.DrawsFromBuffer() || entry.DrawsThroughMapper(), entry.HasBody, true });
    entry.Remove(this->Buffer);
  }
  const auto begin = this->Entries.begin();
  this->Entries.erase(
    begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
}

//------------------------------------------------------------------------------
// Only strokes need to know the picture; without them no camera changes anything.
void vtkShadowCasterList::FindScreen(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window &&
    std::any_of(this->Entries.begin(), this->Entries.end(),
      [](const vtkShadowCasterEntry& entry) { return entry.HasStrokes(); }))
  {
    int viewport[4];
    window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
    this->Screen = vtkShadowScreen::Of(renderer, viewport[3]);
  }
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::PlaceEntries()
{
  for (vtkShadowCasterEntry& entry : this->Entries)
  {
    this->Note(entry.Place(this->Buffer, this->Origin, this->Screen, this->Scratch));
  }
}

//------------------------------------------------------------------------------
// The origin is the mean of the bodies' centres, small bodies counting more, so that floats are finest
// where the detail is. It stays while it is good enough: moving it writes everything anew.
bool vtkShadowCasterList::MoveOrigin()
{
  constexpr double FARTHEST = 64.0; // in mean sizes; 64 x 2^-24 of a body is lost at most
  std::array<double, 3> mean{};
  double weights = 0.0;
  int count = 0;
  for (const vtkShadowCasterEntry& entry : this->Entries)
  {
    for (const Body& body : entry.Parts)
    {
      const auto& box = body.Bounds;
      const double size = std::sqrt(
        std::pow(box[1] - box[0], 2) + std::pow(box[3] - box[2], 2) + std::pow(box[5] - box[4], 2));
      const double weight = size > 0.0 ? 1.0 / size : 0.0;
      for (int i = 0; i < 3; ++i)
      {
        mean[i] += 0.5 * weight * (box[2 * i] + box[2 * i + 1]);
      }
      weights += weight;
      ++count;
    }
  }
  if (!(weights > 0.0))
  {
    return false;
  }
  for (double& coordinate : mean)
  {
    coordinate /= weights;
  }
  const double distance =
    std::sqrt(vtkMath::Distance2BetweenPoints(mean.data(), this->Origin.data()));
  if (this->HasOrigin && distance <= FARTHEST * count / weights)
  {
    return false;
  }
  this->HasOrigin = true;
  this->Origin = mean;
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::CollectBodies()
{
  this->Bodies.clear();
  for (const vtkShadowCasterEntry& entry : this->Entries)
  {
    for (vtkShadowCasters::Body part : entry.Parts)
    {
      part.Casts = entry.Body.Casts; // flags may change without the rest
      part.Receives = entry.Body.Receives;
      this->Bodies.push_back(part);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkShadowCasterList::HasReceivers(const Body& plane, int lightSide, const Body& all) const
{
  return vtkShadowSides::ReachesBehind(plane, lightSide, all) &&
    std::any_of(this->Bodies.begin(), this->Bodies.end(),
      [&plane, lightSide](const Body& body)
      { return body.Receives && vtkShadowSides::ReachesBehind(plane, lightSide, body); });
}

//------------------------------------------------------------------------------
void vtkShadowCasterList::FindReceiversOfPlanes()
{
  // The box of all spares most planes the walk over all bodies.
  Body all;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  all.Bounds = { { infinity, -infinity, infinity, -infinity, infinity, -infinity } };
  for (const Body& body : this->Bodies)
  {
    for (int i = 0; i < 6; i += 2)
    {
      all.Bounds[i] = std::min(all.Bounds[i], body.Bounds[i]);
      all.Bounds[i + 1] = std::max(all.Bounds[i + 1], body.Bounds[i + 1]);
    }
  }
  for (vtkShadowCasterEntry& entry : this->Entries)
  {
    std::array<bool, 2> receivers{ { true, true } };
    if (entry.HasBody && entry.Body.Casts && entry.Body.Flat)
    {
      receivers = { { this->HasReceivers(entry.Body, 1, all),
        this->HasReceivers(entry.Body, -1, all) } };
    }
    this->Changes.Casters = this->Changes.Casters || receivers != entry.HasReceivers;
    entry.HasReceivers = receivers;
  }
}

VTK_ABI_NAMESPACE_END
