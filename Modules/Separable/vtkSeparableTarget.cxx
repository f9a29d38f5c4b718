// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeparableTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkSeparableTarget::Attach(
  vtkOpenGLRenderWindow* window, const std::vector<Output>& outputs, unsigned int marks)
{
  this->Framebuffer.Bind(window);
  std::vector<unsigned int> buffers;
  for (size_t i = 0; i < outputs.size(); ++i)
  {
    const unsigned int attachment = GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(i);
    if (outputs[i].Texture)
    {
      outputs[i].Texture->AttachLayer(0, 0, static_cast<int>(i));
    }
    buffers.push_back(outputs[i].Texture ? attachment : GL_NONE);
  }
  vtkShadowFramebuffer::AttachDepthBuffer(marks);
  const auto count = static_cast<unsigned int>(buffers.size());
  window->GetState()->vtkglDrawBuffers(count, buffers.data());
  // VTK's cache keeps all but the first from the framebuffer before, and may have left out the call.
  glDrawBuffers(static_cast<GLsizei>(count), buffers.data());
  return vtkShadowFramebuffer::IsComplete();
}

//------------------------------------------------------------------------------
// Nothing stays attached: it may be read by the next step.
void vtkSeparableTarget::Detach(size_t outputs)
{
  for (size_t i = 0; i < outputs; ++i)
  {
    glFramebufferTextureLayer(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(i), 0, 0, 0);
  }
  vtkShadowFramebuffer::AttachDepthBuffer(0);
}

//------------------------------------------------------------------------------
void vtkSeparableTarget::Draw(vtkOpenGLRenderWindow* window, vtkShadowShader& shader,
  const std::vector<Output>& outputs, unsigned int marks, double tapsPerPixel,
  const PartSetter& setPart)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  state->PushFramebufferBindings();
  if (!this->Attach(window, outputs, marks))
  {
    vtkSeparableTarget::Detach(outputs.size());
    state->PopFramebufferBindings();
    return;
  }
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  for (size_t i = 0; i < outputs.size(); ++i)
  {
    if (outputs[i].Texture)
    {
      const std::vector<float> value(4, outputs[i].ClearValue);
      glClearBufferfv(GL_COLOR, static_cast<int>(i), value.data());
    }
  }
  // Marks are depths: 1 where a pixel is filtered, 0 elsewhere; shaders draw at 0.5.
  for (const bool proved : { false, true })
  {
    if (proved && !setPart)
    {
      break;
    }
    if (setPart)
    {
      setPart(proved);
    }
    state->vtkglDepthFunc(proved ? GL_GREATER : GL_LESS);
    shader.Draw(tapsPerPixel);
  }
  vtkSeparableTarget::Detach(outputs.size());
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkSeparableTarget::ReleaseGraphicsResources(vtkWindow*)
{
  this->Framebuffer.Release();
}
VTK_ABI_NAMESPACE_END
