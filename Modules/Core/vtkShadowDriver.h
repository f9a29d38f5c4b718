// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowDriver
 * @brief   What draws in the current OpenGL context, and what it can beyond OpenGL 3.2.
 *
 * OpenGL tells neither who draws nor what that costs: this class does, and nothing else looks at a
 * driver's name.
 */

#ifndef vtkShadowDriver_h
#define vtkShadowDriver_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace

#include <string> // For names

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowDriver
{
public:
  enum KindType
  {
    TOLD_BY_NAME = 0,
    CARD = 1,
    PROCESSOR = 2
  };

  /**
   * Whether the processor draws (a software rasteriser) and not a card. Then waiting for what is drawn
   * takes no time from anybody, and every look at a texture and every vertex has its price.
   */
  static bool DrawsOnProcessor();

  /**
   * Whether a vertex shader sees all that earlier draws drew to a texture. OpenGL says so, but Mesa's
   * software rasterisers run vertex shaders at once, even on a texture that they still draw.
   */
  static bool OrdersVertices();

  /// Whether a driver of that name (GL_RENDERER) draws on the processor.
  static bool IsOfProcessor(const std::string& renderer);

  ///@{
  /// Whether the context has a version of OpenGL, and whether it names an extension.
  static bool HasVersion(int major, int minor);
  static bool HasExtension(const std::string& name);
  ///@}

  /// For tests: what DrawsOnProcessor says, whatever draws.
  static void Pretend(KindType kind);

private:
  vtkShadowDriver() = delete;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowDriver.h
