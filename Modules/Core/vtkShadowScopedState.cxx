// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowScopedState.h"

#include "vtkOpenGLState.h"
#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
struct Store
{
  unsigned int Name;
  int Default; // for rows of floats
};
const Store Stores[] = { { GL_PACK_ALIGNMENT, 4 }, { GL_PACK_SWAP_BYTES, 0 },
  { GL_PACK_ROW_LENGTH, 0 }, { GL_PACK_IMAGE_HEIGHT, 0 }, { GL_PACK_SKIP_PIXELS, 0 },
  { GL_PACK_SKIP_ROWS, 0 }, { GL_PACK_SKIP_IMAGES, 0 }, { GL_UNPACK_ALIGNMENT, 4 },
  { GL_UNPACK_SWAP_BYTES, 0 }, { GL_UNPACK_ROW_LENGTH, 0 }, { GL_UNPACK_IMAGE_HEIGHT, 0 },
  { GL_UNPACK_SKIP_PIXELS, 0 }, { GL_UNPACK_SKIP_ROWS, 0 }, { GL_UNPACK_SKIP_IMAGES, 0 } };
} // namespace

//------------------------------------------------------------------------------
vtkShadowScopedRaster::vtkShadowScopedRaster(vtkOpenGLState* state)
  : State(state)
  , HadStencil(state->GetEnumState(GL_STENCIL_TEST))
  , HadPolygonOffset(glIsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE)
{
  glGetIntegerv(GL_POLYGON_MODE, this->PolygonMode);
  glGetIntegerv(GL_FRONT_FACE, &this->FrontFace);
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->BlendEquations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->BlendEquations[1]);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glFrontFace(GL_CCW);
  glDisable(GL_POLYGON_OFFSET_FILL);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglBlendEquation(GL_FUNC_ADD);
}

//------------------------------------------------------------------------------
vtkShadowScopedRaster::~vtkShadowScopedRaster()
{
  glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(this->PolygonMode[0]));
  glFrontFace(static_cast<GLenum>(this->FrontFace));
  this->State->SetEnumState(GL_STENCIL_TEST, this->HadStencil);
  if (this->HadPolygonOffset)
  {
    glEnable(GL_POLYGON_OFFSET_FILL);
  }
  this->State->vtkglBlendEquationSeparate(static_cast<unsigned int>(this->BlendEquations[0]),
    static_cast<unsigned int>(this->BlendEquations[1]));
}

//------------------------------------------------------------------------------
vtkShadowScopedPixelStore::vtkShadowScopedPixelStore()
{
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &this->PackBuffer);
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &this->UnpackBuffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    glGetIntegerv(Stores[i].Name, &this->Values[i]);
    glPixelStorei(Stores[i].Name, Stores[i].Default);
  }
}

//------------------------------------------------------------------------------
vtkShadowScopedPixelStore::~vtkShadowScopedPixelStore()
{
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    glPixelStorei(Stores[i].Name, this->Values[i]);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(this->PackBuffer));
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(this->UnpackBuffer));
}
VTK_ABI_NAMESPACE_END
