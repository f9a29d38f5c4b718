// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedSoftShadowMaps.h"

#include "vtkShadowDepthMaps.h"
#include "vtkShadowShader.h"
#include "vtkSoftShadowServices.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkCascadedSoftShadowMaps::Begin(int mapSize)
{
  this->MapSize = mapSize;
  this->Sets.clear();
  for (std::vector<vtkShadowMapView>& views : this->Views)
  {
    views.clear();
  }
}

//------------------------------------------------------------------------------
size_t vtkCascadedSoftShadowMaps::Add(
  int resolution, int filterSize, vtkSoftShadowSamples&& samples)
{
  std::vector<vtkShadowMapView>& views = this->Views[resolution];
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
    wanted += static_cast<vtkTypeInt64>(this->Views[i].size() * sizeof(float)) * size * size;
  }
  const int shares = services.ExceedsMapMemory(wanted) ? NumberOfResolutions : 1;
  return services.GetMapsPerBatch(this->GetMapSize(resolution), shares);
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowMaps::Run vtkCascadedSoftShadowMaps::Bake(
  const vtkSoftShadowServices& services, size_t set, size_t first)
{
  const Set& wanted = this->Sets[set];
  Run run;
  run.First = run.Last = first;
  run.Texture = this->NoMaps;
  if (wanted.Samples.Views.empty())
  {
    return run;
  }
  const std::vector<vtkShadowMapView>& views = this->Views[wanted.Resolution];
  const size_t count = this->GetBatch(services, wanted.Resolution);
  const size_t index = wanted.First + first;
  const size_t begin = index / count * count;
  const size_t end = std::min(begin + count, views.size());
  services.BeginStep("cascade maps");
  vtkShadowDepthMaps* maps = services.BakeMaps({ views.begin() + begin, views.begin() + end },
    this->GetMapSize(wanted.Resolution), wanted.Resolution);
  services.BeginStep("visibility");
  if (!maps)
  {
    return run;
  }
  run.Texture = maps->GetTexture();
  run.Layer = index - begin;
  run.Last = std::min({ wanted.Samples.Views.size(), end - wanted.First,
    first + static_cast<size_t>(VTK_SOFT_SHADOW_SAMPLES_PER_DRAW) });
  return run;
}
VTK_ABI_NAMESPACE_END
