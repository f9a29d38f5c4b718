// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowPixelCount.h"

#include "vtkShadowShader.h"
#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkSoftShadowPixelCount::Draw(
  vtkOpenGLRenderWindow* window, vtkShadowShader& shader, double tapsPerPixel)
{
  if (!this->CountsNextDraw)
  {
    shader.Draw(tapsPerPixel);
    return;
  }
  this->CountsNextDraw = false;
  this->Queries.Begin(window, this->Used++);
  shader.Draw(tapsPerPixel);
  this->Queries.End();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowPixelCount::GetPixels() const
{
  vtkTypeInt64 sum = 0;
  for (size_t i = 0; i < this->Used; ++i)
  {
    GLuint pixels = 0;
    glGetQueryObjectuiv(this->Queries.GetName(i), GL_QUERY_RESULT, &pixels);
    sum += pixels;
  }
  return sum;
}

//------------------------------------------------------------------------------
void vtkSoftShadowPixelCount::ReleaseGraphicsResources()
{
  this->Queries.Release();
  this->Used = 0;
}
VTK_ABI_NAMESPACE_END
