// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowFailures.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSoftShadowTarget::vtkSoftShadowTarget() = default;

//------------------------------------------------------------------------------
vtkSoftShadowTarget::~vtkSoftShadowTarget() = default;

//------------------------------------------------------------------------------
int vtkSoftShadowTarget::Allocate(vtkOpenGLRenderWindow* window, int width, int height, int layers)
{
  const bool resize = this->Texture->GetWidth() != width || this->Texture->GetHeight() != height;
  if (!resize && this->Texture->GetLayers() >= layers)
  {
    return 0;
  }
  const int count = resize ? layers : std::max(layers, this->Texture->GetLayers());
  if (!this->Texture->Allocate(window, vtkShadowTextureArray::R32F, width, height, count))
  {
    return -1;
  }
  if (!this->AllocateMarks(width, height))
  {
    this->Texture->ReleaseGraphicsResources(window); // one is of no use without the other
    return -1;
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowTarget::AllocateMarks(int width, int height)
{
  if (!this->DepthBuffer)
  {
    glGenRenderbuffers(1, &this->DepthBuffer);
  }
  GLint bound = 0;
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
  glBindRenderbuffer(GL_RENDERBUFFER, this->DepthBuffer);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  const bool made = glGetError() == GL_NO_ERROR;
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  if (!made)
  {
    vtkShadowFailures::Report("no memory for a depth buffer of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels");
  }
  return made;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowTarget::BeginLight(vtkOpenGLRenderWindow* window, int layer)
{
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer.Bind(window);
  vtkShadowFramebuffer::AttachDepthBuffer(this->DepthBuffer);
  this->Texture->AttachLayer(layer);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  if (!vtkShadowFramebuffer::IsComplete())
  {
    return false;
  }
  state->vtkglViewport(0, 0, this->Texture->GetWidth(), this->Texture->GetHeight());
  state->vtkglScissor(0, 0, this->Texture->GetWidth(), this->Texture->GetHeight());
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(-1.0f, -1.0f, -1.0f, -1.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowTarget::BeginMarks(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglClearDepth(0.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
}

//------------------------------------------------------------------------------
void vtkSoftShadowTarget::BeginFilter(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LESS);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowTarget::GetBytes() const
{
  return this->Texture->GetBytes() +
    4 * static_cast<vtkTypeInt64>(this->Texture->GetWidth()) * this->Texture->GetHeight();
}

//------------------------------------------------------------------------------
void vtkSoftShadowTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Framebuffer.Release();
  if (this->DepthBuffer)
  {
    glDeleteRenderbuffers(1, &this->DepthBuffer);
    this->DepthBuffer = 0;
  }
}
VTK_ABI_NAMESPACE_END
