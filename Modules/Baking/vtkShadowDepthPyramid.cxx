// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDepthPyramid.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowFailures.h"
#include "vtkShadowFramebuffer.h"
#include "vtkShadowPyramidBaseFS.h"
#include "vtkShadowPyramidFS.h"
#include "vtkShadowScopedState.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkShadowDepthPyramid);

namespace
{
class ScopedState
{
public:
  explicit ScopedState(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Scissor(state, GL_SCISSOR_TEST)
    , Raster(state)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
    , Blend(state, GL_BLEND)
    , ColorMask(state)
  {
    state->PushFramebufferBindings();
    for (const unsigned int name : { GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND })
    {
      state->vtkglDisable(name);
    }
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  ~ScopedState() { this->State->PopFramebufferBindings(); }
  ScopedState(const ScopedState&) = delete;
  void operator=(const ScopedState&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable Scissor;
  vtkShadowScopedRaster Raster;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglColorMask ColorMask;
};
}

//------------------------------------------------------------------------------
class vtkShadowDepthPyramid::Internals
{
public:
  vtkShadowShader Base{ vtkShadowPyramidBaseFS };
  vtkShadowShader Coarser{ vtkShadowPyramidFS };
  vtkShadowFramebuffer Framebuffer;
  vtkNew<vtkShadowTextureArray>
    Drawn; // a level, which cannot be drawn into the image it is made from
};

//------------------------------------------------------------------------------
vtkShadowDepthPyramid::vtkShadowDepthPyramid()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkShadowDepthPyramid::~vtkShadowDepthPyramid() = default;

//------------------------------------------------------------------------------
int vtkShadowDepthPyramid::GetLevelSize(int level) const
{
  return this->Texture->GetHeight() >> level;
}

//------------------------------------------------------------------------------
std::array<int, 2> vtkShadowDepthPyramid::GetLevelCorner(int level) const
{
  const int size = this->Texture->GetHeight();
  return level == 0 ? std::array<int, 2>{ { 0, 0 } }
                    : std::array<int, 2>{ { size, size - ((2 * size) >> level) } };
}

//------------------------------------------------------------------------------
bool vtkShadowDepthPyramid::Update(vtkOpenGLRenderWindow* window, vtkShadowDepthMaps* maps)
{
  const auto layers = static_cast<int>(maps->GetViews().size());
  if (layers == 0 || (maps->GetBakeTime() == this->BuildTime && this->Texture->GetHandle() != 0))
  {
    return false;
  }
  int size = 1;
  this->Levels = 1;
  while (2 * size < maps->GetResolution())
  {
    size *= 2;
    ++this->Levels;
  }
  const int format = vtkShadowTextureArray::RG32F;
  if (!this->Texture->Allocate(
        window, format, size + size / 2, size, maps->GetTexture()->GetLayers()) ||
    !this->Impl->Drawn->Allocate(window, format, std::max(size / 2, 1), std::max(size / 2, 1), 1))
  {
    return false;
  }

  const ScopedState scoped(window->GetState());
  this->Impl->Framebuffer.Bind(window);
  if (!this->DrawFinest(window, maps, layers) || !this->DrawOthers(window, layers))
  {
    return false;
  }
  if (vtkShadowFailures::IsFailing())
  {
    return false;
  }
  this->BuildTime = maps->GetBakeTime();
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowDepthPyramid::DrawFinest(
  vtkOpenGLRenderWindow* window, vtkShadowDepthMaps* maps, int layers)
{
  vtkShadowShader& shader = this->Impl->Base;
  this->Texture->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  if (!vtkShadowFramebuffer::IsComplete() || !shader.Use(window))
  {
    return false;
  }
  const int size = this->GetLevelSize(0);
  window->GetState()->vtkglViewport(0, 0, size, size);
  shader.GetProgram()->SetUniformi("depthMaps", maps->GetTexture()->Activate());
  for (int layer = 0; layer < layers; ++layer)
  {
    this->Texture->AttachLayer(layer);
    shader.GetProgram()->SetUniformi("layer", layer);
    shader.Draw();
  }
  maps->GetTexture()->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowDepthPyramid::DrawOthers(vtkOpenGLRenderWindow* window, int layers)
{
  vtkShadowShader& shader = this->Impl->Coarser;
  this->Impl->Drawn->AttachLayer(0);
  window->GetState()->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
  if (!vtkShadowFramebuffer::IsComplete() || !shader.Use(window))
  {
    return false;
  }
  vtkShaderProgram* program = shader.GetProgram();
  for (int level = 1; level < this->Levels; ++level)
  {
    const int size = this->GetLevelSize(level);
    const std::array<int, 2> corner = this->GetLevelCorner(level);
    window->GetState()->vtkglViewport(0, 0, size, size);
    program->SetUniform2i("finerCorner", this->GetLevelCorner(level - 1).data());
    for (int layer = 0; layer < layers; ++layer)
    {
      program->SetUniformi("finer", this->Texture->Activate());
      program->SetUniformi("layer", layer);
      shader.Draw();
      this->Texture->Deactivate();
      this->Texture->CopyFromFramebuffer(layer, corner[0], corner[1], size, size);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowDepthPyramid::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->Framebuffer.Release();
  this->Impl->Base.ReleaseGraphicsResources(window);
  this->Impl->Coarser.ReleaseGraphicsResources(window);
  this->Impl->Drawn->ReleaseGraphicsResources(window);
  this->Texture->ReleaseGraphicsResources(window);
  this->BuildTime = 0;
}

//------------------------------------------------------------------------------
void vtkShadowDepthPyramid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Texture->GetHeight() << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Layers: " << this->Texture->GetLayers() << "\n";
}

VTK_ABI_NAMESPACE_END
