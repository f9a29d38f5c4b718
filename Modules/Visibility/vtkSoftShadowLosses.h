// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowLosses
 * @brief   The lights whose visibility could not be had, why, and when to try again.
 *
 * A lost light is shown without shadows. What was lost to a lack of memory may be there in the next
 * frame: while nothing changes it is tried again after 1, 2, 4, ... frames, at most 64.
 */

#ifndef vtkSoftShadowLosses_h
#define vtkSoftShadowLosses_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <set>    // For what is known
#include <string> // For reasons
#include <vector> // For lists

VTK_ABI_NAMESPACE_BEGIN

class vtkSoftShadowLosses
{
public:
  /// Begins an estimate of so many casting lights, none of which is lost.
  void Begin(int lights) { this->Reasons.assign(lights, std::string()); }

  /// The first reason stays. An empty one is none.
  void Lose(int light, const std::string& reason);
  void LoseAll(const std::string& reason);

  /// Ends the estimate: plans when it is tried again if something was lost.
  void End();

  bool HasAny() const;

  /// Empty if the light has its shadow.
  const std::string& GetReason(int light) const;

  /// Counts a frame in which nothing changed; true if it is time to try again.
  bool IsRetryDue();

  /**
   * What to tell about the lights that were not lost before: "light 0 is shown without shadows: ...".
   * Empty if there are none. Numbers are those of the casting lights, names what the user calls them.
   */
  std::string TakeNews(const std::vector<int>& names);

  /// Nothing is lost any more, for there is nothing; what was told stays told.
  void Clear() { this->Reasons.clear(); }

private:
  std::vector<std::string> Reasons; // per casting light; empty: not lost
  std::set<int> Told;               // until an estimate goes well
  int Delay = 1;
  int Left = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkSoftShadowLosses.h
