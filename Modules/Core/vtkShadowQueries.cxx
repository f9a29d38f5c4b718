// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowQueries.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkShadowQueries::vtkShadowQueries()
  : Watch(
      [this](vtkOpenGLRenderWindow*)
      {
        glDeleteQueries(static_cast<GLsizei>(this->Names.size()), this->Names.data());
        this->Names.clear();
      })
{
}

//------------------------------------------------------------------------------
vtkShadowQueries::~vtkShadowQueries() = default;

//------------------------------------------------------------------------------
void vtkShadowQueries::Begin(vtkOpenGLRenderWindow* window, size_t index)
{
  this->Watch.Enter(window);
  while (this->Names.size() <= index)
  {
    this->Names.push_back(0);
    glGenQueries(1, &this->Names.back());
  }
  glBeginQuery(GL_SAMPLES_PASSED, this->Names[index]);
}

//------------------------------------------------------------------------------
void vtkShadowQueries::End()
{
  glEndQuery(GL_SAMPLES_PASSED);
}

//------------------------------------------------------------------------------
unsigned int vtkShadowQueries::GetName(size_t index) const
{
  return index < this->Names.size() ? this->Names[index] : 0;
}
VTK_ABI_NAMESPACE_END
