// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBilateralSoftShadowPass
 * @brief   Soft bilateral filtering shadows: few light samples, their bands filtered on the screen.
 *
 * The mean of hard shadows from few points of the light is a banded penumbra; a filter of the
 * visibility in screen space smooths the bands and stops at silhouettes and creases (Ali, Kolivand,
 * Sunar 2016, "Soft bilateral filtering shadows using multiple image-based algorithms").
 *
 * Stages, per emitter:
 *  1. points: a lattice (vtkBilateralLattice), a depth map each, reused while nothing moves;
 *  2. mean: hard shadows of all points into a texture, with the blockers' distances;
 *  3. filter (vtkSoftShadowScreenFilter), in one or more steps over the visibility alone, never over
 *     shaded colour.
 *
 * A tap weighs w = domain * range * surface (the paper's Eqs. 1 and 2). Range: exp(-dV^2 / (2
 * h_r^2)), a standard deviation where the paper's Eq. 3 has its inverse. Surface: falls to zero for
 * taps off the receiver's plane (camera depth corrected by the slope) and for normals that turn by
 * 45 degrees, so nothing leaks over silhouettes and creases. Filters differ in the domain:
 *
 *  - ADAPTIVE (default): a box with the shape of the shadow of one cell of the lattice, projected
 *    through the pixel's blockers onto its surface and the screen, along one edge of the cell and
 *    then along the other. For one blocker depth over a plane it turns the bands into the exact
 *    ramp, however wide the penumbra; at a contact it has no width. Reaches from umbra and lit
 *    pixels half a band into the penumbra that the points miss; anything else is left untouched.
 *  - PAPER: Gaussian of h_d pixels over FilterWidth taps in x, then in y;
 *  - FULL: the same over a square in one step;
 *  - ATROUS: PAPER, iterated with taps 1, 2, 4, ... pixels apart;
 *  - NONE: the mean as it is.
 *
 * PAPER, FULL and ATROUS leave pixels alone whose mean is 0 or 1.
 *
 * Cost: a map per point, baked when casters or the light move; a lookup per point and pixel; the
 * filter: twice a tap per pixel of the kernel's width, at most 33, and a look for shadows around lit
 * pixels, near penumbrae only. Limits: one distance of blockers per pixel, so a sharp shadow inside a
 * wide penumbra is blurred with it; a kernel is at most MaximumWidth wide.
 *
 * Error, RMSE of the visibility with 5 points, unfiltered and ADAPTIVE: 0.062 and 0.018 in the
 * penumbra of a rectangle (closed form); 0.024 and 0.014 on the bunny, 0.034 and 0.019 on the
 * dragon, 0.063 and 0.029 under fourteen boards at several depths (ray tracing).
 *
 * @sa vtkSampledSoftShadowPass vtkBilateralLattice vtkSoftShadowScreenFilter
 */

#ifndef vtkBilateralSoftShadowPass_h
#define vtkBilateralSoftShadowPass_h

#include "vtkRenderingSoftShadowsBilateralModule.h" // For export macro
#include "vtkShadowLightSampling.h"                 // For weights
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <memory> // For the implementation

VTK_ABI_NAMESPACE_BEGIN
struct vtkSoftShadowSamples;

class VTKRENDERINGSOFTSHADOWSBILATERAL_EXPORT vtkBilateralSoftShadowPass : public vtkSoftShadowPass
{
public:
  static vtkBilateralSoftShadowPass* New();
  vtkTypeMacro(vtkBilateralSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  enum FilterType
  {
    NONE = 0,
    PAPER = 1,
    FULL = 2,
    ATROUS = 3,
    ADAPTIVE = 4
  };

  ///@{
  /**
   * Points of the light, each with a depth map, in [1, 256]. Default is 5.
   */
  vtkSetClampMacro(NumberOfSamples, int, 1, 256);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Weights of the points: uniform, or N(0, 0.5) over the light's window [-1, 1]^2. Default is
   * MEAN.
   */
  vtkSetClampMacro(Weights, int, vtkShadowLightSampling::MEAN, vtkShadowLightSampling::GAUSSIAN);
  vtkGetMacro(Weights, int);
  ///@}

  ///@{
  /**
   * The domain of the filter, a FilterType. Default is ADAPTIVE.
   */
  vtkSetClampMacro(Filter, int, NONE, ADAPTIVE);
  vtkGetMacro(Filter, int);
  ///@}

  ///@{
  /**
   * Taps along an edge of PAPER, FULL and each iteration of ATROUS, in [1, 41]; even numbers count
   * as the next odd one. Default is 3, the paper's.
   */
  vtkSetClampMacro(FilterWidth, int, 1, 41);
  vtkGetMacro(FilterWidth, int);
  ///@}

  ///@{
  /**
   * h_d: standard deviation of the domain weights of PAPER and FULL in pixels, of ATROUS in taps;
   * in [0.1, 100]. Larger smooths more. Default is 3, the paper's.
   */
  vtkSetClampMacro(DomainDeviation, double, 0.1, 100.0);
  vtkGetMacro(DomainDeviation, double);
  ///@}

  ///@{
  /**
   * h_r: standard deviation of the range weights of all filters in units of visibility, in [0.01,
   * 100]. Larger smooths over larger steps. ADAPTIVE takes it for up to three points and (3 / n)^(1/4)
   * of it for n: their bands differ less. Default is 0.5, the paper's.
   */
  vtkSetClampMacro(RangeDeviation, double, 0.01, 100.0);
  vtkGetMacro(RangeDeviation, double);
  ///@}

  ///@{
  /**
   * Times that ATROUS is applied, in [1, 6]. Default is 3.
   */
  vtkSetClampMacro(Iterations, int, 1, 6);
  vtkGetMacro(Iterations, int);
  ///@}

  ///@{
  /**
   * The widest kernel of ADAPTIVE in pixels, in [1, 256]. Bands that are wider remain, and
   * their outermost is cut where a third of it ends. Default is 64.
   */
  vtkSetClampMacro(MaximumWidth, int, 1, 256);
  vtkGetMacro(MaximumWidth, int);
  ///@}

  ///@{
  /**
   * The order of the two steps of separable filters: y before x, or the cell's second edge before
   * its first. Default is off.
   */
  vtkSetMacro(SecondAxisFirst, bool);
  vtkGetMacro(SecondAxisFirst, bool);
  vtkBooleanMacro(SecondAxisFirst, bool);
  ///@}

protected:
  vtkBilateralSoftShadowPass();
  ~vtkBilateralSoftShadowPass() override;

  vtkSoftShadowRequirements GetRequirements() const override;
  void Begin(const vtkSoftShadowServices& services) override;
  void Add(const vtkSoftShadowServices& services) override;
  void AddStatistics(vtkSoftShadowStatistics& statistics) override;

  int NumberOfSamples = 5;
  int Weights = vtkShadowLightSampling::MEAN;
  int Filter = ADAPTIVE;
  int FilterWidth = 3;
  double DomainDeviation = 3.0;
  double RangeDeviation = 0.5;
  int Iterations = 3;
  int MaximumWidth = 64;
  bool SecondAxisFirst = false;

private:
  vtkBilateralSoftShadowPass(const vtkBilateralSoftShadowPass&) = delete;
  void operator=(const vtkBilateralSoftShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  bool DrawMean(const vtkSoftShadowServices& services, const vtkSoftShadowSamples& samples);
  void DrawFilter(const vtkSoftShadowServices& services);
};

VTK_ABI_NAMESPACE_END
#endif
