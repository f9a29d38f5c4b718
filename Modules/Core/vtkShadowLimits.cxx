// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLimits.h"

#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <cstring>

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

bool HasExtension(const char* name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const GLubyte* extension = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (extension && std::strcmp(reinterpret_cast<const char*>(extension), name) == 0)
    {
      return true;
    }
  }
  return false;
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
vtkTypeInt64 vtkShadowLimits::GetFreeMemory()
{
  GLint kibibytes[4] = { 0, 0, 0, 0 };
  if (HasExtension("GL_NVX_gpu_memory_info"))
  {
    glGetIntegerv(CurrentAvailableMemoryNvx, kibibytes);
  }
  else if (HasExtension("GL_ATI_meminfo"))
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
