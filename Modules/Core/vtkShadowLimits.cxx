// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLimits.h"

#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
int MostSize = 0;
int MostLayers = 0;

int GetLimit(unsigned int name, int most)
{
  GLint limit = 0;
  glGetIntegerv(name, &limit);
  return most > 0 ? std::min<int>(limit, most) : limit;
}
} // namespace

//------------------------------------------------------------------------------
int vtkShadowLimits::GetTextureSize()
{
  return GetLimit(GL_MAX_TEXTURE_SIZE, MostSize);
}

//------------------------------------------------------------------------------
int vtkShadowLimits::GetTextureLayers()
{
  return GetLimit(GL_MAX_ARRAY_TEXTURE_LAYERS, MostLayers);
}

//------------------------------------------------------------------------------
void vtkShadowLimits::Restrict(int textureSize, int textureLayers)
{
  MostSize = textureSize;
  MostLayers = textureLayers;
}
VTK_ABI_NAMESPACE_END
