// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTwoKernelSoftShadowPass
 * @brief   What the techniques of this module share: a kernel that searches, one that filters, steps.
 *
 * @sa vtkSeparableSoftShadowPass vtkScreenSpaceSoftShadowPass
 */

#ifndef vtkTwoKernelSoftShadowPass_h
#define vtkTwoKernelSoftShadowPass_h

#include "vtkRenderingSoftShadowsSeparableModule.h" // For export macro
#include "vtkShadowLightSampling.h"                 // For weights
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <memory> // For the target
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkSeparableStep;
class vtkSeparableTarget;

class VTKRENDERINGSOFTSHADOWSSEPARABLE_EXPORT vtkTwoKernelSoftShadowPass : public vtkSoftShadowPass
{
public:
  vtkTypeMacro(vtkTwoKernelSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Taps along an edge of the blocker search, in [1, 128]. Default is 15.
   */
  vtkSetClampMacro(SearchWidth, int, 1, 128);
  vtkGetMacro(SearchWidth, int);
  ///@}

  ///@{
  /**
   * Taps along an edge of the filter, in [1, 128]. Published pairs of search and filter are 7/15,
   * 11/21 and 29/41. Default is 21.
   */
  vtkSetClampMacro(FilterWidth, int, 1, 128);
  vtkGetMacro(FilterWidth, int);
  ///@}

  ///@{
  /**
   * Weights of the taps: N(0, 0.5) over the light's window [-1, 1]^2, or uniform. The Gaussian hides
   * that the kernel is a square. Default is GAUSSIAN.
   */
  vtkSetClampMacro(Weights, int, vtkShadowLightSampling::MEAN, vtkShadowLightSampling::GAUSSIAN);
  vtkGetMacro(Weights, int);
  void SetWeightsToMean() { this->SetWeights(vtkShadowLightSampling::MEAN); }
  void SetWeightsToGaussian() { this->SetWeights(vtkShadowLightSampling::GAUSSIAN); }
  ///@}

protected:
  vtkTwoKernelSoftShadowPass();
  ~vtkTwoKernelSoftShadowPass() override;

  vtkSoftShadowRequirements GetRequirements() const override;
  void AddStatistics(vtkSoftShadowStatistics& statistics) override;
  bool HasGaussianWeights() const { return this->Weights == vtkShadowLightSampling::GAUSSIAN; }

  ///@{
  /// What a technique holds in a window.
  virtual std::vector<vtkSeparableStep*> GetSteps() = 0;
  virtual std::vector<vtkShadowTextureArray*> GetTextures() = 0;
  ///@}

  /// Makes the textures as large as the viewport. False if one cannot be had.
  static bool Allocate(const vtkSoftShadowServices& services, int format,
    const std::vector<vtkShadowTextureArray*>& textures);

  ///@{
  /**
   * Makes a step's program current, with its uniforms of receivers, map and kernels, or returns null;
   * EndStep unbinds what was bound.
   */
  vtkShaderProgram* UseStep(vtkSeparableStep& step, const vtkSoftShadowServices& services);
  static void EndStep(const vtkSoftShadowServices& services);
  ///@}

  ///@{
  /// Taps along an edge of the kernels: all taps of a light without extent are the same one.
  int GetSearchTaps(const vtkSoftShadowServices& services) const;
  int GetFilterTaps(const vtkSoftShadowServices& services) const;
  ///@}

  /// What steps before the last draw into.
  vtkSeparableTarget& GetTarget() { return *this->Target; }

  int SearchWidth = 15;
  int FilterWidth = 21;
  int Weights = vtkShadowLightSampling::GAUSSIAN;

private:
  vtkTwoKernelSoftShadowPass(const vtkTwoKernelSoftShadowPass&) = delete;
  void operator=(const vtkTwoKernelSoftShadowPass&) = delete;

  std::unique_ptr<vtkSeparableTarget> Target;
};

VTK_ABI_NAMESPACE_END
#endif
