// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualDrawing.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowServices.h"
#include "vtkVirtualEmitter.h"
#include "vtkVirtualKernel.h"
#include "vtkVirtualResolution.h"
#include "vtkVirtualSettings.h"
#include "vtkVirtualSoftShadowPass.h"

#include "vtkVirtualFootprintText.h"
#include "vtkVirtualResolveFS.h"
#include "vtkVirtualShapeFS.h"
#include "vtkVirtualTileFS.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Pass = vtkVirtualSoftShadowPass;
using Screen = vtkVirtualScreen;

// Which pixels the last step draws.
enum PartType
{
  PART_ALL = 0,
  PART_LIT = 1,
  PART_PENUMBRA = 2
};

// A step's text with what several steps share in place.
std::string WithShared(const char* text)
{
  std::string composed = text;
  const std::string kernel = "//VirtualSoftShadow::Kernel\n";
  composed.replace(composed.find(kernel), kernel.size(), vtkVirtualKernel::GetShaderText());
  const std::string footprint = "//VirtualSoftShadow::Footprint\n";
  composed.replace(composed.find(footprint), footprint.size(), vtkVirtualFootprintText);
  return composed;
}

vtkShadowShader::Definitions SharedDefinitions()
{
  return { { "VIRTUAL_UNSERVED", std::to_string(Screen::UNSERVED) + ".0" },
    { "VIRTUAL_LIT", std::to_string(Screen::LIT) + ".0" },
    { "VIRTUAL_PENUMBRA", std::to_string(Screen::PENUMBRA) + ".0" },
    { "VIRTUAL_PART_LIT", std::to_string(PART_LIT) },
    { "VIRTUAL_PART_PENUMBRA", std::to_string(PART_PENUMBRA) },
    { "VIRTUAL_DEBUG_TILES", std::to_string(Pass::DEBUG_TILES) },
    { "VIRTUAL_DEBUG_RESOLUTION", std::to_string(Pass::DEBUG_RESOLUTION) },
    { "VIRTUAL_DEBUG_KERNEL", std::to_string(Pass::DEBUG_KERNEL) } };
}

void SetCamera(vtkShaderProgram* program, const vtkSoftShadowServices& services)
{
  vtkCamera* camera = services.Renderer->GetActiveCamera();
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(services.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  // A pixel is 2 / width of the clip coordinates, half of one is half of that.
  const float halfPixel[2] = { static_cast<float>(1.0 /
                                 (services.Receivers->GetWidth() * projection->GetElement(0, 0))),
    static_cast<float>(1.0 / (services.Receivers->GetHeight() * projection->GetElement(1, 1))) };
  program->SetUniform2f("halfPixel", halfPixel);
  program->SetUniformi("cameraParallel", camera->GetParallelProjection());
}

// Octaves of distances in which a pixel searches blockers: most need no more.
constexpr double Octaves = 4.0;

// Taps of a pixel in a tile of so many texels along an edge: its kernel seldom has more than a quarter of
// the most texels along an edge that it may have.
double CountTileTaps(int resolution)
{
  constexpr double Most = 160.0;
  const double edge = 0.25 * std::min(static_cast<double>(resolution), Most);
  return edge * edge;
}

} // namespace

//------------------------------------------------------------------------------
vtkVirtualDrawing::vtkVirtualDrawing()
  : ShapeText(WithShared(vtkVirtualShapeFS))
  , TileText(WithShared(vtkVirtualTileFS))
  , ShapeShader(new vtkShadowShader(ShapeText.c_str()))
  , TileShader(new vtkVirtualBlocks(TileText.c_str(), SharedDefinitions()))
  , ResolveShader(new vtkShadowShader(vtkVirtualResolveFS))
{
  this->ShapeShader->SetDefinitions(SharedDefinitions());
  this->ResolveShader->SetDefinitions(SharedDefinitions());
}

//------------------------------------------------------------------------------
bool vtkVirtualDrawing::DrawShapes(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, const vtkVirtualEmitter& emitter)
{
  if (!this->ShapeShader->Use(services.Window) || !emitter.Screen->BeginShapes(services.Window))
  {
    return false;
  }
  vtkShaderProgram* program = this->ShapeShader->GetProgram();
  services.SetReceiverUniforms(program);
  services.SetMapUniforms(program);
  vtkShadowTextureArray* maps = services.Maps->GetTexture();
  vtkShadowTextureArray* pyramid = services.Pyramid->GetTexture();
  program->SetUniformi("depthMaps", maps->Activate());
  program->SetUniformi("usePyramid", services.EarlyOut ? 1 : 0);
  program->SetUniformi("depthPyramid", pyramid->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(services.Layer));
  program->SetUniformi("searchWidth", settings.SearchWidth);
  program->SetUniformi("kernelGaussian", settings.GaussianWeights ? 1 : 0);
  program->SetUniformi("antialiasing", settings.Antialiasing ? 1 : 0);
  SetCamera(program, services);
  const bool isStatic =
    settings.Metric == Pass::STATIC || (settings.Metric == Pass::AUTOMATIC && emitter.IsStatic);
  const vtkVirtualResolution::Polynomial& texels =
    isStatic ? vtkVirtualResolution::Static : vtkVirtualResolution::Dynamic;
  const float polynomial[4] = { static_cast<float>(texels[0]), static_cast<float>(texels[1]),
    static_cast<float>(texels[2]), static_cast<float>(texels[3]) };
  program->SetUniform4f("texelPolynomial", polynomial);
  program->SetUniformf("quality", static_cast<float>(settings.Quality));
  program->SetUniformf("largestKernel", static_cast<float>(vtkVirtualResolution::LargestKernel));
  this->ShapeShader->Draw(Octaves * settings.SearchWidth * settings.SearchWidth);
  maps->Deactivate();
  pyramid->Deactivate();
  services.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualDrawing::DrawTiles(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, const vtkVirtualEmitter& emitter)
{
  const bool allocated = this->Sums.AllocateSums(
    services.Window, services.Receivers->GetWidth(), services.Receivers->GetHeight());
  if (!allocated || !this->TileShader->FindBounds(services.Window, *emitter.Screen) ||
    !this->TileShader->Use(services.Window) || !this->Sums.BeginSums(services.Window))
  {
    return;
  }
  vtkShaderProgram* program = this->TileShader->GetProgram();
  services.SetReceiverUniforms(program);
  emitter.Screen->Activate(program, Screen::SHAPES);
  emitter.Screen->Activate(program, Screen::PREDICTIONS);
  program->SetUniformi("kernelGaussian", settings.GaussianWeights ? 1 : 0);
  program->SetUniformi("debugView", settings.DebugView);
  program->SetUniformi("antialiasing", settings.Antialiasing ? 1 : 0);
  // Fine tiles sharpen narrow kernels; wide ones are smooth with twice the paper's texels.
  program->SetUniformf("coarseness",
    settings.Adaptive ? static_cast<float>(std::max(0.5 * settings.Quality, 1.0)) : 0.0f);
  SetCamera(program, services);
  const float cell = 1.0f / vtkVirtualTileTree::GridSize;
  int number = 0;
  for (const vtkVirtualTileMaps::Entry& entry : emitter.Maps.GetEntries())
  {
    const vtkVirtualTile& tile = entry.Tile;
    services.SetMapUniforms(program, entry.View, tile.Resolution);
    const float window[4] = { tile.X * cell, tile.Y * cell, tile.Width * cell, tile.Height * cell };
    program->SetUniform4f("tileWindow", window);
    program->SetUniformf("mapLayer", static_cast<float>(entry.Layer));
    // Shades of neighbours differ: multiples of the golden ratio.
    program->SetUniformf(
      "debugShade", static_cast<float>(std::fmod(0.2 + 0.618033988 * number++, 0.9) + 0.05));
    vtkShadowTextureArray* maps = entry.Maps->GetTexture();
    program->SetUniformi("depthMaps", maps->Activate());
    this->TileShader->Draw(services.Window, CountTileTaps(tile.Resolution));
    maps->Deactivate();
  }
  emitter.Screen->Deactivate();
  services.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkVirtualDrawing::Resolve(const vtkSoftShadowServices& services,
  const vtkVirtualSettings& settings, const vtkVirtualEmitter& emitter)
{
  if (!this->ResolveShader->Use(services.Window))
  {
    return;
  }
  vtkVirtualScreen& kernels = *emitter.Screen;
  vtkShaderProgram* program = this->ResolveShader->GetProgram();
  kernels.Activate(program, Screen::SHAPES);
  kernels.Activate(program, Screen::PREDICTIONS);
  this->Sums.Activate(program, Screen::SUMS);
  program->SetUniformf("windowArea",
    static_cast<float>(vtkVirtualKernel::GetWindowArea(
      services.Emitter.Shape == vtkShadowEmitter::DISK, settings.GaussianWeights,
      { { services.Emitter.WindowCenter[0], services.Emitter.WindowCenter[1],
        services.Emitter.WindowHalfSize[0], services.Emitter.WindowHalfSize[1] } })));
  program->SetUniformi("debugView", settings.DebugView);
  program->SetUniformf("weight", static_cast<float>(services.Emitter.Weight));
  if (services.EarlyOut)
  {
    program->SetUniformi("part", PART_LIT);
    this->ResolveShader->Draw();
  }
  // Counted as filtered: without early-outs no pixel counts as proved.
  program->SetUniformi("part", services.EarlyOut ? PART_PENUMBRA : PART_ALL);
  services.DrawMarked(*this->ResolveShader);
  kernels.Deactivate();
  this->Sums.Deactivate();
}

//------------------------------------------------------------------------------
int vtkVirtualDrawing::GetNumberOfBuilds() const
{
  return this->ShapeShader->GetNumberOfBuilds() + this->TileShader->GetNumberOfBuilds() +
    this->ResolveShader->GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkVirtualDrawing::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ShapeShader->ReleaseGraphicsResources(window);
  this->TileShader->ReleaseGraphicsResources(window);
  this->ResolveShader->ReleaseGraphicsResources(window);
  this->Sums.ReleaseGraphicsResources(window);
}
VTK_ABI_NAMESPACE_END
