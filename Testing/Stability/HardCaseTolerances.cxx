// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The one table of errors that the techniques may make, with the settings of Effort::Moderate.
#include "HardCaseJudge.h"

#include <stdexcept>

namespace SoftShadowsTesting
{
namespace
{

struct Row
{
  const char* TechniqueName;
  /// Indexed by Blockers.
  double LargestRmse[4];
};

// Techniques that sample the light know everything that blocks; 64 points leave steps of 1 / 64 and,
// for edges along their grid, of 1 / 8. Techniques with one map from the light's centre are exact for
// blockers at one depth, off by 0.01 to 0.03 for compact bodies, by 0.06 to 0.09 for large lights and
// deep scenes and by 0.16 where blockers at several depths fuse; marching that map makes a third of
// those errors.
const Row Rows[] = {
  { "Sampled", { 0.02, 0.02, 0.025, 0.025 } },
  { "PercentageCloser", { 0.02, 0.03, 0.09, 0.16 } },
  { "Marched", { 0.02, 0.02, 0.03, 0.05 } },
  { "Bilateral", { 0.02, 0.02, 0.025, 0.025 } },
  { "Separable", { 0.02, 0.03, 0.09, 0.16 } },
  { "Cascaded", { 0.02, 0.02, 0.025, 0.025 } },
  { "AdaptiveSampled", { 0.02, 0.02, 0.025, 0.025 } },
  { "Virtual", { 0.02, 0.03, 0.09, 0.16 } },
};

}

//------------------------------------------------------------------------------
const std::vector<KnownError>& KnownErrors()
{
  static const std::string horizon =
    "The ground's horizon cuts the light in the middle of taps: each counts whole, or not at all.";
  static const std::string tiles =
    "The edges of the shadow are off by up to a texel of its tiles, which are as fine as the "
    "predicted kernel asks.";
  static const std::string behind = "Most of the light is hidden by what its centre does not see.";
  static const std::string blocks = "Rays are shared over blocks of pixels, which are coarse in a "
                                    "picture of 96 x 96; the cone leaves "
                                    "little beside the penumbra to be compared.";
  static const std::string edges = "Six pixels on the edge of a hard shadow of 2137 fall to the "
                                   "other side: tiles are as fine as the "
                                   "predicted kernel asks, not as fine as the map may be.";
  static const std::vector<KnownError> errors = {
    { "PercentageCloser", "GrazingLight", 0.03, horizon },
    { "Separable", "GrazingLight", 0.03, horizon },
    { "Virtual", "GrazingLight", 0.03, tiles },
    { "Marched", "LightLargerThanScene", 0.09, behind },
    { "Marched", "Spot", 0.035, blocks },
    { "Virtual", "Bulb", 0.03, edges },
    { "Virtual", "Cone90", 0.03, edges },
    { "Virtual", "Cone120", 0.03, edges },
  };
  return errors;
}

//------------------------------------------------------------------------------
double LargestRmse(const Technique& technique, const HardCase& hardCase)
{
  for (const KnownError& error : KnownErrors())
  {
    if (error.TechniqueName == technique.Name && error.CaseName == hardCase.Name)
    {
      return error.LargestRmse;
    }
  }
  for (const Row& row : Rows)
  {
    if (technique.Name == row.TechniqueName)
    {
      return row.LargestRmse[static_cast<int>(hardCase.Kind)];
    }
  }
  throw std::out_of_range("No tolerances for technique " + technique.Name);
}

}
