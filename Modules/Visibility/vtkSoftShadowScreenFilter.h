// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowScreenFilter
 * @brief   A bilateral filter of visibility on the screen.
 *
 * A technique that estimates visibility from few points of a light draws sums over them into a
 * texture; the filter smooths what the points leave and adds the result to the light's visibility:
 *
 *     if (filter.BeginSums(context))
 *     {
 *       ... draw the sums, additively, over the marked pixels
 *       filter.EndSums();
 *       filter.Draw(context, settings);
 *     }
 *
 * The sums, per pixel, with weights that add up to 1 over all points of the emitter:
 *  r: -1, no value, from the start: the first draw adds 1 to it. And the weights of the points in
 *     front of the receiver's plane;
 *  g: the weights of those of them that it sees;
 *  b: weight * reach of those that are hidden: how much further than its blocker the receiver is,
 *     z_q / z_o - 1 of depths along a positional emitter's direction, z_q - z_o of a directional
 *     one's; what the emitter's size is multiplied by to get the penumbra's;
 *  a: the weights of the points behind the plane that nothing else hides.
 * Only CELL reads b and a; the others take g for the visibility.
 *
 * A tap weighs domain * range * surface. Range: exp(-dV^2 / (2 h_r^2)). Surface: falls to zero for
 * taps off the receiver's plane and for normals that turn by 45 degrees, so nothing leaks over
 * silhouettes and creases. The domain is a DomainType.
 */

#ifndef vtkSoftShadowScreenFilter_h
#define vtkSoftShadowScreenFilter_h

#include "vtkRenderingSoftShadowsVisibilityModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                       // For the ABI namespace
#include "vtkType.h"                                 // For bytes

#include <array>  // For cells
#include <memory> // For the implementation
#include <vector> // For cells

VTK_ABI_NAMESPACE_BEGIN
class vtkWindow;
struct vtkSoftShadowContext;

class VTKRENDERINGSOFTSHADOWSVISIBILITY_EXPORT vtkSoftShadowScreenFilter
{
public:
  enum DomainType
  {
    NONE = 0,      ///< The pixel alone.
    SEPARABLE = 1, ///< Taps along x, then along y; iterated with taps 1, 2, 4, ... pixels apart.
    SQUARE = 2,    ///< Taps over a square, in one step.
    CELL = 3       ///< A box with the shape of the shadow of a cell of the light.
  };

  /**
   * The edges of the cell around each point in the emitter's window [-1, 1]^2, and the view depths
   * between which it is that cell: its weight rises over FadeIn and falls over FadeOut. Taps that
   * differ by no more than BandStep, in units of visibility, lose no weight by it: what a straight
   * edge makes of neighbouring bands.
   */
  struct Cell
  {
    std::array<std::array<double, 2>, 2> Edges = { {} };
    double BandStep = 0.0;
    std::array<double, 2> FadeIn = { { -2e30, -1e30 } };
    std::array<double, 2> FadeOut = { { 1e30, 2e30 } };
  };
  static constexpr int MaximumNumberOfCells = 4;

  struct Settings
  {
    int Domain = CELL;
    /// h_r, in units of visibility, above 0.
    double RangeDeviation = 0.5;
    /// y before x, or the cell's second edge before its first.
    bool SecondAxisFirst = false;

    ///@{
    /// CELL: one cell for all depths, or up to four, whose weights sum to 1; the widest box in
    /// pixels, and whether the emitter's weight is that of its points alone (not uniform).
    std::vector<Cell> Cells;
    int MaximumWidth = 64;
    bool WeightedByPoints = false;
    ///@}

    ///@{
    /// SEPARABLE and SQUARE: taps on either side, standard deviation of a Gaussian in taps (infinite:
    /// a box), and iterations of SEPARABLE.
    int HalfTaps = 1;
    double DomainDeviation = 3.0;
    int Iterations = 1;
    ///@}
  };

  vtkSoftShadowScreenFilter();
  ~vtkSoftShadowScreenFilter();
  vtkSoftShadowScreenFilter(const vtkSoftShadowScreenFilter&) = delete;
  vtkSoftShadowScreenFilter& operator=(const vtkSoftShadowScreenFilter&) = delete;

  /**
   * Keeps what the bound framebuffer knows of pixels that are not marked (proved, or another emitter's):
   * they are taps too. Binds the sums, of the receivers' size, for drawing, and clears them to (-1, 0,
   * 0, 0). Blending and the depth test, with the context's marks, stay as a technique finds them. False,
   * with nothing bound and an error, if there is no such texture.
   */
  bool BeginSums(const vtkSoftShadowContext& context);

  /// Binds again what BeginSums found.
  void EndSums();

  /// Filters the sums, and adds the emitter's weight times the result to the bound framebuffer.
  void Draw(const vtkSoftShadowContext& context, const Settings& settings);

  ///@{
  /// For the statistics of techniques.
  vtkTypeInt64 GetBytes() const;
  int GetNumberOfShaderBuilds() const;
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class Internals;
  std::unique_ptr<Internals> Impl;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowScreenFilter.h
