// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Step 4 of vtkSoftShadowPass: from receivers and maps to visibility, and what techniques use for
// it.
#include "vtkSoftShadowPass.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowMapFitter.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowPassInternals.h"
#include "vtkSoftShadowsOpenGL.h"

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
void vtkSoftShadowPass::EstimateLights(const vtkRenderState* s, bool changed)
{
  Internals& impl = *this->Impl;
  if (impl.Statistics.LightsCasting == 0)
  {
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  window->GetState()->PushFramebufferBindings();
  const vtkShadowFailures failures; // of what all lights need
  const int made = impl.Target->Allocate(
    window, impl.Viewport[2], impl.Viewport[3], impl.Statistics.LightsCasting);
  impl.Statistics.Allocations += std::max(made, 0);
  const vtkShadowMapFitter fitter(impl.Casters->GetBodies());
  vtkSoftShadowContext context;
  context.Renderer = s->GetRenderer();
  context.Window = window;
  context.Casters = impl.Casters;
  context.Fitter = &fitter;
  context.Receivers = impl.Receivers;
  context.Marks = impl.Target->GetMarks();
  context.Changed = changed || impl.IsTechniqueMoved;
  context.IsData = impl.IsData;
  impl.IsTechniqueMoved = false;
  impl.UsedQueries = 0;
  const bool prepare = made >= 0 && this->BeginVisibility(context);
  if (failures.HasAny())
  {
    impl.Losses.LoseAll(failures.GetFirst());
  }
  else
  {
    if (prepare)
    {
      this->EstimateOrPrepare(context, true);
    }
    this->EstimateOrPrepare(context, false);
  }
  window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::EstimateOrPrepare(vtkSoftShadowContext& context, bool preparing)
{
  Internals& impl = *this->Impl;
  for (size_t i = 0; i < impl.Lights.size(); ++i)
  {
    const int layer = impl.Lights[i].Layer;
    if (!impl.Lights[i].Casts || !impl.Losses.GetReason(layer).empty())
    {
      continue;
    }
    context.Light = static_cast<int>(i);
    context.Source = impl.Lights[i].Light;
    const vtkShadowFailures failures;
    if (preparing)
    {
      this->PrepareLight(context, layer);
    }
    else
    {
      this->EstimateLight(context, layer);
    }
    impl.Losses.Lose(layer, failures.GetFirst());
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::PrepareLight(vtkSoftShadowContext& context, int layer)
{
  vtkSoftShadowLightMaps& maps = *this->Impl->Maps[layer];
  const std::vector<vtkSoftShadowLightMaps::Face>& faces = maps.GetFaces();
  size_t parts = 0;
  for (const vtkSoftShadowLightMaps::Face& face : faces)
  {
    parts += face.Parts.size();
  }
  if (parts > faces.size() && this->NeedsEmitterMap() && parts > this->GetMapsPerBatch())
  {
    return; // they would be drawn twice
  }
  context.Part = 0;
  for (size_t f = 0; f < faces.size(); ++f)
  {
    context.FaceAxis = faces[f].Axis;
    for (size_t p = 0; p < faces[f].Parts.size(); ++p)
    {
      context.Maps = maps.GetFaceMaps();
      context.Pyramid = maps.GetFacePyramid();
      context.Layer = faces[f].Layer;
      if (this->SelectPart(context, layer, f, p))
      {
        this->PrepareVisibility(context);
      }
      if (vtkShadowFailures::IsFailing())
      {
        return;
      }
      ++context.Part;
    }
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::EstimateLight(vtkSoftShadowContext& context, int layer)
{
  Internals& impl = *this->Impl;
  impl.Timers.BeginStep("visibility");
  vtkSoftShadowLightMaps& maps = *impl.Maps[layer];
  if (!impl.Target->BeginLight(context.Window, layer))
  {
    return;
  }
  context.Part = 0;
  for (size_t f = 0; f < maps.GetFaces().size(); ++f)
  {
    const vtkSoftShadowLightMaps::Face& face = maps.GetFaces()[f];
    context.FaceAxis = face.Axis;
    context.Emitter = face.Emitter;
    context.Maps = maps.GetFaceMaps();
    context.Pyramid = maps.GetFacePyramid();
    context.Layer = face.Layer;
    impl.Target->BeginMarks(context.Window);
    this->DrawMarks(context, face.HasCasters ? &face.View : nullptr);
    impl.Target->BeginFilter(context.Window);
    impl.CountNextDraw = true;
    for (size_t p = 0; p < face.Parts.size() && !vtkShadowFailures::IsFailing(); ++p)
    {
      this->EstimatePart(context, layer, f, p);
      ++context.Part;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowPass::SelectPart(
  vtkSoftShadowContext& context, int layer, size_t faceIndex, size_t partIndex)
{
  Internals& impl = *this->Impl;
  vtkSoftShadowLightMaps& maps = *impl.Maps[layer];
  const vtkSoftShadowLightMaps::Face& face = maps.GetFaces()[faceIndex];
  const vtkSoftShadowLightMaps::Part& part = face.Parts[partIndex];
  context.Emitter = part.Emitter;
  if (!part.HasCasters)
  {
    return false;
  }
  if (this->NeedsEmitterMap() && face.Parts.size() > 1)
  {
    int baked = 0;
    context.Layer =
      maps.BakePart(context.Renderer, impl.Casters, faceIndex, partIndex, this->GetLimitedMapSize(),
        this->NeedsConservativeMaps(), this->GetMapsPerBatch(), this->NeedsPyramid(), baked);
    context.Maps = maps.GetPartMaps();
    context.Pyramid = maps.GetPartPyramid();
    this->CountBakes(baked);
  }
  return !vtkShadowFailures::IsFailing();
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::EstimatePart(
  vtkSoftShadowContext& context, int layer, size_t faceIndex, size_t partIndex)
{
  Internals& impl = *this->Impl;
  if (this->SelectPart(context, layer, faceIndex, partIndex))
  {
    this->AddVisibility(context);
  }
  else if (impl.ConstantShader.Use(context.Window))
  {
    impl.ConstantShader.GetProgram()->SetUniformf(
      "weight", static_cast<float>(context.Emitter.Weight));
    this->DrawFiltered(impl.ConstantShader);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::BeginStep(const char* name, bool onProcessor)
{
  this->Impl->Timers.BeginStep(name, onProcessor);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::DrawMarks(const vtkSoftShadowContext& context, const vtkShadowMapView* view)
{
  vtkShadowShader& shader = this->Impl->ProofShader;
  if (!shader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = shader.GetProgram();
  const int proof = view && this->EarlyOut ? this->GetProof() : static_cast<int>(PROVES_NOTHING);
  program->SetUniformi("proof", proof);
  program->SetUniformi("hasCasters", view ? 1 : 0);
  this->SetReceiverUniforms(program, context);
  vtkShadowTextureArray* pyramid = context.Pyramid->GetTexture();
  if (proof != PROVES_NOTHING)
  {
    this->SetMapUniforms(program, context, *view, this->GetLimitedMapSize());
    program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  }
  const int pyramidUnit = pyramid->Activate(context.Window);
  program->SetUniformi("depthPyramid", pyramidUnit);
  // Not read without a proof: any texture of its kind will do.
  vtkShadowTextureArray* maps = proof != PROVES_NOTHING ? context.Maps->GetTexture() : nullptr;
  program->SetUniformi("depthMaps", maps ? maps->Activate(context.Window) : pyramidUnit);
  shader.Draw();
  if (maps)
  {
    maps->Deactivate();
  }
  pyramid->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::SetReceiverUniforms(
  vtkShaderProgram* program, const vtkSoftShadowContext& context)
{
  context.Receivers->Activate(program);
  if (!program->IsUniformUsed("viewToApex"))
  {
    return;
  }
  vtkShadowEmitter apex = context.Emitter;
  apex.Center = apex.Apex;
  float matrix[16];
  ComposeToFloat(apex.WorldToEmitter().data(), context.Receivers->GetViewToWorld().data(), matrix);
  program->SetUniformMatrix4x4("viewToApex", matrix);
  program->SetUniformi("lightDirectional", apex.Directional ? 1 : 0);
  program->SetUniformi("lightOneSided", !apex.Directional && apex.HasExtent() ? 1 : 0);
  program->SetUniformf("lightConeCosine",
    apex.HasCone() ? static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(apex.ConeAngle)))
                   : -2.0f);
  program->SetUniformi("lightFaceAxis", context.FaceAxis);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::ViewToMap(
  const vtkSoftShadowContext& context, const vtkShadowMapView& view, float matrix[16])
{
  ComposeToFloat(view.WorldToMap().data(), context.Receivers->GetViewToWorld().data(), matrix);
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::SetMapUniforms(vtkShaderProgram* program,
  const vtkSoftShadowContext& context, const vtkShadowMapView& view, int mapSize)
{
  float matrix[16];
  vtkSoftShadowPass::ViewToMap(context, view, matrix);
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
vtkSoftShadowSamples vtkSoftShadowPass::FitSamples(
  const vtkSoftShadowContext& context, const std::vector<vtkShadowLightSampling::Sample>& points)
{
  vtkSoftShadowSamples samples;
  for (const vtkShadowLightSampling::Sample& point : points)
  {
    const double weight = point.Weight * context.Emitter.Weight;
    vtkShadowMapView view;
    if (context.Fitter->Fit(context.Emitter.PointAt(point.U, point.V, weight), view))
    {
      samples.Views.push_back(view);
      samples.Weights.push_back(static_cast<float>(weight));
    }
    else
    {
      samples.LitWeight += static_cast<float>(weight);
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::SetSampleUniforms(vtkShaderProgram* program,
  const vtkSoftShadowContext& context, const vtkShadowMapView* views, const float* weights,
  size_t count, size_t firstLayer, int mapSize, int filterSize)
{
  program->SetUniformi("sampleCount", static_cast<int>(count));
  program->SetUniformf("firstLayer", static_cast<float>(firstLayer));
  program->SetUniformf("depthMapSize", static_cast<float>(mapSize));
  program->SetUniformi("filterSize", filterSize);
  if (count > 0)
  {
    vtkSoftShadowPass::SetAffineMapUniforms(program, context, views, count);
    program->SetUniform1fv("sampleWeights", static_cast<int>(count), weights);
    SetDepthUniforms(program, views, count);
  }
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::SetAffineMapUniforms(vtkShaderProgram* program,
  const vtkSoftShadowContext& context, const vtkShadowMapView* views, size_t count)
{
  float viewToBase[16];
  vtkSoftShadowPass::ViewToMap(context, views[0], viewToBase);
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
bool vtkSoftShadowPass::ExceedsMapMemory(vtkTypeInt64 bytes) const
{
  return bytes > static_cast<vtkTypeInt64>(this->MapMemory) << 20;
}

//------------------------------------------------------------------------------
size_t vtkSoftShadowPass::GetMapsPerBatch() const
{
  const auto size = static_cast<size_t>(this->GetLimitedMapSize());
  const size_t bytes = size * size * 4;
  const size_t fitting = std::max<size_t>((static_cast<size_t>(this->MapMemory) << 20) / bytes, 1);
  return std::min(fitting, static_cast<size_t>(vtkShadowLimits::GetTextureLayers()));
}

//------------------------------------------------------------------------------
void vtkSoftShadowPass::DrawFiltered(vtkShadowShader& shader)
{
  Internals& impl = *this->Impl;
  if (!impl.CountNextDraw)
  {
    shader.Draw();
    return;
  }
  impl.CountNextDraw = false;
  if (impl.UsedQueries == impl.Queries.size())
  {
    impl.Queries.push_back(0);
    glGenQueries(1, &impl.Queries.back());
  }
  glBeginQuery(GL_SAMPLES_PASSED, impl.Queries[impl.UsedQueries++]);
  shader.Draw();
  glEndQuery(GL_SAMPLES_PASSED);
}
VTK_ABI_NAMESPACE_END
