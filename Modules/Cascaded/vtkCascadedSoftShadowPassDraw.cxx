// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// How a cascade with one set of points is baked and drawn.
#include "vtkCascadedSoftShadowPassInternals.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowTextureArray.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Internals::SetFade(
  vtkShaderProgram* program, const vtkShadowCascades::Cascade& cascade)
{
  const float fadeIn[2] = { static_cast<float>(cascade.FadeIn.first),
    static_cast<float>(cascade.FadeIn.second) };
  const float fadeOut[2] = { static_cast<float>(cascade.FadeOut.first),
    static_cast<float>(cascade.FadeOut.second) };
  program->SetUniform2f("fadeIn", fadeIn);
  program->SetUniform2f("fadeOut", fadeOut);
}

//------------------------------------------------------------------------------
void vtkCascadedSoftShadowPass::Internals::DrawCascade(vtkCascadedSoftShadowPass* self,
  const vtkSoftShadowContext& context, vtkCascadedSoftShadowMaps& maps, size_t cascade)
{
  const vtkCascadedSoftShadowMaps::Set& set = maps.GetSet(cascade);
  float litWeight = set.Samples.LitWeight;
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
    if (!this->Shader.Use(context.Window))
    {
      return;
    }
    vtkShaderProgram* program = this->Shader.GetProgram();
    Internals::SetFade(program, this->Cascades[cascade]);
    program->SetUniformf("litWeight", litWeight);
    litWeight = 0.0f; // once
    self->SetReceiverUniforms(program, context);
    vtkSoftShadowPass::SetSampleUniforms(program, context, set.Samples.Views.data() + run.First,
      set.Samples.Weights.data() + run.First, run.Last - run.First, run.Layer,
      maps.GetMapSize(set.Resolution), set.FilterSize);
    vtkShadowTextureArray* texture = maps.GetMaps(set.Resolution)->GetTexture();
    program->SetUniformi("depthMaps", texture->Activate(context.Window));
    self->DrawFiltered(this->Shader);
    texture->Deactivate();
    context.Receivers->Deactivate();
    first = std::max<size_t>(run.Last, 1);
  }
}

//------------------------------------------------------------------------------
vtkCascadedSoftShadowMaps::Run vtkCascadedSoftShadowPass::Internals::Bake(
  vtkCascadedSoftShadowPass* self, const vtkSoftShadowContext& context,
  vtkCascadedSoftShadowMaps& maps, size_t set, size_t first)
{
  self->BeginStep("cascade maps");
  const size_t memory = static_cast<size_t>(self->MapMemory) << 20;
  std::array<int, vtkCascadedSoftShadowMaps::NumberOfResolutions> baked = { {} };
  const vtkCascadedSoftShadowMaps::Run run = maps.Bake(context, set, first, memory, baked);
  for (int resolution = 0; resolution < vtkCascadedSoftShadowMaps::NumberOfResolutions;
       ++resolution)
  {
    const vtkTypeInt64 size = maps.GetMapSize(resolution);
    self->ChangeStatistics().MapsBaked += baked[resolution];
    self->ChangeStatistics().TexelsDrawn += baked[resolution] * size * size;
  }
  self->BeginStep("visibility");
  return run;
}
VTK_ABI_NAMESPACE_END
