// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedTint
 * @brief   Tints a picture by cascade, for debugging.
 */

#ifndef vtkCascadedTint_h
#define vtkCascadedTint_h

#include "vtkShadowCascades.h" // For the cascades
#include "vtkShadowShader.h"   // For members
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowReceivers;
class vtkWindow;

class vtkCascadedTint
{
public:
  vtkCascadedTint();

  /**
   * Multiplies what is bound by red, green, blue and yellow, near to far, where there are receivers:
   * the mean over the cascades of every emitter. Emitters after the first 32 do not count.
   */
  void Draw(vtkOpenGLRenderWindow* window, vtkShadowReceivers* receivers,
    const std::vector<std::vector<vtkShadowCascades::Cascade>>& emitters);

  int GetNumberOfBuilds() const { return this->Shader.GetNumberOfBuilds(); }
  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Shader.ReleaseGraphicsResources(window);
  }

private:
  vtkShadowShader Shader;
};

VTK_ABI_NAMESPACE_END
#endif
