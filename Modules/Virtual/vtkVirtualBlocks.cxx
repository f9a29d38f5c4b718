// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualBlocks.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkShadowBands.h"
#include "vtkShadowDriver.h"
#include "vtkShadowFailures.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkVirtualScreen.h"

#include "vtkVirtualBlockFS.h"
#include "vtkVirtualBlockVS.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkVirtualBlocks::vtkVirtualBlocks(
  const char* text, const vtkShadowShader::Definitions& definitions)
  : Text(vtkShadowShader::Compose(text, definitions))
  , BoundsShader(vtkVirtualBlockFS)
  , Watch(
      [this](vtkOpenGLRenderWindow*)
      {
        this->Program = nullptr;
        if (this->VertexArray)
        {
          this->VertexArray->ReleaseGraphicsResources();
          this->VertexArray = nullptr;
        }
      })
{
  this->BoundsShader.SetDefinitions(
    { { "VIRTUAL_BLOCK", std::to_string(BlockSize) }, { "VIRTUAL_NOWHERE", "1e30" },
      { "VIRTUAL_PENUMBRA", std::to_string(vtkVirtualScreen::PENUMBRA) + ".0" } });
}

//------------------------------------------------------------------------------
vtkVirtualBlocks::~vtkVirtualBlocks() = default;

//------------------------------------------------------------------------------
bool vtkVirtualBlocks::FindBounds(vtkOpenGLRenderWindow* window, vtkVirtualScreen& kernels)
{
  vtkShadowTextureArray* shapes = kernels.GetTexture(vtkVirtualScreen::SHAPES);
  const int width = (shapes->GetWidth() + BlockSize - 1) / BlockSize;
  const int height = (shapes->GetHeight() + BlockSize - 1) / BlockSize;
  if (!this->Bounds->Allocate(window, vtkShadowTextureArray::RGBA32F, width, height, 1) ||
    !this->BoundsShader.Use(window))
  {
    return false;
  }
  this->Watch.Enter(window);
  if (!this->VertexArray)
  {
    this->VertexArray = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  this->BlockExtent[0] = 2.0f * BlockSize / shapes->GetWidth();
  this->BlockExtent[1] = 2.0f * BlockSize / shapes->GetHeight();
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer.Bind(window);
  this->Bounds->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  if (!vtkShadowFramebuffer::IsComplete())
  {
    return false;
  }
  state->vtkglViewport(0, 0, width, height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  vtkShaderProgram* program = this->BoundsShader.GetProgram();
  kernels.Activate(program, vtkVirtualScreen::SHAPES);
  kernels.Activate(program, vtkVirtualScreen::PREDICTIONS);
  this->BoundsShader.Draw();
  kernels.Deactivate();
  if (!vtkShadowDriver::OrdersVertices())
  {
    glFinish(); // vertices look up what was drawn here
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVirtualBlocks::Use(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Program)
  {
    return cache->ReadyShaderProgram(this->Program) != nullptr;
  }
  this->Program = cache->ReadyShaderProgram(vtkVirtualBlockVS, this->Text.c_str(), "");
  ++this->Builds;
  if (!this->Program)
  {
    vtkShadowFailures::Report("a shader does not compile");
  }
  return this->Program != nullptr;
}

//------------------------------------------------------------------------------
void vtkVirtualBlocks::Draw(vtkOpenGLRenderWindow* window, double tapsPerPixel)
{
  if (vtkShadowFailures::IsFailing())
  {
    return;
  }
  this->Program->SetUniformi("blockBounds", this->Bounds->Activate());
  this->Program->SetUniform2f("blockExtent", this->BlockExtent);
  this->VertexArray->Bind();
  const auto draw = [this]
  {
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * this->Bounds->GetWidth(), this->Bounds->GetHeight());
  };
  vtkShadowBands::Draw(window, tapsPerPixel, draw);
  this->VertexArray->Release();
  this->Bounds->Deactivate();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualBlocks::GetBytes() const
{
  return this->Bounds->GetBytes();
}

//------------------------------------------------------------------------------
int vtkVirtualBlocks::GetNumberOfBuilds() const
{
  return this->Builds + this->BoundsShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkVirtualBlocks::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Bounds->ReleaseGraphicsResources(window);
  this->BoundsShader.ReleaseGraphicsResources(window);
  this->Framebuffer.Release();
  this->Watch.Free();
}
VTK_ABI_NAMESPACE_END
