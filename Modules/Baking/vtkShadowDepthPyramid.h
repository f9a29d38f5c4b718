// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowDepthPyramid
 * @brief   Minimum and maximum depth over ever larger squares of the depth maps.
 *
 * An RG32F array texture with as many layers as the maps. Level 0 is half as wide as the maps,
 * rounded up to a power of two; the texel (i, j) of level k holds (minimum, maximum) of d over the
 * 2^(k+1) x 2^(k+1) texels of the map from (i 2^(k+1), j 2^(k+1)) on, with depth 0 beyond the map. It
 * proves most pixels fully lit or fully blocked without a single tap.
 *
 * All levels of a layer lie in one image, without mip levels: level 0 at the left, the others upon each
 * other in a column to its right. Mesa's software rasterisers fetch the four pixels of a quad from one
 * mip level, the first pixel's; so each pixel may read a level of its own.
 */

#ifndef vtkShadowDepthPyramid_h
#define vtkShadowDepthPyramid_h

#include "vtkNew.h" // For members
#include "vtkObject.h"
#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace

#include <array>  // For corners
#include <memory> // For the implementation

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowDepthMaps;
class vtkShadowTextureArray;
class vtkWindow;

class VTKRENDERINGSOFTSHADOWSBAKING_EXPORT vtkShadowDepthPyramid : public vtkObject
{
public:
  static vtkShadowDepthPyramid* New();
  vtkTypeMacro(vtkShadowDepthPyramid, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Rebuilds the pyramid if the maps' BakeTime says so. Returns true if it did.
  bool Update(vtkOpenGLRenderWindow* window, vtkShadowDepthMaps* maps);

  vtkShadowTextureArray* GetTexture() { return this->Texture; }

  /// Of the last Update; the coarsest level is one texel.
  int GetNumberOfLevels() const { return this->Levels; }

  ///@{
  /// Texels along an edge of a level, and where its lower left texel lies in the image.
  int GetLevelSize(int level) const;
  std::array<int, 2> GetLevelCorner(int level) const;
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkShadowDepthPyramid();
  ~vtkShadowDepthPyramid() override;

  vtkNew<vtkShadowTextureArray> Texture;
  int Levels = 0;
  vtkMTimeType BuildTime = 0;

private:
  vtkShadowDepthPyramid(const vtkShadowDepthPyramid&) = delete;
  void operator=(const vtkShadowDepthPyramid&) = delete;

  bool DrawFinest(vtkOpenGLRenderWindow* window, vtkShadowDepthMaps* maps, int layers);
  bool DrawOthers(vtkOpenGLRenderWindow* window, int layers);

  class Internals;
  std::unique_ptr<Internals> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
