// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowTextureArray
 * @brief   An OpenGL two-dimensional array texture with the few operations the passes need.
 *
 * vtkTextureObject knows no array textures; every call on them stands here. Depth maps, pyramids
 * and visibilities are array textures, one layer per map or light.
 *
 * Nearest filtering; outside lies what is at the edge. That nothing lies beyond a depth map, the
 * snippet vtkShadowDepthMap tells by arithmetic: borders are what samplers differ in.
 */

#ifndef vtkShadowTextureArray_h
#define vtkShadowTextureArray_h

#include "vtkObject.h"
#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkShadowContextWatch.h"             // For members
#include "vtkShadowTextureUnit.h"              // For members
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <vector> // For read-backs

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowTextureArray : public vtkObject
{
public:
  static vtkShadowTextureArray* New();
  vtkTypeMacro(vtkShadowTextureArray, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FormatType
  {
    R32F = 0,
    RG32F = 1,
    RGBA32F = 2,
    DEPTH32F = 3
  };

  /**
   * Makes the texture hold layers of width x height texels with mip levels (1: none). Does nothing
   * and returns true if it already does. False if the driver has no such texture: tells
   * vtkShadowFailures the sizes.
   */
  bool Allocate(
    vtkOpenGLRenderWindow* window, int format, int width, int height, int layers, int levels = 1);

  ///@{
  /// What was allocated last; 0 before and after a release.
  vtkGetMacro(Width, int);
  vtkGetMacro(Height, int);
  vtkGetMacro(Layers, int);
  vtkGetMacro(Levels, int);
  vtkGetMacro(Format, int);
  ///@}

  /// Bytes of all layers and levels.
  vtkTypeInt64 GetBytes() const;

  /// The most layers this window's driver allows.
  static int GetMaximumLayers(vtkOpenGLRenderWindow* window);

  /**
   * Binds the texture to a texture unit of its own and returns the unit, for a sampler2DArray.
   * Every Activate needs its Deactivate. Where no unit is left it tells vtkShadowFailures, binds
   * nothing and returns a unit that a sampler may be set to, but not read.
   *
   * A texture that was never allocated takes an empty unit of the window: a program draws nothing at
   * all while samplers of two kinds share a unit, be they read or not.
   */
  int Activate(vtkOpenGLRenderWindow* window = nullptr);
  void Deactivate();

  /// The OpenGL name, 0 if there is none.
  vtkGetMacro(Handle, unsigned int);

  /**
   * Attaches a layer to the draw framebuffer that is bound now: as its depth attachment if the
   * format is a depth format, else as colour attachment.
   */
  void AttachLayer(int layer, int level = 0, int colorAttachment = 0);

  /// The same with all layers of a level: programs choose one, and clearing clears them all.
  void AttachLayers(int level = 0, int colorAttachment = 0);

  /// Copies the lower left corner of the bound read framebuffer to the texels of a layer from (x, y) on.
  void CopyFromFramebuffer(int layer, int x, int y, int width, int height);

  /// Sampling clamps to levels [base, maximum], so that a level can be read while another is drawn.
  void SetLevelRange(int base, int maximum);

  /// Fills a layer from the CPU: width * height * components floats, bottom row first.
  void WriteLayer(int layer, const float* values);

  /// Copies a layer to the CPU: width * height * components floats of that level, bottom row first.
  std::vector<float> ReadLayer(int layer, int level = 0);

  /// Frees it in the window that it lies in. That window and the destructor do so by themselves.
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkShadowTextureArray();
  ~vtkShadowTextureArray() override;

  vtkShadowContextWatch Watch;
  unsigned int Handle = 0;
  vtkShadowTextureUnit Unit;
  int Format = R32F;
  int Width = 0;
  int Height = 0;
  int Layers = 0;
  int Levels = 0;

private:
  vtkShadowTextureArray(const vtkShadowTextureArray&) = delete;
  void operator=(const vtkShadowTextureArray&) = delete;

  bool IsAllowed(int width, int height, int layers, int levels) const;
  void DeleteTexture();
  unsigned int GetAttachment(int colorAttachment) const;
};

VTK_ABI_NAMESPACE_END
#endif
