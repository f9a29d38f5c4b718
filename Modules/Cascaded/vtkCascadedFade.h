// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedFade
 * @brief   Between which view depths a cascade counts: uniforms of the steps that draw one.
 */

#ifndef vtkCascadedFade_h
#define vtkCascadedFade_h

#include "vtkShaderProgram.h"  // For uniforms
#include "vtkShadowCascades.h" // For cascades
#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

struct vtkCascadedFade
{
  static void SetUniforms(vtkShaderProgram* program, const vtkShadowCascades::Cascade& cascade)
  {
    const float fadeIn[2] = { static_cast<float>(cascade.FadeIn.first),
      static_cast<float>(cascade.FadeIn.second) };
    const float fadeOut[2] = { static_cast<float>(cascade.FadeOut.first),
      static_cast<float>(cascade.FadeOut.second) };
    program->SetUniform2f("fadeIn", fadeIn);
    program->SetUniform2f("fadeOut", fadeOut);
  }
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkCascadedFade.h
