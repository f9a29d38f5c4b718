// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowBands
 * @brief   Draws long work in bands of the viewport, so that no single draw takes a card for long.
 *
 * Systems stop a card that does not answer for a second or two, and the application with it. What a
 * draw may cost is told by the looks at textures (taps) that a pixel takes at most. If pixels times taps
 * are more than one draw may take, the same is drawn several times, each time to some rows of the
 * viewport (by the scissor), and sent on its way after each. Pixels are the same.
 */

#ifndef vtkShadowBands_h
#define vtkShadowBands_h

#include "vtkRenderingSoftShadowsCoreModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                 // For the ABI namespace
#include "vtkType.h"                           // For counts

#include <functional> // For drawing

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class VTKRENDERINGSOFTSHADOWSCORE_EXPORT vtkShadowBands
{
public:
  /// Calls draw once per band. Scissor and scissor test are restored.
  static void Draw(
    vtkOpenGLRenderWindow* window, double tapsPerPixel, const std::function<void()>& draw);

  /// How often draw was called so far, by this thread.
  static vtkTypeInt64 GetNumberOfDraws();

  /// Rows of a band: all of the height, or what a draw may take, in eights if there are as many.
  static int GetRows(int width, int height, double tapsPerPixel);

  /**
   * Taps of a draw. By default 4e9, which an integrated graphics processor takes less than a second
   * for: 1920 x 1080 pixels of 43 x 43 taps are one draw. For tests; 0: the default.
   */
  static void SetMostTaps(double taps);

private:
  vtkShadowBands() = delete;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowBands.h
