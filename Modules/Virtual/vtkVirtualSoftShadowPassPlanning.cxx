// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkVirtualSoftShadowPass asks the GPU for, and the tiles that it plans and draws from it.
#include "vtkVirtualSoftShadowPassInternals.h"

#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowReceivers.h"

#include <algorithm>
#include <sstream>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// What a tile costs for every pixel of the screen, in texels.
constexpr double TexelsPerPixel = 6.0;
// At most, so that large windows do not cost memory.
constexpr double DearestTile = 1024.0 * 1024.0;
} // namespace

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::BeginVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  impl.State += context.Changed ? 1 : 0;
  impl.IsOwed = context.IsData && (impl.IsOwed || impl.Late > 0);
  impl.Waits = impl.Late = 0;
  impl.IsRequested = false;
  for (size_t i = impl.Prepared.size(); i < impl.Screens.size(); ++i)
  {
    impl.Screens[i]->ReleaseGraphicsResources(context.Window);
  }
  impl.Screens.resize(std::min(impl.Prepared.size(), impl.Screens.size()));
  impl.Prepared.clear();
  impl.PreparedViews.clear();
  for (auto iterator = impl.Emitters.begin(); iterator != impl.Emitters.end();)
  {
    vtkVirtualEmitterState& emitter = iterator->second;
    if (emitter.IsShown)
    {
      emitter.IsShown = false;
      ++iterator;
    }
    else
    {
      emitter.Maps.ReleaseGraphicsResources(context.Window);
      emitter.Request.ReleaseGraphicsResources();
      iterator = impl.Emitters.erase(iterator);
    }
  }
  return this->Adaptive;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::PrepareVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  const size_t index = impl.Prepared.size();
  const vtkTypeInt64 bytes = vtkVirtualScreen::CountShapeBytes(
    context.Receivers->GetWidth(), context.Receivers->GetHeight());
  const vtkTypeInt64 most = static_cast<vtkTypeInt64>(this->MapMemory) << 18; // a quarter of it
  if (index > 0 && bytes * static_cast<vtkTypeInt64>(index + 1) > most)
  {
    return;
  }
  if (index == impl.Screens.size())
  {
    impl.Screens.push_back(std::make_unique<vtkVirtualScreen>());
  }
  const vtkVirtualScopedTarget target(context.Window->GetState());
  vtkVirtualEmitterState& emitter = impl.Emitters[Internals::Key(context.Light, context.Part)];
  if (this->TakeShapes(context, emitter, *impl.Screens[index]))
  {
    impl.Prepared.push_back(&emitter);
    impl.PreparedViews.push_back(Internals::GetView(context));
  }
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::TakeShapes(
  const vtkSoftShadowContext& context, vtkVirtualEmitterState& emitter, vtkVirtualScreen& screen)
{
  Internals& impl = *this->Impl;
  emitter.IsShown = true;
  if (emitter.Screen == &screen && emitter.ShapesState == impl.State && &screen != &impl.Spare)
  {
    return true; // nothing changed
  }
  if (context.Changed)
  {
    emitter.IsStatic = emitter.Emitter == context.Emitter &&
      emitter.CastersTime == context.Casters->GetCastersTime();
    emitter.Emitter = context.Emitter;
    emitter.CastersTime = context.Casters->GetCastersTime();
  }
  emitter.Screen = &screen;
  emitter.ShapesState = impl.State;
  this->BeginStep("kernel shapes");
  return screen.AllocateShapes(
           context.Window, context.Receivers->GetWidth(), context.Receivers->GetHeight()) &&
    this->DrawShapes(context, emitter);
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::RequestTiles(const vtkSoftShadowContext& context,
  const std::vector<vtkVirtualEmitterState*>& emitters, const std::vector<vtkShadowMapView>& views)
{
  Internals& impl = *this->Impl;
  std::vector<size_t> asked;
  std::vector<vtkVirtualRequest*> awaited;
  for (size_t i = 0; i < emitters.size(); ++i)
  {
    vtkVirtualRequest& request = emitters[i]->Request;
    if (this->GridLatency > 0 && request.Collect())
    {
      this->LookBack(*emitters[i]);
    }
    const bool serves = !context.IsData && this->GridLatency > 0 && request.Serves(views[i]);
    if (serves && request.IsOf(impl.State))
    {
      continue;
    }
    if (!serves)
    {
      awaited.push_back(&request);
    }
    if (!serves || !request.IsUnderWay())
    {
      asked.push_back(i);
    }
  }
  if (!asked.empty() && !impl.Grid.Begin(context.Window))
  {
    return false;
  }
  for (const size_t i : asked)
  {
    if (!impl.Grid.Draw(context.Window, *emitters[i]->Screen))
    {
      return false;
    }
    emitters[i]->Request.Start(context.Window, impl.Grid.GetCells(), views[i], impl.State);
  }
  // Once the last one has come, all have.
  impl.Waits += awaited.empty() ? 0 : 1;
  for (size_t i = awaited.size(); i > 0; --i)
  {
    awaited[i - 1]->Wait();
  }
  for (vtkVirtualEmitterState* emitter : emitters)
  {
    emitter->IsLate = !emitter->Request.IsOf(impl.State);
    impl.Late += emitter->IsLate ? 1 : 0;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::LookBack(const vtkVirtualEmitterState& emitter)
{
  if (emitter.IsLate)
  {
    // What the last frame asked for is known now; its tiles are still there.
    this->Impl->Excess = emitter.Tree.GetExcess(emitter.Request.GetWishes().front());
  }
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::WantsVisibilityAnew()
{
  const Internals& impl = *this->Impl;
  return this->Adaptive && this->GridLatency > 0 &&
    (impl.IsOwed ||
      std::any_of(impl.Emitters.begin(), impl.Emitters.end(),
        [](const std::pair<const Internals::Key, vtkVirtualEmitterState>& emitter)
        {
          return emitter.second.IsShown && emitter.second.IsLate &&
            emitter.second.Request.HasArrived();
        }));
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::PlanTiles(const vtkSoftShadowContext& context, double mostTexels)
{
  Internals& impl = *this->Impl;
  vtkVirtualTileTree::Limits limits;
  limits.LargestTile = this->MapSize;
  limits.MostTexels = mostTexels;
  limits.MostTiles = std::min(this->MaximumTiles, vtkShadowLimits::GetTextureLayers());
  // Measured with a software rasteriser: a look at a pixel in vain takes as long as a few texels.
  const double pixels =
    static_cast<double>(context.Receivers->GetWidth()) * context.Receivers->GetHeight();
  limits.TileCost = std::min(std::max(limits.TileCost, TexelsPerPixel * pixels), DearestTile);
  if (this->Adaptive)
  {
    const vtkVirtualTileTree::Pyramid& wishes = impl.Current->Request.GetWishes();
    if (impl.Current->IsLate)
    {
      // No tile may be missing, and none be coarser than the map that blockers are searched in.
      const float coarsest = 1.0f / static_cast<float>(this->SearchMapSize);
      impl.Current->Tree.Build(
        vtkVirtualTileTree::MakePyramid(vtkVirtualTileTree::Widen(wishes.front(), coarsest)),
        limits);
    }
    else
    {
      impl.Current->Tree.Build(wishes, limits);
    }
  }
  else
  {
    impl.Current->Tree.BuildUniform(1 << this->FixedLevels, limits);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::BakeTiles(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  vtkVirtualEmitterState& emitter = *impl.Current;
  double mostTexels = this->MapMemory * (1048576.0 / 4.0);
  vtkVirtualTileMaps::Work work;
  std::string reason;
  do
  {
    const vtkShadowFailures attempt;
    this->PlanTiles(context, mostTexels);
    work = emitter.Maps.Update(context.Renderer, context.Casters, Internals::GetView(context),
      emitter.Tree.GetTiles(), vtkVirtualTileTree::GridSize);
    impl.DrawCalls += work.DrawCalls;
    this->ChangeStatistics().MapsBaked += work.Maps;
    this->ChangeStatistics().TexelsDrawn += work.Texels;
    // A driver may have less than was allowed: everything becomes coarser.
    mostTexels = 0.25 * emitter.Tree.GetTexels();
    reason = attempt.GetFirst();
  } while (work.Failed && mostTexels > 65536.0);
  if (work.Failed)
  {
    vtkShadowFailures::Report(reason);
  }
}

//------------------------------------------------------------------------------
int vtkVirtualSoftShadowPass::GetNumberOfTiles() const
{
  size_t tiles = 0;
  for (const auto& emitter : this->Impl->Emitters)
  {
    tiles += emitter.second.IsShown ? emitter.second.Tree.GetTiles().size() : 0;
  }
  return static_cast<int>(tiles);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualSoftShadowPass::GetTileTexels() const
{
  double texels = 0.0;
  for (const auto& emitter : this->Impl->Emitters)
  {
    texels += emitter.second.IsShown ? emitter.second.Tree.GetTexels() : 0.0;
  }
  return static_cast<vtkTypeInt64>(texels);
}

//------------------------------------------------------------------------------
double vtkVirtualSoftShadowPass::GetCoarsening() const
{
  double coarsening = 1.0;
  for (const auto& emitter : this->Impl->Emitters)
  {
    if (emitter.second.IsShown)
    {
      coarsening = std::max(coarsening, emitter.second.Tree.GetCoarsening());
    }
  }
  return coarsening;
}

//------------------------------------------------------------------------------
double vtkVirtualSoftShadowPass::GetLatencyExcess() const
{
  return this->Impl->Excess;
}

//------------------------------------------------------------------------------
std::string vtkVirtualSoftShadowPass::GetTileReport() const
{
  std::ostringstream report;
  for (const auto& emitter : this->Impl->Emitters)
  {
    if (!emitter.second.IsShown)
    {
      continue;
    }
    const vtkVirtualTileTree& tree = emitter.second.Tree;
    report << "light " << emitter.first.first << " part " << emitter.first.second << ": "
           << tree.GetTiles().size() << " tiles, " << static_cast<vtkTypeInt64>(tree.GetTexels())
           << " texels, coarser than predicted by " << tree.GetCoarsening() << "\n";
    for (const vtkVirtualTile& tile : tree.GetTiles())
    {
      report << "  cells " << tile.X << " " << tile.Y << " size " << tile.Width << " x "
             << tile.Height << ": " << tile.Resolution << "\n";
    }
  }
  return report.str();
}
VTK_ABI_NAMESPACE_END
