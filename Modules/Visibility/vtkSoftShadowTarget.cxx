// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSoftShadowTarget::vtkSoftShadowTarget() = default;

//------------------------------------------------------------------------------
vtkSoftShadowTarget::~vtkSoftShadowTarget() = default;

//------------------------------------------------------------------------------
bool vtkSoftShadowTarget::Allocate(vtkOpenGLRenderWindow* window, int width, int height, int layers)
{
  const bool resize = this->Texture->GetWidth() != width || this->Texture->GetHeight() != height;
  if (!resize && this->Texture->GetLayers() >= layers)
  {
    return false;
  }
  const int count = resize ? layers : std::max(layers, this->Texture->GetLayers());
  if (!this->Texture->Allocate(window, vtkShadowTextureArray::R32F, width, height, count))
  {
    return false;
  }
  if (!this->Framebuffer)
  {
    glGenFramebuffers(1, &this->Framebuffer);
    glGenRenderbuffers(1, &this->DepthBuffer);
  }
  glBindRenderbuffer(GL_RENDERBUFFER, this->DepthBuffer);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  return true;
}

//------------------------------------------------------------------------------
void vtkSoftShadowTarget::BeginLight(vtkOpenGLRenderWindow* window, int layer)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  glFramebufferRenderbuffer(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, this->DepthBuffer);
  this->Texture->AttachLayer(layer);
  state->vtkglDrawBuffer(GL_COLOR_ATTACHMENT0);
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
  if (this->Framebuffer)
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteRenderbuffers(1, &this->DepthBuffer);
    this->Framebuffer = this->DepthBuffer = 0;
  }
}
VTK_ABI_NAMESPACE_END
