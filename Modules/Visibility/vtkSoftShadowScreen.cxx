// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowScreen.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSoftShadowScreen::vtkSoftShadowScreen() = default;

//------------------------------------------------------------------------------
vtkSoftShadowScreen::~vtkSoftShadowScreen() = default;

//------------------------------------------------------------------------------
bool vtkSoftShadowScreen::Begin(
  vtkOpenGLRenderWindow* window, TextureName texture, int width, int height, unsigned int marks)
{
  if (!this->Textures[texture]->Allocate(window, vtkShadowTextureArray::RGBA32F, width, height, 1))
  {
    return false;
  }
  this->Framebuffer.Bind(window);
  vtkShadowFramebuffer::AttachDepthBuffer(marks);
  this->Textures[texture]->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  if (!vtkShadowFramebuffer::IsComplete())
  {
    return false;
  }
  window->GetState()->vtkglViewport(0, 0, width, height);
  const float none[4] = { -1.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, none);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowScreen::Copy(vtkOpenGLRenderWindow* window, int width, int height)
{
  vtkShadowTextureArray* texture = this->Textures[KNOWN];
  if (!texture->Allocate(window, vtkShadowTextureArray::R32F, width, height, 1))
  {
    return false;
  }
  texture->CopyFromFramebuffer(0, 0, 0, width, height);
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowScreen::GetBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const auto& texture : this->Textures)
  {
    bytes += texture->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkSoftShadowScreen::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Framebuffer.Release();
}
VTK_ABI_NAMESPACE_END
