// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowStrokeProgram.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkShadowMapView.h"
#include "vtkShadowScreen.h"
#include "vtkShadowStrokeFS.h"
#include "vtkShadowStrokeGS.h"
#include "vtkShadowStrokeVS.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
bool vtkShadowStrokeProgram::Use(
  vtkOpenGLRenderWindow* window, const vtkShadowMapView& view, int resolution)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Program)
  {
    cache->ReadyShaderProgram(this->Program);
  }
  else
  {
    this->Program =
      cache->ReadyShaderProgram(vtkShadowStrokeVS, vtkShadowStrokeFS, vtkShadowStrokeGS);
  }
  if (!this->Program)
  {
    return false;
  }
  this->View = &view;
  const GLint location =
    glGetAttribLocation(static_cast<GLuint>(this->Program->GetHandle()), "positionLocal");
  this->Location = location < 0 ? 0u : static_cast<unsigned int>(location);
  const double extent = std::max(view.Window[1] - view.Window[0], view.Window[3] - view.Window[2]);
  this->Program->SetUniformf("halfTexel", static_cast<float>(0.5 * extent / resolution));
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowStrokeProgram::SetPlace(
  const std::array<double, 3>& center, const vtkShadowScreen& screen)
{
  const auto toClip = this->View->WorldToClip(true);
  const double shift[16] = { 1.0, 0.0, 0.0, center[0], 0.0, 1.0, 0.0, center[1], 0.0, 0.0, 1.0,
    center[2], 0.0, 0.0, 0.0, 1.0 };
  double localToClip[16];
  vtkMatrix4x4::Multiply4x4(toClip.data(), shift, localToClip);
  float elements[16];
  for (int i = 0; i < 16; ++i)
  {
    elements[4 * (i % 4) + i / 4] = static_cast<float>(localToClip[i]);
  }
  this->Program->SetUniformMatrix4x4("localToClip", elements);

  const vtkShadowEmitter& emitter = this->View->Emitter;
  float eye[4] = { 0.0f, 0.0f, 0.0f, emitter.Directional ? 0.0f : 1.0f };
  float pixel[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  double atCenter = screen.Plane[3];
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = static_cast<float>(
      emitter.Directional ? emitter.Direction[i] : emitter.Center[i] - center[i]);
    pixel[i] = static_cast<float>(screen.Plane[i]);
    atCenter += screen.Plane[i] * center[i];
  }
  pixel[3] = static_cast<float>(atCenter);
  this->Program->SetUniform4f("eyeLocal", eye);
  this->Program->SetUniform4f("pixelLocal", pixel);
  this->Program->SetUniformf("leastPixel", static_cast<float>(screen.Least));
}

//------------------------------------------------------------------------------
void vtkShadowStrokeProgram::SetKind(bool dots, bool round, double pixels)
{
  this->Program->SetUniformi("isDot", dots ? 1 : 0);
  this->Program->SetUniformi("isRound", round ? 1 : 0);
  this->Program->SetUniformf("halfPixels", static_cast<float>(0.5 * pixels));
}

VTK_ABI_NAMESPACE_END
