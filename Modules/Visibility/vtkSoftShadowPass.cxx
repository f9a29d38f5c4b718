// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowPass.h"

#include "vtkAbstractMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkShadowContextWatch.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowTextureArray.h"
#include "vtkShadowTextureUnit.h"
#include "vtkSoftShadowDrawnMappers.h"
#include "vtkSoftShadowImages.h"
#include "vtkSoftShadowMapperHooks.h"
#include "vtkSoftShadowRendererDuties.h"
#include "vtkSoftShadowScopedState.h"
#include "vtkSoftShadowSignature.h"
#include "vtkSoftShadowVisibilities.h"
#include "vtkSoftShadowsOpenGL.h"

#include <set>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

vtkOpenGLRenderWindow* GetWindow(const vtkRenderState* s)
{
  return static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
}

} // namespace

vtkCxxSetObjectMacro(vtkSoftShadowPass, DelegatePass, vtkRenderPass);

//------------------------------------------------------------------------------
// What a pass keeps from frame to frame.
class vtkSoftShadowPass::Internals
{
public:
  explicit Internals(vtkSoftShadowPass* pass)
    : Watch([pass](vtkOpenGLRenderWindow* window) { pass->ReleaseGraphicsResources(window); })
    , Visibilities(*pass)
  {
  }

  /// Of the window whose context holds the resources.
  vtkShadowContextWatch Watch;

  static vtkSoftShadowVisibilities::Settings GetSettings(const vtkSoftShadowPass* pass);

  // What is read back lies in the window of the last frame, whichever has rendered or died since.
  void MakeCurrent()
  {
    if (this->Watch.GetWindow())
    {
      this->Watch.GetWindow()->MakeCurrent();
    }
  }

  vtkSoftShadowVisibilities Visibilities;
  vtkSoftShadowMapperHooks Hooks;
  vtkSoftShadowDrawnMappers ReceiverMappers; // of the visibility that is held
  vtkSoftShadowDrawnMappers ShadingMappers;
  vtkSoftShadowDrawnMappers* Drawn = nullptr; // one of them while it is drawn
  vtkSoftShadowSignature Signature;           // of the visibility that is held
  vtkSoftShadowSignature NextSignature;       // of the frame at hand
  int Viewport[4] = { 0, 0, 0, 0 };
  std::set<std::string> ToldMappers; // whose programs take no shadows
  bool WarnedOfRange = false;
};

//------------------------------------------------------------------------------
vtkSoftShadowPass::vtkSoftShadowPass()
  : Impl(new Internals(this))
{
}

//------------------------------------------------------------------------------
vtkSoftShadowPass::~vtkSoftShadowPass()
{
  this->Impl->Watch.Free();
  this->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  Internals& impl = *this->Impl;
  vtkOpenGLRenderWindow* window = GetWindow(s);
  impl.Watch.Enter(window); // one pass for two windows: nothing can move from one to the other
  this->Warn({ impl.Visibilities.Begin(s->GetRenderer(), Internals::GetSettings(this)) });
  vtkSoftShadowRendererDuties::UpdateStereo(s->GetRenderer());
  impl.Hooks.Stage = VTK_SOFT_SHADOW_STAGE_SHADE;
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, impl.Viewport);
  this->CollectLights(s);

  // Picking draws ids, not light.
  const bool shadows =
    !s->GetRenderer()->GetSelector() && impl.Viewport[2] > 0 && impl.Viewport[3] > 0;
  if (!shadows)
  {
    impl.Hooks.Layers.assign(impl.Visibilities.GetLights().GetNumberOfLights(), -1);
  }
  // Props without property keys get empty ones, as from VTK's own passes. They stay: to take them away
  // again would tell everyone, in every frame, that the prop has changed.
  this->PreRender(s);
  if (shadows)
  {
    ++impl.Visibilities.GetStatistics().Frames;
    impl.Visibilities.GetTimers().BeginFrame();
    this->UpdateVisibility(s);
    impl.Visibilities.GetTimers().BeginStep("shading");
  }
  this->Shade(s);
  if (shadows && impl.ShadingMappers.Contradicts(impl.ReceiverMappers))
  {
    // A prop drew another level of detail than the receivers have. Which one it will draw is not known
    // before: only now. At most one correction per frame, what is drawn over it has the same depth.
    impl.Signature.Clear();
    this->CollectLights(s);
    this->UpdateVisibility(s);
    impl.Visibilities.GetTimers().BeginStep("shading");
    this->Shade(s);
  }
  impl.Visibilities.GetTimers().EndFrame();
  this->PostRender(s);
  if (impl.Visibilities.TakeNews())
  {
    this->InvokeEvent(ConvergedEvent);
  }
}

//------------------------------------------------------------------------------
vtkSoftShadowVisibilities::Settings vtkSoftShadowPass::Internals::GetSettings(
  const vtkSoftShadowPass* pass)
{
  vtkSoftShadowVisibilities::Settings settings;
  settings.MapSize = pass->MapSize;
  settings.Split = pass->Split;
  settings.EarlyOut = pass->EarlyOut;
  settings.MapMemory = static_cast<vtkTypeInt64>(pass->MapMemory) << 20;
  settings.Points = pass->ProgressivePoints;
  settings.Tolerance = pass->ProgressiveTolerance;
  settings.Progressive = pass->Progressive;
  return settings;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::CollectLights(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  const std::string news = impl.Visibilities.GetLights().Collect(s->GetRenderer());
  impl.Hooks.SetLights(impl.Visibilities.GetLights());
  impl.Visibilities.GetStatistics().LightsLit = impl.Visibilities.GetLights().GetNumberOfLights();
  impl.Visibilities.GetStatistics().LightsCasting =
    impl.Visibilities.GetLights().GetNumberOfCasting();
  this->Warn({ news });
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
  vtkSoftShadowVisibilities& visibilities = impl.Visibilities;
  visibilities.GetTimers().BeginStep("casters", true);
  visibilities.GetCasters()->Update(s->GetRenderer());
  visibilities.GetLights().SeeFromAfar(vtkShadowMapFitter(visibilities.GetCasters()->GetBodies()));
  const bool anew = this->WantsVisibilityAnew();
  const bool changed = this->SignatureChanged(s) || visibilities.GetLosses().IsRetryDue();
  const vtkSoftShadowSchedule& schedule = visibilities.GetSchedule();
  const bool begun = schedule.IsStarted() || schedule.IsEnded();
  if (changed || (anew && !begun))
  {
    this->EstimateVisibility(s, changed);
  }
  else if (this->GetRefining())
  {
    const vtkSoftShadowScopedState scope(GetWindow(s));
    impl.Hooks.VisibilityUnit = scope.GetFreeUnit(); // as for an estimate
    visibilities.GetTimers().BeginStep("refinement");
    this->Warn(visibilities.Refine());
  }
  visibilities.GetLights().Hide(visibilities.GetLosses());
  impl.Hooks.SetLights(visibilities.GetLights());
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::EstimateVisibility(const vtkRenderState* s, bool changed)
{
  Internals& impl = *this->Impl;
  vtkSoftShadowVisibilities& visibilities = impl.Visibilities;
  vtkOpenGLRenderWindow* window = GetWindow(s);
  if (visibilities.GetLosses().HasAny())
  {
    // Nothing half made stays, and what is held may be what there was no memory for.
    impl.Watch.Free();
    impl.Watch.Enter(window);
  }
  visibilities.Restart(window);
  const vtkSoftShadowScopedState scope(window);
  // The mappers' programs sample the visibility. Where they bake or draw receivers it is not read, but
  // its sampler must not share a unit with a sampler of another type: OpenGL draws nothing then.
  impl.Hooks.VisibilityUnit = scope.GetFreeUnit();
  vtkSoftShadowTimers& timers = visibilities.GetTimers();
  timers.BeginStep("maps");
  if (visibilities.FitViews() > 0 && !impl.WarnedOfRange)
  {
    impl.WarnedOfRange = true;
    vtkWarningMacro("Some shadows near lights are lost:\n" << this->GetLightReport());
  }
  timers.BeginStep("receivers");
  const bool received = this->DrawReceivers(s);
  timers.BeginStep("visibility");
  if (received)
  {
    visibilities.Estimate(changed);
  }
  vtkSoftShadowLosses& losses = visibilities.GetLosses();
  this->Warn({ losses.TakeNews(visibilities.GetLights().GetNumbersByLayer()) });
  losses.End();
  impl.Signature.Swap(impl.NextSignature);
  ++visibilities.GetStatistics().VisibilityFrames;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::Warn(const std::vector<std::string>& news)
{
  for (const std::string& sentence : news)
  {
    if (!sentence.empty())
    {
      vtkWarningMacro(<< sentence);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::SignatureChanged(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  vtkSoftShadowSignature& next = impl.NextSignature;
  next.Clear();
  next.Add(static_cast<vtkTypeUInt64>(this->GetMTime()));
  next.Add(static_cast<vtkTypeUInt64>(impl.Viewport[2]));
  next.Add(static_cast<vtkTypeUInt64>(impl.Viewport[3]));
  impl.Visibilities.AddTo(next);
  next.AddState(s);
  return !(impl.Signature == next);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::DrawReceivers(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  impl.Hooks.Smooth = this->SmoothTerminator;
  impl.Hooks.Casters = impl.Visibilities.GetCasters();
  impl.Visibilities.GetReceivers()->SetSmooth(this->SmoothTerminator);
  const vtkShadowFailures failures;
  if (!vtkShadowTextureUnit::IsAnyLeft(GetWindow(s)))
  {
    impl.Visibilities.GetLosses().LoseAll("no texture unit is left");
    return false;
  }
  const int made =
    impl.Visibilities.GetReceivers()->Begin(s->GetRenderer(), impl.Viewport[2], impl.Viewport[3]);
  if (made < 0)
  {
    impl.Visibilities.GetReceivers()->End(s->GetRenderer());
    impl.Visibilities.GetLosses().LoseAll(failures.GetFirst());
    return false;
  }
  impl.Visibilities.GetStatistics().Allocations += made;
  impl.Hooks.Stage = VTK_SOFT_SHADOW_STAGE_RECEIVE;
  impl.Hooks.SetCamera(s->GetRenderer());
  impl.ReceiverMappers.Clear();
  impl.Drawn = &impl.ReceiverMappers;
  this->DrawOpaque(s);
  impl.Drawn = nullptr;
  impl.Hooks.Stage = VTK_SOFT_SHADOW_STAGE_SHADE;
  impl.Visibilities.GetReceivers()->End(s->GetRenderer());
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::Shade(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  impl.Hooks.Origin[0] = impl.Viewport[0];
  impl.Hooks.Origin[1] = impl.Viewport[1];
  vtkShadowTextureArray* visibility = impl.Visibilities.GetTexture();
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
  ++this->Impl->Visibilities.GetStatistics().MapperShaderBuilds;
  this->Impl->Hooks.PreReplace(vertexShader, fragmentShader, prop);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  std::string problem =
    vtkSoftShadowMapperHooks::PostReplace(vertexShader, geometryShader, fragmentShader);
  if (mapper && mapper->IsA("vtkSurfaceLICMapper"))
  {
    problem = "it draws its surface into buffers of its own";
  }
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
bool vtkSoftShadowPass::GetConverged() const
{
  return this->Progressive && this->Impl->Visibilities.GetSchedule().IsConverged();
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::GetRefining() const
{
  return this->Progressive && !this->Impl->Visibilities.GetSchedule().IsEnded();
}

//------------------------------------------------------------------------------
double vtkSoftShadowPass::GetEstimatedError() const
{
  return this->Impl->Visibilities.GetSchedule().GetEstimatedError();
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowPass::GetProgressReport() const
{
  return this->Progressive ? this->Impl->Visibilities.GetSchedule().Describe()
                           : "progressive mode is off";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowPass::GetVisibilityImage(vtkLight* light)
{
  return this->GetVisibilityImage(this->Impl->Visibilities.GetLights().Find(light));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowPass::GetVisibilityImage(int litLight)
{
  Internals& impl = *this->Impl;
  vtkSoftShadowVisibilities& visibilities = impl.Visibilities;
  if (litLight < 0 || litLight >= visibilities.GetLights().GetNumberOfLights())
  {
    return nullptr;
  }
  impl.MakeCurrent();
  const int layer = visibilities.GetLights().GetLight(litLight).Layer;
  const bool triangles = layer >= 0 && visibilities.NeedsTriangles(impl.Watch.GetWindow());
  if (triangles)
  {
    const vtkSoftShadowScopedState scope(impl.Watch.GetWindow());
    impl.Hooks.VisibilityUnit = scope.GetFreeUnit(); // mappers may bake, see EstimateVisibility
    this->Warn(visibilities.UpdateTriangles());
  }
  return visibilities.MakeImage(layer, triangles);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSoftShadowPass::GetDepthImage()
{
  this->Impl->MakeCurrent();
  return this->Impl->Visibilities.GetReceivers()->ReadDepth();
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::GetVisibilityImage(vtkLight* light, vtkImageData* image)
{
  return vtkSoftShadowImages::Copy(this->GetVisibilityImage(light), image);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::GetDepthImage(vtkImageData* image)
{
  return vtkSoftShadowImages::Copy(this->GetDepthImage(), image);
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkSoftShadowPass::GetVisibilityTexture()
{
  return this->Impl->Visibilities.GetTexture();
}

//------------------------------------------------------------------------------
int vtkSoftShadowPass::GetVisibilityLayer(vtkLight* light) const
{
  const int index = this->Impl->Visibilities.GetLights().Find(light);
  return index < 0 ? -1 : this->Impl->Visibilities.GetLights().GetLight(index).Layer;
}

//------------------------------------------------------------------------------
const vtkSoftShadowStatistics& vtkSoftShadowPass::GetStatistics()
{
  this->Impl->MakeCurrent();
  this->Impl->Visibilities.UpdateStatistics();
  return this->Impl->Visibilities.GetStatistics();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowPass::GetCount(const std::string& name)
{
  return this->GetStatistics().FindCount(name);
}

//------------------------------------------------------------------------------
double vtkSoftShadowPass::GetMilliseconds(const std::string& step)
{
  return this->GetStatistics().FindMilliseconds(step);
}

//------------------------------------------------------------------------------
std::string vtkSoftShadowPass::GetLightReport() const
{
  return this->Impl->Visibilities.GetLights().Describe();
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
  this->Impl->Visibilities.ReleaseGraphicsResources(window);
  this->Impl->Signature.Clear();
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
