// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowSamples
 * @brief   Points of an emitter, each with the view of its map.
 */

#ifndef vtkSoftShadowSamples_h
#define vtkSoftShadowSamples_h

#include "vtkRenderingSoftShadowsVisibilityModule.h" // For export macro
#include "vtkShadowLightSampling.h"                  // For points
#include "vtkShadowMapView.h"                        // For views
#include "vtkSoftShadowsABI.h"                       // For the ABI namespace

#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowMapFitter;

struct VTKRENDERINGSOFTSHADOWSVISIBILITY_EXPORT vtkSoftShadowSamples
{
  std::vector<vtkShadowMapView> Views;
  std::vector<float> Weights; // of the views; the emitter's own weight is in them
  float LitWeight = 0.0f;     // of the points in whose way nothing lies: they have no view

  /// The views that fit points of an emitter, from the points themselves.
  static vtkSoftShadowSamples Fit(const vtkShadowMapFitter& fitter, const vtkShadowEmitter& emitter,
    const std::vector<vtkShadowLightSampling::Sample>& points);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowSamples.h
