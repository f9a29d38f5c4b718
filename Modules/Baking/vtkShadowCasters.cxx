// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasters.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationIterator.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShadowCamera.h"
#include "vtkShadowCasterList.h"
#include "vtkShadowCasterProgram.h"
#include "vtkShadowCasterShape.h"
#include "vtkShadowContextWatch.h"
#include "vtkShadowDrawTest.h"
#include "vtkShadowMapperCasters.h"
#include "vtkShadowStrokeProgram.h"
#include "vtkShadowStrokes.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cstring>

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

// Whether the keys hold VTK's of these names. VTK does not define them since its passes were rewritten
// for OpenGL 3.2, though their documentation still names them; programs make them by name.
void FindKeysOfVTK(vtkInformation* keys, bool& occluder, bool& receiver)
{
  const int marks = keys->Has(vtkOpenGLRenderPass::RenderPasses()) ? 1 : 0;
  if (keys->GetNumberOfKeys() == marks)
  {
    return; // as most props, in every frame: only what passes write there
  }
  vtkNew<vtkInformationIterator> iterator;
  iterator->SetInformationWeak(keys);
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkInformationKey* key = iterator->GetCurrentKey();
    if (std::strcmp(key->GetLocation(), "vtkShadowMapBakerPass") == 0)
    {
      occluder = occluder || std::strcmp(key->GetName(), "OCCLUDER") == 0;
      receiver = receiver || std::strcmp(key->GetName(), "RECEIVER") == 0;
    }
  }
}

bool GetKey(vtkProp* prop, vtkInformationIntegerKey* key)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  if (!keys || keys->Has(key))
  {
    return !keys || keys->Get(key) != 0;
  }
  bool occluder = false;
  bool receiver = false;
  FindKeysOfVTK(keys, occluder, receiver);
  const bool has = key == vtkShadowCasters::CASTS_SHADOW() ? occluder : receiver;
  return has || !(occluder || receiver);
}
}

//------------------------------------------------------------------------------
class vtkShadowCasters::Internals
{
public:
  ~Internals() { this->Watch.Free(); } // while all members are there

  vtkShadowCasterList List;
  vtkShadowCasterProgram Program;
  vtkShadowStrokeProgram StrokeProgram;
  vtkNew<vtkShadowCamera> Camera;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkShadowContextWatch Watch{ [this](vtkOpenGLRenderWindow*)
    {
      this->List.Buffer.ReleaseGraphicsResources();
      for (vtkShadowCasterEntry& entry : this->List.Entries)
      {
        entry.ReleaseGraphicsResources();
      }
      this->Program.ReleaseGraphicsResources();
      this->StrokeProgram.ReleaseGraphicsResources();
    } };

  int DrawSide(int side, int instances);
  int DrawBuffer(vtkOpenGLState* state, bool conservative, int instances = 1);
  void ChooseSides(const vtkShadowMapView* views, int count);
  int DrawStrokes(vtkOpenGLRenderWindow* window, const vtkShadowMapView& view, int resolution);
  int DrawMappers(vtkRenderer* renderer, const vtkShadowMapView& view);
};

//------------------------------------------------------------------------------
// Of every caster the side that all views which show it ask for, or both.
void vtkShadowCasters::Internals::ChooseSides(const vtkShadowMapView* views, int count)
{
  for (int i = 0; i < count; ++i)
  {
    const vtkShadowDrawTest test(views[i]);
    for (vtkShadowCasterEntry& entry : this->List.Entries)
    {
      const int side = test.GetSide(entry);
      const bool isFirst = i == 0 || entry.SideToDraw == vtkShadowCasterEntry::NO_SIDE;
      if (isFirst)
      {
        entry.SideToDraw = side;
      }
      else if (side != vtkShadowCasterEntry::NO_SIDE && side != entry.SideToDraw)
      {
        entry.SideToDraw = 0;
      }
    }
  }
}

//------------------------------------------------------------------------------
int vtkShadowCasters::Internals::DrawSide(int side, int instances)
{
  this->List.Buffer.Begin();
  for (const vtkShadowCasterEntry& entry : this->List.Entries)
  {
    if (entry.SideToDraw == side)
    {
      this->List.Buffer.Add(entry.GetRange());
    }
  }
  return this->List.Buffer.Draw(this->Program.GetLocation(), instances);
}

//------------------------------------------------------------------------------
int vtkShadowCasters::Internals::DrawBuffer(vtkOpenGLState* state, bool conservative, int instances)
{
  int calls = 0;
  for (int side = -1; side <= 1; ++side)
  {
    // Conservative triangles come out of the geometry shader as rectangles.
    this->Program.SetSide(state, conservative ? 0 : side);
    calls += this->DrawSide(side, instances);
  }
  this->Program.SetSide(state, 0);
  return calls;
}

//------------------------------------------------------------------------------
int vtkShadowCasters::Internals::DrawStrokes(
  vtkOpenGLRenderWindow* window, const vtkShadowMapView& view, int resolution)
{
  int calls = 0;
  for (const vtkShadowCasterEntry& entry : this->List.Entries)
  {
    vtkShadowStrokes* strokes = entry.GetStrokes();
    if (!strokes || entry.SideToDraw == vtkShadowCasterEntry::NO_SIDE)
    {
      continue;
    }
    if (calls == 0 && !this->StrokeProgram.Use(window, view, resolution))
    {
      return 0;
    }
    calls += strokes->Draw(this->StrokeProgram, entry.GetScreen());
  }
  return calls;
}

//------------------------------------------------------------------------------
int vtkShadowCasters::Internals::DrawMappers(vtkRenderer* renderer, const vtkShadowMapView& view)
{
  const auto isDrawn = [](const vtkShadowCasterEntry& entry)
  { return entry.DrawsThroughMapper() && entry.SideToDraw != vtkShadowCasterEntry::NO_SIDE; };
  const auto& entries = this->List.Entries;
  if (std::none_of(entries.begin(), entries.end(), isDrawn))
  {
    return 0;
  }
  int calls = 0;
  vtkShadowMapperCasters drawer(renderer, this->Camera, view);
  for (const vtkShadowCasterEntry& entry : entries)
  {
    if (isDrawn(entry))
    {
      this->Matrix->DeepCopy(entry.Matrix.data());
      drawer.Draw(entry.Prop, entry.IsLeaf ? this->Matrix.GetPointer() : nullptr);
      ++calls;
    }
  }
  return calls;
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
    this->Impl->List.ForgetReceivers();
    vtkTimeStamp stamp;
    stamp.Modified();
    this->CastersTime = stamp.GetMTime(); // maps may show what they should not, or lack something
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkShadowCasters::Update(vtkRenderer* renderer)
{
  const vtkShadowCasterEntry::Change change =
    this->Impl->List.Update(renderer, this->EffectiveOnly);
  if (!change.Bodies && !change.Casters && !change.Looks)
  {
    return false;
  }
  vtkTimeStamp stamp;
  stamp.Modified();
  this->LooksTime = stamp.GetMTime();
  if (!change.Bodies && !change.Casters)
  {
    return false;
  }
  this->BodiesTime = stamp.GetMTime();
  if (change.Casters)
  {
    this->CastersTime = this->BodiesTime;
  }
  return true;
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowCasters::Body>& vtkShadowCasters::GetBodies() const
{
  return this->Impl->List.Bodies;
}

//------------------------------------------------------------------------------
double vtkShadowCasters::GetLargestRise(const vtkProp* prop) const
{
  return this->Impl->List.GetLargestRise(prop);
}

//------------------------------------------------------------------------------
const std::array<double, 3>& vtkShadowCasters::GetOrigin() const
{
  return this->Impl->List.Origin;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowCasterShape> vtkShadowCasters::GetShapes() const
{
  std::vector<vtkShadowCasterShape> shapes;
  for (const vtkShadowCasterEntry& entry : this->Impl->List.Entries)
  {
    if (entry.DrawsFromBuffer() || entry.DrawsThroughMapper())
    {
      shapes.push_back(entry.GetShape());
    }
  }
  return shapes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowCasters::GetNumberOfTriangles() const
{
  vtkTypeInt64 triangles = 0;
  for (const vtkShadowCasterEntry& entry : this->Impl->List.Entries)
  {
    triangles += static_cast<vtkTypeInt64>(entry.GetRange().NumberOfIndices / 3);
  }
  return triangles;
}

//------------------------------------------------------------------------------
int vtkShadowCasters::GetNumberOfCasters() const
{
  const auto& entries = this->Impl->List.Entries;
  return static_cast<int>(std::count_if(entries.begin(), entries.end(),
    [](const vtkShadowCasterEntry& entry)
    { return entry.DrawsFromBuffer() || entry.DrawsThroughMapper(); }));
}

//------------------------------------------------------------------------------
int vtkShadowCasters::GetNumberOfMapperCasters() const
{
  const auto& entries = this->Impl->List.Entries;
  return static_cast<int>(std::count_if(entries.begin(), entries.end(),
    [](const vtkShadowCasterEntry& entry) { return entry.DrawsThroughMapper(); }));
}

//------------------------------------------------------------------------------
int vtkShadowCasters::GetNumberOfClosedCasters() const
{
  const auto& entries = this->Impl->List.Entries;
  return static_cast<int>(std::count_if(entries.begin(), entries.end(),
    [](const vtkShadowCasterEntry& entry)
    { return entry.DrawsFromBuffer() && entry.GetFacing() != 0; }));
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowCasters::GetBytes() const
{
  return this->Impl->List.Buffer.GetBytes();
}

//------------------------------------------------------------------------------
int vtkShadowCasters::Draw(
  vtkRenderer* renderer, const vtkShadowMapView& view, int resolution, bool conservative)
{
  Internals& impl = *this->Impl;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  impl.Watch.Enter(window);
  impl.ChooseSides(&view, 1);
  const vtkShadowCasterProgram::ScopedState state(window->GetState());
  int calls = 0;
  if (impl.Program.Use(window, view, impl.List.Origin, resolution, conservative))
  {
    calls += impl.DrawBuffer(window->GetState(), conservative);
    impl.Program.Finish();
  }
  calls += impl.DrawStrokes(window, view, resolution);
  return calls + impl.DrawMappers(renderer, view);
}

//------------------------------------------------------------------------------
bool vtkShadowCasters::CanDrawLayers(vtkRenderer* renderer)
{
  Internals& impl = *this->Impl;
  impl.Watch.Enter(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  const auto& entries = impl.List.Entries;
  return impl.Program.CanDrawLayers() &&
    std::none_of(entries.begin(), entries.end(),
      [](const vtkShadowCasterEntry& entry)
      { return entry.GetStrokes() || entry.DrawsThroughMapper(); });
}

//------------------------------------------------------------------------------
int vtkShadowCasters::DrawLayers(vtkRenderer* renderer, const std::vector<vtkShadowMapView>& views)
{
  Internals& impl = *this->Impl;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  impl.Watch.Enter(window);
  const vtkShadowCasterProgram::ScopedState state(window->GetState());
  const auto count = static_cast<int>(views.size());
  int calls = 0;
  for (int first = 0; first < count; first += vtkShadowCasterProgram::LayersPerDraw)
  {
    const int instances = std::min(count - first, vtkShadowCasterProgram::LayersPerDraw);
    if (!impl.Program.UseLayers(window, views.data() + first, instances, first, impl.List.Origin))
    {
      return -1;
    }
    impl.ChooseSides(views.data() + first, instances);
    calls += impl.DrawBuffer(window->GetState(), false, instances);
    impl.Program.Finish();
  }
  return calls;
}

//------------------------------------------------------------------------------
void vtkShadowCasters::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Watch.Free();
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
