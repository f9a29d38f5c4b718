// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedSoftShadowPass
 * @brief   Cascaded multi-sample soft shadow maps: many light samples near the camera, few far away.
 *
 * The visibility is the mean of hard shadows from points of the light (Zerari et al. 2023, "Accurate
 * approximation of soft shadows for real-time rendering"). The view is cut by depth into cascades;
 * each has its own number of points and resolution of their depth maps, so that what is far, and small
 * on the screen, costs little.
 *
 * Stages, per emitter:
 *  1. splits: cut the depths that receivers can occupy (vtkShadowCascades); parts without receivers
 *     cost nothing;
 *  2. sample: points of the emitter with weights that integrate it;
 *  3. fit: each point's map covers the cascade's receivers and every caster between them and the
 *     light (vtkShadowCascadeWindow), snapped so that a moving camera does not stir the shadows;
 *  4. bake the maps that changed, all of one resolution in one texture array;
 *  5. look: the weighted mean of the hard shadows, blended over a band between cascades;
 *  6. filter: on the screen, over the shadow of a point's cell (vtkSoftShadowScreenFilter), or, as in
 *     the paper, over some texels of each map instead.
 *
 * The first occupied cascade takes the first settings, the next one the second, and so on. Where the
 * casters' fit is smaller than a cascade its maps do not depend on the camera at all.
 *
 * Points are cell-centred with the weights 1 / k^2; the paper's grid to the light's border, with
 * those weights, widens the penumbra.
 *
 * Error, RMSE of the visibility with 16, 9 and 4 points and maps of 1024: 0.012 in the penumbra of a
 * rectangle (closed form); 0.014 on the bunny, 0.013 on the dragon, 0.019 under fourteen boards at several
 * depths, 0.021 on a street (ray tracing; there the maps' texels are what is left).
 *
 * @sa vtkSampledSoftShadowPass vtkShadowCascades vtkSoftShadowScreenFilter
 */

#ifndef vtkCascadedSoftShadowPass_h
#define vtkCascadedSoftShadowPass_h

#include "vtkRenderingSoftShadowsCascadedModule.h" // For export macro
#include "vtkShadowLightSampling.h"                // For patterns
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkWrappingHints.h"  // For VTK_WRAPEXCLUDE

#include <array>  // For settings
#include <memory> // For the implementation

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowQueryReader;
struct vtkCascadedSettings;

class VTKRENDERINGSOFTSHADOWSCASCADED_EXPORT vtkCascadedSoftShadowPass : public vtkSoftShadowPass
{
public:
  static vtkCascadedSoftShadowPass* New();
  vtkTypeMacro(vtkCascadedSoftShadowPass, vtkSoftShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  static constexpr int MaximumNumberOfCascades = 4;

  enum ResolutionType
  {
    HIGH = 0,   ///< MapSize texels along an edge
    MEDIUM = 1, ///< half as many
    LOW = 2     ///< a quarter as many
  };

  ///@{
  /**
   * Parts into which the receivers' depths are cut, in [1, 4]. Default is 3.
   */
  vtkSetClampMacro(NumberOfCascades, int, 1, MaximumNumberOfCascades);
  vtkGetMacro(NumberOfCascades, int);
  ///@}

  ///@{
  /**
   * Share of the logarithmic in the split scheme, in [0, 1]; the rest is uniform. 1 gives every
   * cascade the same resolution on the screen and tiny near cascades. A parallel camera is always
   * split uniformly. Default is 0.7.
   */
  vtkSetClampMacro(SplitLambda, double, 0.0, 1.0);
  vtkGetMacro(SplitLambda, double);
  ///@}

  ///@{
  /**
   * Part of the shorter of two neighbouring cascades over which they blend, in [0, 1]. Pixels there
   * cost both. Default is 0.2.
   */
  vtkSetClampMacro(BlendBand, double, 0.0, 1.0);
  vtkGetMacro(BlendBand, double);
  ///@}

  ///@{
  /**
   * Points of the light along an edge: a cascade has their square, each with a map. cascade is in
   * [0, 3], near to far; others are refused with an error. Edges are clamped to [1, 32]. Default is
   * 4, 3, 2, 2.
   */
  void SetSampleEdge(int cascade, int edge);
  int GetSampleEdge(int cascade) const;
  ///@}

  ///@{
  /**
   * Resolution of a cascade's maps, a ResolutionType. Default is HIGH, HIGH, MEDIUM, MEDIUM.
   */
  void SetResolution(int cascade, int resolution);
  int GetResolution(int cascade) const;
  ///@}

  ///@{
  /**
   * Edge in texels of FIXED, the percentage-closer filter over a cascade's maps, in [1, 15]; 1 is none.
   * Default is 5, 3, 2, 2.
   */
  void SetFilterSize(int cascade, int size);
  int GetFilterSize(int cascade) const;
  ///@}

  /// What smooths the steps between the points.
  enum FilterType
  {
    SCREEN = 0, ///< On the screen, over the shadow of a point's cell of the light.
    FIXED = 1   ///< In the maps, over FilterSize texels everywhere, as in the paper.
  };

  ///@{
  /**
   * What smooths the steps between the points, a FilterType. SCREEN makes them vanish however wide the
   * penumbra, keeps contacts sharp and lets facets throw no lines on their neighbours; it is meant for
   * GRID, whose cells tile the light. FIXED blurs all alike. With Adaptive, SCREEN is no filter: enough points need none.
   * Default is SCREEN.
   */
  vtkSetClampMacro(Filter, int, SCREEN, FIXED);
  vtkGetMacro(Filter, int);
  ///@}

  ///@{
  /**
   * How the points are spread; see vtkShadowLightSampling::PatternType. Default is GRID.
   */
  vtkSetClampMacro(Pattern, int, vtkShadowLightSampling::GRID, vtkShadowLightSampling::HAMMERSLEY);
  vtkGetMacro(Pattern, int);
  ///@}

  ///@{
  /**
   * Weights of the points: uniform, or N(0, 0.5) over the light's window. Default is MEAN.
   */
  vtkSetClampMacro(Weights, int, vtkShadowLightSampling::MEAN, vtkShadowLightSampling::GAUSSIAN);
  vtkGetMacro(Weights, int);
  ///@}

  ///@{
  /**
   * Samples the light as finely as each pixel needs: from the light's four corners on to grids of
   * 9, 25 and 81 points, border included, while the visibility of a pixel, or of one of its
   * neighbours, changes by more than Tolerance. The settings of points (edges, pattern) are ignored.
   * What 9 points miss in a pixel and around it is missed. Default is off.
   */
  vtkSetMacro(Adaptive, bool);
  vtkGetMacro(Adaptive, bool);
  vtkBooleanMacro(Adaptive, bool);
  ///@}

  ///@{
  /**
   * The largest change of a pixel's visibility from one grid to the next that counts as settled, in
   * [0, 1]. A straight edge along the grid changes it by 1/4, 1/8, 1/16 on the three finer grids, and
   * that is also the largest error left. Default is 1/8.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The finest grid of adaptive sampling, in [0, 3]: 4, 9, 25, 81 points. Default is 3.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 3);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * Cut the maps to what each cascade sees. Off, every map covers all casters, whatever the camera
   * sees. Default is on.
   */
  vtkSetMacro(FitToView, bool);
  vtkGetMacro(FitToView, bool);
  vtkBooleanMacro(FitToView, bool);
  ///@}

  ///@{
  /**
   * Read four texels at a time where OpenGL can. Off is what OpenGL 3.2 without
   * GL_ARB_texture_gather does: the same visibility, more slowly. Default is on.
   */
  vtkSetMacro(Gather, bool);
  vtkGetMacro(Gather, bool);
  vtkBooleanMacro(Gather, bool);
  ///@}

  ///@{
  /**
   * Tints the picture by cascade, for debugging: red, green, blue, yellow, near to far. Lights, their
   * parts and faces have cascades of their own; where they differ the tint is the mean. Default is
   * off.
   */
  vtkSetMacro(Tint, bool);
  vtkGetMacro(Tint, bool);
  vtkBooleanMacro(Tint, bool);
  ///@}

  ///@{
  /**
   * The light by whose cascades Tint tints, counted over the lit lights in the renderer's order from
   * 0; -1: all of them. A light that casts nothing tints nothing. Default is -1.
   */
  vtkSetClampMacro(TintLight, int, -1, VTK_INT_MAX);
  vtkGetMacro(TintLight, int);
  ///@}

  /**
   * Cascades that took part in the last visibility that was drawn: the largest number over all
   * emitters (lights, parts, faces). 0 before the first frame and where nothing casts.
   */
  int GetNumberOfOccupiedCascades() const;

  /**
   * With Adaptive: points looked at in all pixels together, as of the newest frame whose counts have
   * come back.
   */
  vtkTypeInt64 GetNumberOfPixelSamples();

  /**
   * What asks for the occlusion queries of Adaptive, so that a test can see that nobody waits for
   * them. Null: OpenGL itself, the default.
   */
  VTK_WRAPEXCLUDE void SetQueryReader(std::shared_ptr<vtkShadowQueryReader> reader);

protected:
  vtkCascadedSoftShadowPass();
  ~vtkCascadedSoftShadowPass() override;

  vtkSoftShadowRequirements GetRequirements() const override;
  void Begin(const vtkSoftShadowServices& services) override;
  void Add(const vtkSoftShadowServices& services) override;
  bool WantsVisibilityAnew() override;
  void AddStatistics(vtkSoftShadowStatistics& statistics) override;

  int NumberOfCascades = 3;
  double SplitLambda = 0.7;
  double BlendBand = 0.2;
  std::array<int, MaximumNumberOfCascades> SampleEdges = { { 4, 3, 2, 2 } };
  std::array<int, MaximumNumberOfCascades> Resolutions = { { HIGH, HIGH, MEDIUM, MEDIUM } };
  std::array<int, MaximumNumberOfCascades> FilterSizes = { { 5, 3, 2, 2 } };
  int Filter = SCREEN;
  int Pattern = vtkShadowLightSampling::GRID;
  int Weights = vtkShadowLightSampling::MEAN;
  bool Gather = true;
  bool Tint = false;
  int TintLight = -1;
  bool Adaptive = false;
  double Tolerance = 0.125;
  int MaximumLevel = 3;
  bool FitToView = true;

private:
  vtkCascadedSoftShadowPass(const vtkCascadedSoftShadowPass&) = delete;
  void operator=(const vtkCascadedSoftShadowPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;

  void Change(std::array<int, MaximumNumberOfCascades>& values, int cascade, int value);
  int Read(const std::array<int, MaximumNumberOfCascades>& values, int cascade) const;
  vtkCascadedSettings GetSettings();
};

VTK_ABI_NAMESPACE_END
#endif
