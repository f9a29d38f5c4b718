// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLObjectCounter.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTextureUnitManager.h"

#include <ostream>
#include <tuple>

namespace SoftShadowsTesting
{
namespace
{

// Drivers hand out small names first. A test makes far fewer objects.
const unsigned int LargestName = 1u << 13;

//------------------------------------------------------------------------------
auto AsTuple(const GLObjectCounts& c)
{
  return std::tie(c.Textures, c.Buffers, c.Framebuffers, c.Renderbuffers, c.VertexArrays,
    c.Programs, c.Shaders, c.Queries, c.TextureUnits);
}

}

//------------------------------------------------------------------------------
bool GLObjectCounts::operator==(const GLObjectCounts& other) const
{
  return AsTuple(*this) == AsTuple(other);
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const GLObjectCounts& c)
{
  return os << c.Textures << " textures, " << c.Buffers << " buffers, " << c.Framebuffers
            << " framebuffers, " << c.Renderbuffers << " renderbuffers, " << c.VertexArrays
            << " vertex arrays, " << c.Programs << " programs, " << c.Shaders << " shaders, "
            << c.Queries << " queries, " << c.TextureUnits << " texture units";
}

//------------------------------------------------------------------------------
GLObjectCounts CountGLObjects(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  GLObjectCounts counts;
  for (unsigned int name = 1; name <= LargestName; ++name)
  {
    counts.Textures += glIsTexture(name) ? 1 : 0;
    counts.Buffers += glIsBuffer(name) ? 1 : 0;
    counts.Framebuffers += glIsFramebuffer(name) ? 1 : 0;
    counts.Renderbuffers += glIsRenderbuffer(name) ? 1 : 0;
    counts.VertexArrays += glIsVertexArray(name) ? 1 : 0;
    counts.Programs += glIsProgram(name) ? 1 : 0;
    counts.Shaders += glIsShader(name) ? 1 : 0;
    counts.Queries += glIsQuery(name) ? 1 : 0;
  }
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  for (int unit = 0; unit < units->GetNumberOfTextureUnits(); ++unit)
  {
    counts.TextureUnits += units->IsAllocated(unit) ? 1 : 0;
  }
  return counts;
}

}
