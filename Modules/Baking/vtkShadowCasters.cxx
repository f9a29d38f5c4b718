// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasters.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCollectionRange.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowCamera.h"
#include "vtkShadowCasterEntry.h"
#include "vtkShadowCasterProgram.h"
#include "vtkShadowMapView.h"
#include "vtkShadowMapperCasters.h"
#include "vtkShadowSides.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkShadowCasters);
vtkInformationKeyMacro(vtkShadowCasters, CASTS_SHADOW, Integer);
vtkInformationKeyMacro(vtkShadowCasters, RECEIVES_SHADOW, Integer);

namespace
{
void SetKey(vtkProp* prop, vtkInformationIntegerKey* key, bool value)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Set(key, value ? 1 : 0);
}

bool GetKey(vtkProp* prop, vtkInformationIntegerKey* key)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

// The planes that cull, as {a, b, c, d} with a x + b y + c z + d < 0 outside, in world coordinates:
// the four sides, and the far one, behind which nothing is written. In front of the near plane there
// is none: what is there is clamped to it.
struct CullingPlanes
{
  explicit CullingPlanes(const std::array<double, 16>& toClip)
  {
    for (int i = 0; i < 4; ++i)
    {
      const double w = toClip[12 + i];
      this->Planes[0][i] = w + toClip[i];
      this->Planes[1][i] = w - toClip[i];
      this->Planes[2][i] = w + toClip[4 + i];
      this->Planes[3][i] = w - toClip[4 + i];
      this->Planes[4][i] = w - toClip[8 + i];
    }
  }

  bool Excludes(const std::array<double, 6>& box) const
  {
    for (const auto& plane : this->Planes)
    {
      double farthest = plane[3];
      for (int i = 0; i < 3; ++i)
      {
        farthest += std::max(plane[i] * box[2 * i], plane[i] * box[2 * i + 1]);
      }
      if (farthest < 0.0)
      {
        return true;
      }
    }
    return false;
  }

  std::array<std::array<double, 4>, 5> Planes;
};

// What a view's map shows.
class DrawTest
{
public:
  explicit DrawTest(const vtkShadowMapView& view)
    : View(view)
    , Planes(view.WorldToClip())
  {
  }

  // From inside a closed surface its other side is seen, and maybe from inside its box.
  int GetSide(const vtkShadowCasterEntry& entry) const
  {
    if (this->View.Emitter.Directional)
    {
      return entry.GetFacing();
    }
    const auto& eye = this->View.Emitter.Center;
    const auto& box = entry.Body.Bounds;
    const bool inside = eye[0] >= box[0] && eye[0] <= box[1] && eye[1] >= box[2] &&
      eye[1] <= box[3] && eye[2] >= box[4] && eye[2] <= box[5];
    return inside ? 0 : entry.GetFacing();
  }

  bool operator()(const vtkShadowCasterEntry& entry) const
  {
    return entry.HasBody && entry.Body.Casts && !this->Planes.Excludes(entry.Body.Bounds) &&
      this->IsEffective(entry);
  }

private:
  bool IsEffective(const vtkShadowCasterEntry& entry) const
  {
    if (entry.HasReceivers[0] && entry.HasReceivers[1])
    {
      return true;
    }
    const int side = vtkShadowSides::OfEmitter(entry.Body, this->View.Emitter);
    return side == 0 ? entry.HasReceivers[0] || entry.HasReceivers[1]
                     : entry.HasReceivers[side > 0 ? 0 : 1];
  }

  const vtkShadowMapView& View;
  CullingPlanes Planes;
};
}

//------------------------------------------------------------------------------
class vtkShadowCasters::Internals
{
public:
  std::vector<vtkShadowCasterEntry> Entries;
  std::size_t Cursor = 0;
  vtkShadowCasterSource Source;
  vtkShadowCasterBuffer Buffer;
  std::vector<vtkShadowCasters::Body> Bodies;
  std::array<double, 3> Origin{};
  bool HasOrigin = false;
  std::vector<float> Scratch;
  vtkShadowCasterProgram Program;
  vtkNew<vtkShadowCamera> Camera;
  vtkNew<vtkMatrix4x4> Matrix;

  bool CastersChanged = false;
  bool BodiesChanged = false;
  bool MustCollect = false; // at the next Update, whatever it finds

  void Note(const vtkShadowCasterEntry::Change& change)
  {
    this->CastersChanged = this->CastersChanged || change.Casters;
    this->BodiesChanged = this->BodiesChanged || change.Bodies;
  }

  void VisitProp(vtkProp* prop);
  void VisitLeaf(vtkProp* leaf, vtkMatrix4x4* matrix, vtkProp* top);
  vtkShadowCasterEntry& FindEntry(vtkProp3D* prop);
  void RemoveEntries(std::size_t first, std::size_t last);
  void PlaceEntries();
  bool MoveOrigin();
  void CollectBodies();
  int DrawSide(int side);
  void FindReceiversOfPlanes();
  bool HasReceivers(const vtkShadowCasters::Body& plane, int lightSide, const Body& all) const;
};

//------------------------------------------------------------------------------
void vtkShadowCasters::Internals::VisitProp(vtkProp* prop)
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
void vtkShadowCasters::Internals::VisitLeaf(vtkProp* leaf, vtkMatrix4x4* matrix, vtkProp* top)
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
  this->Note(entry.Refresh(this->Source, elements, GetKey(top, vtkShadowCasters::CASTS_SHADOW()),
    GetKey(top, vtkShadowCasters::RECEIVES_SHADOW())));
}

//------------------------------------------------------------------------------
// Props come in the same order in every frame, so the next entry is the prop's own unless props came
// or went.
vtkShadowCasterEntry& vtkShadowCasters::Internals::FindEntry(vtkProp3D* prop)
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
void vtkShadowCasters::Internals::RemoveEntries(std::size_t first, std::size_t last)
{
  for (std::size_t i = first; i < last; ++i)
  {
    vtkShadowCasterEntry& entry = this->Entries[i];
    this->Note({ entry.DrawsFromBuffer() || entry.DrawsThroughMapper(), entry.HasBody });
    entry.Remove(this->Buffer);
  }
  const auto begin = this->Entries.begin();
  this->Entries.erase(
    begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
}

//------------------------------------------------------------------------------
void vtkShadowCasters::Internals::PlaceEntries()
{
  for (vtkShadowCasterEntry& entry : this->Entries)
  {
    this->Note(entry.Place(this->Buffer, this->Origin, this->Scratch));
  }
}

//------------------------------------------------------------------------------
// The origin is the mean of the bodies' centres, small bodies counting more, so that floats are finest
// where the detail is. It stays while it is good enough: moving it writes everything anew.
bool vtkShadowCasters::Internals::MoveOrigin()
{
  constexpr double FARTHEST = 64.0; // in mean sizes; 64 x 2^-24 of a body is lost at most
  std::array<double, 3> mean{};
  double weights = 0.0;
  int count = 0;
  for (const vtkShadowCasterEntry& entry : this->Entries)
  {
    if (!entry.HasBody)
    {
      continue;
    }
    const auto& box = entry.Body.Bounds;
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
void vtkShadowCasters::Internals::CollectBodies()
{
  this->Bodies.clear();
  for (const vtkShadowCasterEntry& entry : this->Entries)
  {
    if (entry.HasBody)
    {
      this->Bodies.push_back(entry.Body);
    }
  }
}

//------------------------------------------------------------------------------
int vtkShadowCasters::Internals::DrawSide(int side)
{
  this->Buffer.Begin();
  for (const vtkShadowCasterEntry& entry : this->Entries)
  {
    if (entry.SideToDraw == side)
    {
      this->Buffer.Add(entry.GetRange());
    }
  }
  return this->Buffer.Draw(this->Program.GetLocation());
}

//------------------------------------------------------------------------------
bool vtkShadowCasters::Internals::HasReceivers(
  const vtkShadowCasters::Body& plane, int lightSide, const Body& all) const
{
  return vtkShadowSides::ReachesBehind(plane, lightSide, all) &&
    std::any_of(this->Bodies.begin(), this->Bodies.end(),
      [&plane, lightSide](const vtkShadowCasters::Body& body)
      { return body.Receives && vtkShadowSides::ReachesBehind(plane, lightSide, body); });
}

//------------------------------------------------------------------------------
void vtkShadowCasters::Internals::FindReceiversOfPlanes()
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
    this->CastersChanged = this->CastersChanged || receivers != entry.HasReceivers;
    entry.HasReceivers = receivers;
  }
}

//------------------------------------------------------------------------------
vtkShadowCasters::vtkShadowCasters()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkShadowCasters::~vtkShadowCasters() = default;

//------------------------------------------------------------------------------
void vtkShadowCasters::SetCastsShadow(vtkProp* prop, bool casts)
{
  SetKey(prop, vtkShadowCasters::CASTS_SHADOW(), casts);
}

//------------------------------------------------------------------------------
void vtkShadowCasters::SetReceivesShadow(vtkProp* prop, bool receives)
{
  SetKey(prop, vtkShadowCasters::RECEIVES_SHADOW(), receives);
}

//------------------------------------------------------------------------------
bool vtkShadowCasters::GetCastsShadow(vtkProp* prop)
{
  return GetKey(prop, vtkShadowCasters::CASTS_SHADOW());
}

//------------------------------------------------------------------------------
bool vtkShadowCasters::GetReceivesShadow(vtkProp* prop)
{
  return GetKey(prop, vtkShadowCasters::RECEIVES_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowCasters::SetEffectiveOnly(bool effectiveOnly)
{
  if (this->EffectiveOnly != effectiveOnly)
  {
    this->EffectiveOnly = effectiveOnly;
    this->Impl->MustCollect = true;
    for (vtkShadowCasterEntry& entry : this->Impl->Entries)
    {
      entry.HasReceivers = { { true, true } };
    }
    // What casts may differ from what the maps show.
    vtkTimeStamp stamp;
    stamp.Modified();
    this->CastersTime = stamp.GetMTime();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkShadowCasters::Update(vtkRenderer* renderer)
{
  Internals& impl = *this->Impl;
  impl.Cursor = 0;
  impl.CastersChanged = false;
  impl.BodiesChanged = impl.MustCollect;
  impl.MustCollect = false;

  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    impl.VisitProp(prop);
  }
  impl.RemoveEntries(impl.Cursor, impl.Entries.size());

  impl.PlaceEntries();
  if ((impl.BodiesChanged || impl.CastersChanged) && impl.MoveOrigin())
  {
    std::for_each(
      impl.Entries.begin(), impl.Entries.end(), [](vtkShadowCasterEntry& entry) { entry.Touch(); });
    impl.PlaceEntries();
  }
  if (impl.Buffer.IsWasteful())
  {
    impl.Buffer.Clear();
    std::for_each(impl.Entries.begin(), impl.Entries.end(),
      [](vtkShadowCasterEntry& entry) { entry.ForgetRange(); });
    impl.PlaceEntries();
  }
  if (impl.BodiesChanged)
  {
    impl.CollectBodies();
    if (this->EffectiveOnly)
    {
      impl.FindReceiversOfPlanes();
    }
  }
  if (!impl.BodiesChanged && !impl.CastersChanged)
  {
    return false;
  }
  vtkTimeStamp stamp;
  stamp.Modified();
  this->BodiesTime = stamp.GetMTime();
  if (impl.CastersChanged)
  {
    this->CastersTime = this->BodiesTime;
  }
  return true;
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowCasters::Body>& vtkShadowCasters::GetBodies() const
{
  return this->Impl->Bodies;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowCasters::GetNumberOfTriangles() const
{
  vtkTypeInt64 triangles = 0;
  for (const vtkShadowCasterEntry& entry : this->Impl->Entries)
  {
    triangles += static_cast<vtkTypeInt64>(entry.GetRange().NumberOfIndices / 3);
  }
  return triangles;
}

//------------------------------------------------------------------------------
int vtkShadowCasters::GetNumberOfCasters() const
{
  const auto& entries = this->Impl->Entries;
  return static_cast<int>(std::count_if(entries.begin(), entries.end(),
    [](const vtkShadowCasterEntry& entry)
    { return entry.DrawsFromBuffer() || entry.DrawsThroughMapper(); }));
}

//------------------------------------------------------------------------------
int vtkShadowCasters::GetNumberOfMapperCasters() const
{
  const auto& entries = this->Impl->Entries;
  return static_cast<int>(std::count_if(entries.begin(), entries.end(),
    [](const vtkShadowCasterEntry& entry) { return entry.DrawsThroughMapper(); }));
}

//------------------------------------------------------------------------------
int vtkShadowCasters::GetNumberOfClosedCasters() const
{
  const auto& entries = this->Impl->Entries;
  return static_cast<int>(std::count_if(entries.begin(), entries.end(),
    [](const vtkShadowCasterEntry& entry)
    { return entry.DrawsFromBuffer() && entry.GetFacing() != 0; }));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowCasters::GetBytes() const
{
  return this->Impl->Buffer.GetBytes();
}

//------------------------------------------------------------------------------
int vtkShadowCasters::Draw(
  vtkRenderer* renderer, const vtkShadowMapView& view, int resolution, bool conservative)
{
  Internals& impl = *this->Impl;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const DrawTest test(view);
  std::array<bool, 3> sides{}; // clockwise, both, counterclockwise
  bool mappers = false;
  for (vtkShadowCasterEntry& entry : impl.Entries)
  {
    entry.SideToDraw = test(entry) ? test.GetSide(entry) : vtkShadowCasterEntry::NO_SIDE;
    if (entry.SideToDraw != vtkShadowCasterEntry::NO_SIDE)
    {
      mappers = mappers || entry.DrawsThroughMapper();
      sides[static_cast<std::size_t>(entry.SideToDraw + 1)] = true;
    }
  }

  int calls = 0;
  const vtkShadowCasterProgram::ScopedState state(window->GetState());
  if (impl.Program.Use(window, view, impl.Origin, resolution, conservative))
  {
    for (int side = -1; side <= 1; ++side)
    {
      if (sides[static_cast<std::size_t>(side + 1)])
      {
        impl.Program.SetSide(window->GetState(), conservative ? 0 : side);
        calls += impl.DrawSide(side);
      }
    }
    impl.Program.SetSide(window->GetState(), 0);
  }
  if (!mappers)
  {
    return calls;
  }
  vtkShadowMapperCasters drawer(renderer, impl.Camera, view);
  for (const vtkShadowCasterEntry& entry : impl.Entries)
  {
    if (entry.DrawsThroughMapper() && entry.SideToDraw != vtkShadowCasterEntry::NO_SIDE)
    {
      impl.Matrix->DeepCopy(entry.Matrix.data());
      drawer.Draw(entry.Prop, entry.IsLeaf ? impl.Matrix.GetPointer() : nullptr);
      ++calls;
    }
  }
  return calls;
}

//------------------------------------------------------------------------------
void vtkShadowCasters::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Buffer.ReleaseGraphicsResources();
  this->Impl->Program.ReleaseGraphicsResources();
}

//------------------------------------------------------------------------------
void vtkShadowCasters::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Casters: " << this->GetNumberOfCasters() << "\n";
  os << indent << "Casters drawn by their mappers: " << this->GetNumberOfMapperCasters() << "\n";
  os << indent << "Triangles: " << this->GetNumberOfTriangles() << "\n";
  os << indent << "Bytes: " << this->GetBytes() << "\n";
  os << indent << "CastersTime: " << this->CastersTime << "\n";
}

VTK_ABI_NAMESPACE_END
