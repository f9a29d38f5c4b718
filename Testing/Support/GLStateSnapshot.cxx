// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLStateSnapshot.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSoftShadowsOpenGL.h"

#include <sstream>

namespace SoftShadowsTesting
{
namespace
{

struct NamedState
{
  const char* Name;
  unsigned int Enum;
  int Size;
};

// What can be read with glGetDoublev.
const NamedState Numbers[] = {
  { "draw framebuffer", GL_DRAW_FRAMEBUFFER_BINDING, 1 },
  { "read framebuffer", GL_READ_FRAMEBUFFER_BINDING, 1 },
  { "draw buffer 0", GL_DRAW_BUFFER0, 1 },
  { "draw buffer 1", GL_DRAW_BUFFER1, 1 },
  { "read buffer", GL_READ_BUFFER, 1 },
  { "viewport", GL_VIEWPORT, 4 },
  { "scissor box", GL_SCISSOR_BOX, 4 },
  { "blend source colour", GL_BLEND_SRC_RGB, 1 },
  { "blend destination colour", GL_BLEND_DST_RGB, 1 },
  { "blend source alpha", GL_BLEND_SRC_ALPHA, 1 },
  { "blend destination alpha", GL_BLEND_DST_ALPHA, 1 },
  { "blend equation colour", GL_BLEND_EQUATION_RGB, 1 },
  { "blend equation alpha", GL_BLEND_EQUATION_ALPHA, 1 },
  { "depth function", GL_DEPTH_FUNC, 1 },
  { "depth mask", GL_DEPTH_WRITEMASK, 1 },
  { "depth range", GL_DEPTH_RANGE, 2 },
  { "clear depth", GL_DEPTH_CLEAR_VALUE, 1 },
  { "clear colour", GL_COLOR_CLEAR_VALUE, 4 },
  { "colour mask", GL_COLOR_WRITEMASK, 4 },
  { "cull face mode", GL_CULL_FACE_MODE, 1 },
  { "front face", GL_FRONT_FACE, 1 },
  { "polygon offset factor", GL_POLYGON_OFFSET_FACTOR, 1 },
  { "polygon offset units", GL_POLYGON_OFFSET_UNITS, 1 },
  { "active texture", GL_ACTIVE_TEXTURE, 1 },
  { "program", GL_CURRENT_PROGRAM, 1 },
  { "vertex array", GL_VERTEX_ARRAY_BINDING, 1 },
  { "array buffer", GL_ARRAY_BUFFER_BINDING, 1 },
  { "pixel pack buffer", GL_PIXEL_PACK_BUFFER_BINDING, 1 },
  { "pixel unpack buffer", GL_PIXEL_UNPACK_BUFFER_BINDING, 1 },
  { "pack alignment", GL_PACK_ALIGNMENT, 1 },
  { "unpack alignment", GL_UNPACK_ALIGNMENT, 1 },
  { "line width", GL_LINE_WIDTH, 1 },
  { "point size", GL_POINT_SIZE, 1 },
  { "polygon mode", GL_POLYGON_MODE, 1 },
  { "provoking vertex", GL_PROVOKING_VERTEX, 1 },
  { "renderbuffer", GL_RENDERBUFFER_BINDING, 1 },
  { "uniform buffer", GL_UNIFORM_BUFFER_BINDING, 1 },
  { "pack row length", GL_PACK_ROW_LENGTH, 1 },
  { "pack skip pixels", GL_PACK_SKIP_PIXELS, 1 },
  { "unpack row length", GL_UNPACK_ROW_LENGTH, 1 },
  { "unpack skip rows", GL_UNPACK_SKIP_ROWS, 1 },
  { "clear stencil", GL_STENCIL_CLEAR_VALUE, 1 },
  { "stencil function", GL_STENCIL_FUNC, 1 },
  { "stencil reference", GL_STENCIL_REF, 1 },
  { "stencil value mask", GL_STENCIL_VALUE_MASK, 1 },
  { "stencil write mask", GL_STENCIL_WRITEMASK, 1 },
  { "stencil fail", GL_STENCIL_FAIL, 1 },
  { "stencil depth fail", GL_STENCIL_PASS_DEPTH_FAIL, 1 },
  { "stencil depth pass", GL_STENCIL_PASS_DEPTH_PASS, 1 },
};

// What can be read with glIsEnabled. The first Cached of them VTK keeps as well.
const NamedState Switches[] = {
  { "blend", GL_BLEND, 0 },
  { "depth test", GL_DEPTH_TEST, 0 },
  { "cull face", GL_CULL_FACE, 0 },
  { "scissor test", GL_SCISSOR_TEST, 0 },
  { "stencil test", GL_STENCIL_TEST, 0 },
  { "multisample", GL_MULTISAMPLE, 0 },
  { "polygon offset fill", GL_POLYGON_OFFSET_FILL, 0 },
  { "depth clamp", GL_DEPTH_CLAMP, 0 },
  { "clip distance 0", GL_CLIP_DISTANCE0, 0 },
  { "clip distance 1", GL_CLIP_DISTANCE1, 0 },
  { "framebuffer sRGB", GL_FRAMEBUFFER_SRGB, 0 },
  { "program point size", GL_PROGRAM_POINT_SIZE, 0 },
};
const int Cached = 6;

//------------------------------------------------------------------------------
std::string Text(const std::vector<double>& values)
{
  std::ostringstream text;
  for (const double value : values)
  {
    text << ' ' << value;
  }
  return text.str();
}

}

//------------------------------------------------------------------------------
GLStateSnapshot::GLStateSnapshot(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  for (const NamedState& state : Numbers)
  {
    double values[4] = { 0.0, 0.0, 0.0, 0.0 };
    glGetDoublev(state.Enum, values);
    this->Values.emplace_back(state.Name, std::vector<double>(values, values + state.Size));
  }
  for (const NamedState& state : Switches)
  {
    this->Values.emplace_back(
      state.Name, std::vector<double>(1, glIsEnabled(state.Enum) ? 1.0 : 0.0));
  }
}

//------------------------------------------------------------------------------
std::string GLStateSnapshot::DifferenceTo(const GLStateSnapshot& other) const
{
  std::ostringstream text;
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    if (this->Values[i].second != other.Values[i].second)
    {
      text << this->Values[i].first << ':' << Text(this->Values[i].second) << " became"
           << Text(other.Values[i].second) << '\n';
    }
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string StateCacheErrors(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  std::ostringstream text;
  for (int i = 0; i < Cached; ++i)
  {
    const bool actual = glIsEnabled(Switches[i].Enum) != GL_FALSE;
    const bool cached = window->GetState()->GetEnumState(Switches[i].Enum);
    if (actual != cached)
    {
      text << Switches[i].Name << " is " << actual << ", VTK holds it for " << cached << '\n';
    }
  }
  return text.str();
}

}
