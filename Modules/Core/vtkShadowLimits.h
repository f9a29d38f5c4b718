// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowLimits
 * @brief   What the current OpenGL context allows at most.
 */

#ifndef vtkShadowLimits_h
#define vtkShadowLimits_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace
#include "vtkType.h"                           // For bytes

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowLimits
{
public:
  ///@{
  /// Texels along an edge of a texture, and layers of an array texture.
  static int GetTextureSize();
  static int GetTextureLayers();
  ///@}

  /// Bytes of memory for textures that the driver says are free; 0 if it does not say.
  static vtkTypeInt64 GetFreeMemory();

  ///@{
  /// Lower limits than the driver's, for tests of drivers with less; 0: the driver's.
  static void Restrict(int textureSize, int textureLayers);
  ///@}

private:
  vtkShadowLimits() = delete;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowLimits.h
