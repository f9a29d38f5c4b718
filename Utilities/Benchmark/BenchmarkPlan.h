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

/**
 * The peers (plain, vtk, rays) and every technique: with its defaults and a light that is split in
 * two by two; with each map size, pair of kernel widths and number of samples where it has such
 * options. Uniform weights. quick: one or two per technique, maps of 1024.
 */
std::vector<ContestantChoice> PlanContestants(
  const std::vector<KnownTechnique>& techniques, bool quick);

/**
 * The scenes of all .json files of a folder, by name, and those that grow: actors-10 to -1000 (boxes
 * over a ground), triangles-1000 to -1000000 (a sphere over a ground). Files that cannot be read come
 * with the reason. quick: images of 320 x 240, growing scenes left out.
 */
std::vector<BenchmarkScene> PlanScenes(
  const std::string& folder, const std::vector<std::string>& modelFolders, bool quick);

/// Those whose name is in the list; all if the list is empty. Throws std::runtime_error for names
/// that are no scene's, and lists all that are.
std::vector<BenchmarkScene> SelectScenes(
  const std::vector<BenchmarkScene>& scenes, const std::vector<std::string>& names);

/// The same for contestants, by technique.
std::vector<ContestantChoice> SelectTechniques(
  const std::vector<ContestantChoice>& choices, const std::vector<std::string>& techniques);

}

#endif
