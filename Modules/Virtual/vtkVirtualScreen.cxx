// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualScreen.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkVirtualScreen::vtkVirtualScreen() = default;

//------------------------------------------------------------------------------
vtkVirtualScreen::~vtkVirtualScreen() = default;

//------------------------------------------------------------------------------
bool vtkVirtualScreen::AllocateShapes(vtkOpenGLRenderWindow* window, int width, int height)
{
  const int rgba = vtkShadowTextureArray::RGBA32F;
  return this->Textures[SHAPES]->Allocate(window, rgba, width, height, 1) &&
    this->Textures[PREDICTIONS]->Allocate(window, rgba, width, height, 1);
}

//------------------------------------------------------------------------------
bool vtkVirtualScreen::AllocateSums(vtkOpenGLRenderWindow* window, int width, int height)
{
  return this->Textures[SUMS]->Allocate(window, vtkShadowTextureArray::RGBA32F, width, height, 1);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualScreen::CountShapeBytes(int width, int height)
{
  constexpr vtkTypeInt64 pixel = 2 * 4 * sizeof(float);
  return pixel * width * height;
}

//------------------------------------------------------------------------------
void vtkVirtualScreen::Bind(vtkOpenGLRenderWindow* window, TextureName first)
{
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer.Bind(window);
  state->vtkglViewport(0, 0, this->Textures[first]->GetWidth(), this->Textures[first]->GetHeight());
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
}

//------------------------------------------------------------------------------
bool vtkVirtualScreen::BeginShapes(vtkOpenGLRenderWindow* window)
{
  this->Bind(window, SHAPES);
  this->Textures[SHAPES]->AttachLayer(0, 0, 0);
  this->Textures[PREDICTIONS]->AttachLayer(0, 0, 1);
  vtkShadowFramebuffer::SetDrawBuffers(window, 2);
  window->GetState()->vtkglDisable(GL_BLEND);
  return vtkShadowFramebuffer::IsComplete();
}

//------------------------------------------------------------------------------
bool vtkVirtualScreen::BeginSums(vtkOpenGLRenderWindow* window)
{
  this->Bind(window, SUMS);
  this->Textures[SUMS]->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  if (!vtkShadowFramebuffer::IsComplete())
  {
    return false;
  }
  window->GetState()->vtkglEnable(GL_BLEND); // one plus one, as the base class set it
  const float zero[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, zero);
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualScreen::Activate(vtkShaderProgram* program, TextureName texture)
{
  const char* const samplers[] = { "kernelShapes", "predictions", "sums" };
  if (program->IsUniformUsed(samplers[texture]))
  {
    program->SetUniformi(samplers[texture], this->Textures[texture]->Activate());
  }
}

//------------------------------------------------------------------------------
void vtkVirtualScreen::Deactivate()
{
  for (const auto& texture : this->Textures)
  {
    texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualScreen::GetBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const auto& texture : this->Textures)
  {
    bytes += texture->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkVirtualScreen::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Framebuffer.Release();
}
VTK_ABI_NAMESPACE_END
