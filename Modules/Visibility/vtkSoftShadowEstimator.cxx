// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowEstimator.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowMapStore.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowLights.h"
#include "vtkSoftShadowLosses.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowPixelCount.h"
#include "vtkSoftShadowServices.h"
#include "vtkSoftShadowTarget.h"

#include "vtkSoftShadowConstantFS.h"
#include "vtkSoftShadowProofFS.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Requirements = vtkSoftShadowRequirements;

// Texels along an edge of the emitters' maps.
int GetMapSize(const Requirements& requirements, const vtkSoftShadowServices& services)
{
  return requirements.EmitterMapSize > 0
    ? std::min(requirements.EmitterMapSize, vtkShadowLimits::GetTextureSize())
    : services.MapSize;
}

// How often a light is cut along each axis.
int GetSplit(const vtkSoftShadowEstimator::Job& job)
{
  return job.Requirements.CutLights ? job.Split : 1;
}

} // namespace

//------------------------------------------------------------------------------
vtkSoftShadowEstimator::vtkSoftShadowEstimator()
  : ProofShader(vtkSoftShadowProofFS)
  , ConstantShader(vtkSoftShadowConstantFS)
{
}

//------------------------------------------------------------------------------
int vtkSoftShadowEstimator::FitViews(const Job& job, const vtkSoftShadowServices& services)
{
  int tooNear = 0;
  for (const vtkSoftShadowLights::LitLight& light : *job.Lights)
  {
    if (light.Casts)
    {
      vtkSoftShadowLightFit& fit = job.Lights->GetFit(light.Layer);
      fit.Fit(light.Emitter, *services.Fitter, services.Casters->GetBodiesTime(), GetSplit(job),
        job.Requirements.GaussianWeights);
      tooNear += fit.GetNumberTooNear();
    }
  }
  return tooNear;
}

//------------------------------------------------------------------------------
void vtkSoftShadowEstimator::Estimate(const Job& job, vtkSoftShadowServices& services)
{
  const int layers = job.Lights->GetNumberOfCasting();
  if (layers == 0)
  {
    return;
  }
  vtkOpenGLState* state = services.Window->GetState();
  state->PushFramebufferBindings();
  const vtkShadowFailures failures; // of what all lights need
  const int made = job.Target->Allocate(
    services.Window, services.Receivers->GetWidth(), services.Receivers->GetHeight(), layers);
  services.CountAllocations(std::max(made, 0));
  services.Marks = job.Target->GetMarks();
  job.Pixels->Restart();
  if (made >= 0)
  {
    job.Technique->Begin(services);
  }
  if (failures.HasAny())
  {
    job.Losses->LoseAll(failures.GetFirst());
  }
  else
  {
    if (job.Requirements.Preparation)
    {
      this->EstimateOrPrepare(job, services, true);
    }
    this->EstimateOrPrepare(job, services, false);
  }
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkSoftShadowEstimator::EstimateOrPrepare(
  const Job& job, vtkSoftShadowServices& services, bool preparing)
{
  for (int i = 0; i < job.Lights->GetNumberOfLights(); ++i)
  {
    const vtkSoftShadowLights::LitLight& light = job.Lights->GetLight(i);
    if (!light.Casts || !job.Losses->GetReason(light.Layer).empty())
    {
      continue;
    }
    services.Light = i;
    services.Source = light.Light;
    const vtkShadowFailures failures;
    if (preparing)
    {
      this->PrepareLight(job, services, light.Layer);
    }
    else
    {
      this->EstimateLight(job, services, light.Layer);
    }
    job.Losses->Lose(light.Layer, failures.GetFirst());
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowEstimator::PrepareLight(
  const Job& job, vtkSoftShadowServices& services, int layer)
{
  const vtkSoftShadowLightFit& fit = job.Lights->GetFit(layer);
  if (GetSplit(job) > 1 && job.Requirements.EmitterMap &&
    fit.GetNumberOfParts() > services.GetMapsPerBatch(GetMapSize(job.Requirements, services)))
  {
    return; // they would be drawn twice
  }
  services.Part = 0;
  for (size_t f = 0; f < fit.GetFaces().size(); ++f)
  {
    const vtkSoftShadowLightFit::Face& face = fit.GetFaces()[f];
    services.FaceAxis = face.Axis;
    for (size_t p = 0; p < face.Parts.size(); ++p)
    {
      if (this->SelectFaces(job, services, layer) && this->SelectPart(job, services, layer, f, p))
      {
        job.Technique->Prepare(services);
      }
      if (vtkShadowFailures::IsFailing())
      {
        return;
      }
      ++services.Part;
    }
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowEstimator::EstimateLight(
  const Job& job, vtkSoftShadowServices& services, int layer)
{
  services.BeginStep("visibility");
  const vtkSoftShadowLightFit& fit = job.Lights->GetFit(layer);
  if (!job.Target->BeginLight(services.Window, layer))
  {
    return;
  }
  services.Part = 0;
  for (size_t f = 0; f < fit.GetFaces().size(); ++f)
  {
    const vtkSoftShadowLightFit::Face& face = fit.GetFaces()[f];
    if (!this->SelectFaces(job, services, layer))
    {
      return;
    }
    services.FaceAxis = face.Axis;
    services.Emitter = face.Emitter;
    services.Layer = face.Layer;
    job.Target->BeginMarks(services.Window);
    this->DrawMarks(job, services, face.HasCasters ? &face.View : nullptr);
    job.Target->BeginFilter(services.Window);
    job.Pixels->BeginMarks();
    for (size_t p = 0; p < face.Parts.size() && !vtkShadowFailures::IsFailing(); ++p)
    {
      this->EstimatePart(job, services, layer, f, p);
      ++services.Part;
    }
  }
}

//------------------------------------------------------------------------------
// The maps of all faces. Without one nothing is selected.
bool vtkSoftShadowEstimator::SelectFaces(const Job& job, vtkSoftShadowServices& services, int layer)
{
  const Requirements& requirements = job.Requirements;
  const bool proves = services.EarlyOut && requirements.Proof != Requirements::PROVES_NOTHING;
  services.Maps = nullptr;
  services.Pyramid = this->NoPyramid;
  services.GetStore().BeginEmitter();
  vtkShadowMapStore::Request request;
  request.Pyramid = proves || requirements.Pyramid;
  if (!request.Pyramid && (GetSplit(job) > 1 || !requirements.EmitterMap))
  {
    return true;
  }
  request.Views = job.Lights->GetFit(layer).GetFaceViews();
  request.MapSize = GetMapSize(requirements, services);
  request.Conservative = requirements.ConservativeMap;
  return request.Views.empty() ||
    this->Select(services, { services.Source, 0, vtkSoftShadowServices::FACE_MAPS }, request);
}

//------------------------------------------------------------------------------
bool vtkSoftShadowEstimator::Select(vtkSoftShadowServices& services,
  const vtkShadowMapStore::Key& key, const vtkShadowMapStore::Request& request)
{
  services.BeginStep("maps");
  const vtkShadowMapStore::Maps maps =
    services.GetStore().Bake(services.Renderer, services.Casters, key, request);
  services.BeginStep("visibility");
  services.CountBakes(maps.Baked, request.MapSize);
  services.Maps = maps.Depths;
  services.Pyramid = maps.Pyramid ? maps.Pyramid : this->NoPyramid.GetPointer();
  return maps.Depths != nullptr;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowEstimator::SelectPart(
  const Job& job, vtkSoftShadowServices& services, int layer, size_t faceIndex, size_t partIndex)
{
  const vtkSoftShadowLightFit& fit = job.Lights->GetFit(layer);
  const vtkSoftShadowLightFit::Face& face = fit.GetFaces()[faceIndex];
  const vtkSoftShadowLightFit::Part& part = face.Parts[partIndex];
  services.Emitter = part.Emitter;
  services.Layer = face.Layer;
  if (!part.HasCasters)
  {
    return false;
  }
  if (face.Parts.size() > 1)
  {
    services.GetStore().BeginEmitter();
  }
  if (job.Requirements.EmitterMap && face.Parts.size() > 1)
  {
    vtkShadowMapStore::Request request;
    request.MapSize = GetMapSize(job.Requirements, services);
    request.Conservative = job.Requirements.ConservativeMap;
    request.Pyramid = job.Requirements.Pyramid;
    size_t selected = 0;
    request.Views =
      fit.GetBatch(faceIndex, partIndex, services.GetMapsPerBatch(request.MapSize), selected);
    services.Layer = static_cast<int>(selected);
    this->Select(services, { services.Source, 0, vtkSoftShadowServices::PART_MAPS }, request);
  }
  return !vtkShadowFailures::IsFailing();
}

//------------------------------------------------------------------------------
void vtkSoftShadowEstimator::EstimatePart(
  const Job& job, vtkSoftShadowServices& services, int layer, size_t faceIndex, size_t partIndex)
{
  if (this->SelectPart(job, services, layer, faceIndex, partIndex))
  {
    job.Technique->Add(services);
  }
  else if (this->ConstantShader.Use(services.Window))
  {
    this->ConstantShader.GetProgram()->SetUniformf(
      "weight", static_cast<float>(services.Emitter.Weight));
    services.DrawMarked(this->ConstantShader);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowEstimator::DrawMarks(
  const Job& job, const vtkSoftShadowServices& services, const vtkShadowMapView* view)
{
  if (!this->ProofShader.Use(services.Window))
  {
    return;
  }
  vtkShaderProgram* program = this->ProofShader.GetProgram();
  const int proof = view && services.EarlyOut ? job.Requirements.Proof
                                              : static_cast<int>(Requirements::PROVES_NOTHING);
  program->SetUniformi("proof", proof);
  program->SetUniformi("hasCasters", view ? 1 : 0);
  services.SetReceiverUniforms(program);
  vtkShadowTextureArray* pyramid = services.Pyramid->GetTexture();
  if (proof != Requirements::PROVES_NOTHING)
  {
    services.SetMapUniforms(program, *view, GetMapSize(job.Requirements, services));
    program->SetUniformf("mapLayer", static_cast<float>(services.Layer));
  }
  const int pyramidUnit = pyramid->Activate(services.Window);
  program->SetUniformi("depthPyramid", pyramidUnit);
  // Not read without a proof: any texture of its kind will do.
  vtkShadowTextureArray* maps =
    proof != Requirements::PROVES_NOTHING ? services.Maps->GetTexture() : nullptr;
  program->SetUniformi("depthMaps", maps ? maps->Activate(services.Window) : pyramidUnit);
  this->ProofShader.Draw();
  if (maps)
  {
    maps->Deactivate();
  }
  pyramid->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
int vtkSoftShadowEstimator::GetNumberOfBuilds() const
{
  return this->ProofShader.GetNumberOfBuilds() + this->ConstantShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkSoftShadowEstimator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ProofShader.ReleaseGraphicsResources(window);
  this->ConstantShader.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
