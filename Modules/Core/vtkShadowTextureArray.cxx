// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTextureArray.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLimits.h"
#include "vtkShadowScopedState.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkShadowTextureArray);

namespace
{
struct FormatInfo
{
  GLint Internal;
  GLenum External;
  int Components;
};

FormatInfo GetFormatInfo(int format)
{
  switch (format)
  {
    case vtkShadowTextureArray::RG32F:
      return { GL_RG32F, GL_RG, 2 };
    case vtkShadowTextureArray::RGBA32F:
      return { GL_RGBA32F, GL_RGBA, 4 };
    case vtkShadowTextureArray::DEPTH32F:
      return { GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, 1 };
    default:
      return { GL_R32F, GL_RED, 1 };
  }
}

void SetParameters(int levels)
{
  const GLenum target = GL_TEXTURE_2D_ARRAY;
  glTexParameteri(
    target, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
  glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_NONE);
}
} // namespace

//------------------------------------------------------------------------------
vtkShadowTextureArray::vtkShadowTextureArray()
  : Watch([this](vtkOpenGLRenderWindow*) { this->DeleteTexture(); })
{
}

//------------------------------------------------------------------------------
vtkShadowTextureArray::~vtkShadowTextureArray()
{
  this->Watch.Free(); // while all members are there
}

//------------------------------------------------------------------------------
bool vtkShadowTextureArray::IsAllowed(int width, int height, int layers, int levels) const
{
  const int largest = vtkShadowLimits::GetTextureSize();
  const int mostLayers = vtkShadowLimits::GetTextureLayers();
  if (width > 0 && height > 0 && layers > 0 && levels > 0 && width <= largest &&
    height <= largest && layers <= mostLayers)
  {
    return true;
  }
  std::ostringstream reason;
  reason << "a texture of " << width << " x " << height << " texels and " << layers
         << " layers cannot be made; this OpenGL allows " << largest << " texels along an edge and "
         << mostLayers << " layers";
  vtkShadowFailures::Report(reason.str());
  return false;
}

//------------------------------------------------------------------------------
bool vtkShadowTextureArray::Allocate(
  vtkOpenGLRenderWindow* window, int format, int width, int height, int layers, int levels)
{
  if (this->Handle && this->Watch.GetWindow() == window && this->Format == format &&
    this->Width == width && this->Height == height && this->Layers == layers &&
    this->Levels == levels)
  {
    return true;
  }
  this->Watch.Free();
  if (!this->IsAllowed(width, height, layers, levels))
  {
    return false;
  }

  this->Watch.Enter(window);
  this->Format = format;
  this->Width = width;
  this->Height = height;
  this->Layers = layers;
  this->Levels = levels;
  const vtkShadowScopedPixelStore pixelStore; // or the data are a buffer's
  glGenTextures(1, &this->Handle);
  this->Activate(window);
  SetParameters(levels);
  const FormatInfo info = GetFormatInfo(format);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  for (int level = 0; level < levels; ++level)
  {
    glTexImage3D(GL_TEXTURE_2D_ARRAY, level, info.Internal, std::max(width >> level, 1),
      std::max(height >> level, 1), layers, 0, info.External, GL_FLOAT, nullptr);
  }
  bool failed = false;
  while (glGetError() != GL_NO_ERROR)
  {
    failed = true; // one of the levels
  }
  this->Deactivate();
  if (failed)
  {
    std::ostringstream reason;
    reason << "no memory for a texture of " << width << " x " << height << " texels and " << layers
           << " layers (" << this->GetBytes() / (1 << 20) << " MiB)";
    vtkShadowFailures::Report(reason.str());
    this->Watch.Free();
  }
  return !failed;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowTextureArray::GetBytes() const
{
  if (!this->Handle)
  {
    return 0;
  }
  vtkTypeInt64 texels = 0;
  for (int level = 0; level < this->Levels; ++level)
  {
    texels += static_cast<vtkTypeInt64>(std::max(this->Width >> level, 1)) *
      std::max(this->Height >> level, 1);
  }
  return texels * this->Layers * GetFormatInfo(this->Format).Components * 4;
}

//------------------------------------------------------------------------------
int vtkShadowTextureArray::GetMaximumLayers(vtkOpenGLRenderWindow*)
{
  return vtkShadowLimits::GetTextureLayers();
}

//------------------------------------------------------------------------------
int vtkShadowTextureArray::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->Handle && !window)
  {
    vtkShadowFailures::Report("a texture is missing"); // whoever could not have it draws nothing
    return 0;
  }
  return this->Unit.Bind(
    this->Handle ? this->Watch.GetWindow() : window, GL_TEXTURE_2D_ARRAY, this->Handle);
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::Deactivate()
{
  this->Unit.Release();
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::AttachLayer(int layer, int level, int colorAttachment)
{
  glFramebufferTextureLayer(
    GL_DRAW_FRAMEBUFFER, this->GetAttachment(colorAttachment), this->Handle, level, layer);
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::AttachLayers(int level, int colorAttachment)
{
  glFramebufferTexture(
    GL_DRAW_FRAMEBUFFER, this->GetAttachment(colorAttachment), this->Handle, level);
}

//------------------------------------------------------------------------------
unsigned int vtkShadowTextureArray::GetAttachment(int colorAttachment) const
{
  return this->Format == DEPTH32F ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0 + colorAttachment;
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::CopyFromFramebuffer(int layer, int x, int y, int width, int height)
{
  this->Activate(this->Watch.GetWindow());
  glCopyTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, x, y, layer, 0, 0, width, height);
  this->Deactivate();
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::SetLevelRange(int base, int maximum)
{
  this->Activate(this->Watch.GetWindow());
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, base);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, maximum);
  this->Deactivate();
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::WriteLayer(int layer, const float* values)
{
  const vtkShadowScopedPixelStore pixelStore;
  this->Activate(this->Watch.GetWindow());
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, this->Width, this->Height, 1,
    GetFormatInfo(this->Format).External, GL_FLOAT, values);
  this->Deactivate();
}

//------------------------------------------------------------------------------
std::vector<float> vtkShadowTextureArray::ReadLayer(int layer, int level)
{
  const FormatInfo info = GetFormatInfo(this->Format);
  const int width = std::max(this->Width >> level, 1);
  const int height = std::max(this->Height >> level, 1);
  std::vector<float> values(static_cast<size_t>(width) * height * info.Components);
  vtkOpenGLState* state = this->Watch.GetWindow()->GetState();
  const vtkShadowScopedPixelStore pixelStore;
  state->PushReadFramebufferBinding();
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  const bool isDepth = this->Format == DEPTH32F;
  glFramebufferTextureLayer(GL_READ_FRAMEBUFFER,
    isDepth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, this->Handle, level, layer);
  state->vtkglReadBuffer(isDepth ? GL_NONE : GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, width, height, info.External, GL_FLOAT, values.data());
  state->PopReadFramebufferBinding();
  glDeleteFramebuffers(1, &framebuffer);
  return values;
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::DeleteTexture()
{
  this->Deactivate();
  glDeleteTextures(1, &this->Handle);
  this->Handle = 0;
  this->Width = this->Height = this->Layers = this->Levels = 0;
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::ReleaseGraphicsResources(vtkWindow*)
{
  this->Watch.Free();
}

//------------------------------------------------------------------------------
void vtkShadowTextureArray::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Bytes: " << this->GetBytes() << "\n";
}
VTK_ABI_NAMESPACE_END
