// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The steps of vtkVirtualSoftShadowPass that draw pictures of the screen's size.
#include "vtkVirtualSoftShadowPassInternals.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTextureArray.h"
#include "vtkVirtualKernel.h"
#include "vtkVirtualResolution.h"

#include "vtkVirtualFootprintText.h"
#include "vtkVirtualResolveFS.h"
#include "vtkVirtualShapeFS.h"
#include "vtkVirtualTileFS.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
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
  using Pass = vtkVirtualSoftShadowPass;
  return { { "VIRTUAL_UNSERVED", std::to_string(Screen::UNSERVED) + ".0" },
    { "VIRTUAL_LIT", std::to_string(Screen::LIT) + ".0" },
    { "VIRTUAL_PENUMBRA", std::to_string(Screen::PENUMBRA) + ".0" },
    { "VIRTUAL_PART_LIT", std::to_string(PART_LIT) },
    { "VIRTUAL_PART_PENUMBRA", std::to_string(PART_PENUMBRA) },
    { "VIRTUAL_DEBUG_TILES", std::to_string(Pass::DEBUG_TILES) },
    { "VIRTUAL_DEBUG_RESOLUTION", std::to_string(Pass::DEBUG_RESOLUTION) },
    { "VIRTUAL_DEBUG_KERNEL", std::to_string(Pass::DEBUG_KERNEL) } };
}
} // namespace

//------------------------------------------------------------------------------
vtkVirtualSoftShadowPass::Internals::Internals()
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
void vtkVirtualSoftShadowPass::Internals::SetCamera(
  vtkShaderProgram* program, const vtkSoftShadowContext& context)
{
  vtkCamera* camera = context.Renderer->GetActiveCamera();
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(context.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  // A pixel is 2 / width of the clip coordinates, half of one is half of that.
  const float halfPixel[2] = { static_cast<float>(1.0 /
                                 (context.Receivers->GetWidth() * projection->GetElement(0, 0))),
    static_cast<float>(1.0 / (context.Receivers->GetHeight() * projection->GetElement(1, 1))) };
  program->SetUniform2f("halfPixel", halfPixel);
  program->SetUniformi("cameraParallel", camera->GetParallelProjection());
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::DrawShapes(
  const vtkSoftShadowContext& context, const vtkVirtualEmitterState& emitter)
{
  Internals& impl = *this->Impl;
  if (!impl.ShapeShader->Use(context.Window) || !emitter.Screen->BeginShapes(context.Window))
  {
    return false;
  }
  vtkShaderProgram* program = impl.ShapeShader->GetProgram();
  this->SetReceiverUniforms(program, context);
  this->SetMapUniforms(
    program, context, Internals::GetView(context), context.Maps->GetResolution());
  vtkShadowTextureArray* maps = context.Maps->GetTexture();
  vtkShadowTextureArray* pyramid = context.Pyramid->GetTexture();
  program->SetUniformi("depthMaps", maps->Activate());
  program->SetUniformi("usePyramid", this->EarlyOut ? 1 : 0);
  program->SetUniformi("depthPyramid", pyramid->Activate());
  program->SetUniformf("mapLayer", static_cast<float>(context.Layer));
  program->SetUniformi("searchWidth", this->SearchWidth);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  program->SetUniformi("antialiasing", this->Antialiasing ? 1 : 0);
  Internals::SetCamera(program, context);
  const bool isStatic = this->Metric == STATIC || (this->Metric == AUTOMATIC && emitter.IsStatic);
  const vtkVirtualResolution::Polynomial& texels =
    isStatic ? vtkVirtualResolution::Static : vtkVirtualResolution::Dynamic;
  const float polynomial[4] = { static_cast<float>(texels[0]), static_cast<float>(texels[1]),
    static_cast<float>(texels[2]), static_cast<float>(texels[3]) };
  program->SetUniform4f("texelPolynomial", polynomial);
  program->SetUniformf("quality", static_cast<float>(this->Quality));
  program->SetUniformf("largestKernel", static_cast<float>(vtkVirtualResolution::LargestKernel));
  impl.ShapeShader->Draw();
  maps->Deactivate();
  pyramid->Deactivate();
  context.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::DrawTiles(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  const vtkVirtualEmitterState& emitter = *impl.Current;
  const bool allocated = impl.Sums.AllocateSums(
    context.Window, context.Receivers->GetWidth(), context.Receivers->GetHeight());
  if (!allocated || !impl.TileShader->FindBounds(context.Window, *emitter.Screen) ||
    !impl.TileShader->Use(context.Window) || !impl.Sums.BeginSums(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = impl.TileShader->GetProgram();
  this->SetReceiverUniforms(program, context);
  emitter.Screen->Activate(program, Screen::SHAPES);
  emitter.Screen->Activate(program, Screen::PREDICTIONS);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  program->SetUniformi("debugView", this->DebugView);
  program->SetUniformi("antialiasing", this->Antialiasing ? 1 : 0);
  // Fine tiles sharpen narrow kernels; wide ones are smooth with twice the paper's texels.
  program->SetUniformf(
    "coarseness", this->Adaptive ? static_cast<float>(std::max(0.5 * this->Quality, 1.0)) : 0.0f);
  Internals::SetCamera(program, context);
  const float cell = 1.0f / vtkVirtualTileTree::GridSize;
  int number = 0;
  for (const vtkVirtualTileMaps::Entry& entry : emitter.Maps.GetEntries())
  {
    const vtkVirtualTile& tile = entry.Tile;
    this->SetMapUniforms(program, context, entry.View, tile.Resolution);
    const float window[4] = { tile.X * cell, tile.Y * cell, tile.Width * cell, tile.Height * cell };
    program->SetUniform4f("tileWindow", window);
    program->SetUniformf("mapLayer", static_cast<float>(entry.Layer));
    // Shades of neighbours differ: multiples of the golden ratio.
    program->SetUniformf(
      "debugShade", static_cast<float>(std::fmod(0.2 + 0.618033988 * number++, 0.9) + 0.05));
    vtkShadowTextureArray* maps = entry.Maps->GetTexture();
    program->SetUniformi("depthMaps", maps->Activate());
    impl.TileShader->Draw();
    maps->Deactivate();
  }
  emitter.Screen->Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::Resolve(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!impl.ResolveShader->Use(context.Window))
  {
    return;
  }
  vtkVirtualScreen& kernels = *impl.Current->Screen;
  vtkShaderProgram* program = impl.ResolveShader->GetProgram();
  kernels.Activate(program, Screen::SHAPES);
  kernels.Activate(program, Screen::PREDICTIONS);
  impl.Sums.Activate(program, Screen::SUMS);
  program->SetUniformf("windowArea",
    static_cast<float>(
      vtkVirtualKernel::GetWindowArea(Internals::IsDisk(context) == 1, this->HasGaussianWeights(),
        { { context.Emitter.WindowCenter[0], context.Emitter.WindowCenter[1],
          context.Emitter.WindowHalfSize[0], context.Emitter.WindowHalfSize[1] } })));
  program->SetUniformi("debugView", this->DebugView);
  program->SetUniformf("weight", static_cast<float>(context.Emitter.Weight));
  if (this->EarlyOut)
  {
    program->SetUniformi("part", PART_LIT);
    impl.ResolveShader->Draw();
  }
  // Counted as filtered: without early-outs no pixel counts as proved.
  program->SetUniformi("part", this->EarlyOut ? PART_PENUMBRA : PART_ALL);
  this->DrawFiltered(*impl.ResolveShader);
  kernels.Deactivate();
  impl.Sums.Deactivate();
}
VTK_ABI_NAMESPACE_END
