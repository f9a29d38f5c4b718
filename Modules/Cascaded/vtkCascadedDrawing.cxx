// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedDrawing.h"

#include "vtkCascadedEmitter.h"
#include "vtkCascadedFade.h"
#include "vtkCascadedSettings.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"

#include "vtkCascadedSoftShadowFS.h"
#include "vtkCascadedSumsFS.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// A square of the disk's area has an edge of the root of pi, in radii.
constexpr double DiskEdge = 1.772453850905516;

// h_r: how much more than a band a shadow's edge may differ before it stops the filter. Larger ones
// blur shadows of blockers at several depths over each other (0.2: an RMSE of 0.0212 in place of 0.0187
// on fourteen boards); single ramps do not care.
constexpr double RangeDeviation = 0.05;

// A point's cell in a cascade of edge x edge points. A straight edge moves over a row of them at once.
vtkSoftShadowScreenFilter::Cell MakeCell(const vtkShadowEmitter& emitter,
  const vtkShadowCascades::Cascade& cascade, const std::vector<float>& weights, int edge)
{
  vtkSoftShadowScreenFilter::Cell cell;
  const double length = (emitter.Shape == vtkShadowEmitter::DISK ? DiskEdge : 2.0) / edge;
  cell.Edges = { { { { length, 0.0 } }, { { 0.0, length } } } };
  const auto heaviest = std::max_element(weights.begin(), weights.end());
  cell.BandStep = heaviest == weights.end() ? 0.0 : edge * *heaviest / emitter.Weight;
  cell.FadeIn = { { cascade.FadeIn.first, cascade.FadeIn.second } };
  cell.FadeOut = { { cascade.FadeOut.first, cascade.FadeOut.second } };
  return cell;
}
} // namespace

//------------------------------------------------------------------------------
vtkCascadedDrawing::vtkCascadedDrawing()
  : Shader(vtkCascadedSoftShadowFS)
  , SumsShader(vtkCascadedSumsFS)
{
}

//------------------------------------------------------------------------------
void vtkCascadedDrawing::SetDefinitions(const vtkShadowShader::Definitions& definitions)
{
  this->Shader.SetDefinitions(definitions);
  this->SumsShader.SetDefinitions(definitions);
}

//------------------------------------------------------------------------------
void vtkCascadedDrawing::DrawCascade(
  const vtkSoftShadowServices& services, vtkCascadedEmitter& emitter, size_t cascade)
{
  vtkCascadedSoftShadowMaps& maps = emitter.GetMaps();
  const vtkCascadedSoftShadowMaps::Set& set = maps.GetSet(cascade);
  float litWeight = set.Samples.LitWeight;
  const size_t count = set.Samples.Views.size();
  for (size_t first = 0; first == 0 || first < count;)
  {
    const vtkCascadedSoftShadowMaps::Run run = maps.Bake(services, cascade, first);
    if (count > 0 && run.Last == run.First)
    {
      return;
    }
    if (!this->Shader.Use(services.Window))
    {
      return;
    }
    vtkShaderProgram* program = this->Shader.GetProgram();
    vtkCascadedFade::SetUniforms(program, emitter.GetCascades()[cascade]);
    program->SetUniformf("litWeight", litWeight);
    litWeight = 0.0f; // once
    services.SetReceiverUniforms(program);
    services.SetSampleUniforms(program, set.Samples.Views.data() + run.First,
      set.Samples.Weights.data() + run.First, run.Last - run.First, run.Layer,
      maps.GetMapSize(set.Resolution), set.FilterSize);
    vtkShadowTextureArray* texture = run.Texture;
    program->SetUniformi("depthMaps", texture->Activate(services.Window));
    services.DrawMarked(
      this->Shader, vtkSoftShadowServices::CountSampleTaps(run.Last - run.First, set.FilterSize));
    texture->Deactivate();
    services.Receivers->Deactivate();
    first = std::max<size_t>(run.Last, 1);
  }
}

//------------------------------------------------------------------------------
void vtkCascadedDrawing::DrawScreen(const vtkSoftShadowServices& services,
  const vtkCascadedSettings& settings, vtkCascadedEmitter& emitter)
{
  const std::vector<vtkShadowCascades::Cascade>& cascades = emitter.GetCascades();
  if (!this->ScreenFilter.BeginSums(services))
  {
    return;
  }
  bool isFirst = true;
  for (size_t i = 0; i < cascades.size(); ++i)
  {
    this->DrawSums(services, emitter, i, isFirst);
  }
  this->ScreenFilter.EndSums();
  services.BeginStep("screen filter");
  vtkSoftShadowScreenFilter::Settings filter;
  filter.RangeDeviation = RangeDeviation;
  filter.WeightedByPoints = settings.Weights == vtkShadowLightSampling::GAUSSIAN;
  for (size_t i = 0; i < cascades.size(); ++i)
  {
    filter.Cells.push_back(
      MakeCell(services.Emitter, cascades[i], emitter.GetMaps().GetSet(i).Samples.Weights,
        services.Emitter.HasExtent() ? settings.SampleEdges[i] : 1));
  }
  this->ScreenFilter.Draw(services, filter);
  services.BeginStep("visibility");
}

//------------------------------------------------------------------------------
void vtkCascadedDrawing::DrawSums(
  const vtkSoftShadowServices& services, vtkCascadedEmitter& emitter, size_t cascade, bool& isFirst)
{
  vtkCascadedSoftShadowMaps& maps = emitter.GetMaps();
  const vtkCascadedSoftShadowMaps::Set& set = maps.GetSet(cascade);
  const auto share = static_cast<float>(1.0 / services.Emitter.Weight);
  float litWeight = share * set.Samples.LitWeight;
  const size_t count = set.Samples.Views.size();
  for (size_t first = 0; first == 0 || first < count;)
  {
    const vtkCascadedSoftShadowMaps::Run run = maps.Bake(services, cascade, first);
    if (count > 0 && run.Last == run.First)
    {
      return;
    }
    if (!this->SumsShader.Use(services.Window))
    {
      return;
    }
    vtkShaderProgram* program = this->SumsShader.GetProgram();
    vtkCascadedFade::SetUniforms(program, emitter.GetCascades()[cascade]);
    program->SetUniformf("litWeight", litWeight);
    program->SetUniformf("madeUp", isFirst ? 1.0f : 0.0f); // the sums start at -1, no value
    litWeight = 0.0f;                                      // once
    isFirst = false;
    services.SetReceiverUniforms(program);
    const auto begin = set.Samples.Weights.begin();
    std::vector<float> weights(begin + run.First, begin + run.Last);
    std::for_each(weights.begin(), weights.end(), [share](float& weight) { weight *= share; });
    services.SetSampleUniforms(program, set.Samples.Views.data() + run.First, weights.data(),
      weights.size(), run.Layer, maps.GetMapSize(set.Resolution), set.FilterSize);
    vtkShadowTextureArray* texture = run.Texture;
    program->SetUniformi("depthMaps", texture->Activate(services.Window));
    services.DrawMarked(this->SumsShader,
      vtkSoftShadowServices::CountSampleTaps(run.Last - run.First, set.FilterSize));
    texture->Deactivate();
    services.Receivers->Deactivate();
    first = std::max<size_t>(run.Last, 1);
  }
}

//------------------------------------------------------------------------------
int vtkCascadedDrawing::GetNumberOfBuilds() const
{
  return this->Shader.GetNumberOfBuilds() + this->SumsShader.GetNumberOfBuilds() +
    this->ScreenFilter.GetNumberOfShaderBuilds();
}

//------------------------------------------------------------------------------
void vtkCascadedDrawing::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Shader.ReleaseGraphicsResources(window);
  this->SumsShader.ReleaseGraphicsResources(window);
  this->ScreenFilter.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
