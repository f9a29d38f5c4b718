// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCascades
 * @brief   The parts of the view, by depth, that have shadow maps of their own.
 *
 * The depths that receivers can occupy are cut by the practical scheme (Zhang et al. 2006; Zerari et
 * al. 2023, Eq. 5), the mean of the logarithmic and the uniform split. Depths are linear view
 * depths. The range is bounded by clipping the receivers' boxes to the camera's frustum: exact for
 * planes, a bound for others, and known before anything is drawn, so that nothing waits for the GPU
 * and a picture does not depend on the frames before it. Its ends are rounded to quarters of an
 * octave of the scene's size: a moving camera changes the splits at a few places only.
 *
 * A part in which no receiver can be is no cascade. Its neighbours share its depths, so that every
 * depth has its cascades and their weights sum to 1.
 */

#ifndef vtkShadowCascades_h
#define vtkShadowCascades_h

#include "vtkRenderingSoftShadowsCascadedModule.h" // For export macro
#include "vtkShadowCasters.h"                      // For the bodies
#include "vtkShadowMapView.h"                      // For views
#include "vtkSoftShadowsABI.h"                     // For the ABI namespace

#include <array>   // For matrices
#include <utility> // For intervals
#include <vector>  // For lists

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

struct VTKRENDERINGSOFTSHADOWSCASCADED_EXPORT vtkShadowCascades
{
  /// Nearest and farthest depth.
  using Interval = std::pair<double, double>;

  struct Cascade
  {
    /// What its maps must cover: its depths and its share of the bands on both sides.
    Interval Covered;
    /// Its weight rises from 0 to 1 over FadeIn and falls from 1 to 0 over FadeOut.
    Interval FadeIn;
    Interval FadeOut;
    /// Centre and radius of the sphere around the covered part of the view, in world coordinates.
    std::array<double, 3> Center = { { 0.0, 0.0, 0.0 } };
    double Radius = 0.0;
    /// The corners of what it covers of the box around all receivers, in world coordinates; none if they
    /// are unknown.
    std::vector<std::array<double, 3>> Corners;
    /// False if nothing that can be seen lies behind a caster: it takes no maps.
    bool Occupied = true;
  };

  /// A point of the light, and what of the light it stands for.
  struct LightPoint
  {
    vtkShadowMapView Map;
    /// Half the image of its cell, in (s, t) per unit of depth between blocker and receiver.
    std::array<double, 2> CellScale = { { 0.0, 0.0 } };
    /// How far a filter reaches beyond that, in (s, t).
    double Border = 0.0;
  };

  /// What a camera sees: world to clip coordinates and world to view depth, row-major.
  struct View
  {
    std::array<double, 16> WorldToClip;
    std::array<double, 4> WorldToDepth;
    bool Parallel = false;
    /// The points whose maps count: a flat receiver matters where a caster may hide a part of one's
    /// cell. Empty: everywhere.
    std::vector<LightPoint> Points;

    static View Of(vtkRenderer* renderer);
  };

  /**
   * Depths Z_0 = nearest to Z_count = farthest. lambda is the share of the logarithmic split, the
   * rest is uniform. Nearest must be positive unless lambda is 0.
   */
  static std::vector<double> Split(double nearest, double farthest, int count, double lambda);

  /// The depths at which each receiving body can be seen, and in shadow; bodies that cannot are left
  /// out.
  static std::vector<Interval> FindDepths(
    const std::vector<vtkShadowCasters::Body>& bodies, const View& view);

  /// A range that holds all intervals, its ends rounded away from each other, in steps of quarters
  /// of an octave from unit.
  static Interval Round(const std::vector<Interval>& depths, bool parallel, double unit);

  /**
   * The occupied cascades, near to far: at most count, at least one, which may be empty. band is the part of the
   * shorter of two neighbouring splits over which they blend, in [0, 1]. Parallel views are split
   * uniformly, whatever lambda: all their depths are seen equally large.
   */
  static std::vector<Cascade> Find(const std::vector<vtkShadowCasters::Body>& bodies,
    const View& view, int count, double lambda, double band);

  /// Adds the next cascade to one: what it covers, and its fading out.
  static void Join(Cascade& cascade, const Cascade& next);

  /// The weight of a cascade at a depth, as in the shader.
  static double Weight(const Cascade& cascade, double depth);
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCascades.h
