// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowScreen
 * @brief   The textures of the screen's size that the steps of the filter read and write.
 */

#ifndef vtkSoftShadowScreen_h
#define vtkSoftShadowScreen_h

#include "vtkNew.h"               // For members
#include "vtkShadowFramebuffer.h" // For members
#include "vtkSoftShadowsABI.h"    // For the ABI namespace
#include "vtkType.h"              // For bytes

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowTextureArray;
class vtkWindow;

class vtkSoftShadowScreen
{
public:
  enum TextureName
  {
    SUMS = 0, // RGBA32F: weights of the points in front, -1 where there is no value, and of those
              // seen; reaches of the blockers
    BLURRED =
      1,       // RGBA32F: visibility, -1 where there is no value; guide; weight of points in front
    AGAIN = 2, // RGBA32F: the same, where more than two steps need it
    TILES = 3, // RGBA32F: least and greatest visibility of a tile
    KNOWN = 4, // R32F: visibility where there is nothing to estimate, as proved; else negative or 0
    NUMBER_OF_TEXTURES = 5
  };

  vtkSoftShadowScreen();
  ~vtkSoftShadowScreen();
  vtkSoftShadowScreen(const vtkSoftShadowScreen&) = delete;
  vtkSoftShadowScreen& operator=(const vtkSoftShadowScreen&) = delete;

  /**
   * Binds a texture of width x height texels for drawing, made or resized if need be, and clears it
   * to (-1, 0). marks, if not 0, is a depth renderbuffer of that size for the depth test. The
   * caller restores framebuffer, viewport and scissor. False if there is no such texture.
   */
  bool Begin(
    vtkOpenGLRenderWindow* window, TextureName texture, int width, int height, unsigned int marks);

  /// Copies the bound framebuffer's visibility into KNOWN.
  bool Copy(vtkOpenGLRenderWindow* window, int width, int height);

  vtkShadowTextureArray* GetTexture(TextureName texture) { return this->Textures[texture]; }
  vtkTypeInt64 GetBytes() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkShadowTextureArray> Textures[NUMBER_OF_TEXTURES];
  vtkShadowFramebuffer Framebuffer;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowScreen.h
