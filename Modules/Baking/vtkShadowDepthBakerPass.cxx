// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDepthBakerPass.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowEmitter.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLightSampling.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowMapStore.h"

#include <algorithm>
#include <sstream>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkShadowDepthBakerPass);

namespace
{
// A lit light of the last frame.
struct BakedLight
{
  vtkLight* Light = nullptr;          // compared, never followed
  vtkShadowDepthMaps* Maps = nullptr; // the store's
  std::string Report;
};

std::vector<vtkShadowMapView> FitViews(
  const vtkShadowMapFitter& fitter, const vtkShadowEmitter& emitter, int samples)
{
  std::vector<vtkShadowMapView> views;
  for (const auto& sample : vtkShadowLightSampling::Generate(
         emitter, samples, vtkShadowLightSampling::GRID, vtkShadowLightSampling::MEAN))
  {
    const std::vector<vtkShadowMapView> fitted =
      fitter.FitAll(emitter.PointAt(sample.U, sample.V, sample.Weight));
    views.insert(views.end(), fitted.begin(), fitted.end());
  }
  return views;
}
}

//------------------------------------------------------------------------------
class vtkShadowDepthBakerPass::Internals
{
public:
  vtkShadowMapStore Store;
  std::vector<BakedLight> Lights;
  std::string ToldWanted; // with a warning, as of the last frame
  std::string ToldLost;

  const BakedLight* Find(const vtkLight* light) const
  {
    const auto found = std::find_if(this->Lights.begin(), this->Lights.end(),
      [light](const BakedLight& baked) { return baked.Light == light && baked.Maps; });
    return found == this->Lights.end() ? nullptr : &*found;
  }

  // Lights that went out or away.
  void ReleaseOthers(const std::vector<BakedLight>& previous)
  {
    for (const BakedLight& baked : previous)
    {
      if (baked.Maps && !this->Find(baked.Light))
      {
        this->Store.Release({ baked.Light, 0, 0 });
      }
    }
  }
};

//------------------------------------------------------------------------------
vtkShadowDepthBakerPass::vtkShadowDepthBakerPass()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkShadowDepthBakerPass::~vtkShadowDepthBakerPass() = default;

//------------------------------------------------------------------------------
void vtkShadowDepthBakerPass::Render(const vtkRenderState* s)
{
  Internals& impl = *this->Impl;
  this->NumberOfRenderedProps = 0;
  this->NumberOfBakes = 0;
  vtkRenderer* renderer = s->GetRenderer();
  this->Casters->Update(renderer);
  const vtkShadowMapFitter fitter(this->Casters->GetBodies());

  const int mapSize = std::min(this->MapSize, vtkShadowLimits::GetTextureSize());
  std::ostringstream wanted; // more than OpenGL allows
  std::string lost;          // why a light has no maps
  if (mapSize < this->MapSize)
  {
    wanted << "maps of " << this->MapSize << " texels along an edge, ";
  }
  std::vector<BakedLight> previous;
  previous.swap(impl.Lights);
  impl.Store.Begin(renderer);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    BakedLight baked;
    baked.Light = light;
    vtkShadowEmitter emitter;
    if (vtkShadowEmitter::FromLight(light, emitter, baked.Report))
    {
      emitter = fitter.SeeFromAfar(emitter);
      vtkShadowMapStore::Request request;
      request.MapSize = mapSize;
      request.Conservative = this->Conservative;
      std::vector<vtkShadowMapView>& views = request.Views;
      views = FitViews(fitter, emitter, this->NumberOfSamples);
      const auto mostLayers = static_cast<std::size_t>(vtkShadowLimits::GetTextureLayers());
      if (views.size() > mostLayers)
      {
        wanted << views.size() << " maps of a light, ";
        views.resize(mostLayers);
      }
      const vtkShadowFailures failures;
      const vtkShadowMapStore::Maps maps =
        impl.Store.Bake(renderer, this->Casters, { light, 0, 0 }, request);
      this->NumberOfBakes += maps.Baked;
      baked.Maps = maps.Depths;
      lost = baked.Maps ? lost : failures.GetFirst();
      baked.Report = baked.Maps ? std::to_string(baked.Maps->GetViews().size()) +
          " depth maps of " + std::to_string(mapSize) + " x " + std::to_string(mapSize) + " texels"
                                : failures.GetFirst();
    }
    impl.Lights.push_back(baked);
  }
  impl.ReleaseOthers(previous);
  this->Warn(wanted.str(), lost);
}

//------------------------------------------------------------------------------
void vtkShadowDepthBakerPass::Warn(const std::string& wanted, const std::string& lost)
{
  Internals& impl = *this->Impl;
  if (!wanted.empty() && wanted != impl.ToldWanted)
  {
    vtkWarningMacro("Wanted are " << wanted << "but this OpenGL allows "
                                  << vtkShadowLimits::GetTextureSize() << " texels and "
                                  << vtkShadowLimits::GetTextureLayers() << " layers.");
  }
  if (!lost.empty() && impl.ToldLost.empty())
  {
    vtkWarningMacro("A light has no depth maps: " << lost << ".");
  }
  impl.ToldWanted = wanted;
  impl.ToldLost = lost;
}

//------------------------------------------------------------------------------
int vtkShadowDepthBakerPass::GetNumberOfLights() const
{
  const auto& lights = this->Impl->Lights;
  return static_cast<int>(std::count_if(
    lights.begin(), lights.end(), [](const BakedLight& baked) { return baked.Maps != nullptr; }));
}

//------------------------------------------------------------------------------
vtkShadowDepthMaps* vtkShadowDepthBakerPass::GetDepthMaps(vtkLight* light)
{
  const BakedLight* baked = this->Impl->Find(light);
  return baked ? baked->Maps : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkShadowDepthBakerPass::GetDepthImage(vtkLight* light, int layer)
{
  vtkShadowDepthMaps* maps = this->GetDepthMaps(light);
  if (!maps)
  {
    vtkErrorMacro(
      "The light has no depth maps: it was not lit in the last frame or casts nothing.");
    return nullptr;
  }
  return maps->ReadDepth(layer);
}

//------------------------------------------------------------------------------
std::string vtkShadowDepthBakerPass::GetLightReport() const
{
  std::ostringstream report;
  for (std::size_t i = 0; i < this->Impl->Lights.size(); ++i)
  {
    const BakedLight& baked = this->Impl->Lights[i];
    report << "light " << i << ": " << (baked.Maps ? "" : "casts nothing: ") << baked.Report
           << "\n";
  }
  return report.str();
}

//------------------------------------------------------------------------------
void vtkShadowDepthBakerPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->Store.ReleaseGraphicsResources(window);
  this->Impl->Lights.clear();
  this->Casters->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkShadowDepthBakerPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Conservative: " << this->Conservative << "\n";
  os << indent << "NumberOfBakes: " << this->NumberOfBakes << "\n";
  os << indent << "NumberOfLights: " << this->GetNumberOfLights() << "\n";
  os << indent << "Casters:\n";
  this->Casters->PrintSelf(os, indent.GetNextIndent());
}

VTK_ABI_NAMESPACE_END
