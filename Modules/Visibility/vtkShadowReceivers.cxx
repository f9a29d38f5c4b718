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
#include "vtkPixelBufferObject.h"
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
  const bool resize =
    this->Width != width || this->Height != height || this->Positions->GetHandle() == 0;
  if (resize && !this->Allocate(window, width, height))
  {
    return -1;
  }
  this->Framebuffer->Bind();
  // VTK's cache of draw buffers keeps all but the first from the framebuffer before (vtkSSAOPass draws
  // into three) and would leave out the call: first make it see a difference.
  state->vtkglDrawBuffer(GL_NONE);
  this->Framebuffer->ActivateDrawBuffers(2);
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
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::Deactivate()
{
  this->PositionUnit.Release();
  this->NormalUnit.Release();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowReceivers::GetBytes() const
{
  return static_cast<vtkTypeInt64>(this->Width) * this->Height * (16 + 16 + 4);
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
  std::vector<float> positions(4 * count);
  const vtkShadowScopedPixelStore pixelStore;
  vtkSmartPointer<vtkPixelBufferObject> buffer;
  buffer.TakeReference(this->Positions->Download());
  unsigned int size[2] = { static_cast<unsigned int>(this->Width),
    static_cast<unsigned int>(this->Height) };
  vtkIdType increments[2] = { 0, 0 };
  buffer->Download2D(VTK_FLOAT, positions.data(), size, 4, increments);
  for (size_t i = 0; i < count; ++i)
  {
    const float mark = positions[4 * i + 3];
    const bool surface = mark == VTK_SOFT_SHADOW_RECEIVES || mark == VTK_SOFT_SHADOW_SURFACE;
    values[i] = surface ? -positions[4 * i + 2] : std::numeric_limits<float>::quiet_NaN();
  }
  return image;
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Positions->ReleaseGraphicsResources(window);
  this->Normals->ReleaseGraphicsResources(window);
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
