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

} // namespace

//------------------------------------------------------------------------------
vtkSoftShadowEstimator::vtkSoftShadowEstimator()
  : ProofShader(vtkSoftShadowProofFS)
  , ConstantShader(vtkSoftShadowConstantFS)
{
}

//------------------------------------------------------------------------------
int vtkSoftShadowEstimator::BakeMaps(const Job& job, vtkSoftShadowServices& services)
{
  const Requirements& requirements = job.Requirements;
  const bool proves = services.EarlyOut && requirements.Proof != Requirements::PROVES_NOTHING;
  const bool pyramid = proves || requirements.Pyramid;
  const int split = requirements.CutLights ? job.Split : 1;
  const bool faceMaps = pyramid || (split == 1 && requirements.EmitterMap);
  const int mapSize = GetMapSize(requirements, services);
  int tooNear = 0;
  for (const vtkSoftShadowLights::LitLight& light : *job.Lights)
  {
    if (!light.Casts)
    {
      continue;
    }
    vtkSoftShadowLightMaps& maps = job.Lights->GetMaps(light.Layer);
    const vtkShadowFailures failures;
    maps.Fit(light.Emitter, *services.Fitter, services.Casters->GetBodiesTime(), split,
      requirements.GaussianWeights);
    tooNear += maps.GetNumberTooNear();
    if (faceMaps)
    {
      services.CountBakes(maps.BakeFaces(services.Renderer, services.Casters, mapSize,
                            requirements.ConservativeMap, pyramid),
        mapSize);
    }
    job.Losses->Lose(light.Layer, failures.GetFirst());
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
  vtkSoftShadowLightMaps& maps = job.Lights->GetMaps(layer);
  const std::vector<vtkSoftShadowLightMaps::Face>& faces = maps.GetFaces();
  size_t parts = 0;
  for (const vtkSoftShadowLightMaps::Face& face : faces)
  {
    parts += face.Parts.size();
  }
  if (parts > faces.size() && job.Requirements.EmitterMap &&
    parts > services.GetMapsPerBatch(GetMapSize(job.Requirements, services)))
  {
    return; // they would be drawn twice
  }
  services.Part = 0;
  for (size_t f = 0; f < faces.size(); ++f)
  {
    services.FaceAxis = faces[f].Axis;
    for (size_t p = 0; p < faces[f].Parts.size(); ++p)
    {
      services.Maps = maps.GetFaceMaps();
      services.Pyramid = maps.GetFacePyramid();
      services.Layer = faces[f].Layer;
      if (this->SelectPart(job, services, layer, f, p))
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
  vtkSoftShadowLightMaps& maps = job.Lights->GetMaps(layer);
  if (!job.Target->BeginLight(services.Window, layer))
  {
    return;
  }
  services.Part = 0;
  for (size_t f = 0; f < maps.GetFaces().size(); ++f)
  {
    const vtkSoftShadowLightMaps::Face& face = maps.GetFaces()[f];
    services.FaceAxis = face.Axis;
    services.Emitter = face.Emitter;
    services.Maps = maps.GetFaceMaps();
    services.Pyramid = maps.GetFacePyramid();
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
bool vtkSoftShadowEstimator::SelectPart(
  const Job& job, vtkSoftShadowServices& services, int layer, size_t faceIndex, size_t partIndex)
{
  vtkSoftShadowLightMaps& maps = job.Lights->GetMaps(layer);
  const vtkSoftShadowLightMaps::Face& face = maps.GetFaces()[faceIndex];
  const vtkSoftShadowLightMaps::Part& part = face.Parts[partIndex];
  services.Emitter = part.Emitter;
  if (!part.HasCasters)
  {
    return false;
  }
  if (job.Requirements.EmitterMap && face.Parts.size() > 1)
  {
    const int mapSize = GetMapSize(job.Requirements, services);
    int baked = 0;
    services.Layer = maps.BakePart(services.Renderer, services.Casters, faceIndex, partIndex,
      mapSize, job.Requirements.ConservativeMap, services.GetMapsPerBatch(mapSize),
      job.Requirements.Pyramid, baked);
    services.Maps = maps.GetPartMaps();
    services.Pyramid = maps.GetPartPyramid();
    services.CountBakes(baked, mapSize);
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
