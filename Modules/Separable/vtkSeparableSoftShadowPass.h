// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeparableSoftShadowPass
 * @brief   Percentage-closer soft shadows whose two kernels are separated into rows and columns.
 *
 * J. M. Buades, J. Gumbau, M. Chover, "Separable soft shadow mapping", The Visual Computer 2015.
 * Both kernels of percentage-closer soft shadows, n x n taps each, are columns of n rows of n taps,
 * and a row that one pixel has taken serves all pixels in whose column it lies:
 *  1. rows: per receiver the middle row of its blocker search, along the map's s axis;
 *  2. columns: per penumbra pixel the rows along t, each taken from the pixel that sees the place,
 * or, if that pixel shows something else, read from the depth map; hence the blockers' mean
 * distance and the penumbra's width; and the middle row of the filter of that width;
 *  3. visibility: the filter's rows along t, likewise.
 * So a pixel costs some 4 n steps in place of 2 n^2. Where no row can be reused the result is that
 * of vtkPercentageCloserSoftShadowPass with the same taps, exactly.
 *
 * Unlike the paper, whose blur walks the screen, both columns walk the map: rows of the screen and
 * rows of the light need not be parallel. See ReuseType for when a row is reused.
 *
 * It inherits the errors of percentage-closer soft shadows and adds what reuse adds; see the figures
 * in Documentation/Techniques/SeparableSoftShadowMapping.md.
 */

#ifndef vtkSeparableSoftShadowPass_h
#define vtkSeparableSoftShadowPass_h

#include "vtkRenderingSoftShadowsSeparableModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                      // For the ABI namespace
#include "vtkTwoKernelSoftShadowPass.h"

#include <array>  // For weights
#include <memory> // For the implementation
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN

class VTKRENDERINGSOFTSHADOWSSEPARABLE_EXPORT vtkSeparableSoftShadowPass
  : public vtkTwoKernelSoftShadowPass
{
public:
  static vtkSeparableSoftShadowPass* New();
  vtkTypeMacro(vtkSeparableSoftShadowPass, vtkTwoKernelSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// When a row of another pixel may stand for the row that is needed.
  enum ReuseType
  {
    /**
     * Its point lies within a share of a depth off the receiver's plane: of the receiver's own map
     * depth (Alpha), of the depth between receiver and blockers (Beta). Widths of kernels are
     * proportional to map depths; a row of the search or of the filter may be wider or narrower than
     * the kernel by half. A near object never reuses rows of what lies
     * behind it, whatever the size of the scene.
     */
    REUSE_BY_KERNEL = 0,
    /**
     * As published: its distance from the light differs by less than Alpha times the depth range of
     * the map (search), or its point is along the camera's depth less than Beta times the camera's
     * clipping range off the receiver's plane (filter).
     */
    REUSE_AS_PUBLISHED = 1
  };

  ///@{
  /**
   * The criterion of reuse. Default is REUSE_BY_KERNEL.
   */
  vtkSetClampMacro(Reuse, int, REUSE_BY_KERNEL, REUSE_AS_PUBLISHED);
  vtkGetMacro(Reuse, int);
  void SetReuseToByKernel() { this->SetReuse(REUSE_BY_KERNEL); }
  void SetReuseToAsPublished() { this->SetReuse(REUSE_AS_PUBLISHED); }
  ///@}

  ///@{
  /**
   * Thresholds of reuse for the blocker search (Alpha) and the filter (Beta), shares as ReuseType
   * says, in [0, 1]. 0 reuses nothing: the exact result of the brute-force kernels, slowly. Larger
   * is faster and less accurate. Default is 0.1.
   */
  vtkSetClampMacro(Alpha, double, 0.0, 1.0);
  vtkGetMacro(Alpha, double);
  vtkSetClampMacro(Beta, double, 0.0, 1.0);
  vtkGetMacro(Beta, double);
  ///@}

  ///@{
  /**
   * Thresholds of one light, in the place of Alpha and Beta and clamped like them, until they are
   * reset. A light that is deleted takes them with it.
   */
  void SetLightThresholds(vtkLight* light, double alpha, double beta);
  void ResetLightThresholds(vtkLight* light);
  double GetLightAlpha(vtkLight* light) const;
  double GetLightBeta(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * Whether the search and the filter leave out what no ray from the receiver to the light can meet: taps
   * outside the light's image at their own depth, as in vtkPercentageCloserSoftShadowPass. The paper
   * takes all taps. Default is on.
   */
  vtkSetMacro(Footprint, bool);
  vtkGetMacro(Footprint, bool);
  vtkBooleanMacro(Footprint, bool);
  ///@}

  /// Which axis of the map the rows lie along.
  enum RowAxisType
  {
    ROWS_ALONG_S = 0,
    ROWS_ALONG_T = 1
  };

  ///@{
  /**
   * Which axis of the map the rows lie along. Default is ROWS_ALONG_S.
   */
  vtkSetClampMacro(RowAxis, int, ROWS_ALONG_S, ROWS_ALONG_T);
  vtkGetMacro(RowAxis, int);
  ///@}

  enum StageType
  {
    SEARCH_STAGE = 0,
    FILTER_STAGE = 1
  };

  ///@{
  /**
   * Count the rows that are reused, for GetReuseImage, GetReuseShare and the statistics. Takes a second
   * draw of the last step and a wait for the GPU. Default is off.
   */
  vtkSetMacro(CountReuse, bool);
  vtkGetMacro(CountReuse, bool);
  vtkBooleanMacro(CountReuse, bool);
  ///@}

  ///@{
  /**
   * The share of rows that were reused in a stage, in [0, 1]: the mean over all emitters that filtered
   * the pixel, and over all these pixels. The image is float, one component, the viewport's size,
   * bottom row first, NaN where nothing was filtered; of the last frame that counted; null, and 0,
   * if none did.
   */
  vtkSmartPointer<vtkImageData> GetReuseImage(int stage);
  double GetReuseShare(int stage);
  ///@}

  enum DebugViewType
  {
    DEBUG_NONE = 0,
    DEBUG_SEARCH_REUSE = 1,
    DEBUG_FILTER_REUSE = 2
  };
  ///@{
  /**
   * Shows, in place of visibilities, the share of rows that were reused in a stage, black 0 and white 1
   * (the paper's Fig. 10); 1 also where no row is needed. Default is DEBUG_NONE.
   */
  vtkSetClampMacro(DebugView, int, DEBUG_NONE, DEBUG_FILTER_REUSE);
  vtkGetMacro(DebugView, int);
  ///@}

protected:
  vtkSeparableSoftShadowPass();
  ~vtkSeparableSoftShadowPass() override;

  void Add(const vtkSoftShadowServices& services) override;
  /// Shares are shown where there is no light, too.
  vtkSoftShadowRequirements GetRequirements() const override;
  std::vector<vtkSeparableStep*> GetSteps() override;
  std::vector<vtkShadowTextureArray*> GetTextures() override;

  int Reuse = REUSE_BY_KERNEL;
  double Alpha = 0.1;
  double Beta = 0.1;
  bool Footprint = true;
  int RowAxis = ROWS_ALONG_S;
  bool CountReuse = false;
  int DebugView = DEBUG_NONE;

private:
  vtkSeparableSoftShadowPass(const vtkSeparableSoftShadowPass&) = delete;
  void operator=(const vtkSeparableSoftShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  void DrawRows(const vtkSoftShadowServices& services);
  void DrawColumns(const vtkSoftShadowServices& services);
  void DrawVisibility(const vtkSoftShadowServices& services);
  /// Whether the steps write the share of rows that they reuse in a stage.
  bool WritesShares(int stage) const;
  vtkShaderProgram* UseRows(vtkSeparableStep& step, const vtkSoftShadowServices& services);
  /// Sums of the filter's weights in the parts of a row.
  std::array<float, 3> GetRowWeights(const vtkSoftShadowServices& services) const;
  void SetReuseUniforms(vtkShaderProgram* program, const vtkSoftShadowServices& services);
};

VTK_ABI_NAMESPACE_END
#endif
