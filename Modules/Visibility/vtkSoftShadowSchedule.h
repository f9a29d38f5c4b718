// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowSchedule
 * @brief   Which points of the lights come next while nothing changes, and when they are enough.
 *
 * The mean over points of the light with a hard shadow each converges to the truth, whatever the
 * technique, but for the texels of the maps. Two errors are estimated per tile of the screen:
 *  - of the maps: the mean of the first 64 points is drawn with maps of half the size and of the full
 *    size. Where texels fall is chance, another for each point: that averages out, and is in the error
 *    of the points. What does not is common to both halves of the points; the mean product of their
 *    differences is its square. That is known by chance only, so half of the chance counts. Where it
 *    falls by the factor r per doubling, what is left is r / (1 - r) of the difference; r is 0.55, a
 *    little over the half that a bias of texels makes. While this is over half the tolerance and memory
 *    allows it, maps of twice the size are taken.
 *  - of the points: after 128, 256, 512, ... points the mean is compared with the one at half as many.
 *    The two halves are scrambled nets, as good as independent; half their difference, which is the
 *    change of the mean, is the standard error of the mean.
 * The estimate is the worst tile's root of the sum of their squares. It ends when that is under the
 * tolerance, or when the maps' error alone forbids it and that of the points no longer counts.
 *
 * Knows no OpenGL. Points are counted per light; all lights advance together.
 */

#ifndef vtkSoftShadowSchedule_h
#define vtkSoftShadowSchedule_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <string> // For descriptions
#include <vector> // For tiles

VTK_ABI_NAMESPACE_BEGIN

class vtkSoftShadowSchedule
{
public:
  /// Points of the first means, which compare maps.
  static constexpr int FirstPoints = 64;
  /**
   * What the changes of a light without extent are multiplied by while maps are compared. All its points
   * are one, and its errors are pixels on the wrong side of a hard edge: their number, which is the mean
   * square, halves as maps double, and those of two sizes are not the same pixels. So a third of the
   * difference's square is left, not the factor for what all points have in common.
   */
  static constexpr float HardShare = 2.0f / 9.0f;
  /// No more points than these.
  static constexpr int MostPoints = 65536;

  /// Begins anew. Maps start with mapSize texels along an edge and grow to at most largestMapSize.
  void Start(int mapSize, int largestMapSize, double tolerance);
  /// Back to before Start.
  void Reset() { *this = vtkSoftShadowSchedule(); }

  bool IsStarted() const { return this->MapSize > 0; }
  /// Ends at once: with nothing left to do, or in failure. What is shown stays without the sum.
  void Finish(bool converged);

  /**
   * For maps of GetMapSize() texels there is no memory. If smaller ones had been looked at, they are
   * kept for good and the sum begins anew with them: true. Else it ends in failure: false. Either way
   * what the sum holds is not shown.
   */
  bool LoseMaps();

  bool IsEnded() const { return this->Converged || this->Exhausted; }
  bool IsConverged() const { return this->Converged; }

  /// Whether it goes on, or why it ended: a sentence with its figures.
  std::string Describe() const;

  /// Texels along an edge of the maps of the next points.
  int GetMapSize() const { return this->MapSize; }
  /// Points in the mean; the next point's number.
  int GetCount() const { return this->Count; }
  /// Standard error of the worst tile; 1 until it is known.
  double GetEstimatedError() const { return this->EstimatedError; }

  /**
   * Share of the mean in what is shown, in [0, 1]. Few points show as bands, so the mean takes over as
   * the first of them come; before its error is estimated it is shown alone.
   */
  float GetShare() const;

  /// Whether the rest of what is shown is the mean that is held, not the technique's own visibility.
  bool IsHeldShown() const { return this->Grown; }

  /// How many of the frame's points may be drawn before the next look at the mean.
  int GetRun(int most) const;

  /// Counts points that were drawn. True if the mean is to be looked at now.
  bool Advance(int points);

  /// Whether the mean of half the points is to be kept now, for the look that compares maps.
  bool IsHalfway() const { return !this->HasFloor && this->Count == FirstPoints / 2; }

  /// Whether the look needs tiles, or there is no mean to compare with yet.
  bool NeedsTiles() const { return !this->Probing; }

  /// Whether it compares maps, by what is common to both halves of the points.
  bool ComparesMaps() const { return !this->HasFloor; }

  /// What to do with the mean after a look.
  enum NextType
  {
    END,           ///< It is the result.
    HOLD,          ///< Keep a copy to compare with, and go on.
    HOLD_AND_CLEAR ///< Keep a copy to compare with, and begin the sum anew.
  };

  /// changes: per tile the mean square of the difference to the copy that is held; of the common
  /// one while maps are compared.
  NextType Look(const std::vector<float>& changes);

private:
  int MapSize = 0;
  int LargestMapSize = 0;
  double Tolerance = 0.0;
  int Count = 0;
  int Goal = FirstPoints;
  bool Probing = true; // with maps of half the size
  bool Grown = false;  // the maps
  bool HasFloor = false;
  bool Lost = false;   // finer maps
  bool Failed = false; // the sum is worth nothing
  bool Converged = false;
  bool Exhausted = false;
  double EstimatedError = 1.0;
  double MapError = 0.0;    // of the worst tile, of the maps alone
  std::vector<float> Floor; // of the maps: mean squares per tile

  NextType LookAtMaps(const std::vector<float>& changes);
  NextType LookAtPoints(const std::vector<float>& changes);
};

VTK_ABI_NAMESPACE_END
#endif
