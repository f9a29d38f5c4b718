// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Faults.h"

#include "vtkSoftShadowsOpenGL.h"

#include <limits>

namespace SoftShadowsTesting
{
namespace
{

int Calls = 0;
int Failing = 0;
decltype(glTexImage3D) TexImage3D = nullptr;
decltype(glRenderbufferStorage) RenderbufferStorage = nullptr;
decltype(glBufferData) BufferData = nullptr;
decltype(glCheckFramebufferStatus) CheckFramebufferStatus = nullptr;

//------------------------------------------------------------------------------
bool IsNext()
{
  return ++Calls == Failing;
}

//------------------------------------------------------------------------------
void GLAPIENTRY FailTexImage3D(GLenum target, GLint level, GLint internal, GLsizei width,
  GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels)
{
  const bool fails = IsNext();
  const GLsizei edge = 16384;
  TexImage3D(target, level, internal, fails ? edge : width, fails ? edge : height,
    fails ? 2048 : depth, border, format, type, pixels);
}

//------------------------------------------------------------------------------
void GLAPIENTRY FailRenderbufferStorage(
  GLenum target, GLenum internal, GLsizei width, GLsizei height)
{
  RenderbufferStorage(
    target, internal, IsNext() ? std::numeric_limits<GLsizei>::max() : width, height);
}

//------------------------------------------------------------------------------
// VTK's own buffers are VTK's to worry about.
void GLAPIENTRY FailBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
  const bool fails = usage == GL_DYNAMIC_DRAW && !data && IsNext();
  BufferData(target, fails ? GLsizeiptr(1) << 46 : size, data, usage);
}

//------------------------------------------------------------------------------
GLenum GLAPIENTRY FailCheckFramebufferStatus(GLenum target)
{
  return IsNext() ? GL_FRAMEBUFFER_UNSUPPORTED : CheckFramebufferStatus(target);
}

}

//------------------------------------------------------------------------------
Messages::Messages()
  : Before(vtkOutputWindow::GetInstance())
{
  vtkOutputWindow::SetInstance(this->Window);
}

//------------------------------------------------------------------------------
Messages::~Messages()
{
  vtkOutputWindow::SetInstance(this->Before);
}

//------------------------------------------------------------------------------
int Messages::Count(const std::string& text)
{
  const std::string all = this->Get();
  int count = 0;
  for (std::size_t at = all.find(text); at != std::string::npos; at = all.find(text, at + 1))
  {
    ++count;
  }
  return count;
}

//------------------------------------------------------------------------------
Faults::Faults(int which)
{
  Calls = 0;
  Failing = which;
  TexImage3D = glTexImage3D;
  RenderbufferStorage = glRenderbufferStorage;
  BufferData = glBufferData;
  CheckFramebufferStatus = glCheckFramebufferStatus;
  glTexImage3D = FailTexImage3D;
  glRenderbufferStorage = FailRenderbufferStorage;
  glBufferData = FailBufferData;
  glCheckFramebufferStatus = FailCheckFramebufferStatus;
}

//------------------------------------------------------------------------------
Faults::~Faults()
{
  glTexImage3D = TexImage3D;
  glRenderbufferStorage = RenderbufferStorage;
  glBufferData = BufferData;
  glCheckFramebufferStatus = CheckFramebufferStatus;
}

//------------------------------------------------------------------------------
bool Faults::HasFailed() const
{
  return Calls >= Failing;
}

}
