// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualSoftShadowPass
 * @brief   Predicted virtual soft shadow maps: tiles of depth maps as fine as each penumbra needs.
 *
 * L. Shen, G. Guennebaud, B. Yang, J. Feng, "Predicted Virtual Soft Shadow Maps with High Quality
 * Filtering", 2011. Per emitter:
 *  1. a small depth map of everything, rasterised conservatively: no blocker in it proves a pixel
 * lit;
 *  2. kernel shapes: per pixel, the mean linear depth of its blockers, the light's image at that
 * depth, convolved with the pixel's footprint on the map (antialiasing without samples);
 *  3. prediction: how many texels that kernel needs, from its size on the screen (a user study),
 * gathered in a grid of 64 x 64 cells and cut into tiles of at most MapSize texels along an edge. Steps
 * 2 and 3 are drawn for all emitters before the CPU reads the first grid;
 *  4. tiles: each draws the casters that can touch it, and adds what it shows of each kernel, V A and
 * A. Texels are squares of constant depth, weighted by their exact overlap with the kernel: no bands;
 *  5. V = V A / A, once.
 *
 * Exact, up to texels, for one blocker depth parallel to the light; the blockers of a kernel count as
 * one plane and only what the emitter's centre sees blocks, as in percentage-closer filtering. Cost:
 * the texels under the kernels of pixels that are not proved lit, and the tiles that changed.
 * A disk's kernel is an ellipse; a directional light's likewise. Gaussian weights are integrated over
 * each texel's overlap.
 *
 * Beyond the paper: blockers are searched octave by octave of their distance from the receiver and
 * weighted by what they hide of the light; a texel outside the pyramid of receiver and light at its own
 * depth counts neither as lit nor as blocked; what is behind the receiver's plane is blocked; and a wide
 * kernel over tiles that are finer than it asked for takes several texels as one. RMSE of the
 * visibility: below 0.002 (Quality 2) on closed forms of one blocker depth; in the scenes of the
 * benchmark 0.005 to 0.03 in most, 0.06 on the terrain, 0.054 where blockers at many depths fuse under
 * a large light.
 */

#ifndef vtkVirtualSoftShadowPass_h
#define vtkVirtualSoftShadowPass_h

#include "vtkRenderingSoftShadowsVirtualModule.h" // For export macro
#include "vtkShadowLightSampling.h"               // For weights
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <memory> // For the implementation
#include <string> // For the report

VTK_ABI_NAMESPACE_BEGIN
struct vtkVirtualSettings;

class VTKRENDERINGSOFTSHADOWSVIRTUAL_EXPORT vtkVirtualSoftShadowPass : public vtkSoftShadowPass
{
public:
  static vtkVirtualSoftShadowPass* New();
  vtkTypeMacro(vtkVirtualSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Texels along an edge of the small map that blockers are searched in, in [32, 8192]. Default is
   * 1024. MapSize is that of the largest tile; its default here is 4096.
   */
  vtkSetClampMacro(SearchMapSize, int, 32, 8192);
  vtkGetMacro(SearchMapSize, int);
  ///@}

  ///@{
  /**
   * Cut the map into tiles of predicted resolution. Off: a single map of MapSize. Default is on.
   */
  vtkSetMacro(Adaptive, bool);
  vtkGetMacro(Adaptive, bool);
  vtkBooleanMacro(Adaptive, bool);
  ///@}

  ///@{
  /**
   * Cuts the single map of a pass that is not adaptive into 2^FixedLevels tiles along an edge, in
   * [0, 6]; the result is the same for kernels below 160 texels. Default is 0.
   */
  vtkSetClampMacro(FixedLevels, int, 0, 6);
  vtkGetMacro(FixedLevels, int);
  ///@}

  ///@{
  /**
   * Convolve the light's kernel with the pixel's footprint on the map, so that shadows finer than a
   * pixel become their mean over the pixel. Off: the visibility of the pixel's centre, as that of
   * other techniques and of the ray-traced reference. Default is off.
   */
  vtkSetMacro(Antialiasing, bool);
  vtkGetMacro(Antialiasing, bool);
  vtkBooleanMacro(Antialiasing, bool);
  ///@}

  enum MetricType
  {
    DYNAMIC = 0,
    STATIC = 1,
    AUTOMATIC = 2
  };
  ///@{
  /**
   * Which of the two fitted predictions: for shadows that move, for those at rest (fewer texels), or
   * STATIC while only the camera moves. The default is DYNAMIC, as in the paper; then a picture does
   * not depend on the frames before it.
   */
  vtkSetClampMacro(Metric, int, DYNAMIC, AUTOMATIC);
  vtkGetMacro(Metric, int);
  void SetMetricToDynamic() { this->SetMetric(DYNAMIC); }
  void SetMetricToStatic() { this->SetMetric(STATIC); }
  void SetMetricToAutomatic() { this->SetMetric(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Weights of the light's points: uniform, or N(0, 0.5) over the light's window [-1, 1]^2. Default is
   * MEAN.
   */
  vtkSetClampMacro(Weights, int, vtkShadowLightSampling::MEAN, vtkShadowLightSampling::GAUSSIAN);
  vtkGetMacro(Weights, int);
  void SetWeightsToMean() { this->SetWeights(vtkShadowLightSampling::MEAN); }
  void SetWeightsToGaussian() { this->SetWeights(vtkShadowLightSampling::GAUSSIAN); }
  ///@}

  ///@{
  /**
   * What the predicted number of texels along an edge is multiplied by, in [0.125, 8]. 1 is the
   * paper's: it looks right, but straight edges along the map may lie half a texel off, a few
   * hundredths of visibility. Default is 3.
   */
  vtkSetClampMacro(Quality, double, 0.125, 8.0);
  vtkGetMacro(Quality, double);
  ///@}

  ///@{
  /**
   * Blocks along an edge of the blocker search, in [1, 64], for each octave of distances from the
   * receiver; a region of fewer texels is searched completely. Software rasterisers end a shader's
   * loops after 65535 rounds, hence the limit. Default is 12: with 24 the RMSE of the benchmark's
   * scenes changes by less than 0.001.
   */
  vtkSetClampMacro(SearchWidth, int, 1, 64);
  vtkGetMacro(SearchWidth, int);
  ///@}

  ///@{
  /**
   * The most tiles of an emitter, in [1, 4096]; their memory is limited by MapMemory. Beyond, all
   * tiles become coarser by the same factor, see GetCoarsening. Default is 256.
   */
  vtkSetClampMacro(MaximumTiles, int, 1, 4096);
  vtkGetMacro(MaximumTiles, int);
  ///@}

  enum GridLatencyType
  {
    LATENCY_OF_DRIVER = -1
  };
  ///@{
  /**
   * How many frames old the grid may be that tiles are planned by, 0 or 1. With 0 the CPU waits, once
   * per frame for all emitters, until the GPU has drawn this frame's grid. With 1 it does not: while
   * camera, lights or casters move the grid of the frame before serves, if it has arrived, else an
   * older one. Each cell then takes the finest wish of its 3 x 3 neighbours, and of as many more as
   * points have moved on the map, and no cell is coarser than the search map. It waits only in first
   * frames and where points have moved by more than 4 of the 64 cells. Once nothing changes, the next
   * frame is drawn anew with its own grid: a still picture is the same with both settings.
   *
   * Default is LATENCY_OF_DRIVER: 1 on a graphics card; 0 where the processor draws, since waiting
   * takes no time from anybody there, so that pictures do not depend on time.
   */
  vtkSetClampMacro(GridLatency, int, LATENCY_OF_DRIVER, 1);
  vtkGetMacro(GridLatency, int);
  void SetGridLatencyToDriver() { this->SetGridLatency(LATENCY_OF_DRIVER); }
  ///@}

  enum DebugViewType
  {
    DEBUG_NONE = 0,
    DEBUG_TILES = 1,
    DEBUG_RESOLUTION = 2,
    DEBUG_KERNEL = 3
  };
  ///@{
  /**
   * Shows, in place of visibilities, a shade per tile; the finest wanted texel size; or the kernel's
   * half extent. The latter two are fractions f of the map, shown as 1 + log2(f) / 16. Default is
   * DEBUG_NONE.
   */
  vtkSetClampMacro(DebugView, int, DEBUG_NONE, DEBUG_KERNEL);
  vtkGetMacro(DebugView, int);
  ///@}

  ///@{
  /// Of the last frame that drew visibilities, over all emitters.
  int GetNumberOfTiles() const;
  vtkTypeInt64 GetTileTexels() const;
  /// By how much texels are larger than predicted, at worst; 1 if they are not.
  double GetCoarsening() const;
  ///@}

  /**
   * Without waiting (GridLatency): by how much the texels of the last frame drawn by an older grid were larger
   * than it asked for, at worst; 1 if they were not. Known a frame later.
   */
  double GetLatencyExcess() const;

  /// A line per emitter (tiles, texels, coarsening) and tile (window in the map, resolution).
  std::string GetTileReport() const;

protected:
  vtkVirtualSoftShadowPass();
  ~vtkVirtualSoftShadowPass() override;

  vtkSoftShadowRequirements GetRequirements() const override;
  void Begin(const vtkSoftShadowServices& services) override;
  void Prepare(const vtkSoftShadowServices& services) override;
  void Add(const vtkSoftShadowServices& services) override;
  bool WantsVisibilityAnew() override;
  void AddStatistics(vtkSoftShadowStatistics& statistics) override;

  int SearchMapSize = 1024;
  bool Adaptive = true;
  int FixedLevels = 0;
  bool Antialiasing = false;
  int Metric = DYNAMIC;
  int Weights = vtkShadowLightSampling::MEAN;
  double Quality = 3.0;
  int SearchWidth = 12;
  int MaximumTiles = 256;
  int GridLatency = LATENCY_OF_DRIVER;
  int DebugView = DEBUG_NONE;

private:
  vtkVirtualSoftShadowPass(const vtkVirtualSoftShadowPass&) = delete;
  void operator=(const vtkVirtualSoftShadowPass&) = delete;

  vtkVirtualSettings GetSettings() const;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
