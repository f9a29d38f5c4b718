// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSoftShadowPass does when visibilities are read and the picture is shaded with others: those of
// smooth receivers. The triangles' own are estimated only then.
#include "vtkSoftShadowPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowPassInternals.h"
#include "vtkSoftShadowScopedState.h"
#include "vtkSoftShadowsOpenGL.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowPass::Internals::SwapData()
{
  std::swap(this->Target, this->Data.Target);
  std::swap(this->Schedule, this->Data.Schedule);
  std::swap(this->Accumulator, this->Data.Accumulator);
  std::swap(this->PointMaps, this->Data.PointMaps);
  std::swap(this->PointWeights, this->Data.PointWeights);
  std::swap(this->Refinements, this->Data.Refinements);
  std::swap(this->Queries, this->Data.Queries);
  std::swap(this->UsedQueries, this->Data.UsedQueries);
  this->IsData = !this->IsData;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::Internals::ReleaseData(vtkWindow* window)
{
  this->Data.Target->ReleaseGraphicsResources(window);
  this->Data.Accumulator->ReleaseGraphicsResources(window);
  this->Data.PointMaps->ReleaseGraphicsResources(window);
  if (!this->Data.Queries.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(this->Data.Queries.size()), this->Data.Queries.data());
    this->Data.Queries.clear();
    this->Data.UsedQueries = 0;
  }
  this->Data.Schedule.Reset();
  this->Data.IsKnown = false;
}

//------------------------------------------------------------------------------
vtkShadowTextureArray* vtkSoftShadowPass::GetDataTexture()
{
  Internals& impl = *this->Impl;
  if (!impl.Renderer || !impl.Watch.GetWindow() ||
    impl.Renderer->GetRenderWindow() != impl.Watch.GetWindow() || impl.Losses.HasAny() ||
    !impl.Target->GetTexture()->GetHandle() || !impl.Receivers->HasSmooth())
  {
    return impl.Target->GetTexture(); // the picture's is the triangles' own
  }
  const vtkRenderState state(impl.Renderer);
  const vtkSoftShadowScopedState scope(impl.Watch.GetWindow());
  impl.Hooks.VisibilityUnit = scope.GetFreeUnit(); // mappers may bake, see UpdateVisibility
  const vtkSoftShadowStatistics counts = impl.Statistics;
  const vtkSoftShadowLosses losses = impl.Losses;
  const bool hasNews = impl.HasNews;
  const int refinements = impl.Refinements;
  const bool isEnded = impl.Schedule.IsEnded();
  impl.Receivers->SetSmooth(false);
  impl.SwapData();
  impl.Data.IsWanted = true;
  if (!impl.Data.IsKnown)
  {
    impl.Data.IsKnown = true;
    impl.Schedule.Reset();
    impl.Refinements = 0;
    this->EstimateLights(&state, true);
    ++impl.Statistics.DataFrames;
    impl.IsTechniqueMoved = true;
  }
  // As many points as the picture has, or as good a mean.
  while (
    this->Progressive && !impl.Schedule.IsEnded() && (impl.Refinements < refinements || isEnded))
  {
    this->Refine(&state);
  }
  impl.SwapData();
  impl.Receivers->SetSmooth(true);
  impl.HasNews = hasNews;
  const bool isLost = impl.Losses.HasAny();
  impl.Losses = losses; // the picture has lost nothing
  impl.Statistics.TechniqueCounts = counts.TechniqueCounts;
  impl.Statistics.ProgressiveFrames = counts.ProgressiveFrames;
  if (isLost)
  {
    impl.ReleaseData(impl.Watch.GetWindow());
  }
  return impl.Data.Target->GetTexture();
}
VTK_ABI_NAMESPACE_END
