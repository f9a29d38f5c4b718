// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowSamples.h"

#include "vtkShadowMapFitter.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkSoftShadowSamples vtkSoftShadowSamples::Fit(const vtkShadowMapFitter& fitter,
  const vtkShadowEmitter& emitter, const std::vector<vtkShadowLightSampling::Sample>& points)
{
  vtkSoftShadowSamples samples;
  for (const vtkShadowLightSampling::Sample& point : points)
  {
    const double weight = point.Weight * emitter.Weight;
    vtkShadowMapView view;
    if (fitter.Fit(emitter.PointAt(point.U, point.V, weight), view))
    {
      samples.Views.push_back(view);
      samples.Weights.push_back(static_cast<float>(weight));
    }
    else
    {
      samples.LitWeight += static_cast<float>(weight);
    }
  }
  return samples;
}
VTK_ABI_NAMESPACE_END
