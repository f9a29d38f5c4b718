// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualRequest.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowScopedState.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <cmath>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int GridSize = vtkVirtualTileTree::GridSize;
constexpr int GridLevels = vtkVirtualTileTree::GridLevels;

// Of all levels together.
GLsizeiptr CountBytes()
{
  size_t cells = 0;
  for (int level = 0; level < GridLevels; ++level)
  {
    cells += static_cast<size_t>(GridSize >> level) * (GridSize >> level);
  }
  return static_cast<GLsizeiptr>(cells * sizeof(vtkVirtualTileTree::Cell));
}

// Kernels of other sizes ask for other texels.
bool HaveOneSize(const vtkShadowEmitter& a, const vtkShadowEmitter& b)
{
  const auto isNear = [](double x, double y)
  { return std::abs(x - y) <= 0.1 * std::max(std::abs(x), std::abs(y)); };
  return a.Shape == b.Shape && a.Directional == b.Directional &&
    isNear(a.HalfSize[0], b.HalfSize[0]) && isNear(a.HalfSize[1], b.HalfSize[1]);
}
} // namespace

//------------------------------------------------------------------------------
vtkVirtualRequest::vtkVirtualRequest()
  : Watch(
      [this](vtkOpenGLRenderWindow*)
      {
        if (this->Fence)
        {
          glDeleteSync(static_cast<GLsync>(this->Fence));
          this->Fence = nullptr;
        }
        glDeleteBuffers(1, &this->PixelBuffer);
        this->PixelBuffer = 0;
        this->Wishes.clear();
      })
{
}

//------------------------------------------------------------------------------
vtkVirtualRequest::~vtkVirtualRequest() = default;

//------------------------------------------------------------------------------
void vtkVirtualRequest::Start(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* cells,
  const vtkShadowMapView& view, vtkTypeInt64 state)
{
  this->Watch.Enter(window);
  const vtkShadowScopedPixelStore pixelStore;
  if (!this->PixelBuffer)
  {
    glGenBuffers(1, &this->PixelBuffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, this->PixelBuffer);
    glBufferData(GL_PIXEL_PACK_BUFFER, CountBytes(), nullptr, GL_STREAM_READ);
  }
  window->GetState()->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->PixelBuffer);
  size_t offset = 0;
  for (int level = 0; level < GridLevels; ++level)
  {
    const int size = GridSize >> level;
    cells->AttachLayer(0, level);
    glReadPixels(0, 0, size, size, GL_RG, GL_FLOAT, reinterpret_cast<void*>(offset));
    offset += static_cast<size_t>(size) * size * sizeof(vtkVirtualTileTree::Cell);
  }
  if (this->Fence)
  {
    glDeleteSync(static_cast<GLsync>(this->Fence));
  }
  this->Fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  this->SentView = view;
  this->SentState = state;
}

//------------------------------------------------------------------------------
bool vtkVirtualRequest::HasArrived() const
{
  if (!this->Fence)
  {
    return false;
  }
  const GLenum status =
    glClientWaitSync(static_cast<GLsync>(this->Fence), GL_SYNC_FLUSH_COMMANDS_BIT, 0);
  return status == GL_ALREADY_SIGNALED || status == GL_CONDITION_SATISFIED;
}

//------------------------------------------------------------------------------
int vtkVirtualRequest::GetShift(const vtkShadowMapView& view) const
{
  if (this->Wishes.empty() || !HaveOneSize(this->HeldView.Emitter, view.Emitter))
  {
    return Far;
  }
  if (this->HeldView == view)
  {
    return 0;
  }
  double heldToWorld[16];
  vtkMatrix4x4::Invert(this->HeldView.WorldToMap().data(), heldToWorld);
  double heldToMap[16];
  vtkMatrix4x4::Multiply4x4(view.WorldToMap().data(), heldToWorld, heldToMap);
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double from[4] = { (corner & 1) != 0 ? 1.0 : 0.0, (corner & 2) != 0 ? 1.0 : 0.0,
      (corner & 4) != 0 ? 0.0 : -1.0, 1.0 };
    double to[4];
    vtkMatrix4x4::MultiplyPoint(heldToMap, from, to);
    if (!(to[3] > 0.0))
    {
      return Far;
    }
    largest =
      std::max({ largest, std::abs(to[0] / to[3] - from[0]), std::abs(to[1] / to[3] - from[1]) });
  }
  return static_cast<int>(std::ceil(std::min(largest, 1.0 * Far / GridSize) * GridSize));
}

//------------------------------------------------------------------------------
bool vtkVirtualRequest::Collect()
{
  return this->HasArrived() && this->Take();
}

//------------------------------------------------------------------------------
bool vtkVirtualRequest::Wait()
{
  return this->Fence && this->Take(); // mapping the buffer waits
}

//------------------------------------------------------------------------------
bool vtkVirtualRequest::Take()
{
  glDeleteSync(static_cast<GLsync>(this->Fence));
  this->Fence = nullptr;
  const vtkShadowScopedPixelStore pixelStore;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->PixelBuffer);
  const void* data = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, CountBytes(), GL_MAP_READ_BIT);
  if (data)
  {
    this->Wishes.resize(GridLevels);
    const auto* cells = static_cast<const vtkVirtualTileTree::Cell*>(data);
    for (int i = 0; i < GridLevels; ++i)
    {
      vtkVirtualTileTree::Level& level = this->Wishes[i];
      level.resize(static_cast<size_t>(GridSize >> i) * (GridSize >> i));
      std::memcpy(level.data(), cells, level.size() * sizeof(vtkVirtualTileTree::Cell));
      cells += level.size();
    }
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    this->HeldView = this->SentView;
    this->HeldState = this->SentState;
  }
  return data != nullptr;
}
VTK_ABI_NAMESPACE_END
