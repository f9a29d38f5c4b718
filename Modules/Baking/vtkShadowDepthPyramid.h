// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowDepthPyramid
 * @brief   Minimum and maximum depth over ever larger squares of the depth maps.
 *
 * An RG32F array texture with as many layers as the maps. Its level 0 is half as wide as the maps,
 * rounded up to a power of two; the texel (i, j) of level k holds (minimum, maximum) of d over the
 * 2^(k+1) x 2^(k+1) texels of the map from (i 2^(k+1), j 2^(k+1)) on, with depth 1 beyond the map. It
 * proves most pixels fully lit or fully blocked without a single tap.
 */

#ifndef vtkShadowDepthPyramid_h
#define vtkShadowDepthPyramid_h

#include "vtkNew.h" // For members
#include "vtkObject.h"
#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace

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

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkShadowDepthPyramid();
  ~vtkShadowDepthPyramid() override;

  vtkNew<vtkShadowTextureArray> Texture;
  vtkMTimeType BuildTime = 0;

private:
  vtkShadowDepthPyramid(const vtkShadowDepthPyramid&) = delete;
  void operator=(const vtkShadowDepthPyramid&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
