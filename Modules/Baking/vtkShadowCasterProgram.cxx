// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterProgram.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterFS.h"
#include "vtkShadowCasterVS.h"
#include "vtkShadowConservativeFS.h"
#include "vtkShadowConservativeGS.h"
#include "vtkShadowDriver.h"
#include "vtkShadowFailures.h"
#include "vtkShadowMapView.h"
#include "vtkSoftShadowsOpenGL.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
#ifdef GL_ZERO_TO_ONE
// Loaders find the function where the driver does not support it.
bool HasClipControl()
{
  return (vtkShadowDriver::HasVersion(4, 5) ||
           vtkShadowDriver::HasExtension("GL_ARB_clip_control")) &&
    glClipControl != nullptr;
}
#else
bool HasClipControl()
{
  return false;
}
#endif

// The marks by which VTK puts a version before a shader come first.
std::string WithDepth(const char* shader)
{
  const std::string mark = "//VTK::System::Dec\n";
  std::string text = shader;
  return text.replace(text.find(mark), mark.size(), mark + "#define SHADOW_WRITES_DEPTH\n");
}
}

//------------------------------------------------------------------------------
vtkShadowCasterProgram::ScopedState::ScopedState(vtkOpenGLState* state)
  : DepthTest(state, GL_DEPTH_TEST)
  , CullFace(state, GL_CULL_FACE)
  , Blend(state, GL_BLEND)
  , State(state)
  , DepthMask(state)
  , DepthFunc(state)
  , ColorMask(state)
  , HadDepthClamp(glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE)
  , HadPolygonOffset(glIsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE)
{
  state->vtkglGetIntegerv(GL_CULL_FACE_MODE, &this->CullFaceMode);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_GREATER); // maps hold 1 on the near plane, 0 where nothing is
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  // vtkOpenGLState knows neither of these.
  glEnable(GL_DEPTH_CLAMP);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

//------------------------------------------------------------------------------
vtkShadowCasterProgram::ScopedState::~ScopedState()
{
  this->State->vtkglCullFace(static_cast<unsigned int>(this->CullFaceMode));
  if (!this->HadDepthClamp)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  if (this->HadPolygonOffset)
  {
    glEnable(GL_POLYGON_OFFSET_FILL);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowCasterProgram::Use(vtkOpenGLRenderWindow* window, const vtkShadowMapView& view,
  const std::array<double, 3>& origin, int resolution, bool conservative)
{
  vtkShaderProgram*& program = this->Programs[conservative ? 1 : 0];
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (program)
  {
    cache->ReadyShaderProgram(program);
  }
  else
  {
    // Conservative triangles write their depth in any case.
    this->WritesDepth = !HasClipControl();
    program = conservative ? cache->ReadyShaderProgram(
                               vtkShadowCasterVS, vtkShadowConservativeFS, vtkShadowConservativeGS)
      : this->WritesDepth ? cache->ReadyShaderProgram(WithDepth(vtkShadowCasterVS).c_str(),
                              WithDepth(vtkShadowCasterFS).c_str(), "")
                          : cache->ReadyShaderProgram(vtkShadowCasterVS, vtkShadowCasterFS, "");
  }
  if (!program)
  {
    vtkShadowFailures::Report("a shader does not compile");
    return false;
  }
#ifdef GL_ZERO_TO_ONE
  if (!this->WritesDepth)
  {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  }
#endif
  const GLint location =
    glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), "positionLocal");
  this->Location = location < 0 ? 0u : static_cast<unsigned int>(location);

  const auto toClip = view.WorldToClip(true);
  const double shift[16] = { 1.0, 0.0, 0.0, origin[0], 0.0, 1.0, 0.0, origin[1], 0.0, 0.0, 1.0,
    origin[2], 0.0, 0.0, 0.0, 1.0 };
  double localToClip[16];
  vtkMatrix4x4::Multiply4x4(toClip.data(), shift, localToClip);
  float elements[16];
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      elements[4 * column + row] = static_cast<float>(localToClip[4 * row + column]);
    }
  }
  program->SetUniformMatrix4x4("localToClip", elements);
  if (conservative)
  {
    constexpr double ROUNDING = 1e-3; // of half a texel
    constexpr double LEAST = 1e-4;    // of the near distance
    program->SetUniformf("halfTexel", static_cast<float>((1.0 + ROUNDING) / resolution));
    program->SetUniformf(
      "leastW", view.Emitter.Directional ? 0.5f : static_cast<float>(LEAST * view.Near));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowCasterProgram::Finish() const
{
#ifdef GL_ZERO_TO_ONE
  if (!this->WritesDepth)
  {
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
#endif
}

//------------------------------------------------------------------------------
void vtkShadowCasterProgram::SetSide(vtkOpenGLState* state, int side)
{
  if (side == 0)
  {
    state->vtkglDisable(GL_CULL_FACE);
    return;
  }
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(side > 0 ? GL_BACK : GL_FRONT);
}

//------------------------------------------------------------------------------
void vtkShadowCasterProgram::ReleaseGraphicsResources()
{
  this->Programs.fill(nullptr);
}

VTK_ABI_NAMESPACE_END
