// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDriver.h"

#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
vtkShadowDriver::KindType Pretended = vtkShadowDriver::TOLD_BY_NAME;

// Parts of the names of drivers that draw on the processor: Mesa's, Google's, Microsoft's and Apple's.
// Layers over another driver have its name in theirs: zink, Direct3D.
const char* const ProcessorNames[] = { "llvmpipe", "softpipe", "lavapipe", "swrast", "SWR (",
  "Software Rasterizer", "SwiftShader", "GDI Generic", "Microsoft Basic Render",
  "Apple Software Renderer" };

// Null without a context.
std::string ToString(const GLubyte* name)
{
  return name ? reinterpret_cast<const char*>(name) : "";
}

std::string GetRenderer()
{
  return ToString(glGetString(GL_RENDERER));
}
} // namespace

//------------------------------------------------------------------------------
bool vtkShadowDriver::IsOfProcessor(const std::string& renderer)
{
  return std::any_of(std::begin(ProcessorNames), std::end(ProcessorNames),
    [&renderer](const char* name) { return renderer.find(name) != std::string::npos; });
}

//------------------------------------------------------------------------------
bool vtkShadowDriver::DrawsOnProcessor()
{
  return Pretended == TOLD_BY_NAME ? vtkShadowDriver::IsOfProcessor(GetRenderer())
                                   : Pretended == PROCESSOR;
}

//------------------------------------------------------------------------------
bool vtkShadowDriver::OrdersVertices()
{
  return !vtkShadowDriver::IsOfProcessor(GetRenderer());
}

//------------------------------------------------------------------------------
bool vtkShadowDriver::HasVersion(int major, int minor)
{
  GLint current[2] = { 0, 0 };
  glGetIntegerv(GL_MAJOR_VERSION, &current[0]);
  glGetIntegerv(GL_MINOR_VERSION, &current[1]);
  return current[0] > major || (current[0] == major && current[1] >= minor);
}

//------------------------------------------------------------------------------
bool vtkShadowDriver::HasExtension(const std::string& name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    if (ToString(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))) == name)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkShadowDriver::Pretend(KindType kind)
{
  Pretended = kind;
}
VTK_ABI_NAMESPACE_END
