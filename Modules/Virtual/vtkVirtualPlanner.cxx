// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualPlanner.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowScopedTarget.h"
#include "vtkSoftShadowServices.h"
#include "vtkVirtualDrawing.h"
#include "vtkVirtualEmitter.h"
#include "vtkVirtualSettings.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// What a tile costs for every pixel of the screen, in texels.
constexpr double TexelsPerPixel = 6.0;
// At most, so that large windows do not cost memory.
constexpr double DearestTile = 1024.0 * 1024.0;
// An older grid serves up to so many cells that points have moved by: each cell then takes over the
// wishes of those around it that far.
constexpr int LargestShift = 4;
} // namespace

//------------------------------------------------------------------------------
void vtkVirtualPlanner::Begin(const vtkSoftShadowServices& services)
{
  this->State += services.Changed ? 1 : 0;
  this->Owed = services.IsData && (this->Owed || this->Late > 0);
  this->Waits = this->Late = 0;
  this->IsRequested = false;
  for (size_t i = this->Prepared.size(); i < this->Screens.size(); ++i)
  {
    this->Screens[i]->ReleaseGraphicsResources(services.Window);
  }
  this->Screens.resize(std::min(this->Prepared.size(), this->Screens.size()));
  this->Prepared.clear();
  this->PreparedViews.clear();
}

//------------------------------------------------------------------------------
void vtkVirtualPlanner::Prepare(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, vtkVirtualEmitter& emitter, vtkVirtualDrawing& drawing)
{
  const size_t index = this->Prepared.size();
  const vtkTypeInt64 bytes = vtkVirtualScreen::CountShapeBytes(
    services.Receivers->GetWidth(), services.Receivers->GetHeight());
  const vtkTypeInt64 most = services.MapMemory / 4;
  if (index > 0 && bytes * static_cast<vtkTypeInt64>(index + 1) > most)
  {
    return;
  }
  if (index == this->Screens.size())
  {
    this->Screens.push_back(std::make_unique<vtkVirtualScreen>());
  }
  const vtkShadowScopedTarget target(services.Window->GetState());
  if (this->TakeShapes(services, settings, emitter, *this->Screens[index], drawing))
  {
    this->Prepared.push_back(&emitter);
    this->PreparedViews.push_back(services.GetMapView());
  }
}

//------------------------------------------------------------------------------
bool vtkVirtualPlanner::Request(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, vtkVirtualEmitter& emitter, vtkVirtualDrawing& drawing)
{
  const bool isPrepared =
    std::find(this->Prepared.begin(), this->Prepared.end(), &emitter) != this->Prepared.end();
  if (!isPrepared && !this->TakeShapes(services, settings, emitter, this->Spare, drawing))
  {
    return false;
  }
  services.BeginStep("tile planning");
  bool done = true;
  if (settings.Adaptive && !isPrepared)
  {
    done = this->RequestTiles(services, settings, { &emitter }, { services.GetMapView() });
  }
  else if (settings.Adaptive && !this->IsRequested)
  {
    this->IsRequested = true;
    done = this->RequestTiles(services, settings, this->Prepared, this->PreparedViews);
  }
  return done && (!settings.Adaptive || !emitter.Request.GetWishes().empty());
}

//------------------------------------------------------------------------------
bool vtkVirtualPlanner::TakeShapes(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, vtkVirtualEmitter& emitter, vtkVirtualScreen& screen,
  vtkVirtualDrawing& drawing)
{
  emitter.IsShown = true;
  if (emitter.Screen == &screen && emitter.ShapesState == this->State && &screen != &this->Spare)
  {
    return true; // nothing changed
  }
  if (services.Changed)
  {
    emitter.IsStatic = emitter.Emitter == services.Emitter &&
      emitter.CastersTime == services.Casters->GetCastersTime();
    emitter.Emitter = services.Emitter;
    emitter.CastersTime = services.Casters->GetCastersTime();
  }
  emitter.Screen = &screen;
  emitter.ShapesState = this->State;
  services.BeginStep("kernel shapes");
  return screen.AllocateShapes(
           services.Window, services.Receivers->GetWidth(), services.Receivers->GetHeight()) &&
    drawing.DrawShapes(services, settings, emitter);
}

//------------------------------------------------------------------------------
bool vtkVirtualPlanner::RequestTiles(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, const std::vector<vtkVirtualEmitter*>& emitters,
  const std::vector<vtkShadowMapView>& views)
{
  std::vector<size_t> asked;
  std::vector<vtkVirtualRequest*> awaited;
  for (size_t i = 0; i < emitters.size(); ++i)
  {
    vtkVirtualRequest& request = emitters[i]->Request;
    if (settings.GridLatency > 0 && request.Collect())
    {
      this->LookBack(*emitters[i]);
    }
    emitters[i]->Shift = request.GetShift(views[i]);
    const bool serves =
      !services.IsData && settings.GridLatency > 0 && emitters[i]->Shift <= LargestShift;
    if (serves && request.IsOf(this->State))
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
  if (!asked.empty() && !this->Grid.Begin(services.Window))
  {
    return false;
  }
  for (const size_t i : asked)
  {
    if (!this->Grid.Draw(services.Window, *emitters[i]->Screen))
    {
      return false;
    }
    emitters[i]->Request.Start(services.Window, this->Grid.GetCells(), views[i], this->State);
  }
  // Once the last one has come, all have.
  this->Waits += awaited.empty() ? 0 : 1;
  for (size_t i = awaited.size(); i > 0; --i)
  {
    awaited[i - 1]->Wait();
  }
  for (vtkVirtualEmitter* emitter : emitters)
  {
    emitter->IsLate = !emitter->Request.IsOf(this->State);
    this->Late += emitter->IsLate ? 1 : 0;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualPlanner::LookBack(const vtkVirtualEmitter& emitter)
{
  if (emitter.IsLate)
  {
    // What the last frame asked for is known now; its tiles are still there.
    this->Excess = emitter.Tree.GetExcess(emitter.Request.GetWishes().front());
  }
}

//------------------------------------------------------------------------------
void vtkVirtualPlanner::PlanTiles(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, vtkVirtualEmitter& emitter, double mostTexels)
{
  vtkVirtualTileTree::Limits limits;
  limits.LargestTile = services.MapSize;
  limits.MostTexels = mostTexels;
  limits.MostTiles = std::min(settings.MaximumTiles, vtkShadowLimits::GetTextureLayers());
  // Measured with a software rasteriser: a look at a pixel in vain takes as long as a few texels.
  const double pixels =
    static_cast<double>(services.Receivers->GetWidth()) * services.Receivers->GetHeight();
  limits.TileCost = std::min(std::max(limits.TileCost, TexelsPerPixel * pixels), DearestTile);
  if (settings.Adaptive)
  {
    const vtkVirtualTileTree::Pyramid& wishes = emitter.Request.GetWishes();
    if (emitter.IsLate)
    {
      // No tile may be missing, and none be coarser than the map that blockers are searched in.
      const float coarsest = 1.0f / static_cast<float>(settings.SearchMapSize);
      emitter.Tree.Build(vtkVirtualTileTree::MakePyramid(
                           vtkVirtualTileTree::Widen(wishes.front(), coarsest, 1 + emitter.Shift)),
        limits);
    }
    else
    {
      emitter.Tree.Build(wishes, limits);
    }
  }
  else
  {
    emitter.Tree.BuildUniform(1 << settings.FixedLevels, limits);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualPlanner::BakeTiles(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, vtkVirtualEmitter& emitter)
{
  double mostTexels = static_cast<double>(services.MapMemory) / 4.0;
  bool isComplete = false;
  std::string reason;
  do
  {
    const vtkShadowFailures attempt;
    vtkVirtualPlanner::PlanTiles(services, settings, emitter, mostTexels);
    isComplete =
      emitter.Maps.Update(services, emitter.Tree.GetTiles(), vtkVirtualTileTree::GridSize);
    // A driver may have less than was allowed: everything becomes coarser.
    mostTexels = 0.25 * emitter.Tree.GetTexels();
    reason = attempt.GetFirst();
  } while (!isComplete && mostTexels > 65536.0);
  if (!isComplete)
  {
    vtkShadowFailures::Report(reason);
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualPlanner::GetBytes() const
{
  vtkTypeInt64 bytes = this->Spare.GetBytes() + this->Grid.GetBytes();
  for (const auto& screen : this->Screens)
  {
    bytes += screen->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkVirtualPlanner::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& screen : this->Screens)
  {
    screen->ReleaseGraphicsResources(window);
  }
  this->Screens.clear();
  this->Prepared.clear();
  this->PreparedViews.clear();
  this->Spare.ReleaseGraphicsResources(window);
  this->Grid.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
