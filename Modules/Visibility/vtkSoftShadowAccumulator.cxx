// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowAccumulator.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFailures.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include "vtkSoftShadowMixFS.h"
#include "vtkSoftShadowTilesFS.h"

#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSoftShadowAccumulator::vtkSoftShadowAccumulator()
  : MixShader(vtkSoftShadowMixFS)
  , TilesShader(vtkSoftShadowTilesFS)
{
  for (auto& texture : this->Textures)
  {
    texture = vtkSmartPointer<vtkShadowTextureArray>::New();
  }
  const vtkShadowShader::Definitions definitions = { { "SOFT_SHADOW_TILE",
    std::to_string(TileSize) } };
  this->TilesShader.SetDefinitions(definitions);
}

//------------------------------------------------------------------------------
vtkSoftShadowAccumulator::~vtkSoftShadowAccumulator() = default;

//------------------------------------------------------------------------------
int vtkSoftShadowAccumulator::Begin(
  vtkOpenGLRenderWindow* window, vtkShadowTextureArray* visibility)
{
  const int width = visibility->GetWidth();
  const int height = visibility->GetHeight();
  const int layers = visibility->GetLayers();
  const auto allocate = [&](vtkShadowTextureArray* texture, int w, int h)
  {
    const bool held =
      texture->GetWidth() == w && texture->GetHeight() == h && texture->GetLayers() == layers;
    return texture->Allocate(window, vtkShadowTextureArray::R32F, w, h, layers) ? (held ? 0 : 1)
                                                                                : -1;
  };
  int made =
    allocate(this->Tiles, (width + TileSize - 1) / TileSize, (height + TileSize - 1) / TileSize);
  for (const auto& texture : this->Textures)
  {
    const int one = made < 0 ? -1 : allocate(texture, width, height);
    made = one < 0 ? -1 : made + one;
  }
  if (made < 0)
  {
    this->ReleaseTextures(window);
    return -1;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    this->Mix(window, this->Textures[BASE], visibility, visibility, layer, 1.0f, 0.0f);
  }
  this->Clear(window);
  if (vtkShadowFailures::IsFailing())
  {
    this->ReleaseTextures(window);
    return -1;
  }
  return made;
}

//------------------------------------------------------------------------------
bool vtkSoftShadowAccumulator::Bind(
  vtkOpenGLRenderWindow* window, vtkShadowTextureArray* target, int layer)
{
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer.Bind(window);
  target->AttachLayer(layer);
  vtkShadowFramebuffer::SetDrawBuffers(window, 1);
  state->vtkglViewport(0, 0, target->GetWidth(), target->GetHeight());
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return vtkShadowFramebuffer::IsComplete();
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::Clear(vtkOpenGLRenderWindow* window)
{
  for (int layer = 0; layer < this->Textures[SUM]->GetLayers(); ++layer)
  {
    if (this->Bind(window, this->Textures[SUM], layer))
    {
      window->GetState()->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
      window->GetState()->vtkglClear(GL_COLOR_BUFFER_BIT);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSoftShadowAccumulator::BeginSum(vtkOpenGLRenderWindow* window, int layer)
{
  const bool bound = this->Bind(window, this->Textures[SUM], layer);
  vtkOpenGLState* state = window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  return bound;
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::Hold(vtkOpenGLRenderWindow* window, int layer, float scale)
{
  this->Mix(
    window, this->Textures[HELD], this->Textures[BASE], this->Textures[SUM], layer, 0.0f, scale);
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::HoldHalf(vtkOpenGLRenderWindow* window, int layer, float scale)
{
  this->Mix(
    window, this->Textures[HALF], this->Textures[BASE], this->Textures[SUM], layer, 0.0f, scale);
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::KeepHalves()
{
  std::swap(this->Textures[HALF], this->Textures[HELD_HALF]);
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::Show(vtkOpenGLRenderWindow* window,
  vtkShadowTextureArray* visibility, int layer, float share, float scale, bool fromHeld)
{
  this->Mix(window, visibility, this->Textures[fromHeld ? HELD : BASE], this->Textures[SUM], layer,
    1.0f - share, share * scale);
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::Mix(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* target,
  vtkShadowTextureArray* first, vtkShadowTextureArray* second, int layer, float firstShare,
  float secondShare)
{
  if (!this->Bind(window, target, layer) || !this->MixShader.Use(window))
  {
    return;
  }
  vtkShaderProgram* program = this->MixShader.GetProgram();
  const float shares[2] = { firstShare, secondShare };
  program->SetUniform2f("shares", shares);
  program->SetUniformf("layer", static_cast<float>(layer));
  const int unit = first->Activate();
  program->SetUniformi("first", unit);
  program->SetUniformi("second", first == second ? unit : second->Activate());
  this->MixShader.Draw();
  if (first != second)
  {
    second->Deactivate();
  }
  first->Deactivate();
}

//------------------------------------------------------------------------------
std::vector<float> vtkSoftShadowAccumulator::ReadChanges(vtkOpenGLRenderWindow* window,
  vtkShadowReceivers* receivers, int layer, float scale, ChangeType change)
{
  if (!this->Bind(window, this->Tiles, layer) || !this->TilesShader.Use(window))
  {
    return {};
  }
  vtkShaderProgram* program = this->TilesShader.GetProgram();
  receivers->Activate(program);
  program->SetUniformf("share", scale);
  program->SetUniformf("layer", static_cast<float>(layer));
  program->SetUniformi("commonOnly", change == COMMON ? 1 : 0);
  // All change has no halves, but a sampler has to have something to read.
  const bool halves = change == COMMON;
  const int names[NUMBER_OF_TEXTURES] = { BASE, SUM, HELD, halves ? HALF : SUM,
    halves ? HELD_HALF : HELD };
  const char* const samplers[NUMBER_OF_TEXTURES] = { "base", "sum", "held", "halfMean",
    "heldHalfMean" };
  int units[NUMBER_OF_TEXTURES];
  for (int i = 0; i < NUMBER_OF_TEXTURES; ++i)
  {
    units[i] = names[i] == i ? this->Textures[i]->Activate() : units[names[i]];
    program->SetUniformi(samplers[i], units[i]);
  }
  this->TilesShader.Draw();
  for (int i = 0; i < NUMBER_OF_TEXTURES; ++i)
  {
    if (names[i] == i)
    {
      this->Textures[i]->Deactivate();
    }
  }
  receivers->Deactivate();
  return this->Tiles->ReadLayer(layer);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkSoftShadowAccumulator::GetBytes() const
{
  vtkTypeInt64 bytes = this->Tiles->GetBytes();
  for (const auto& texture : this->Textures)
  {
    bytes += texture->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
int vtkSoftShadowAccumulator::GetNumberOfBuilds() const
{
  return this->MixShader.GetNumberOfBuilds() + this->TilesShader.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::ReleaseHalves(vtkWindow* window)
{
  this->Textures[HALF]->ReleaseGraphicsResources(window);
  this->Textures[HELD_HALF]->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::ReleaseTextures(vtkWindow* window)
{
  for (const auto& texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Tiles->ReleaseGraphicsResources(window);
  // What is attached to a framebuffer lives as long as that does.
  this->Framebuffer.Release();
}

//------------------------------------------------------------------------------
void vtkSoftShadowAccumulator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ReleaseTextures(window);
  this->MixShader.ReleaseGraphicsResources(window);
  this->TilesShader.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
