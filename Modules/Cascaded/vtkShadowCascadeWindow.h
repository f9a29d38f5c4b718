// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCascadeWindow
 * @brief   The part of a light sample's depth map that a cascade's receivers look at.
 *
 * A sample's map is looked at where the receiver itself is seen from the sample, so the window need
 * hold no more than the receivers' own projection and what a filter reaches beyond: it is the fit
 * over all effective casters, cut to the projection of the sphere around the cascade. The light's
 * penumbra lies between the samples, each of which has a window of its own. Depths stay those of the
 * fit, so every caster between the receivers and the light is in the map.
 *
 * The window's edge is rounded up, in steps of an eighth of an octave from the fit's, and its place
 * to whole texels of a grid that does not move with the camera; where the fit is smaller than the
 * sphere it is the fit itself. So a moving camera keeps the map as it is, or moves it by whole
 * texels.
 */

#ifndef vtkShadowCascadeWindow_h
#define vtkShadowCascadeWindow_h

#include "vtkRenderingSoftShadowsCascadedModule.h" // For export macro
#include "vtkShadowMapView.h"                      // For views
#include "vtkSoftShadowsABI.h"                     // For the ABI namespace

#include <array>  // For centres
#include <vector> // For corners

VTK_ABI_NAMESPACE_BEGIN

struct VTKRENDERINGSOFTSHADOWSCASCADED_EXPORT vtkShadowCascadeWindow
{
  /**
   * Cuts view, a fit over the effective casters, to a sphere in world coordinates, and to the convex
   * hull of corners, if there are any and the light sees them all. resolution: the map's texels along
   * an edge; border: texels that must remain around the sphere. False if no caster can be seen in
   * front of the sphere: all receivers in it are lit.
   */
  static bool Cut(const std::array<double, 3>& center, double radius,
    const std::vector<std::array<double, 3>>& corners, int resolution, int border,
    vtkShadowMapView& view);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCascadeWindow.h
