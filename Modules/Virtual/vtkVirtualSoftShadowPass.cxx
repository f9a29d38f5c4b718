// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkVirtualSoftShadowPassInternals.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkVirtualSoftShadowPass);

//------------------------------------------------------------------------------
vtkVirtualSoftShadowPass::vtkVirtualSoftShadowPass()
  : Impl(new Internals)
{
  this->MapSize = 4096;
}

//------------------------------------------------------------------------------
vtkVirtualSoftShadowPass::~vtkVirtualSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  vtkVirtualEmitterState& emitter = impl.Emitters[Internals::Key(context.Light, context.Part)];
  impl.Current = &emitter;
  {
    const vtkVirtualScopedTarget target(context.Window->GetState());
    if (!this->RequestEmitter(context, emitter))
    {
      return;
    }
    this->BeginStep("tile maps");
    this->BakeTiles(context);
    this->BeginStep("filtering");
    this->DrawTiles(context);
  }
  this->ChangeStatistics().TechniqueCounts = { { "tiles", this->GetNumberOfTiles() },
    { "tile_kilotexels", this->GetTileTexels() / 1000 }, { "grid_waits", impl.Waits },
    { "late_grids", impl.Late } };
  this->Resolve(context);
  this->BeginStep("visibility");
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::RequestEmitter(
  const vtkSoftShadowContext& context, vtkVirtualEmitterState& emitter)
{
  Internals& impl = *this->Impl;
  const bool isPrepared =
    std::find(impl.Prepared.begin(), impl.Prepared.end(), &emitter) != impl.Prepared.end();
  if (!isPrepared && !this->TakeShapes(context, emitter, impl.Spare))
  {
    return false;
  }
  this->BeginStep("tile planning");
  bool done = true;
  if (this->Adaptive && !isPrepared)
  {
    done = this->RequestTiles(context, { &emitter }, { Internals::GetView(context) });
  }
  else if (this->Adaptive && !impl.IsRequested)
  {
    impl.IsRequested = true;
    done = this->RequestTiles(context, impl.Prepared, impl.PreparedViews);
  }
  return done && (!this->Adaptive || !emitter.Request.GetWishes().empty());
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualSoftShadowPass::GetTechniqueBytes()
{
  const Internals& impl = *this->Impl;
  vtkTypeInt64 bytes = impl.Spare.GetBytes() + impl.Sums.GetBytes() + impl.Grid.GetBytes() +
    impl.TileShader->GetBytes();
  for (const auto& screen : impl.Screens)
  {
    bytes += screen->GetBytes();
  }
  for (const auto& emitter : impl.Emitters)
  {
    bytes += emitter.second.Maps.GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualSoftShadowPass::GetTechniqueDrawCalls()
{
  return this->Impl->DrawCalls;
}

//------------------------------------------------------------------------------
int vtkVirtualSoftShadowPass::GetTechniqueShaderBuilds()
{
  const Internals& impl = *this->Impl;
  return impl.ShapeShader->GetNumberOfBuilds() + impl.TileShader->GetNumberOfBuilds() +
    impl.ResolveShader->GetNumberOfBuilds() + impl.Grid.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  impl.ShapeShader->ReleaseGraphicsResources(window);
  impl.TileShader->ReleaseGraphicsResources(window);
  impl.ResolveShader->ReleaseGraphicsResources(window);
  for (auto& screen : impl.Screens)
  {
    screen->ReleaseGraphicsResources(window);
  }
  impl.Screens.clear();
  impl.Prepared.clear();
  impl.PreparedViews.clear();
  impl.Spare.ReleaseGraphicsResources(window);
  impl.Sums.ReleaseGraphicsResources(window);
  impl.Grid.ReleaseGraphicsResources(window);
  for (auto& emitter : impl.Emitters)
  {
    emitter.second.Maps.ReleaseGraphicsResources(window);
    emitter.second.Request.ReleaseGraphicsResources();
  }
  impl.Emitters.clear();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const metrics[] = { "dynamic", "static", "automatic" };
  const char* const views[] = { "none", "tiles", "resolution", "kernel" };
  os << indent << "SearchMapSize: " << this->SearchMapSize << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "on" : "off") << "\n";
  os << indent << "FixedLevels: " << this->FixedLevels << "\n";
  os << indent << "Antialiasing: " << (this->Antialiasing ? "on" : "off") << "\n";
  os << indent << "Metric: " << metrics[this->Metric] << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "SearchWidth: " << this->SearchWidth << "\n";
  os << indent << "GridLatency: " << this->GridLatency << "\n";
  os << indent << "MaximumTiles: " << this->MaximumTiles << "\n";
  os << indent << "DebugView: " << views[this->DebugView] << "\n";
}
VTK_ABI_NAMESPACE_END
