// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeparableStep.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkSeparableSoftShadowPass.h"
#include "vtkShaderProgram.h"
#include "vtkShadowMapView.h"
#include "vtkShadowReceivers.h"
#include "vtkSoftShadowContext.h"

#include "vtkSeparableReuse.h"
#include "vtkSeparableRows.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
std::string Compose(std::string text)
{
  vtkShaderProgram::Substitute(text, "//Separable::Rows", vtkSeparableRows);
  vtkShaderProgram::Substitute(text, "//Separable::Reuse", vtkSeparableReuse);
  return text;
}
} // namespace

//------------------------------------------------------------------------------
vtkSeparableStep::vtkSeparableStep(const char* text)
  : Text(Compose(text))
  , Shader(this->Text.c_str())
{
  using Pass = vtkSeparableSoftShadowPass;
  this->Shader.SetDefinitions(
    { { "SEPARABLE_DEBUG_SEARCH", std::to_string(Pass::DEBUG_SEARCH_REUSE) },
      { "SEPARABLE_DEBUG_FILTER", std::to_string(Pass::DEBUG_FILTER_REUSE) },
      { "SEPARABLE_LIT_ROW", std::to_string(vtkSeparableStep::LitRow) },
      { "SEPARABLE_NO_ROW", std::to_string(vtkSeparableStep::NoRow) },
      { "SEPARABLE_PROVED", std::to_string(vtkSeparableStep::ProvedRow) } });
}

//------------------------------------------------------------------------------
void vtkSeparableStep::MapToScreen(
  const vtkSoftShadowContext& context, const vtkShadowMapView& view, float matrix[16])
{
  double viewToMap[16];
  vtkMatrix4x4::Multiply4x4(
    view.WorldToMap().data(), context.Receivers->GetViewToWorld().data(), viewToMap);
  double mapToView[16];
  vtkMatrix4x4::Invert(viewToMap, mapToView);
  vtkMatrix4x4* projection = context.Renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    context.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  double mapToClip[16];
  vtkMatrix4x4::Multiply4x4(projection->GetData(), mapToView, mapToClip);
  for (int column = 0; column < 4; ++column)
  {
    const double w = mapToClip[12 + column];
    matrix[4 * column + 0] = static_cast<float>(0.5 * (mapToClip[column] + w));
    matrix[4 * column + 1] = static_cast<float>(0.5 * (mapToClip[4 + column] + w));
    matrix[4 * column + 2] = 0.0f;
    matrix[4 * column + 3] = static_cast<float>(w);
  }
}
VTK_ABI_NAMESPACE_END
