// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowQueryReader.h"

#include "vtkSoftShadowsOpenGL.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkShadowQueryReader::~vtkShadowQueryReader() = default;

//------------------------------------------------------------------------------
bool vtkShadowQueryReader::IsAvailable(unsigned int query)
{
  GLuint available = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
  return available != 0;
}

//------------------------------------------------------------------------------
unsigned int vtkShadowQueryReader::GetResult(unsigned int query)
{
  GLuint samples = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  return samples;
}
VTK_ABI_NAMESPACE_END
