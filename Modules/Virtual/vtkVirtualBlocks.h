// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualBlocks
 * @brief   Draws, for a tile, only the blocks of pixels whose kernels reach into it.
 *
 * A small texture holds what every block of pixels needs of the map: the rectangle around its kernels.
 * A fragment shader is then drawn over blocks whose rectangle touches the tile, chosen by the vertex
 * shader; the CPU reads nothing back. Blocks without kernels are never drawn.
 */

#ifndef vtkVirtualBlocks_h
#define vtkVirtualBlocks_h

#include "vtkNew.h"                // For members
#include "vtkShadowContextWatch.h" // For members
#include "vtkShadowFramebuffer.h"  // For members
#include "vtkShadowShader.h"       // For members
#include "vtkSmartPointer.h"       // For members
#include "vtkSoftShadowsABI.h"     // For the ABI namespace
#include "vtkType.h"               // For bytes

#include <string> // For the shader

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkShadowTextureArray;
class vtkVirtualScreen;
class vtkWindow;

class vtkVirtualBlocks
{
public:
  /// Pixels along an edge of a block.
  static constexpr int BlockSize = 16;

  /// The text and definitions of the fragment shader, as vtkShadowShader takes them.
  vtkVirtualBlocks(const char* text, const vtkShadowShader::Definitions& definitions);
  ~vtkVirtualBlocks();
  vtkVirtualBlocks(const vtkVirtualBlocks&) = delete;
  vtkVirtualBlocks& operator=(const vtkVirtualBlocks&) = delete;

  /**
   * Finds the rectangles of the screen's kernels. Changes framebuffer, viewport, blending, scissor and
   * depth test, which the caller restores. False, with an error, if that cannot be.
   */
  bool FindBounds(vtkOpenGLRenderWindow* window, vtkVirtualScreen& kernels);

  /// Makes the fragment shader current; false if it does not compile.
  bool Use(vtkOpenGLRenderWindow* window);

  /// After Use: takes uniforms tileWindow (low corner and extent in (s, t)) and depthMapSize too.
  vtkShaderProgram* GetProgram() const { return this->Program; }

  /// Draws the blocks that touch the tile whose uniforms were set; long work in bands (vtkShadowBands).
  void Draw(vtkOpenGLRenderWindow* window, double tapsPerPixel);

  vtkTypeInt64 GetBytes() const;
  int GetNumberOfBuilds() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  const std::string Text;
  vtkNew<vtkShadowTextureArray> Bounds; // RGBA32F: least (s, t), minus the greatest
  vtkShadowShader BoundsShader;
  vtkShaderProgram* Program = nullptr;
  vtkSmartPointer<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShadowFramebuffer Framebuffer;
  int Builds = 0;
  float BlockExtent[2] = { 0.0f, 0.0f }; // in clip coordinates
  vtkShadowContextWatch Watch;           // of program and vertex array
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualBlocks.h
