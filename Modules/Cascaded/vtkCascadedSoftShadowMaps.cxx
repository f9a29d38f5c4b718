// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedSoftShadowMaps.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowCasters.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkCascadedSoftShadowMaps::Begin(int mapSize)
{
  this->MapSize = mapSize;
  this->Sets.clear();
  for (Array& array : this->Arrays)
  {
    array.Views.clear();
  }
}

//------------------------------------------------------------------------------
size_t vtkCascadedSoftShadowMaps::Add(
  int resolution, int filterSize, vtkSoftShadowSamples&& samples)
{
  std::vector<vtkShadowMapView>& views = this->Arrays[resolution].Views;
  Set set;
  set.Resolution = resolution;
  set.First = views.size();
  set.FilterSize = filterSize;
  set.Samples = std::move(samples);
  views.insert(views.end(), set.Samples.Views.begin(), set.Samples.Views.end());
  this->Sets.push_back(std::move(set));
  return this->Sets.size() - 1;
}

//------------------------------------------------------------------------------
int vtkCascadedSoftShadowMaps::GetMapSize(int resolution) const
{
  return std::max(this->MapSize >> resolution, 32);
}

//------------------------------------------------------------------------------
size_t vtkCascadedSoftShadowMaps::GetBatch(
  const vtkSoftShadowServices& services, int resolution) const
{
  vtkTypeInt64 wanted = 0;
  for (int i = 0; i < NumberOfResolutions; ++i)
  {
    const auto size = static_cast<vtkTypeInt64>(this->GetMapSize(i));
    wanted += static_cast<vtkTypeInt64>(this->Arrays[i].Views.size() * sizeof(float)) * size * size;
  }
  const int shares = services.ExceedsMapMemory(wanted) ? NumberOfResolutions : 1;
  return services.GetMapsPerBatch(this->GetMapSize(resolution), shares);
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowMaps::Run vtkCascadedSoftShadowMaps::Bake(
  const vtkSoftShadowServices& services, size_t set, size_t first)
{
  const Set& wanted = this->Sets[set];
  Array& array = this->Arrays[wanted.Resolution];
  const int mapSize = this->GetMapSize(wanted.Resolution);
  const size_t count = this->GetBatch(services, wanted.Resolution);
  const size_t index = wanted.First + first;
  const size_t begin = index / count * count;
  const size_t end = std::min(begin + count, array.Views.size());
  const std::vector<vtkShadowMapView> batch(array.Views.begin() + begin, array.Views.begin() + end);
  services.BeginStep("cascade maps");
  const int drawn = array.Maps->Bake(services.Renderer, services.Casters, batch, mapSize);
  services.BeginStep("visibility");
  Run run;
  run.First = run.Last = first;
  if (drawn < 0)
  {
    return run;
  }
  services.CountBakes(drawn, mapSize);
  run.Layer = index - begin;
  run.Last = std::min({ wanted.Samples.Views.size(), end - wanted.First,
    first + static_cast<size_t>(VTK_SOFT_SHADOW_SAMPLES_PER_DRAW) });
  return run;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowMaps::GetBytes()
{
  vtkTypeInt64 bytes = 0;
  for (Array& array : this->Arrays)
  {
    bytes += array.Maps->GetTexture()->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkCascadedSoftShadowMaps::GetNumberOfDrawCalls()
{
  vtkTypeInt64 calls = 0;
  for (Array& array : this->Arrays)
  {
    calls += array.Maps->GetNumberOfDrawCalls();
  }
  return calls;
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Array& array : this->Arrays)
  {
    array.Maps->ReleaseGraphicsResources(window);
  }
}
VTK_ABI_NAMESPACE_END
