// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowPass.h"

#include "vtkAbstractMapper.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowPassInternals.h"
#include "vtkSoftShadowRendererDuties.h"
#include "vtkSoftShadowScopedState.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <cstdint>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

vtkOpenGLRenderWindow* GetWindow(const vtkRenderState* s)
{
  return static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
}

// VTK takes one of its own for a moment whenever it makes a texture.
bool HasTextureUnit(vtkOpenGLRenderWindow* window)
{
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  const int unit = units->Allocate();
  if (unit >= 0)
  {
    units->Free(unit);
  }
  return unit >= 0;
}

} // namespace

vtkCxxSetObjectMacro(vtkSoftShadowPass, DelegatePass, vtkRenderPass);

//------------------------------------------------------------------------------
// While one lives, maps are at most as large as this OpenGL's textures.
class vtkSoftShadowPass::ScopedMapSize
{
public:
  explicit ScopedMapSize(vtkSoftShadowPass* pass)
    : Pass(pass)
    , Wanted(pass->MapSize)
  {
    const int largest = vtkShadowLimits::GetTextureSize();
    if (this->Wanted > largest && pass->Impl->ToldMapSize != this->Wanted)
    {
      pass->Impl->ToldMapSize = this->Wanted;
      vtkWarningWithObjectMacro(pass,
        "Depth maps have " << largest << " texels along an edge, not " << this->Wanted
                           << ": this OpenGL allows no more.");
    }
    pass->MapSize = std::min(this->Wanted, largest);
  }
  ~ScopedMapSize() { this->Pass->MapSize = this->Wanted; }
  ScopedMapSize(const ScopedMapSize&) = delete;
  void operator=(const ScopedMapSize&) = delete;

private:
  vtkSoftShadowPass* Pass;
  int Wanted;
};

//------------------------------------------------------------------------------
vtkSoftShadowPass::vtkSoftShadowPass()
  : Impl(new Internals(this))
{
}

//------------------------------------------------------------------------------
vtkSoftShadowPass::~vtkSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
  this->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::ReleaseBeforeDestruction()
{
  this->Impl->Watch.Free();
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  Internals& impl = *this->Impl;
  vtkOpenGLRenderWindow* window = GetWindow(s);
  impl.Watch.Enter(window); // one pass for two windows: nothing can move from one to the other
  const ScopedMapSize mapSize(this);
  impl.Renderer = s->GetRenderer();
  vtkSoftShadowRendererDuties::UpdateStereo(s->GetRenderer());
  impl.Hooks.Stage = VTK_SOFT_SHADOW_STAGE_SHADE;
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, impl.Viewport);
  this->CollectLights(s);

  // Picking draws ids, not light.
  const bool shadows =
    !s->GetRenderer()->GetSelector() && impl.Viewport[2] > 0 && impl.Viewport[3] > 0;
  if (!shadows)
  {
    impl.Hooks.Layers.assign(impl.Lights.size(), -1);
  }
  // Props without property keys get empty ones, as from VTK's own passes. They stay: to take them away
  // again would tell everyone, in every frame, that the prop has changed.
  this->PreRender(s);
  if (shadows)
  {
    ++impl.Statistics.Frames;
    impl.Timers.BeginFrame();
    this->UpdateVisibility(s);
    impl.Timers.BeginStep("shading");
  }
  this->Shade(s);
  if (shadows && impl.ShadingMappers.Contradicts(impl.ReceiverMappers))
  {
    // A prop drew another level of detail than the receivers have. Which one it will draw is not known
    // before: only now. At most one correction per frame, what is drawn over it has the same depth.
    impl.Signature.Clear();
    this->CollectLights(s);
    this->UpdateVisibility(s);
    impl.Timers.BeginStep("shading");
    this->Shade(s);
  }
  impl.Timers.EndFrame();
  this->PostRender(s);
  if (impl.HasNews)
  {
    impl.HasNews = false;
    this->InvokeEvent(ConvergedEvent);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::CollectLights(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  impl.Lights.clear();
  impl.Hooks.Layers.clear();
  impl.Hooks.Attenuations.clear();
  vtkLightCollection* lights = s->GetRenderer()->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  const int mostLayers = vtkShadowLimits::GetTextureLayers();
  int layers = 0;
  int firstWithout = -1;
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (!light->GetSwitch())
    {
      continue; // mappers number lit lights only
    }
    Internals::LitLight lit;
    lit.Light = light;
    lit.Casts = vtkShadowEmitter::FromLight(light, lit.Emitter, lit.Reason);
    if (lit.Casts && layers == mostLayers)
    {
      lit.Casts = false;
      firstWithout = firstWithout < 0 ? static_cast<int>(impl.Lights.size()) : firstWithout;
      lit.Reason =
        "this OpenGL has no more than " + std::to_string(layers) + " layers of a texture";
    }
    lit.Layer = lit.Casts ? layers++ : -1;
    impl.Hooks.Layers.push_back(lit.Layer);
    impl.Hooks.Attenuations.push_back(
      std::min(std::max(0.0f, light->GetShadowAttenuation()), 1.0f));
    impl.Lights.push_back(lit);
  }
  impl.Statistics.LightsLit = static_cast<int>(impl.Lights.size());
  impl.Statistics.LightsCasting = layers;
  if (firstWithout >= 0 && !impl.ToldLayers)
  {
    vtkWarningMacro("Light " << firstWithout << " is shown without shadows: "
                             << impl.Lights[firstWithout].Reason << ".");
  }
  impl.ToldLayers = firstWithout >= 0;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::DrawOpaque(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = vtkSoftShadowRendererDuties::DrawOpaque(s);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::UpdateVisibility(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  impl.Timers.BeginStep("casters", true);
  impl.Casters->Update(s->GetRenderer());
  const vtkShadowMapFitter fitter(impl.Casters->GetBodies());
  for (Internals::LitLight& light : impl.Lights)
  {
    light.Emitter = light.Casts ? fitter.SeeFromAfar(light.Emitter) : light.Emitter;
  }
  const bool anew = this->WantsVisibilityAnew();
  const bool changed = this->SignatureChanged(s) || impl.Losses.IsRetryDue();
  const bool begun = impl.Schedule.IsStarted() || impl.Schedule.IsEnded();
  if (changed || (anew && !begun))
  {
    this->EstimateVisibility(s, changed);
  }
  else if (this->GetRefining())
  {
    const vtkSoftShadowScopedState scope(GetWindow(s));
    impl.Hooks.VisibilityUnit = scope.GetFreeUnit(); // as for an estimate
    impl.Timers.BeginStep("refinement");
    this->Refine(s);
  }
  this->HideLostLights();
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::EstimateVisibility(const vtkRenderState* s, bool changed)
{
  Internals& impl = *this->Impl;
  vtkOpenGLRenderWindow* window = GetWindow(s);
  if (impl.Losses.HasAny())
  {
    // Nothing half made stays, and what is held may be what there was no memory for.
    impl.Watch.Free();
    impl.Watch.Enter(window);
  }
  impl.Schedule.Reset();
  impl.Refinements = 0;
  impl.Data.IsKnown = false;
  if (!impl.Data.IsWanted)
  {
    impl.ReleaseData(GetWindow(s)); // nobody reads it any more
  }
  impl.Data.IsWanted = false;
  impl.HasNews = false; // of a mean that is thrown away
  if (!this->Progressive)
  {
    this->ReleaseProgress(window);
  }
  const vtkSoftShadowScopedState scope(window);
  // The mappers' programs sample the visibility. Where they bake or draw receivers it is not read, but
  // its sampler must not share a unit with a sampler of another type: OpenGL draws nothing then.
  impl.Hooks.VisibilityUnit = scope.GetFreeUnit();
  impl.Losses.Begin(impl.Statistics.LightsCasting);
  impl.Timers.BeginStep("maps");
  this->BakeMaps(s);
  impl.Timers.BeginStep("receivers");
  const bool received = this->DrawReceivers(s);
  impl.Timers.BeginStep("visibility");
  impl.Statistics.TechniqueCounts.clear();
  if (received)
  {
    this->EstimateLights(s, changed);
  }
  this->WarnOfLosses();
  impl.Losses.End();
  impl.Signature.Swap(impl.NextSignature);
  ++impl.Statistics.VisibilityFrames;
}

//------------------------------------------------------------------------------
// A light without a layer reaches every surface.
void vtkSoftShadowPass::HideLostLights()
{
  Internals& impl = *this->Impl;
  for (size_t i = 0; i < impl.Lights.size(); ++i)
  {
    const std::string& reason = impl.Losses.GetReason(impl.Lights[i].Layer);
    if (!reason.empty())
    {
      impl.Lights[i].Casts = false;
      impl.Lights[i].Reason = reason;
      impl.Lights[i].Layer = impl.Hooks.Layers[i] = -1;
    }
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::WarnOfLosses()
{
  Internals& impl = *this->Impl;
  std::vector<int> numbers;
  for (size_t i = 0; i < impl.Lights.size(); ++i)
  {
    if (impl.Lights[i].Casts)
    {
      numbers.push_back(static_cast<int>(i));
    }
  }
  const std::string news = impl.Losses.TakeNews(numbers);
  if (!news.empty())
  {
    vtkWarningMacro(<< news);
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::SignatureChanged(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  vtkSoftShadowSignature& next = impl.NextSignature;
  next.Clear();
  next.Add(static_cast<vtkTypeUInt64>(reinterpret_cast<std::uintptr_t>(s->GetRenderer())));
  next.Add(static_cast<vtkTypeUInt64>(this->GetMTime()));
  next.Add(static_cast<vtkTypeUInt64>(impl.Casters->GetBodiesTime()));
  next.Add(static_cast<vtkTypeUInt64>(impl.Casters->GetLooksTime()));
  next.Add(static_cast<vtkTypeUInt64>(impl.Viewport[2]));
  next.Add(static_cast<vtkTypeUInt64>(impl.Viewport[3]));
  next.AddCamera(s->GetRenderer());
  for (const Internals::LitLight& light : impl.Lights)
  {
    next.Add(static_cast<vtkTypeUInt64>(light.Casts));
    next.AddEmitter(light.Emitter);
  }
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    next.AddProp(s->GetPropArray()[i]);
  }
  return !(impl.Signature == next);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::BakeMaps(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  const vtkShadowMapFitter fitter(impl.Casters->GetBodies());
  const bool proves = this->EarlyOut && this->GetProof() != PROVES_NOTHING;
  const bool pyramid = proves || this->NeedsPyramid();
  const int split = this->CutsLights() ? this->Split : 1;
  const bool faceMaps = pyramid || (split == 1 && this->NeedsEmitterMap());
  int tooNear = 0;
  for (const Internals::LitLight& light : impl.Lights)
  {
    if (!light.Casts)
    {
      continue;
    }
    const size_t layer = static_cast<size_t>(light.Layer);
    if (layer >= impl.Maps.size())
    {
      impl.Maps.push_back(std::make_unique<vtkSoftShadowLightMaps>());
    }
    vtkSoftShadowLightMaps& maps = *impl.Maps[layer];
    const vtkShadowFailures failures;
    maps.Fit(
      light.Emitter, fitter, impl.Casters->GetBodiesTime(), split, this->HasGaussianWeights());
    tooNear += maps.GetNumberTooNear();
    if (faceMaps)
    {
      const int baked = maps.BakeFaces(s->GetRenderer(), impl.Casters, this->GetLimitedMapSize(),
        this->NeedsConservativeMaps(), pyramid);
      this->CountBakes(baked);
    }
    impl.Losses.Lose(light.Layer, failures.GetFirst());
  }
  if (tooNear > 0 && !impl.WarnedOfRange)
  {
    impl.WarnedOfRange = true;
    vtkWarningMacro("Some shadows near lights are lost:\n" << this->GetLightReport());
  }
}

//------------------------------------------------------------------------------
int vtkSoftShadowPass::GetLimitedMapSize() const
{
  return std::min(this->GetEmitterMapSize(), vtkShadowLimits::GetTextureSize());
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::CountBakes(int maps)
{
  const vtkTypeInt64 size = this->GetLimitedMapSize();
  this->Impl->Statistics.MapsBaked += maps;
  this->Impl->Statistics.TexelsDrawn += maps * size * size;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::DrawReceivers(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  impl.Hooks.Smooth = this->SmoothTerminator;
  impl.Hooks.Casters = impl.Casters;
  impl.Receivers->SetSmooth(this->SmoothTerminator);
  const vtkShadowFailures failures;
  if (!HasTextureUnit(GetWindow(s)))
  {
    impl.Losses.LoseAll("no texture unit is left");
    return false;
  }
  const int made = impl.Receivers->Begin(s->GetRenderer(), impl.Viewport[2], impl.Viewport[3]);
  if (made < 0)
  {
    impl.Receivers->End(s->GetRenderer());
    impl.Losses.LoseAll(failures.GetFirst());
    return false;
  }
  impl.Statistics.Allocations += made;
  impl.Hooks.Stage = VTK_SOFT_SHADOW_STAGE_RECEIVE;
  impl.Hooks.SetCamera(s->GetRenderer());
  impl.ReceiverMappers.Clear();
  impl.Drawn = &impl.ReceiverMappers;
  this->DrawOpaque(s);
  impl.Drawn = nullptr;
  impl.Hooks.Stage = VTK_SOFT_SHADOW_STAGE_SHADE;
  impl.Receivers->End(s->GetRenderer());
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::Shade(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  impl.Hooks.Origin[0] = impl.Viewport[0];
  impl.Hooks.Origin[1] = impl.Viewport[1];
  vtkShadowTextureArray* visibility = impl.Target->GetTexture();
  const vtkOpenGLState::ScopedglActiveTexture activeTexture(GetWindow(s)->GetState());
  impl.Hooks.VisibilityUnit = visibility->Activate(GetWindow(s));
  impl.ShadingMappers.Clear();
  impl.Drawn = &impl.ShadingMappers;
  if (this->DelegatePass && !s->GetRenderer()->GetSelector())
  {
    this->DelegatePass->Render(s);
    this->NumberOfRenderedProps = this->DelegatePass->GetNumberOfRenderedProps();
  }
  else
  {
    this->DrawOpaque(s);
  }
  impl.Drawn = nullptr;
  visibility->Deactivate();
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::PreReplaceShaderValues(std::string& vertexShader, std::string&,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  ++this->Impl->Statistics.MapperShaderBuilds;
  this->Impl->Hooks.PreReplace(vertexShader, fragmentShader, prop);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  const std::string problem =
    vtkSoftShadowMapperHooks::PostReplace(vertexShader, geometryShader, fragmentShader);
  const std::string name = mapper ? mapper->GetClassName() : "a mapper";
  if (!problem.empty() && this->Impl->ToldMappers.insert(name).second)
  {
    vtkWarningMacro("No shadow falls on what " << name << " draws: " << problem << ".");
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (this->Impl->Drawn)
  {
    this->Impl->Drawn->Add(prop, mapper);
  }
  this->Impl->Hooks.SetUniforms(program, prop);
  return true;
}

//------------------------------------------------------------------------------
vtkSoftShadowStatistics& vtkSoftShadowPass::ChangeStatistics()
{
  return this->Impl->Statistics;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Impl->Watch.GetWindow())
  {
    // Whichever window is meant: comes here again, in the context of the one that all lies in.
    // Techniques come here first, and find nothing left to free afterwards.
    this->Impl->Watch.Free();
  }
  this->Superclass::ReleaseGraphicsResources(window);
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
  Internals& impl = *this->Impl;
  impl.Casters->ReleaseGraphicsResources(window);
  impl.Receivers->ReleaseGraphicsResources(window);
  impl.Target->ReleaseGraphicsResources(window);
  impl.Timers.ReleaseGraphicsResources();
  impl.ProofShader.ReleaseGraphicsResources(window);
  impl.ConstantShader.ReleaseGraphicsResources(window);
  impl.PointShader.ReleaseGraphicsResources(window);
  impl.Accumulator->ReleaseGraphicsResources(window);
  impl.PointMaps->ReleaseGraphicsResources(window);
  impl.Schedule.Reset();
  impl.ReleaseData(window);
  for (const auto& maps : impl.Maps)
  {
    maps->ReleaseGraphicsResources(window);
  }
  if (!impl.Queries.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(impl.Queries.size()), impl.Queries.data());
    impl.Queries.clear();
    impl.UsedQueries = 0;
  }
  impl.Signature.Clear();
  impl.Losses.Clear();
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "Split: " << this->Split << "\n";
  os << indent << "EarlyOut: " << (this->EarlyOut ? "on" : "off") << "\n";
  os << indent << "MapMemory: " << this->MapMemory << " MiB\n";
  os << indent << "Progressive: " << (this->Progressive ? "on" : "off") << "\n";
  os << indent << "ProgressiveTolerance: " << this->ProgressiveTolerance << "\n";
  os << indent << "ProgressivePoints: " << this->ProgressivePoints << "\n";
  os << indent << "SmoothTerminator: " << (this->SmoothTerminator ? "on" : "off") << "\n";
  os << indent << "DelegatePass: " << this->DelegatePass << "\n";
}
VTK_ABI_NAMESPACE_END
