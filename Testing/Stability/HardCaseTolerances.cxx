// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The one table of errors that the techniques must make, no more and not much less, with the settings of
// Effort::Moderate.
#include "HardCaseJudge.h"

#include <cstddef>
#include <iterator>
#include <stdexcept>

namespace SoftShadowsTesting
{
namespace
{

struct Row
{
  const char* CaseName;
  /// A tolerance up to this asks for no least error: chance makes as much. Where a light has no size,
  /// single pixels on a shadow's edge fall to the other side with another driver, at 0.01 each.
  double Floor;
  /// In the order of AllTechniques().
  double LargestRmse[9];
};

// Measured, and a quarter more. Techniques that sample the light know everything that blocks; 64 points
// leave steps of 1 / 64 and, for edges along their grid, of 1 / 8. Techniques with one map from the
// light's centre are exact for blockers at one depth, and worse the larger the light and the more
// depths blockers lie at; marching that map makes a third of those errors. Exact rays know everything, and are few.
const Row Rows[] = {
#include "HardCaseTolerances.inc"
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
    { "PercentageCloser", "GrazingLight", horizon },
    { "Separable", "GrazingLight", horizon },
    { "Virtual", "GrazingLight", tiles },
    { "Marched", "LightLargerThanScene", behind },
    { "Marched", "Spot", blocks },
    { "Virtual", "Bulb", edges },
    { "Virtual", "Cone90", edges },
    { "Virtual", "Cone120", edges },
  };
  return errors;
}

//------------------------------------------------------------------------------
Tolerance ToleranceOf(const std::string& techniqueName, const std::string& caseName)
{
  const std::vector<Technique>& techniques = AllTechniques();
  if (techniques.size() != std::size(Rows[0].LargestRmse))
  {
    throw std::out_of_range("The table of tolerances has another number of techniques");
  }
  for (const Row& row : Rows)
  {
    for (std::size_t i = 0; i < techniques.size(); ++i)
    {
      if (row.CaseName == caseName && techniques[i].Name == techniqueName)
      {
        const double most = row.LargestRmse[i];
        return { most > row.Floor ? most / 2.0 : 0.0, most };
      }
    }
  }
  throw std::out_of_range("No tolerance for " + techniqueName + " in " + caseName);
}

//------------------------------------------------------------------------------
std::vector<std::string> CasesWithTolerances()
{
  std::vector<std::string> names;
  for (const Row& row : Rows)
  {
    names.emplace_back(row.CaseName);
  }
  return names;
}

}
