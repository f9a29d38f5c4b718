// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualGrid
 * @brief   The tile grid on the GPU: what texel size every cell of the map's plane is asked for.
 *
 * L. Shen et al. 2011, section 5.2, steps 4 and 5: a point per pixel, made from its vertex number,
 * falls into its cell with minimum blending; the pyramid of minima is drawn level by level. On a card
 * the first of the pixels of a block of 8 x 8 that lie in one cell draws the point of all. How the grid
 * reaches the CPU is vtkVirtualRequest's.
 *
 * Beyond the paper, cells take over the wishes of all kernels that reach into them (the paper: of the
 * pixels that lie in them), so that a kernel over a tile's border finds the same texels there.
 */

#ifndef vtkVirtualGrid_h
#define vtkVirtualGrid_h

#include "vtkNew.h"                               // For members
#include "vtkRenderingSoftShadowsVirtualModule.h" // For export macro
#include "vtkShadowContextWatch.h"                // For members
#include "vtkShadowFramebuffer.h"                 // For members
#include "vtkShadowShader.h"                      // For members
#include "vtkSmartPointer.h"                      // For members
#include "vtkSoftShadowsABI.h"                    // For the ABI namespace
#include "vtkType.h"                              // For bytes

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkShadowTextureArray;
class vtkVirtualScreen;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSVIRTUAL_EXPORT vtkVirtualGrid
{
public:
  vtkVirtualGrid();
  ~vtkVirtualGrid();
  vtkVirtualGrid(const vtkVirtualGrid&) = delete;
  vtkVirtualGrid& operator=(const vtkVirtualGrid&) = delete;

  /**
   * Before the grids of a frame, when the kernels of all their screens have been drawn. Waits until
   * they are where nothing else orders vertex shaders after drawing (vtkShadowDriver).
   */
  bool Begin(vtkOpenGLRenderWindow* window);

  /**
   * Draws grid and pyramid from the screen's predictions and leaves the framebuffer bound to which
   * GetCells was attached. The caller restores framebuffer, viewport, blending and depth test. False
   * if something does not compile.
   */
  bool Draw(vtkOpenGLRenderWindow* window, vtkVirtualScreen& screen);

  /// RG32F with all levels: texel sizes.
  vtkShadowTextureArray* GetCells() { return this->Cells; }

  vtkTypeInt64 GetBytes() const;
  int GetNumberOfBuilds() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Allocate(vtkOpenGLRenderWindow* window);
  bool DrawPoints(vtkOpenGLRenderWindow* window, vtkVirtualScreen& screen);
  bool Dilate(vtkOpenGLRenderWindow* window, vtkShadowTextureArray* from, int axis);
  bool DrawPyramid(vtkOpenGLRenderWindow* window);

  vtkNew<vtkShadowTextureArray> Wishes[2]; // RGBA32F: texel sizes, minus half extents of kernels
  vtkNew<vtkShadowTextureArray> Cells;     // RG32F with all levels: texel sizes
  vtkSmartPointer<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* PointProgram = nullptr; // the window's shader cache owns it
  vtkShadowShader DilateShader;
  vtkShadowShader PyramidShader;
  vtkShadowFramebuffer Framebuffer;
  int PointBuilds = 0;
  vtkShadowContextWatch Watch; // of program and vertex array
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualGrid.h
