// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowDriver.h"
#include "vtkShadowScopedTarget.h"
#include "vtkSoftShadowServices.h"
#include "vtkVirtualDrawing.h"
#include "vtkVirtualEmitter.h"
#include "vtkVirtualPlanner.h"
#include "vtkVirtualSettings.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkVirtualSoftShadowPass);

//------------------------------------------------------------------------------
class vtkVirtualSoftShadowPass::Internals
{
public:
  using Key = std::pair<const vtkLight*, int>; // light and part

  std::map<Key, vtkVirtualEmitter> Emitters;
  vtkVirtualPlanner Planner;
  vtkVirtualDrawing Drawing;
  int GridLatency = 0; // of this driver
};

//------------------------------------------------------------------------------
vtkVirtualSoftShadowPass::vtkVirtualSoftShadowPass()
  : Impl(new Internals)
{
  this->MapSize = 4096;
}

//------------------------------------------------------------------------------
vtkVirtualSoftShadowPass::~vtkVirtualSoftShadowPass() = default;

//------------------------------------------------------------------------------
vtkSoftShadowRequirements vtkVirtualSoftShadowPass::GetRequirements() const
{
  vtkSoftShadowRequirements requirements;
  requirements.EmitterMapSize = this->SearchMapSize;
  requirements.ConservativeMap = true;
  requirements.Pyramid = true;
  // The kernel shapes prove pixels lit themselves, footprint included; holes that a conservative
  // map closes forbid to prove them blocked.
  requirements.Proof = vtkSoftShadowRequirements::PROVES_NOTHING;
  requirements.GaussianWeights = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  requirements.Preparation = this->Adaptive;
  return requirements;
}

//------------------------------------------------------------------------------
vtkVirtualSettings vtkVirtualSoftShadowPass::GetSettings() const
{
  vtkVirtualSettings settings;
  settings.SearchMapSize = this->SearchMapSize;
  settings.Adaptive = this->Adaptive;
  settings.FixedLevels = this->FixedLevels;
  settings.Antialiasing = this->Antialiasing;
  settings.Metric = this->Metric;
  settings.GaussianWeights = this->Weights == vtkShadowLightSampling::GAUSSIAN;
  settings.Quality = this->Quality;
  settings.SearchWidth = this->SearchWidth;
  settings.MaximumTiles = this->MaximumTiles;
  settings.GridLatency = this->Impl->GridLatency;
  settings.DebugView = this->DebugView;
  return settings;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::Begin(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  impl.Planner.Begin(services);
  impl.GridLatency = this->GridLatency;
  if (this->GridLatency == LATENCY_OF_DRIVER)
  {
    impl.GridLatency = vtkShadowDriver::DrawsOnProcessor() ? 0 : 1;
  }
  for (auto emitter = impl.Emitters.begin(); emitter != impl.Emitters.end();)
  {
    emitter->second.IsShown = false;
    const bool isThere = vtkSoftShadowContext::HasLight(services.Renderer, emitter->first.first);
    emitter = isThere ? std::next(emitter) : impl.Emitters.erase(emitter);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::Prepare(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  impl.Planner.Prepare(services, this->GetSettings(),
    impl.Emitters[Internals::Key(services.Source, services.Part)], impl.Drawing);
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::Add(const vtkSoftShadowServices& services)
{
  Internals& impl = *this->Impl;
  vtkVirtualEmitter& emitter = impl.Emitters[Internals::Key(services.Source, services.Part)];
  emitter.Light = services.Light;
  emitter.Part = services.Part;
  const vtkVirtualSettings settings = this->GetSettings();
  {
    const vtkShadowScopedTarget target(services.Window->GetState());
    if (!impl.Planner.Request(services, settings, emitter, impl.Drawing))
    {
      return;
    }
    services.BeginStep("tile maps");
    vtkVirtualPlanner::BakeTiles(services, settings, emitter);
    services.BeginStep("filtering");
    impl.Drawing.DrawTiles(services, settings, emitter);
  }
  services.SetCounts(
    { { "tiles", this->GetNumberOfTiles() }, { "tile_kilotexels", this->GetTileTexels() / 1000 },
      { "grid_waits", impl.Planner.GetWaits() }, { "late_grids", impl.Planner.GetLate() } });
  impl.Drawing.Resolve(services, settings, emitter);
  services.BeginStep("visibility");
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::WantsVisibilityAnew()
{
  const Internals& impl = *this->Impl;
  return this->Adaptive && impl.GridLatency > 0 &&
    (impl.Planner.IsOwed() ||
      std::any_of(impl.Emitters.begin(), impl.Emitters.end(),
        [](const std::pair<const Internals::Key, vtkVirtualEmitter>& emitter)
        {
          return emitter.second.IsShown && emitter.second.IsLate &&
            emitter.second.Request.HasArrived();
        }));
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
  return this->Impl->Planner.GetExcess();
}

//------------------------------------------------------------------------------
std::string vtkVirtualSoftShadowPass::GetTileReport() const
{
  std::map<std::pair<int, int>, const vtkVirtualTileTree*> trees; // in the lights' order
  for (const auto& entry : this->Impl->Emitters)
  {
    const vtkVirtualEmitter& emitter = entry.second;
    if (emitter.IsShown)
    {
      trees[std::make_pair(emitter.Light, emitter.Part)] = &emitter.Tree;
    }
  }
  std::ostringstream report;
  for (const auto& tree : trees)
  {
    report << "light " << tree.first.first << " part " << tree.first.second << ": "
           << tree.second->GetTiles().size() << " tiles, "
           << static_cast<vtkTypeInt64>(tree.second->GetTexels())
           << " texels, coarser than predicted by " << tree.second->GetCoarsening() << "\n";
    for (const vtkVirtualTile& tile : tree.second->GetTiles())
    {
      report << "  cells " << tile.X << " " << tile.Y << " size " << tile.Width << " x "
             << tile.Height << ": " << tile.Resolution << "\n";
    }
  }
  return report.str();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::AddStatistics(vtkSoftShadowStatistics& statistics)
{
  const Internals& impl = *this->Impl;
  statistics.BytesHeld += impl.Planner.GetBytes() + impl.Drawing.GetBytes();
  statistics.ShaderBuilds += impl.Planner.GetNumberOfBuilds() + impl.Drawing.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  impl.Drawing.ReleaseGraphicsResources(window);
  impl.Planner.ReleaseGraphicsResources(window);
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
  os << indent
     << "Weights: " << (this->Weights == vtkShadowLightSampling::GAUSSIAN ? "gaussian" : "mean")
     << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "SearchWidth: " << this->SearchWidth << "\n";
  os << indent << "GridLatency: ";
  if (this->GridLatency == LATENCY_OF_DRIVER)
  {
    os << "of the driver\n";
  }
  else
  {
    os << this->GridLatency << "\n";
  }
  os << indent << "MaximumTiles: " << this->MaximumTiles << "\n";
  os << indent << "DebugView: " << views[this->DebugView] << "\n";
}
VTK_ABI_NAMESPACE_END
