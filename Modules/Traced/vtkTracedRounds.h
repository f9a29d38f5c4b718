// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedRounds
 * @brief   What VTK draws of points and lines: spheres, tubes, and flat squares and bands.
 *
 * They are hit where their formulas say, in double precision. Squares and bands face the ray; their shadow
 * begins half their width behind them, lest they shade themselves.
 */

#ifndef vtkTracedRounds_h
#define vtkTracedRounds_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkTracedBody.h"

#include <vector> // For the list

VTK_ABI_NAMESPACE_BEGIN
struct vtkTracedHits;

class vtkTracedRounds : public vtkTracedBody
{
public:
  enum KindType
  {
    SPHERE,
    TUBE, ///< with lids, as a cone if the ends' radii differ
    SQUARE,
    BAND
  };

  struct Round
  {
    KindType Kind = SPHERE;
    /// Of a sphere or a square the first alone counts.
    std::array<vtkTracedVector, 2> Ends;
    std::array<double, 2> Radii{};
  };

  using vtkTracedBody::vtkTracedBody;

  /// Takes them in place of what was held; their coordinates are relative to center.
  void Take(std::vector<Round> rounds, const vtkTracedVector& center);

  vtkTypeInt64 GetBytes() const override;

  /**
   * Where a ray first meets one, as a share of its way, if between nothing and most; else negative.
   * direction need not be of unit length.
   */
  static double FindHit(const Round& round, const vtkTracedVector& start,
    const vtkTracedVector& direction, double most);

  /**
   * Whether a ray that starts on its surface leaves it: bodies are convex, so that it meets it no more.
   * A start less than a fiftieth of the radius below the surface is on it.
   */
  static bool IsLeft(
    const Round& round, const vtkTracedVector& start, const vtkTracedVector& direction);

  const Round& GetRound(unsigned int index) const { return this->Rounds[index]; }

private:
  std::vector<Round> Rounds;
};

VTK_ABI_NAMESPACE_END
#endif
