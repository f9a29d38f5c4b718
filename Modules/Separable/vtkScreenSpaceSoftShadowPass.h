// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScreenSpaceSoftShadowPass
 * @brief   The hard shadow of one depth map, blurred on the screen as wide as the penumbra.
 *
 * The family that vtkSeparableSoftShadowPass is measured against: Z. Zheng, S. Saito, "Screen space
 * anisotropic blurred soft shadows", 2011, and M. MohammadBagher et al., "Screen-space percentage-
 * closer soft shadows", 2010.
 *  1. the hard shadow of every receiver;
 *  2. per penumbra pixel the blocker search of percentage-closer soft shadows, n x n taps, and how far
 * the kernel reaches on the screen;
 *  3. and 4. a blur along the screen's x, then its y, whose taps count less the further they lie off the
 * receiver's plane (a bilateral filter).
 * Fast for small kernels: the blur is separable, the search is not. What the screen does not show is not
 * blurred: penumbrae break off beside objects that hide part of them and at the border of the
 * viewport, and a kernel turned on the screen is taken as if it were not.
 *
 * @sa vtkSeparableSoftShadowPass
 */

#ifndef vtkScreenSpaceSoftShadowPass_h
#define vtkScreenSpaceSoftShadowPass_h

#include "vtkRenderingSoftShadowsSeparableModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                      // For the ABI namespace
#include "vtkTwoKernelSoftShadowPass.h"

#include <memory> // For the implementation
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSSEPARABLE_EXPORT vtkScreenSpaceSoftShadowPass
  : public vtkTwoKernelSoftShadowPass
{
public:
  static vtkScreenSpaceSoftShadowPass* New();
  vtkTypeMacro(vtkScreenSpaceSoftShadowPass, vtkTwoKernelSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Standard deviation of the bilateral term: the distance of a tap's point to the receiver's plane, as a
   * share of the receiver's distance from the camera, in [1e-6, 1]. Larger blurs over edges and
   * creases. Default is 0.01.
   */
  vtkSetClampMacro(Beta, double, 1e-6, 1.0);
  vtkGetMacro(Beta, double);
  ///@}

protected:
  vtkScreenSpaceSoftShadowPass();
  ~vtkScreenSpaceSoftShadowPass() override;

  void Add(const vtkSoftShadowServices& services) override;
  std::vector<vtkSeparableStep*> GetSteps() override;
  std::vector<vtkShadowTextureArray*> GetTextures() override;

  double Beta = 0.01;

private:
  vtkScreenSpaceSoftShadowPass(const vtkScreenSpaceSoftShadowPass&) = delete;
  void operator=(const vtkScreenSpaceSoftShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  void DrawHardShadow(const vtkSoftShadowServices& services);
  void DrawPenumbrae(const vtkSoftShadowServices& services);
  void DrawBlur(const vtkSoftShadowServices& services, bool last);
};

VTK_ABI_NAMESPACE_END
#endif
