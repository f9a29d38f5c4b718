// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSoftShadowPass.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowShader.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkVirtualGrid.h"
#include "vtkVirtualKernel.h"
#include "vtkVirtualResolution.h"
#include "vtkVirtualScreen.h"
#include "vtkVirtualTileMaps.h"
#include "vtkVirtualTileTree.h"

#include "vtkVirtualFootprintText.h"
#include "vtkVirtualResolveFS.h"
#include "vtkVirtualShapeFS.h"
#include "vtkVirtualTileFS.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkVirtualSoftShadowPass);

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

// What steps of this technique change and the base class expects back.
struct ScopedTarget
{
  explicit ScopedTarget(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , ScissorTest(state, GL_SCISSOR_TEST)
  {
    state->PushFramebufferBindings();
  }
  ~ScopedTarget() { this->State->PopFramebufferBindings(); }
  ScopedTarget(const ScopedTarget&) = delete;
  void operator=(const ScopedTarget&) = delete;

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
};
} // namespace

// What is kept per light and part.
struct EmitterState
{
  vtkVirtualTileMaps Maps;
  vtkVirtualTileTree Tree;
  vtkShadowEmitter Emitter;
  vtkMTimeType CastersTime = 0;
};

class vtkVirtualSoftShadowPass::Internals
{
public:
  std::map<std::pair<int, int>, EmitterState> Emitters; // by light and part
  vtkVirtualScreen Screen;
  vtkVirtualGrid Grid;
  vtkVirtualTileTree::Pyramid Wishes; // of the emitter at hand

  const std::string ShapeText = WithShared(vtkVirtualShapeFS);
  const std::string TileText = WithShared(vtkVirtualTileFS);
  vtkShadowShader ShapeShader{ ShapeText.c_str() };
  vtkShadowShader TileShader{ TileText.c_str() };
  vtkShadowShader ResolveShader{ vtkVirtualResolveFS };
  vtkTypeInt64 DrawCalls = 0;
  EmitterState* Current = nullptr; // of AddVisibility
  bool IsStatic = false;           // nothing but the camera moved since the frame before

  static const vtkShadowMapView& GetView(const vtkSoftShadowContext& context)
  {
    return context.Maps->GetViews()[context.Layer];
  }
  void SetCamera(vtkShaderProgram* program, const vtkSoftShadowContext& context);
  static int IsDisk(const vtkSoftShadowContext& context)
  {
    return context.Emitter.Shape == vtkShadowEmitter::DISK ? 1 : 0;
  }
};

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
vtkVirtualSoftShadowPass::vtkVirtualSoftShadowPass()
  : Impl(new Internals)
{
  this->MapSize = 4096;
  this->Impl->ShapeShader.SetDefinitions(SharedDefinitions());
  this->Impl->TileShader.SetDefinitions(SharedDefinitions());
  this->Impl->ResolveShader.SetDefinitions(SharedDefinitions());
}

//------------------------------------------------------------------------------
vtkVirtualSoftShadowPass::~vtkVirtualSoftShadowPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::AddVisibility(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  EmitterState& emitter = impl.Emitters[std::make_pair(context.Light, context.Part)];
  impl.Current = &emitter;
  impl.IsStatic =
    emitter.Emitter == context.Emitter && emitter.CastersTime == context.Casters->GetCastersTime();
  emitter.Emitter = context.Emitter;
  emitter.CastersTime = context.Casters->GetCastersTime();
  if (!impl.Screen.Allocate(
        context.Window, context.Receivers->GetWidth(), context.Receivers->GetHeight()))
  {
    return;
  }
  {
    const ScopedTarget target(context.Window->GetState());
    this->BeginStep("kernel shapes");
    if (!this->DrawShapes(context))
    {
      return;
    }
    this->BeginStep("tile planning");
    if (!this->PredictTiles(context))
    {
      return;
    }
    this->BeginStep("tile maps");
    this->BakeTiles(context);
    this->BeginStep("filtering");
    this->DrawTiles(context);
  }
  this->Resolve(context);
  this->BeginStep("visibility");
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::DrawShapes(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!impl.ShapeShader.Use(context.Window))
  {
    return false;
  }
  impl.Screen.BeginShapes(context.Window);
  vtkShaderProgram* program = impl.ShapeShader.GetProgram();
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
  impl.SetCamera(program, context);
  const bool isStatic = this->Metric == STATIC || (this->Metric == AUTOMATIC && impl.IsStatic);
  const vtkVirtualResolution::Polynomial& texels =
    isStatic ? vtkVirtualResolution::Static : vtkVirtualResolution::Dynamic;
  const float polynomial[4] = { static_cast<float>(texels[0]), static_cast<float>(texels[1]),
    static_cast<float>(texels[2]), static_cast<float>(texels[3]) };
  program->SetUniform4f("texelPolynomial", polynomial);
  program->SetUniformf("quality", static_cast<float>(this->Quality));
  program->SetUniformf("largestKernel", static_cast<float>(vtkVirtualResolution::LargestKernel));
  impl.ShapeShader.Draw();
  maps->Deactivate();
  pyramid->Deactivate();
  context.Receivers->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::PredictTiles(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!this->Adaptive)
  {
    return true;
  }
  if (!impl.Grid.Draw(context.Window, impl.Screen))
  {
    return false;
  }
  impl.Wishes = impl.Grid.Read();
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::PlanTiles(double mostTexels)
{
  Internals& impl = *this->Impl;
  vtkVirtualTileTree::Limits limits;
  limits.LargestTile = this->MapSize;
  limits.MostTexels = mostTexels;
  limits.MostTiles = this->MaximumTiles;
  if (this->Adaptive)
  {
    impl.Current->Tree.Build(impl.Wishes, limits);
  }
  else
  {
    impl.Current->Tree.BuildUniform(1 << this->FixedLevels, limits);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::BakeTiles(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  EmitterState& emitter = *impl.Current;
  double mostTexels = this->MapMemory * (1048576.0 / 4.0);
  vtkVirtualTileMaps::Work work;
  do
  {
    this->PlanTiles(mostTexels);
    work = emitter.Maps.Update(context.Renderer, context.Casters, Internals::GetView(context),
      emitter.Tree.GetTiles(), vtkVirtualTileTree::GridSize);
    impl.DrawCalls += work.DrawCalls;
    this->ChangeStatistics().MapsBaked += work.Maps;
    this->ChangeStatistics().TexelsDrawn += work.Texels;
    // A driver may have less than was allowed: everything becomes coarser.
    mostTexels = 0.25 * emitter.Tree.GetTexels();
  } while (work.Failed && mostTexels > 65536.0);
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::DrawTiles(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!impl.TileShader.Use(context.Window))
  {
    return;
  }
  impl.Screen.BeginSums(context.Window);
  vtkShaderProgram* program = impl.TileShader.GetProgram();
  this->SetReceiverUniforms(program, context);
  impl.Screen.Activate(program, Screen::SHAPES);
  impl.Screen.Activate(program, Screen::PREDICTIONS);
  program->SetUniformi("kernelGaussian", this->HasGaussianWeights() ? 1 : 0);
  program->SetUniformi("debugView", this->DebugView);
  program->SetUniformi("antialiasing", this->Antialiasing ? 1 : 0);
  // Fine tiles sharpen narrow kernels; wide ones are smooth with twice the paper's texels.
  program->SetUniformf(
    "coarseness", this->Adaptive ? static_cast<float>(std::max(0.5 * this->Quality, 1.0)) : 0.0f);
  impl.SetCamera(program, context);
  const float cell = 1.0f / vtkVirtualTileTree::GridSize;
  int number = 0;
  for (const vtkVirtualTileMaps::Entry& entry : impl.Current->Maps.GetEntries())
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
    impl.TileShader.Draw();
    maps->Deactivate();
  }
  impl.Screen.Deactivate();
  context.Receivers->Deactivate();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::Resolve(const vtkSoftShadowContext& context)
{
  Internals& impl = *this->Impl;
  if (!impl.ResolveShader.Use(context.Window))
  {
    return;
  }
  vtkShaderProgram* program = impl.ResolveShader.GetProgram();
  impl.Screen.Activate(program, Screen::SHAPES);
  impl.Screen.Activate(program, Screen::PREDICTIONS);
  impl.Screen.Activate(program, Screen::SUMS);
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
    impl.ResolveShader.Draw();
  }
  // Counted as filtered: without early-outs no pixel counts as proved.
  program->SetUniformi("part", this->EarlyOut ? PART_PENUMBRA : PART_ALL);
  this->DrawFiltered(impl.ResolveShader);
  impl.Screen.Deactivate();
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowPass::HasGaussianWeights() const
{
  return this->Weights == vtkShadowLightSampling::GAUSSIAN;
}

//------------------------------------------------------------------------------
int vtkVirtualSoftShadowPass::GetNumberOfTiles() const
{
  size_t tiles = 0;
  for (const auto& emitter : this->Impl->Emitters)
  {
    tiles += emitter.second.Tree.GetTiles().size();
  }
  return static_cast<int>(tiles);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualSoftShadowPass::GetTileTexels() const
{
  double texels = 0.0;
  for (const auto& emitter : this->Impl->Emitters)
  {
    texels += emitter.second.Tree.GetTexels();
  }
  return static_cast<vtkTypeInt64>(texels);
}

//------------------------------------------------------------------------------
double vtkVirtualSoftShadowPass::GetCoarsening() const
{
  double coarsening = 1.0;
  for (const auto& emitter : this->Impl->Emitters)
  {
    coarsening = std::max(coarsening, emitter.second.Tree.GetCoarsening());
  }
  return coarsening;
}

//------------------------------------------------------------------------------
std::string vtkVirtualSoftShadowPass::GetTileReport() const
{
  std::ostringstream report;
  for (const auto& emitter : this->Impl->Emitters)
  {
    const vtkVirtualTileTree& tree = emitter.second.Tree;
    report << "light " << emitter.first.first << " part " << emitter.first.second << ": "
           << tree.GetTiles().size() << " tiles, " << static_cast<vtkTypeInt64>(tree.GetTexels())
           << " texels, coarser than predicted by " << tree.GetCoarsening() << "\n";
    for (const vtkVirtualTile& tile : tree.GetTiles())
    {
      report << "  cells " << tile.X << " " << tile.Y << " size " << tile.Width << " x "
             << tile.Height << ": " << tile.Resolution << "\n";
    }
  }
  return report.str();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualSoftShadowPass::GetTechniqueBytes()
{
  vtkTypeInt64 bytes = this->Impl->Screen.GetBytes() + this->Impl->Grid.GetBytes();
  for (const auto& emitter : this->Impl->Emitters)
  {
    bytes += emitter.second.Maps.GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkVirtualSoftShadowPass::GetTechniqueDrawCalls()
{
  return this->Impl->DrawCalls;
}

//------------------------------------------------------------------------------
int vtkVirtualSoftShadowPass::GetTechniqueShaderBuilds()
{
  const Internals& impl = *this->Impl;
  return impl.ShapeShader.GetNumberOfBuilds() + impl.TileShader.GetNumberOfBuilds() +
    impl.ResolveShader.GetNumberOfBuilds() + impl.Grid.GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& impl = *this->Impl;
  impl.ShapeShader.ReleaseGraphicsResources(window);
  impl.TileShader.ReleaseGraphicsResources(window);
  impl.ResolveShader.ReleaseGraphicsResources(window);
  impl.Screen.ReleaseGraphicsResources(window);
  impl.Grid.ReleaseGraphicsResources(window);
  for (auto& emitter : impl.Emitters)
  {
    emitter.second.Maps.ReleaseGraphicsResources(window);
  }
  impl.Emitters.clear();
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const metrics[] = { "dynamic", "static", "automatic" };
  const char* const views[] = { "none", "tiles", "resolution", "kernel" };
  os << indent << "SearchMapSize: " << this->SearchMapSize << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "on" : "off") << "\n";
  os << indent << "FixedLevels: " << this->FixedLevels << "\n";
  os << indent << "Antialiasing: " << (this->Antialiasing ? "on" : "off") << "\n";
  os << indent << "Metric: " << metrics[this->Metric] << "\n";
  os << indent << "Weights: " << (this->HasGaussianWeights() ? "gaussian" : "mean") << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "SearchWidth: " << this->SearchWidth << "\n";
  os << indent << "MaximumTiles: " << this->MaximumTiles << "\n";
  os << indent << "DebugView: " << views[this->DebugView] << "\n";
}
VTK_ABI_NAMESPACE_END
