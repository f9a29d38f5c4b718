// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowPixelCount
 * @brief   How many pixels are filtered: neither proved lit nor proved blocked.
 *
 * Of what is drawn over the marks of a light's face, the first draw is counted.
 */

#ifndef vtkSoftShadowPixelCount_h
#define vtkSoftShadowPixelCount_h

#include "vtkShadowQueries.h"  // For members
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For counts

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowShader;

class vtkSoftShadowPixelCount
{
public:
  /// Forgets what was counted.
  void Restart() { this->Used = 0; }

  /// The next draw is the first over new marks.
  void BeginMarks() { this->CountsNextDraw = true; }

  void Draw(vtkOpenGLRenderWindow* window, vtkShadowShader& shader, double tapsPerPixel);

  /// Pixels and lights. Waits for the GPU; the window's context is current.
  vtkTypeInt64 GetPixels() const;

  void ReleaseGraphicsResources();

private:
  vtkShadowQueries Queries;
  size_t Used = 0;
  bool CountsNextDraw = false;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowPixelCount.h
