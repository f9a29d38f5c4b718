// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveSampledSoftShadowPass
 * @brief   Adaptive subdivision of the light without cascades: the rival of the cascaded pass.
 *
 * Schwarzler et al. 2012, "Fast accurate soft shadows with adaptive light source sampling", as
 * vtkCascadedSoftShadowPass refines: the light's corners first, then 9, 25 and 81 points, while the
 * visibility of a pixel changes. Every map covers all casters, so that a moving camera bakes
 * nothing. The pass is a cascaded one with other defaults: one cascade, Adaptive on, FitToView off,
 * Tolerance 1/16.
 *
 * @sa vtkCascadedSoftShadowPass
 */

#ifndef vtkAdaptiveSampledSoftShadowPass_h
#define vtkAdaptiveSampledSoftShadowPass_h

#include "vtkCascadedSoftShadowPass.h"
#include "vtkRenderingSoftShadowsCascadedModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                     // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSCASCADED_EXPORT vtkAdaptiveSampledSoftShadowPass
  : public vtkCascadedSoftShadowPass
{
public:
  static vtkAdaptiveSampledSoftShadowPass* New();
  vtkTypeMacro(vtkAdaptiveSampledSoftShadowPass, vtkCascadedSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkAdaptiveSampledSoftShadowPass();
  ~vtkAdaptiveSampledSoftShadowPass() override = default;

private:
  vtkAdaptiveSampledSoftShadowPass(const vtkAdaptiveSampledSoftShadowPass&) = delete;
  void operator=(const vtkAdaptiveSampledSoftShadowPass&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
