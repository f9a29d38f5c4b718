// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowServices.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapStore.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkSoftShadowFits.h"
#include "vtkSoftShadowPixelCount.h"
#include "vtkSoftShadowStatistics.h"
#include "vtkSoftShadowTimers.h"

#include <algorithm>
#include <array>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

// (A B), row-major, as column-major floats.
void ComposeToFloat(const double* a, const double* b, float matrix[16])
{
  double product[16];
  vtkMatrix4x4::Multiply4x4(a, b, product);
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix[4 * column + row] = static_cast<float>(product[4 * row + column]);
    }
  }
}

// For vtkShadowPointSums.
void SetDepthUniforms(vtkShaderProgram* program, const vtkShadowMapView* views, size_t count)
{
  if (count == 0 || !program->IsUniformUsed("depthToLinears"))
  {
    return;
  }
  std::array<float[2], VTK_SOFT_SHADOW_SAMPLES_PER_DRAW> depths;
  for (size_t i = 0; i < count; ++i)
  {
    const std::array<double, 2> linear = views[i].GetDepthToLinear();
    depths[i][0] = static_cast<float>(linear[0]);
    depths[i][1] = static_cast<float>(linear[1]);
  }
  program->SetUniform2fv("depthToLinears", static_cast<int>(count), depths.data());
  program->SetUniformi("mapDirectional", views[0].Emitter.Directional ? 1 : 0);
}

} // namespace

//------------------------------------------------------------------------------
vtkSoftShadowServices::vtkSoftShadowServices(const Tools& tools)
  : Used(tools)
{
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::SetReceiverUniforms(vtkShaderProgram* program) const
{
  this->Receivers->Activate(program);
  if (!program->IsUniformUsed("viewToApex"))
  {
    return;
  }
  vtkShadowEmitter apex = this->Emitter;
  apex.Center = apex.Apex;
  float matrix[16];
  ComposeToFloat(apex.WorldToEmitter().data(), this->Receivers->GetViewToWorld().data(), matrix);
  program->SetUniformMatrix4x4("viewToApex", matrix);
  program->SetUniformi("lightDirectional", apex.Directional ? 1 : 0);
  program->SetUniformi("lightOneSided", !apex.Directional && apex.HasExtent() ? 1 : 0);
  program->SetUniformf("lightConeCosine",
    apex.HasCone() ? static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(apex.ConeAngle)))
                   : -2.0f);
  program->SetUniformi("lightFaceAxis", this->FaceAxis);
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::ViewToMap(const vtkShadowMapView& view, float matrix[16]) const
{
  ComposeToFloat(view.WorldToMap().data(), this->Receivers->GetViewToWorld().data(), matrix);
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::SetMapUniforms(
  vtkShaderProgram* program, const vtkShadowMapView& view, int mapSize) const
{
  float matrix[16];
  this->ViewToMap(view, matrix);
  program->SetUniformMatrix4x4("viewToMap", matrix);
  program->SetUniformf("depthMapSize", static_cast<float>(mapSize));
  const std::array<double, 2> scale = view.GetKernelScale();
  const float kernelScale[2] = { static_cast<float>(scale[0]), static_cast<float>(scale[1]) };
  program->SetUniform2f("kernelScale", kernelScale);
  if (program->IsUniformUsed("depthToLinear"))
  {
    const std::array<double, 2> linear = view.GetDepthToLinear();
    const float depthToLinear[2] = { static_cast<float>(linear[0]), static_cast<float>(linear[1]) };
    program->SetUniform2f("depthToLinear", depthToLinear);
    program->SetUniformi("mapDirectional", view.Emitter.Directional ? 1 : 0);
  }
  if (program->IsUniformUsed("emitterDisk"))
  {
    const vtkShadowEmitter& emitter = view.Emitter;
    program->SetUniformi("emitterDisk", emitter.Shape == vtkShadowEmitter::DISK ? 1 : 0);
    const float window[4] = { static_cast<float>(emitter.WindowCenter[0]),
      static_cast<float>(emitter.WindowCenter[1]), static_cast<float>(emitter.WindowHalfSize[0]),
      static_cast<float>(emitter.WindowHalfSize[1]) };
    program->SetUniform4f("emitterWindow", window);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::SetMapUniforms(vtkShaderProgram* program) const
{
  this->SetMapUniforms(program, this->GetMapView(), this->Maps->GetResolution());
}

//------------------------------------------------------------------------------
const vtkShadowMapView& vtkSoftShadowServices::GetMapView() const
{
  return this->Maps->GetViews()[this->Layer];
}

//------------------------------------------------------------------------------
vtkSoftShadowSamples vtkSoftShadowServices::FitSamples(
  const std::vector<vtkShadowLightSampling::Sample>& points) const
{
  return vtkSoftShadowSamples::Fit(*this->Fitter, this->Emitter, points);
}

//------------------------------------------------------------------------------
const vtkSoftShadowSamples& vtkSoftShadowServices::FitSamples(int set, vtkMTimeType settings,
  const std::function<std::vector<vtkShadowLightSampling::Sample>()>& points) const
{
  return this->Used.Fits->Get(*this, set, settings, points);
}

//------------------------------------------------------------------------------
vtkShadowDepthMaps* vtkSoftShadowServices::BakeMaps(
  const std::vector<vtkShadowMapView>& views, int mapSize, int texture) const
{
  vtkShadowMapStore::Request request;
  request.Views = views;
  request.MapSize = mapSize;
  const vtkShadowMapStore::Maps maps = this->Used.Store->Bake(this->Renderer, this->Casters,
    { this->Source, this->Part, FIRST_OF_TECHNIQUE + texture }, request);
  this->CountBakes(maps.Baked, mapSize);
  return maps.Depths;
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::ReleaseMaps(int texture) const
{
  this->Used.Store->Release({ this->Source, this->Part, FIRST_OF_TECHNIQUE + texture });
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::SetSampleUniforms(vtkShaderProgram* program,
  const vtkShadowMapView* views, const float* weights, size_t count, size_t firstLayer, int mapSize,
  int filterSize) const
{
  program->SetUniformi("sampleCount", static_cast<int>(count));
  program->SetUniformf("firstLayer", static_cast<float>(firstLayer));
  program->SetUniformf("depthMapSize", static_cast<float>(mapSize));
  program->SetUniformi("filterSize", filterSize);
  if (count > 0)
  {
    this->SetAffineMapUniforms(program, views, count);
    program->SetUniform1fv("sampleWeights", static_cast<int>(count), weights);
    SetDepthUniforms(program, views, count);
  }
}

//------------------------------------------------------------------------------
double vtkSoftShadowServices::CountSampleTaps(size_t count, int filterSize)
{
  constexpr double CreaseTaps = 10.0;
  const double edge = filterSize + 1.0;
  return static_cast<double>(count) * (edge * edge + CreaseTaps);
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::SetAffineMapUniforms(
  vtkShaderProgram* program, const vtkShadowMapView* views, size_t count) const
{
  float viewToBase[16];
  this->ViewToMap(views[0], viewToBase);
  program->SetUniformMatrix4x4("viewToBase", viewToBase);
  double baseToWorld[16];
  vtkMatrix4x4::Invert(views[0].WorldToMap().data(), baseToWorld);
  std::array<float[4], 3 * VTK_SOFT_SHADOW_SAMPLES_PER_DRAW> rows;
  for (size_t i = 0; i < count; ++i)
  {
    double baseToMap[16];
    vtkMatrix4x4::Multiply4x4(views[i].WorldToMap().data(), baseToWorld, baseToMap);
    for (size_t entry = 0; entry < 12; ++entry)
    {
      rows[3 * i + entry / 4][entry % 4] = static_cast<float>(baseToMap[entry] / baseToMap[15]);
    }
  }
  program->SetUniform4fv("baseToMaps", static_cast<int>(3 * count), rows.data());
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::DrawMarked(vtkShadowShader& shader, double tapsPerPixel) const
{
  this->Used.Pixels->Draw(this->Window, shader, tapsPerPixel);
}

//------------------------------------------------------------------------------
size_t vtkSoftShadowServices::GetMapsPerBatch(int mapSize, int shares) const
{
  const vtkTypeInt64 bytes = static_cast<vtkTypeInt64>(4) * mapSize * mapSize;
  const auto fitting =
    static_cast<size_t>(std::max<vtkTypeInt64>(this->MapMemory / shares / bytes, 1));
  return std::min(fitting, static_cast<size_t>(vtkShadowLimits::GetTextureLayers()));
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::CountBakes(int maps, int mapSize) const
{
  this->CountMaps(maps, static_cast<vtkTypeInt64>(maps) * mapSize * mapSize);
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::CountMaps(int maps, vtkTypeInt64 texels) const
{
  this->Used.Statistics->MapsBaked += maps;
  this->Used.Statistics->TexelsDrawn += texels;
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::CountAllocations(int textures) const
{
  this->Used.Statistics->Allocations += textures;
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::BeginStep(const char* name, bool onProcessor) const
{
  this->Used.Timers->BeginStep(name, onProcessor);
}

//------------------------------------------------------------------------------
void vtkSoftShadowServices::SetCounts(
  std::vector<std::pair<std::string, vtkTypeInt64>> counts) const
{
  this->Used.Statistics->TechniqueCounts = std::move(counts);
}
VTK_ABI_NAMESPACE_END
