// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarchedSoftShadowPass
 * @brief   Soft shadows by rays marched through one depth map to points of the light.
 *
 * Per pixel, for each of Rays well-spread points of the light: walk the ray from the receiver towards
 * the point through the depth map, in Steps steps, from the nearest depth within the kernel to the
 * receiver. In map coordinates such a ray is a straight line. A texel blocks if it lies in front of
 * the ray and of the receiver's plane, but not by more than the blocker's thickness: the map knows
 * nothing behind the first surface, and without a bound everything behind a silhouette were dark.
 *
 * The rim of the light and half of the other rays decide where they all agree. Rays and steps are
 * the same for every pixel: the result is deterministic and free of noise, in steps of 1 / Rays.
 *
 * Blockers at several depths do not fuse as with the techniques that widen a map's edges; what the
 * light's centre does not see stays unknown. Split makes it converge.
 */

#ifndef vtkMarchedSoftShadowPass_h
#define vtkMarchedSoftShadowPass_h

#include "vtkRenderingSoftShadowsMarchedModule.h" // For export macro
#include "vtkShadowLightSampling.h"               // For weights
#include "vtkShadowShader.h"                      // For members
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSMARCHED_EXPORT vtkMarchedSoftShadowPass : public vtkSoftShadowPass
{
public:
  static vtkMarchedSoftShadowPass* New();
  vtkTypeMacro(vtkMarchedSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Rays to points of the light, in [1, 240]. The visibility has about as many steps. Default is 64.
   */
  vtkSetClampMacro(Rays, int, 1, 240);
  vtkGetMacro(Rays, int);
  ///@}

  ///@{
  /**
   * Steps along a ray, in [1, 256]. Few steps make blockers thick. Default is 16.
   */
  vtkSetClampMacro(Steps, int, 1, 256);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /**
   * How thick a blocker is taken to be, in steps, in [0.1, 10]. Under 1 rays slip through between two
   * steps. Default is 1.
   */
  vtkSetClampMacro(Thickness, double, 0.1, 10.0);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * Weights of the rays: uniform, or N(0, 0.5) over the light's window [-1, 1]^2. Default is MEAN.
   */
  vtkSetClampMacro(Weights, int, vtkShadowLightSampling::MEAN, vtkShadowLightSampling::GAUSSIAN);
  vtkGetMacro(Weights, int);
  void SetWeightsToMean() { this->SetWeights(vtkShadowLightSampling::MEAN); }
  void SetWeightsToGaussian() { this->SetWeights(vtkShadowLightSampling::GAUSSIAN); }
  ///@}

protected:
  vtkMarchedSoftShadowPass();
  ~vtkMarchedSoftShadowPass() override;

  void AddVisibility(const vtkSoftShadowContext& context) override;
  bool HasGaussianWeights() const override;
  bool NeedsPyramid() const override { return true; }
  int GetProof() const override;
  int GetTechniqueShaderBuilds() override;

  int Rays = 64;
  int Steps = 16;
  double Thickness = 1.0;
  int Weights = vtkShadowLightSampling::MEAN;

private:
  vtkMarchedSoftShadowPass(const vtkMarchedSoftShadowPass&) = delete;
  void operator=(const vtkMarchedSoftShadowPass&) = delete;

  vtkShadowShader Shader;
};

VTK_ABI_NAMESPACE_END
#endif
