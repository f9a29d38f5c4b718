// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowRendererDuties.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowRendererDuties::UpdateStereo(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if ((camera->GetStereo() != 0) == (window->GetStereoRender() != 0))
  {
    return;
  }
  // Only the camera's own Render sets it. That would also clear the window, which is done already, and
  // set the renderer's viewport, which may be that of a framebuffer.
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const auto erase = renderer->GetErase();
  renderer->SetErase(0);
  camera->Render(renderer);
  renderer->SetErase(erase);
  renderer->Modified(); // matrices that the camera keeps are too old
}

//------------------------------------------------------------------------------
int vtkSoftShadowRendererDuties::DrawOpaque(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    return selector->Render(renderer, s->GetPropArray(), s->GetPropArrayCount());
  }
  int drawn = 0;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    drawn += s->GetPropArray()[i]->RenderOpaqueGeometry(renderer);
  }
  return drawn;
}
VTK_ABI_NAMESPACE_END
