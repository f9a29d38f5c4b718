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

enum Which
{
  NORMAL = 0,
  CONSERVATIVE = 1,
  LAYERS = 2
};

// The marks by which VTK puts a version before a shader come first.
std::string WithLines(const char* shader, const std::string& lines)
{
  const std::string mark = "//VTK::System::Dec\n";
  std::string text = shader;
  return text.replace(text.find(mark), mark.size(), mark + lines);
}

// Column by column, relative to the casters' origin.
void GetLocalToClip(
  const vtkShadowMapView& view, const std::array<double, 3>& origin, float elements[16])
{
  const auto toClip = view.WorldToClip(true);
  const double shift[16] = { 1.0, 0.0, 0.0, origin[0], 0.0, 1.0, 0.0, origin[1], 0.0, 0.0, 1.0,
    origin[2], 0.0, 0.0, 0.0, 1.0 };
  double localToClip[16];
  vtkMatrix4x4::Multiply4x4(toClip.data(), shift, localToClip);
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      elements[4 * column + row] = static_cast<float>(localToClip[4 * row + column]);
    }
  }
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
// The last that there is: it is written against OpenGL 3.2, the other against a later one.
bool vtkShadowCasterProgram::CanDrawLayers()
{
  if (!this->IsLayerKnown)
  {
    this->IsLayerKnown = true;
    for (const char* name : { "GL_ARB_shader_viewport_layer_array", "GL_AMD_vertex_shader_layer" })
    {
      this->LayerExtension = vtkShadowDriver::HasExtension(name) ? name : this->LayerExtension;
    }
  }
  return this->LayerExtension != nullptr;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkShadowCasterProgram::MakeReady(vtkOpenGLRenderWindow* window, int which)
{
  vtkShaderProgram*& program = this->Programs[which];
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (program)
  {
    cache->ReadyShaderProgram(program);
    return program;
  }
  this->WritesDepth = !HasClipControl();
  if (which == CONSERVATIVE)
  {
    // Such triangles write their depth in any case.
    program = cache->ReadyShaderProgram(
      vtkShadowCasterVS, vtkShadowConservativeFS, vtkShadowConservativeGS);
    return program;
  }
  const std::string depth = this->WritesDepth ? "#define SHADOW_WRITES_DEPTH\n" : "";
  const std::string layers = which == LAYERS ? "#extension " + std::string(this->LayerExtension) +
      " : require\n#define SHADOW_LAYERS " + std::to_string(LayersPerDraw) + "\n"
                                             : "";
  program = cache->ReadyShaderProgram(WithLines(vtkShadowCasterVS, layers + depth).c_str(),
    WithLines(vtkShadowCasterFS, depth).c_str(), "");
  return program;
}

//------------------------------------------------------------------------------
void vtkShadowCasterProgram::Begin(vtkShaderProgram* program)
{
#ifdef GL_ZERO_TO_ONE
  if (!this->WritesDepth)
  {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  }
#endif
  const GLint location =
    glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), "positionLocal");
  this->Location = location < 0 ? 0u : static_cast<unsigned int>(location);
}

//------------------------------------------------------------------------------
bool vtkShadowCasterProgram::Use(vtkOpenGLRenderWindow* window, const vtkShadowMapView& view,
  const std::array<double, 3>& origin, int resolution, bool conservative)
{
  vtkShaderProgram* program = this->MakeReady(window, conservative ? CONSERVATIVE : NORMAL);
  if (!program)
  {
    vtkShadowFailures::Report("a shader does not compile");
    return false;
  }
  this->Begin(program);
  float localToClip[16];
  GetLocalToClip(view, origin, localToClip);
  program->SetUniformMatrix4x4("localToClip", localToClip);
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
bool vtkShadowCasterProgram::UseLayers(vtkOpenGLRenderWindow* window, const vtkShadowMapView* views,
  int count, int firstLayer, const std::array<double, 3>& origin)
{
  vtkShaderProgram* program = this->MakeReady(window, LAYERS);
  if (!program)
  {
    this->LayerExtension = nullptr; // the driver promised more than it holds
    return false;
  }
  this->Begin(program);
  std::array<float, 16 * LayersPerDraw> localToClip{};
  for (int i = 0; i < count; ++i)
  {
    GetLocalToClip(views[i], origin, localToClip.data() + 16 * i);
  }
  program->SetUniformMatrix4x4v("localToClip", count, localToClip.data());
  program->SetUniformi("firstLayer", firstLayer);
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
  this->IsLayerKnown = false;
  this->LayerExtension = nullptr;
}

VTK_ABI_NAMESPACE_END
