// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFramebuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowFailures.h"
#include "vtkSoftShadowsOpenGL.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkShadowFramebuffer::vtkShadowFramebuffer()
  : Watch(
      [this](vtkOpenGLRenderWindow*)
      {
        glDeleteFramebuffers(1, &this->Handle);
        this->Handle = 0;
      })
{
}

//------------------------------------------------------------------------------
vtkShadowFramebuffer::~vtkShadowFramebuffer() = default;

//------------------------------------------------------------------------------
void vtkShadowFramebuffer::Bind(vtkOpenGLRenderWindow* window)
{
  this->Watch.Enter(window);
  if (!this->Handle)
  {
    glGenFramebuffers(1, &this->Handle);
  }
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Handle);
}

//------------------------------------------------------------------------------
void vtkShadowFramebuffer::AttachDepthBuffer(unsigned int renderbuffer)
{
  glFramebufferRenderbuffer(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, renderbuffer);
}

//------------------------------------------------------------------------------
void vtkShadowFramebuffer::SetDrawBuffers(vtkOpenGLRenderWindow* window, int count)
{
  if (count < 2)
  {
    window->GetState()->vtkglDrawBuffer(count > 0 ? GL_COLOR_ATTACHMENT0 : GL_NONE);
    return;
  }
  std::vector<unsigned int> buffers;
  for (int i = 0; i < count; ++i)
  {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(i));
  }
  window->GetState()->vtkglDrawBuffers(static_cast<unsigned int>(count), buffers.data());
  // VTK's cache keeps all but the first from the framebuffer before, and may have left out the call.
  glDrawBuffers(count, buffers.data());
}

//------------------------------------------------------------------------------
bool vtkShadowFramebuffer::IsComplete()
{
  const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE)
  {
    return true;
  }
  vtkShadowFailures::Report(
    "OpenGL cannot draw into a framebuffer (status " + std::to_string(status) + ")");
  return false;
}
VTK_ABI_NAMESPACE_END
