// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSampledSoftShadowPass
 * @brief   Soft shadows as the mean of hard shadows from points of the light.
 *
 * Every point of the light has a depth map of its own; the visibility is the weighted mean of the
 * points that a receiver sees. It converges to the truth with the number of points, whatever the
 * scene, and is the reference on the GPU: the other techniques are measured against it and against
 * ray tracing. Its price is the maps. One point is the hard shadow.
 *
 * The error of n points is about the banding of their steps: n of 1 / n, as a lattice has whatever the
 * edge's direction; a grid has sqrt(n) of 1 / sqrt(n) at edges along the light's axes. What remains at
 * many points is the maps' resolution.
 */

#ifndef vtkSampledSoftShadowPass_h
#define vtkSampledSoftShadowPass_h

#include "vtkRenderingSoftShadowsSampledModule.h" // For export macro
#include "vtkShadowLightSampling.h"               // For patterns
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <memory> // For the implementation

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSSAMPLED_EXPORT vtkSampledSoftShadowPass : public vtkSoftShadowPass
{
public:
  static vtkSampledSoftShadowPass* New();
  vtkTypeMacro(vtkSampledSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Points of the light, each with a depth map, in [1, 4096]. Maps beyond MapMemory are baked anew
   * in every frame. Default is 16.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 4096);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * How the points are spread; see vtkShadowLightSampling::PatternType. Default is LATTICE.
   */
  vtkSetClampMacro(Pattern, int, vtkShadowLightSampling::GRID, vtkShadowLightSampling::LATTICE);
  vtkGetMacro(Pattern, int);
  void SetPatternToGrid() { this->SetPattern(vtkShadowLightSampling::GRID); }
  void SetPatternToStratified() { this->SetPattern(vtkShadowLightSampling::STRATIFIED); }
  void SetPatternToHammersley() { this->SetPattern(vtkShadowLightSampling::HAMMERSLEY); }
  void SetPatternToSobol() { this->SetPattern(vtkShadowLightSampling::SOBOL); }
  void SetPatternToLattice() { this->SetPattern(vtkShadowLightSampling::LATTICE); }
  ///@}

  ///@{
  /**
   * Weights of the points: uniform, or N(0, 0.5) over the light's window [-1, 1]^2. Default is
   * MEAN.
   */
  vtkSetClampMacro(Weights, int, vtkShadowLightSampling::MEAN, vtkShadowLightSampling::GAUSSIAN);
  vtkGetMacro(Weights, int);
  void SetWeightsToMean() { this->SetWeights(vtkShadowLightSampling::MEAN); }
  void SetWeightsToGaussian() { this->SetWeights(vtkShadowLightSampling::GAUSSIAN); }
  ///@}

  ///@{
  /**
   * Edge in texels of a percentage-closer filter over each map, in [1, 15]. It hides the texels of
   * hard shadows and blurs by its width. Default is 1, none.
   */
  vtkSetClampMacro(FilterSize, int, 1, 15);
  vtkGetMacro(FilterSize, int);
  ///@}

protected:
  vtkSampledSoftShadowPass();
  ~vtkSampledSoftShadowPass() override;

  vtkSoftShadowRequirements GetRequirements() const override;
  void Add(const vtkSoftShadowServices& services) override;
  void AddStatistics(vtkSoftShadowStatistics& statistics) override;

  int NumberOfSamples = 16;
  int Pattern = vtkShadowLightSampling::LATTICE;
  int Weights = vtkShadowLightSampling::MEAN;
  int FilterSize = 1;

private:
  vtkSampledSoftShadowPass(const vtkSampledSoftShadowPass&) = delete;
  void operator=(const vtkSampledSoftShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
