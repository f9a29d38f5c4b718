// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualRequest
 * @brief   What texel sizes the pixels of one emitter ask for, and their way from the GPU.
 *
 * Start copies a drawn grid to a pixel buffer with a fence behind it. The CPU looks whether the fence
 * is signalled (Collect) or waits for it (Wait); meanwhile it holds what came before. A state is a
 * number that the caller changes whenever anything changed that grids depend on.
 */

#ifndef vtkVirtualRequest_h
#define vtkVirtualRequest_h

#include "vtkShadowContextWatch.h" // For members
#include "vtkShadowMapView.h"      // For views
#include "vtkSoftShadowsABI.h"     // For the ABI namespace
#include "vtkType.h"               // For states
#include "vtkVirtualTileTree.h"    // For the pyramid

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowTextureArray;

class vtkVirtualRequest
{
public:
  vtkVirtualRequest();
  ~vtkVirtualRequest();
  vtkVirtualRequest(const vtkVirtualRequest&) = delete;
  vtkVirtualRequest& operator=(const vtkVirtualRequest&) = delete;

  /**
   * Starts the way of a grid with all its levels to the CPU; what was under way is lost. The draw
   * framebuffer that is bound must be one for reading, too: levels are attached to it.
   */
  void Start(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* cells,
    const vtkShadowMapView& view, vtkTypeInt64 state);

  /// Whether something is under way, and whether it could be had without waiting.
  bool IsUnderWay() const { return this->Fence != nullptr; }
  bool HasArrived() const;

  ///@{
  /// Takes what is under way, if it has arrived or in any case. True if anything was taken.
  bool Collect();
  bool Wait();
  ///@}

  /// The pyramid that was taken last; empty before the first one.
  const vtkVirtualTileTree::Pyramid& GetWishes() const { return this->Wishes; }

  /// Whether that is what this state asks for.
  bool IsOf(vtkTypeInt64 state) const { return !this->Wishes.empty() && this->HeldState == state; }

  /**
   * By how many cells, at most, a point of the map that its cells are of lies elsewhere on the map of
   * this view. Far if that cannot be told, if the light has another size, or before the first one.
   */
  int GetShift(const vtkShadowMapView& view) const;
  static constexpr int Far = 1 << 20;

  /// Forgets all, also what was taken. The window's end and the destructor do so by themselves.
  void ReleaseGraphicsResources() { this->Watch.Free(); }

private:
  bool Take();

  vtkVirtualTileTree::Pyramid Wishes;
  vtkShadowMapView HeldView;
  vtkTypeInt64 HeldState = -1;
  vtkShadowMapView SentView;
  vtkTypeInt64 SentState = -1;
  void* Fence = nullptr; // a GLsync
  unsigned int PixelBuffer = 0;
  vtkShadowContextWatch Watch;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualRequest.h
