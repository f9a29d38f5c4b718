// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualDrawing
 * @brief   The steps that draw pictures of the screen's size: kernels, sums over tiles, visibility.
 */

#ifndef vtkVirtualDrawing_h
#define vtkVirtualDrawing_h

#include "vtkShadowShader.h"   // For members
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkVirtualBlocks.h"  // For members
#include "vtkVirtualScreen.h"  // For members

#include <memory> // For shaders
#include <string> // For shaders

VTK_ABI_NAMESPACE_BEGIN
class vtkSoftShadowServices;
struct vtkVirtualEmitter;
struct vtkVirtualSettings;

class vtkVirtualDrawing
{
public:
  vtkVirtualDrawing();

  /// Draws the emitter's kernels and what texels they want to its screen. Restores nothing.
  bool DrawShapes(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    const vtkVirtualEmitter& emitter);

  /// Draws the sums over the emitter's tiles. Restores nothing.
  void DrawTiles(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    const vtkVirtualEmitter& emitter);

  /// Adds the visibility that the sums make to the bound framebuffer.
  void Resolve(const vtkSoftShadowServices& services, const vtkVirtualSettings& settings,
    const vtkVirtualEmitter& emitter);

  vtkTypeInt64 GetBytes() const { return this->Sums.GetBytes() + this->TileShader->GetBytes(); }
  int GetNumberOfBuilds() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string ShapeText;
  std::string TileText;
  std::unique_ptr<vtkShadowShader> ShapeShader;
  std::unique_ptr<vtkVirtualBlocks> TileShader;
  std::unique_ptr<vtkShadowShader> ResolveShader;
  vtkVirtualScreen Sums;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualDrawing.h
