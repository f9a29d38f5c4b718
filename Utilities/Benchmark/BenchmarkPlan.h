// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkPlan.h
 * @brief What a run consists of: which scenes, which contestants.
 */

#ifndef SoftShadowsBenchmark_BenchmarkPlan_h
#define SoftShadowsBenchmark_BenchmarkPlan_h

#include "BenchmarkRunner.h"

namespace softshadows
{

/// A technique and the names of its options, as far as a plan needs to know it.
struct KnownTechnique
{
  std::string Name;
  std::vector<std::string> Options;

  bool Has(const std::string& option) const;
};

/// How many settings of each technique are wanted.
enum class PlanSize
{
  Defaults, ///< Defaults, and hard maps; no rays.
  Few,      ///< One, with a map of 1024; hard maps with 1 and 16 samples.
  Main,     ///< Defaults, a light split in two by two, pairs of kernel widths, numbers of samples.
  All       ///< Those, and every map size.
};

/**
 * The peers (plain, vtk, rays) and every technique, each with the settings that it has options for.
 * Uniform weights. Those that tell most come first: what no time is left for is left out, but for
 * defaults, which are essential.
 */
std::vector<ContestantChoice> PlanContestants(
  const std::vector<KnownTechnique>& techniques, PlanSize size);

/**
 * The scenes of all .json files of a folder, by name, and those that grow: actors-10 to -1000 (boxes
 * over a ground), triangles-1000 to -1000000 (a sphere over a ground). Files that cannot be read come
 * with the reason.
 */
std::vector<BenchmarkScene> PlanScenes(
  const std::string& folder, const std::vector<std::string>& modelFolders);

/// Those of the benchmark's own scenes that tell most, at 240 x 180; of other scenes all that do not
/// grow.
std::vector<BenchmarkScene> PlanQuickScenes(const std::vector<BenchmarkScene>& scenes);

/// Seconds for one of the scenes that are left, by their shares; 0 for no limit.
double ShareOfTime(const std::vector<BenchmarkScene>& scenes, size_t next, double secondsLeft);

/// Those whose name is in the list; all if the list is empty. Throws std::runtime_error for names
/// that are no scene's, and lists all that are.
std::vector<BenchmarkScene> SelectScenes(
  const std::vector<BenchmarkScene>& scenes, const std::vector<std::string>& names);

/// The same for contestants, by technique.
std::vector<ContestantChoice> SelectTechniques(
  const std::vector<ContestantChoice>& choices, const std::vector<std::string>& techniques);

}

#endif
