// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDepthMaps.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFailures.h"
#include "vtkShadowScopedState.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkShadowDepthMaps);

namespace
{
// The state of a bake that is not the casters' own: where they are drawn.
class ScopedTarget
{
public:
  ScopedTarget(vtkOpenGLRenderWindow* window, vtkShadowFramebuffer& framebuffer, int resolution)
    : ScopedTarget(window->GetState())
  {
    framebuffer.Bind(window);
    vtkShadowFramebuffer::SetDrawBuffers(window, 0);
    this->State->vtkglReadBuffer(GL_NONE);
    this->State->vtkglViewport(0, 0, resolution, resolution);
    this->State->vtkglDisable(GL_SCISSOR_TEST);
    this->State->vtkglDepthMask(GL_TRUE); // or nothing is cleared
  }
  ~ScopedTarget() { this->State->PopFramebufferBindings(); }
  ScopedTarget(const ScopedTarget&) = delete;
  void operator=(const ScopedTarget&) = delete;

private:
  explicit ScopedTarget(vtkOpenGLState* state)
    : State(state)
    , Viewport(state)
    , Scissor(state, GL_SCISSOR_TEST)
    , Raster(state)
    , DepthMask(state)
  {
    state->PushFramebufferBindings();
  }

  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglEnableDisable Scissor;
  vtkShadowScopedRaster Raster;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
};
}

//------------------------------------------------------------------------------
vtkShadowDepthMaps::vtkShadowDepthMaps() = default;

//------------------------------------------------------------------------------
vtkShadowDepthMaps::~vtkShadowDepthMaps() = default;

//------------------------------------------------------------------------------
int vtkShadowDepthMaps::Bake(vtkRenderer* renderer, vtkShadowCasters* casters,
  const std::vector<vtkShadowMapView>& views, int resolution, bool conservative)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("Depth maps need an OpenGL render window.");
    return -1;
  }
  const auto count = static_cast<int>(views.size());
  bool all = casters->GetCastersTime() != this->CastersTime || resolution != this->Resolution ||
    conservative != this->Conservative;
  if (count > 0 && (resolution != this->Texture->GetWidth() || count > this->Texture->GetLayers()))
  {
    if (!this->Texture->Allocate(
          window, vtkShadowTextureArray::DEPTH32F, resolution, resolution, count))
    {
      this->Views.clear();
      return -1;
    }
    all = true;
  }
  if (all)
  {
    this->Views.clear();
  }
  this->CastersTime = casters->GetCastersTime();
  this->Resolution = resolution;
  this->Conservative = conservative;
  return this->BakeLayers(renderer, casters, views);
}

//------------------------------------------------------------------------------
bool vtkShadowDepthMaps::IsHeld(std::size_t layer, const vtkShadowMapView& view) const
{
  return layer < this->Views.size() && this->Views[layer] == view;
}

//------------------------------------------------------------------------------
// Returns -1 if the framebuffer cannot be had.
int vtkShadowDepthMaps::BakeOneByOne(
  vtkRenderer* renderer, vtkShadowCasters* casters, const std::vector<vtkShadowMapView>& views)
{
  int baked = 0;
  const float empty = 0.0f;
  for (std::size_t layer = 0; layer < views.size(); ++layer)
  {
    if (!this->IsHeld(layer, views[layer]))
    {
      this->Texture->AttachLayer(static_cast<int>(layer));
      if (baked == 0 && !vtkShadowFramebuffer::IsComplete())
      {
        return -1;
      }
      glClearBufferfv(GL_DEPTH, 0, &empty);
      this->NumberOfDrawCalls +=
        casters->Draw(renderer, views[layer], this->Resolution, this->Conservative);
      ++baked;
    }
  }
  return baked;
}

//------------------------------------------------------------------------------
// All layers of the texture are cleared, so none may be held. Returns 0 if the driver cannot after all.
int vtkShadowDepthMaps::BakeAllAtOnce(
  vtkRenderer* renderer, vtkShadowCasters* casters, const std::vector<vtkShadowMapView>& views)
{
  this->Texture->AttachLayers();
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    return 0; // no failure: there is another way
  }
  const float empty = 0.0f;
  glClearBufferfv(GL_DEPTH, 0, &empty);
  const int calls = casters->DrawLayers(renderer, views);
  this->NumberOfDrawCalls += std::max(calls, 0);
  return calls < 0 ? 0 : static_cast<int>(views.size());
}

//------------------------------------------------------------------------------
int vtkShadowDepthMaps::BakeLayers(
  vtkRenderer* renderer, vtkShadowCasters* casters, const std::vector<vtkShadowMapView>& views)
{
  std::size_t held = 0;
  for (std::size_t layer = 0; layer < views.size(); ++layer)
  {
    held += this->IsHeld(layer, views[layer]) ? 1 : 0;
  }
  int baked = 0;
  if (held < views.size())
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    const ScopedTarget target(window, this->Framebuffer, this->Resolution);
    const bool atOnce = this->CanBakeAtOnce && held == 0 && views.size() > 1 &&
      !this->Conservative && this->Texture->GetLayers() < 2 * static_cast<int>(views.size()) &&
      casters->CanDrawLayers(renderer);
    baked = atOnce ? this->BakeAllAtOnce(renderer, casters, views) : 0;
    this->CanBakeAtOnce = this->CanBakeAtOnce && (!atOnce || baked > 0);
    baked = baked == 0 ? this->BakeOneByOne(renderer, casters, views) : baked;
    if (baked < 0)
    {
      this->Views.clear();
      return -1;
    }
  }
  if (vtkShadowFailures::IsFailing())
  {
    this->Views.clear(); // they lack casters
    return -1;
  }
  if (baked > 0 || views.size() != this->Views.size())
  {
    vtkTimeStamp stamp;
    stamp.Modified();
    this->BakeTime = stamp.GetMTime();
  }
  this->Views = views;
  this->NumberOfBakes += baked;
  return baked;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkShadowDepthMaps::ReadDepth(int layer)
{
  if (layer < 0 || layer >= static_cast<int>(this->Views.size()))
  {
    vtkErrorMacro("There is no layer " << layer << "; the layers are 0 to "
                                       << static_cast<int>(this->Views.size()) - 1 << ".");
    return nullptr;
  }
  const std::vector<float> depths = this->Texture->ReadLayer(layer);
  const vtkShadowMapView& view = this->Views[static_cast<std::size_t>(layer)];
  const double width = (view.Window[1] - view.Window[0]) / this->Resolution;
  const double height = (view.Window[3] - view.Window[2]) / this->Resolution;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Resolution, this->Resolution, 1);
  image->SetOrigin(view.Window[0] + 0.5 * width, view.Window[2] + 0.5 * height, 0.0);
  image->SetSpacing(width, height, 1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->SetName("Depth");
  auto* values = static_cast<float*>(image->GetScalarPointer());
  std::transform(depths.begin(), depths.end(), values,
    [&view](float depth)
    {
      return depth > 0.0f ? static_cast<float>(view.LinearDepth(-depth))
                          : std::numeric_limits<float>::infinity();
    });
  return image;
}

//------------------------------------------------------------------------------
void vtkShadowDepthMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer.Release();
  this->Texture->ReleaseGraphicsResources(window);
  this->Views.clear();
  this->Resolution = 0;
  this->CanBakeAtOnce = true;
}

//------------------------------------------------------------------------------
void vtkShadowDepthMaps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Views: " << this->Views.size() << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Conservative: " << this->Conservative << "\n";
  os << indent << "NumberOfBakes: " << this->NumberOfBakes << "\n";
  os << indent << "NumberOfDrawCalls: " << this->NumberOfDrawCalls << "\n";
}

VTK_ABI_NAMESPACE_END
