// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowRendererDuties
 * @brief   What a vtkRenderer does in its own frame, and chains of VTK's passes leave out.
 *
 * A renderer with a pass hands its whole frame over. VTK's passes neither tell the camera that the
 * window is in stereo (both eyes see the same then) nor let a hardware selector number the props (it
 * finds nothing then).
 */

#ifndef vtkSoftShadowRendererDuties_h
#define vtkSoftShadowRendererDuties_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderState;
class vtkRenderer;

class vtkSoftShadowRendererDuties
{
public:
  /// Before anything is drawn: the camera's projection follows the window's stereo from now on.
  static void UpdateStereo(vtkRenderer* renderer);

  /**
   * Draws opaque geometry. If the renderer is selecting, its selector draws the props, each under its
   * number, and reads what it needs. Returns the number of props drawn.
   */
  static int DrawOpaque(const vtkRenderState* s);
};

VTK_ABI_NAMESPACE_END
#endif
