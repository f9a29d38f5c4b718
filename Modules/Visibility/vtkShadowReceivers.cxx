// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReceivers.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFailures.h"
#include "vtkShadowFramebuffer.h"
#include "vtkShadowLimits.h"
#include "vtkShadowScopedState.h"
#include "vtkShadowShader.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTextureObject.h"

#include <limits>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkShadowReceivers);

namespace
{
vtkOpenGLRenderWindow* GetWindow(vtkRenderer* renderer)
{
  return static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
}

// Full floats, set by hand: the default for floats may be anything.
void AllocateColor(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int width, int height)
{
  texture->SetContext(window);
  texture->SetInternalFormat(GL_RGBA32F);
  texture->SetFormat(GL_RGBA);
  texture->SetDataType(GL_FLOAT);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->Allocate2D(width, height, 4, VTK_FLOAT);
}
// Four floats per pixel, bottom row first.
void ReadColor(vtkTextureObject* texture, std::vector<float>& values)
{
  values.resize(4 * static_cast<size_t>(texture->GetWidth()) * texture->GetHeight());
  const vtkShadowScopedPixelStore pixelStore;
  vtkShadowTextureUnit unit;
  unit.Bind(texture->GetContext(), GL_TEXTURE_2D, texture->GetHandle());
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, values.data());
  unit.Release();
}

// As the snippet vtkShadowReceiver.
int MarkOf(float w)
{
  return w >= VTK_SOFT_SHADOW_FIRST_NORMAL
    ? VTK_SOFT_SHADOW_RECEIVES
    : (w <= -VTK_SOFT_SHADOW_FIRST_NORMAL ? VTK_SOFT_SHADOW_SURFACE : 0);
}

std::vector<float> ReadColor(vtkTextureObject* texture)
{
  std::vector<float> values;
  ReadColor(texture, values);
  return values;
}
} // namespace

//------------------------------------------------------------------------------
vtkShadowReceivers::vtkShadowReceivers()
{
  vtkMatrix4x4::Identity(this->ViewToWorld.data());
}

//------------------------------------------------------------------------------
vtkShadowReceivers::~vtkShadowReceivers() = default;

//------------------------------------------------------------------------------
int vtkShadowReceivers::Begin(vtkRenderer* renderer, int width, int height)
{
  vtkOpenGLRenderWindow* window = GetWindow(renderer);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  // A window that closes frees VTK's textures by itself.
  const bool resize = this->Width != width || this->Height != height ||
    this->Positions->GetHandle() == 0 || this->Smooth != (this->Surfaces->GetHandle() != 0);
  if (resize && !this->Allocate(window, width, height))
  {
    return -1;
  }
  this->Framebuffer->Bind();
  // VTK's cache of draw buffers keeps all but the first from the framebuffer before (vtkSSAOPass draws
  // into three) and would leave out the call: first make it see a difference.
  state->vtkglDrawBuffer(GL_NONE);
  this->Framebuffer->ActivateDrawBuffers(this->Smooth ? 3 : 2);
  if (resize && !vtkShadowFramebuffer::IsComplete())
  {
    this->ReleaseGraphicsResources(window);
    return -1;
  }

  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

  this->FoundSmooth = -1;
  vtkMatrix4x4* worldToView = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  vtkMatrix4x4::Invert(worldToView->GetData(), this->ViewToWorld.data());
  return resize ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkShadowReceivers::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  const vtkShadowScopedPixelStore pixelStore;
  this->ReleaseGraphicsResources(window);
  const int largest = vtkShadowLimits::GetTextureSize();
  if (width > largest || height > largest)
  {
    vtkShadowFailures::Report("a picture of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels is larger than this OpenGL's textures, of " +
      std::to_string(largest));
    return false;
  }
  this->Width = width;
  this->Height = height;
  AllocateColor(this->Positions, window, width, height);
  AllocateColor(this->Normals, window, width, height);
  this->Depth->SetContext(window);
  this->Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Positions);
  this->Framebuffer->AddColorAttachment(1, this->Normals);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  if (this->Smooth)
  {
    AllocateColor(this->Surfaces, window, width, height);
    this->Framebuffer->AddColorAttachment(2, this->Surfaces);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::End(vtkRenderer* renderer)
{
  GetWindow(renderer)->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::Activate(vtkShaderProgram* program)
{
  vtkOpenGLRenderWindow* window = this->Positions->GetContext();
  program->SetUniformi("receiverPosition",
    this->PositionUnit.Bind(window, GL_TEXTURE_2D, this->Positions->GetHandle()));
  program->SetUniformi(
    "receiverNormal", this->NormalUnit.Bind(window, GL_TEXTURE_2D, this->Normals->GetHandle()));
  // Where it is not read, the sampler gets another of its type.
  vtkTextureObject* surfaces = this->Smooth ? this->Surfaces : this->Normals;
  program->SetUniformi(
    "receiverSurface", this->SurfaceUnit.Bind(window, GL_TEXTURE_2D, surfaces->GetHandle()));
  program->SetUniformi("receiverSmooth", this->Smooth ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::Deactivate()
{
  this->PositionUnit.Release();
  this->NormalUnit.Release();
  this->SurfaceUnit.Release();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowReceivers::GetBytes() const
{
  return static_cast<vtkTypeInt64>(this->Width) * this->Height *
    (16 + 16 + 4 + (this->Surfaces->GetHandle() ? 16 : 0));
}

//------------------------------------------------------------------------------
bool vtkShadowReceivers::HasSmooth()
{
  if (!this->Smooth || !this->Surfaces->GetHandle())
  {
    return false;
  }
  if (this->FoundSmooth < 0)
  {
    this->FoundSmooth = 0;
    const std::vector<float> positions = ReadColor(this->Positions);
    const std::vector<float> surfaces = ReadColor(this->Surfaces);
    for (size_t i = 3; i < surfaces.size() && this->FoundSmooth == 0; i += 4)
    {
      // What is unlit writes anything.
      this->FoundSmooth =
        MarkOf(positions[i]) == VTK_SOFT_SHADOW_RECEIVES && surfaces[i] != 0.0f ? 1 : 0;
    }
  }
  return this->FoundSmooth == 1;
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::Read(std::vector<float>& positions, std::vector<float>& normals)
{
  ReadColor(this->Positions, positions);
  for (size_t i = 3; i < positions.size(); i += 4)
  {
    positions[i] = static_cast<float>(MarkOf(positions[i]));
  }
  if (!this->Smooth)
  {
    ReadColor(this->Normals, normals);
    return;
  }
  ReadColor(this->Surfaces, normals);
  for (size_t i = 0; i < normals.size(); i += 4)
  {
    for (size_t k = 0; k < 3; ++k)
    {
      positions[i + k] += normals[i + 3] * normals[i + k];
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkShadowReceivers::ReadDepth()
{
  if (this->Width == 0)
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Width, this->Height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  const size_t count = static_cast<size_t>(this->Width) * this->Height;
  const std::vector<float> positions = ReadColor(this->Positions);
  for (size_t i = 0; i < count; ++i)
  {
    values[i] = MarkOf(positions[4 * i + 3]) != 0 ? -positions[4 * i + 2]
                                                  : std::numeric_limits<float>::quiet_NaN();
  }
  return image;
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Positions->ReleaseGraphicsResources(window);
  this->Normals->ReleaseGraphicsResources(window);
  this->Surfaces->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Width = this->Height = 0;
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
}
VTK_ABI_NAMESPACE_END
