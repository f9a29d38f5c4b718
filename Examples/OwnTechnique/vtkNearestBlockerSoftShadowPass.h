// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNearestBlockerSoftShadowPass
 * @brief   Soft shadows as if everything that blocks were as near to the light as the nearest caster.
 *
 * One depth map; per pixel, the share of lit taps in the light's image on the map's near plane, which
 * touches the nearest caster. Exact for one flat blocker parallel to the light; anything farther from the
 * light gets a penumbra that is too wide. The smallest technique that is one.
 */

#ifndef vtkNearestBlockerSoftShadowPass_h
#define vtkNearestBlockerSoftShadowPass_h

#include "vtkShadowShader.h" // For members
#include "vtkSoftShadowPass.h"

class vtkNearestBlockerSoftShadowPass : public vtkSoftShadowPass
{
public:
  static vtkNearestBlockerSoftShadowPass* New();
  vtkTypeMacro(vtkNearestBlockerSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Taps along an edge of the filter, in [1, 128]. Default is 21.
   */
  vtkSetClampMacro(FilterWidth, int, 1, 128);
  vtkGetMacro(FilterWidth, int);
  ///@}

protected:
  vtkNearestBlockerSoftShadowPass();
  ~vtkNearestBlockerSoftShadowPass() override;

  void Add(const vtkSoftShadowServices& services) override;
  void AddStatistics(vtkSoftShadowStatistics& statistics) override;

  int FilterWidth = 21;

private:
  vtkNearestBlockerSoftShadowPass(const vtkNearestBlockerSoftShadowPass&) = delete;
  void operator=(const vtkNearestBlockerSoftShadowPass&) = delete;

  vtkShadowShader Shader;
};

#endif
