// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// How cascades are drawn whose visibility is filtered on the screen.
#include "vtkCascadedSoftShadowPassInternals.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowTextureArray.h"

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
void vtkCascadedSoftShadowPass::Internals::DrawScreen(vtkCascadedSoftShadowPass* self,
  const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps)
{
  if (!this->ScreenFilter.BeginSums(context))
  {
    return;
  }
  bool isFirst = true;
  for (size_t i = 0; i < this->Cascades.size(); ++i)
  {
    this->DrawSums(self, context, maps, i, isFirst);
  }
  this->ScreenFilter.EndSums();
  self->BeginStep("screen filter");
  vtkSoftShadowScreenFilter::Settings settings;
  settings.RangeDeviation = RangeDeviation;
  settings.WeightedByPoints = self->HasGaussianWeights();
  for (size_t i = 0; i < this->Cascades.size(); ++i)
  {
    settings.Cells.push_back(MakeCell(context.Emitter, this->Cascades[i],
      maps.GetSet(i).Samples.Weights, context.Emitter.HasExtent() ? self->SampleEdges[i] : 1));
  }
  this->ScreenFilter.Draw(context, settings);
  self->BeginStep("visibility");
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Internals::DrawSums(vtkCascadedSoftShadowPass* self,
  const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps, size_t cascade,
  bool& isFirst)
{
  const vtkCascadedSoftShadowMaps::Set& set = maps.GetSet(cascade);
  const auto share = static_cast<float>(1.0 / context.Emitter.Weight);
  float litWeight = share * set.Samples.LitWeight;
  const size_t count = set.Samples.Views.size();
  for (size_t first = 0; first == 0 || first < count;)
  {
    vtkCascadedSoftShadowMaps::Run run;
    if (count > 0)
    {
      run = Internals::Bake(self, context, maps, cascade, first);
      if (run.Last == run.First)
      {
        return;
      }
    }
    if (!this->SumsShader.Use(context.Window))
    {
      return;
    }
    vtkShaderProgram* program = this->SumsShader.GetProgram();
    Internals::SetFade(program, this->Cascades[cascade]);
    program->SetUniformf("litWeight", litWeight);
    program->SetUniformf("madeUp", isFirst ? 1.0f : 0.0f); // the sums start at -1, no value
    litWeight = 0.0f;                                      // once
    isFirst = false;
    self->SetReceiverUniforms(program, context);
    const auto begin = set.Samples.Weights.begin();
    std::vector<float> weights(begin + run.First, begin + run.Last);
    std::for_each(weights.begin(), weights.end(), [share](float& weight) { weight *= share; });
    vtkSoftShadowPass::SetSampleUniforms(program, context, set.Samples.Views.data() + run.First,
      weights.data(), weights.size(), run.Layer, maps.GetMapSize(set.Resolution), set.FilterSize);
    vtkShadowTextureArray* texture = maps.GetMaps(set.Resolution)->GetTexture();
    program->SetUniformi("depthMaps", texture->Activate(context.Window));
    self->DrawFiltered(this->SumsShader);
    texture->Deactivate();
    context.Receivers->Deactivate();
    first = std::max<size_t>(run.Last, 1);
  }
}
VTK_ABI_NAMESPACE_END
