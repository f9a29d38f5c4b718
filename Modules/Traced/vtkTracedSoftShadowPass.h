// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedSoftShadowPass
 * @brief   Soft shadows by exact rays to points of the light, traced on the processor.
 *
 * The visible points are read from the frame once, rays go from each to points of the light through the
 * casters' own triangles (Embree), and the visibility goes back as a texture. There is no depth map: no
 * texels, no bias, no order of light and scene in size.
 *
 * The pixels of a block of 4 x 4 have different points, which together are as well spread as those of each.
 *
 * Where OpenGL is a software rasteriser the points lie in memory already. On a graphics card the frame waits
 * until they are read, and nothing is drawn meanwhile.
 */

#ifndef vtkTracedSoftShadowPass_h
#define vtkTracedSoftShadowPass_h

#include "vtkRenderingSoftShadowsTracedModule.h" // For export macro
#include "vtkShadowLightSampling.h"              // For weights
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <memory> // For the implementation
#include <string> // For the report

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSTRACED_EXPORT vtkTracedSoftShadowPass : public vtkSoftShadowPass
{
public:
  static vtkTracedSoftShadowPass* New();
  vtkTypeMacro(vtkTracedSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Rays to points of the light per pixel, in [1, 1024]. Default is 4.
   */
  vtkSetClampMacro(Rays, int, 1, 1024);
  vtkGetMacro(Rays, int);
  ///@}

  ///@{
  /**
   * Take the mean of neighbours where the penumbra is wide enough: the points of a block of 4 x 4 pixels in
   * place of one pixel's. It stops at edges. Default is on.
   */
  vtkSetMacro(Filter, bool);
  vtkGetMacro(Filter, bool);
  vtkBooleanMacro(Filter, bool);
  ///@}

  ///@{
  /**
   * Shoot MostRays where neighbours disagree and the penumbra is too narrow for their mean. Default is on.
   */
  vtkSetMacro(Adaptive, bool);
  vtkGetMacro(Adaptive, bool);
  vtkBooleanMacro(Adaptive, bool);
  ///@}

  ///@{
  /**
   * Rays of a pixel where Adaptive wants more, in [1, 4096]. Fewer than Rays count as Rays. Default is 16.
   */
  vtkSetClampMacro(MostRays, int, 1, 4096);
  vtkGetMacro(MostRays, int);
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

  /**
   * A line per reason why props cast nothing in the last frame although they are opaque: what they look like
   * is known to a shader alone, or to a mapper of another kind. Empty if there are none.
   */
  std::string GetCasterReport() const;

protected:
  vtkTracedSoftShadowPass();
  ~vtkTracedSoftShadowPass() override;

  vtkSoftShadowRequirements GetRequirements() const override;
  void Begin(const vtkSoftShadowServices& services) override;
  void Add(const vtkSoftShadowServices& services) override;
  bool AddPoint(
    const vtkSoftShadowServices& services, const vtkShadowLightSampling::Sample& point) override;
  void AddStatistics(vtkSoftShadowStatistics& statistics) override;

  int Rays = 4;
  bool Filter = true;
  bool Adaptive = true;
  int MostRays = 16;
  int Weights = vtkShadowLightSampling::MEAN;

private:
  vtkTracedSoftShadowPass(const vtkTracedSoftShadowPass&) = delete;
  void operator=(const vtkTracedSoftShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  bool ReadFrame(const vtkSoftShadowServices& services);
  void WarnOfUntraced();
  bool Draw(const vtkSoftShadowServices& services, double weight);
  void Count(const vtkSoftShadowServices& services) const;
};

VTK_ABI_NAMESPACE_END
#endif
