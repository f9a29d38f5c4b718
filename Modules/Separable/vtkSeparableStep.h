// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeparableStep
 * @brief   A shader of this module: its snippets and marks in place, and uniforms that steps share.
 */

#ifndef vtkSeparableStep_h
#define vtkSeparableStep_h

#include "vtkShadowShader.h"   // For the shader
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <string> // For text

VTK_ABI_NAMESPACE_BEGIN
struct vtkShadowMapView;
struct vtkSoftShadowContext;

class vtkSeparableStep
{
public:
  ///@{
  /// In place of the depth between receiver and blockers in the rows of the filter: no blockers; no
  /// row, because the pixel was proved lit or blocked; no row, because its kernel has none.
  static constexpr float LitRow = -1.0f;
  static constexpr float ProvedRow = -2.0f;
  static constexpr float NoRow = -3.0f;
  ///@}

  explicit vtkSeparableStep(const char* text);

  vtkShadowShader& GetShader() { return this->Shader; }

  /// Homogeneous map coordinates to homogeneous texture coordinates of the screen, column-major.
  static void MapToScreen(
    const vtkSoftShadowContext& context, const vtkShadowMapView& view, float matrix[16]);

private:
  std::string Text;
  vtkShadowShader Shader;
};

VTK_ABI_NAMESPACE_END
#endif
