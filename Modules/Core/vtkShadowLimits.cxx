// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLimits.h"

#include "vtkShadowDriver.h"
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

// Of the extensions that tell, in KiB; their names stand in no header of VTK's.
constexpr GLenum CurrentAvailableMemoryNvx = 0x9049;
constexpr GLenum TextureFreeMemoryAti = 0x87FC;
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
vtkTypeInt64 vtkShadowLimits::GetFreeMemory()
{
  GLint kibibytes[4] = { 0, 0, 0, 0 };
  if (vtkShadowDriver::HasExtension("GL_NVX_gpu_memory_info"))
  {
    glGetIntegerv(CurrentAvailableMemoryNvx, kibibytes);
  }
  else if (vtkShadowDriver::HasExtension("GL_ATI_meminfo"))
  {
    glGetIntegerv(TextureFreeMemoryAti, kibibytes); // the first of four: in the pool altogether
  }
  return static_cast<vtkTypeInt64>(std::max(kibibytes[0], 0)) << 10;
}

//------------------------------------------------------------------------------
void vtkShadowLimits::Restrict(int textureSize, int textureLayers)
{
  MostSize = textureSize;
  MostLayers = textureLayers;
}
VTK_ABI_NAMESPACE_END
