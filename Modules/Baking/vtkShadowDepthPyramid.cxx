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

  // Draws one level of all layers from a texture that is bound to a unit.
  void DrawLevel(vtkShadowShader& shader, vtkOpenGLState* state, const char* sampler, int unit,
    vtkShadowTextureArray* target, int layers, int level)
  {
    const int size = target->GetWidth() >> level;
    state->vtkglViewport(0, 0, size, size);
    shader.GetProgram()->SetUniformi(sampler, unit);
    for (int layer = 0; layer < layers; ++layer)
    {
      target->AttachLayer(layer, level);
      shader.GetProgram()->SetUniformi("layer", layer);
      shader.Draw();
    }
  }
};

//------------------------------------------------------------------------------
vtkShadowDepthPyramid::vtkShadowDepthPyramid()
  : Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkShadowDepthPyramid::~vtkShadowDepthPyramid() = default;

//------------------------------------------------------------------------------
bool vtkShadowDepthPyramid::Update(vtkOpenGLRenderWindow* window, vtkShadowDepthMaps* maps)
{
  const auto layers = static_cast<int>(maps->GetViews().size());
  if (layers == 0 || (maps->GetBakeTime() == this->BuildTime && this->Texture->GetHandle() != 0))
  {
    return false;
  }
  int size = 1;
  int levels = 1;
  while (2 * size < maps->GetResolution())
  {
    size *= 2;
    ++levels;
  }
  if (!this->Texture->Allocate(
        window, vtkShadowTextureArray::RG32F, size, size, maps->GetTexture()->GetLayers(), levels))
  {
    return false;
  }

  Internals& impl = *this->Impl;
  vtkOpenGLState* state = window->GetState();
  const ScopedState scoped(state);
  impl.Framebuffer.Bind(window);
  this->Texture->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  if (!vtkShadowFramebuffer::IsComplete() || !impl.Base.Use(window))
  {
    return false;
  }
  impl.DrawLevel(
    impl.Base, state, "depthMaps", maps->GetTexture()->Activate(), this->Texture, layers, 0);
  maps->GetTexture()->Deactivate();

  if (levels > 1 && impl.Coarser.Use(window))
  {
    for (int level = 1; level < levels; ++level)
    {
      this->Texture->SetLevelRange(level - 1, level - 1);
      impl.DrawLevel(
        impl.Coarser, state, "finer", this->Texture->Activate(), this->Texture, layers, level);
      this->Texture->Deactivate();
    }
    this->Texture->SetLevelRange(0, levels - 1);
  }
  if (vtkShadowFailures::IsFailing())
  {
    return false;
  }
  this->BuildTime = maps->GetBakeTime();
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowDepthPyramid::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->Framebuffer.Release();
  this->Impl->Base.ReleaseGraphicsResources(window);
  this->Impl->Coarser.ReleaseGraphicsResources(window);
  this->Texture->ReleaseGraphicsResources(window);
  this->BuildTime = 0;
}

//------------------------------------------------------------------------------
void vtkShadowDepthPyramid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Texture->GetWidth() << "\n";
  os << indent << "Levels: " << this->Texture->GetLevels() << "\n";
  os << indent << "Layers: " << this->Texture->GetLayers() << "\n";
}

VTK_ABI_NAMESPACE_END
