// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualGrid.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDriver.h"
#include "vtkShadowFailures.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkVirtualScreen.h"
#include "vtkVirtualTileTree.h"

#include "vtkVirtualDilateFS.h"
#include "vtkVirtualPointFS.h"
#include "vtkVirtualPointVS.h"
#include "vtkVirtualPyramidFS.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int GridSize = vtkVirtualTileTree::GridSize;
constexpr int GridLevels = vtkVirtualTileTree::GridLevels;

// Edge of the blocks of pixels that draw a point per cell. Cards blend at one place one after the other;
// to a processor looks at neighbours are dearer than points.
constexpr int PointBlock = 8;

vtkShadowShader::Definitions GridDefinitions()
{
  return { { "VIRTUAL_PENUMBRA", std::to_string(vtkVirtualScreen::PENUMBRA) + ".0" },
    { "VIRTUAL_UNUSED", std::to_string(vtkVirtualTileTree::Unused) } };
}
} // namespace

//------------------------------------------------------------------------------
vtkVirtualGrid::vtkVirtualGrid()
  : DilateShader(vtkVirtualDilateFS)
  , PyramidShader(vtkVirtualPyramidFS)
  , Watch(
      [this](vtkOpenGLRenderWindow*)
      {
        this->PointProgram = nullptr;
        if (this->VertexArray)
        {
          this->VertexArray->ReleaseGraphicsResources();
          this->VertexArray = nullptr;
        }
      })
{
  this->DilateShader.SetDefinitions(GridDefinitions());
}

//------------------------------------------------------------------------------
vtkVirtualGrid::~vtkVirtualGrid() = default;

//------------------------------------------------------------------------------
bool vtkVirtualGrid::Allocate(vtkOpenGLRenderWindow* window)
{
  for (const auto& wishes : this->Wishes)
  {
    if (!wishes->Allocate(window, vtkShadowTextureArray::RGBA32F, GridSize, GridSize, 1))
    {
      return false;
    }
  }
  if (!this->Cells->Allocate(
        window, vtkShadowTextureArray::RG32F, GridSize, GridSize, 1, GridLevels))
  {
    return false;
  }
  this->Watch.Enter(window);
  if (!this->VertexArray)
  {
    this->VertexArray = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVirtualGrid::Begin(vtkOpenGLRenderWindow* window)
{
  if (!this->Allocate(window))
  {
    return false;
  }
  if (!vtkShadowDriver::OrdersVertices())
  {
    glFinish(); // points look up what the steps before drew
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVirtualGrid::Draw(vtkOpenGLRenderWindow* window, vtkVirtualScreen& screen)
{
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer.Bind(window);
  this->Wishes[0]->AttachLayer(0);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  if (!vtkShadowFramebuffer::IsComplete())
  {
    return false;
  }
  state->vtkglViewport(0, 0, GridSize, GridSize);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  if (!this->DrawPoints(window, screen))
  {
    return false;
  }
  state->vtkglDisable(GL_BLEND);
  this->Wishes[1]->AttachLayer(0);
  if (!this->Dilate(window, this->Wishes[0], 0))
  {
    return false;
  }
  this->Cells->AttachLayer(0);
  return this->Dilate(window, this->Wishes[1], 1) && this->DrawPyramid(window);
}

//------------------------------------------------------------------------------
bool vtkVirtualGrid::DrawPoints(vtkOpenGLRenderWindow* window, vtkVirtualScreen& screen)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->PointProgram)
  {
    cache->ReadyShaderProgram(this->PointProgram);
  }
  else
  {
    const std::string vertex = vtkShadowShader::Compose(vtkVirtualPointVS, GridDefinitions());
    this->PointProgram = cache->ReadyShaderProgram(vertex.c_str(), vtkVirtualPointFS, "");
    ++this->PointBuilds;
    if (!this->PointProgram)
    {
      vtkShadowFailures::Report("a shader does not compile");
      return false;
    }
  }
  const float unused[4] = { vtkVirtualTileTree::Unused, vtkVirtualTileTree::Unused, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, unused);
  vtkOpenGLState* state = window->GetState();
  GLint equations[2] = { GL_FUNC_ADD, GL_FUNC_ADD };
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equations[1]);
  const bool hasPointSize = glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE;
  glEnable(GL_PROGRAM_POINT_SIZE); // the shader's, not what an actor left
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MIN);
  screen.Activate(this->PointProgram, vtkVirtualScreen::SHAPES);
  screen.Activate(this->PointProgram, vtkVirtualScreen::PREDICTIONS);
  vtkShadowTextureArray* shapes = screen.GetTexture(vtkVirtualScreen::SHAPES);
  this->PointProgram->SetUniformi("gridSize", GridSize);
  this->PointProgram->SetUniformi(
    "blockSize", vtkShadowDriver::DrawsOnProcessor() ? 1 : PointBlock);
  this->VertexArray->Bind();
  // Mesa's softpipe miscounts the vertices of long draws: rows are instances.
  glDrawArraysInstanced(GL_POINTS, 0, shapes->GetWidth(), shapes->GetHeight());
  this->VertexArray->Release();
  screen.Deactivate();
  state->vtkglBlendEquationSeparate(equations[0], equations[1]);
  if (!hasPointSize)
  {
    glDisable(GL_PROGRAM_POINT_SIZE);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVirtualGrid::Dilate(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* from, int axis)
{
  if (!this->DilateShader.Use(window))
  {
    return false;
  }
  vtkShaderProgram* program = this->DilateShader.GetProgram();
  program->SetUniformi("axis", axis);
  program->SetUniformi("gridSize", GridSize);
  program->SetUniformi("wishes", from->Activate());
  this->DilateShader.Draw();
  from->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkVirtualGrid::DrawPyramid(vtkOpenGLRenderWindow* window)
{
  if (!this->PyramidShader.Use(window))
  {
    return false;
  }
  for (int level = 1; level < GridLevels; ++level)
  {
    this->Cells->SetLevelRange(level - 1, level - 1);
    this->Cells->AttachLayer(0, level);
    window->GetState()->vtkglViewport(0, 0, GridSize >> level, GridSize >> level);
    this->PyramidShader.GetProgram()->SetUniformi("cells", this->Cells->Activate());
    this->PyramidShader.Draw();
    this->Cells->Deactivate();
  }
  this->Cells->SetLevelRange(0, GridLevels - 1);
  return true;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualGrid::GetBytes() const
{
  return this->Wishes[0]->GetBytes() + this->Wishes[1]->GetBytes() + this->Cells->GetBytes();
}

//------------------------------------------------------------------------------
int vtkVirtualGrid::GetNumberOfBuilds() const
{
  return this->PointBuilds + this->DilateShader.GetNumberOfBuilds() +
    this->PyramidShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkVirtualGrid::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& wishes : this->Wishes)
  {
    wishes->ReleaseGraphicsResources(window);
  }
  this->Cells->ReleaseGraphicsResources(window);
  this->DilateShader.ReleaseGraphicsResources(window);
  this->PyramidShader.ReleaseGraphicsResources(window);
  this->Framebuffer.Release();
  this->Watch.Free();
}
VTK_ABI_NAMESPACE_END
