// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkScenes.h
 * @brief Scenes of a benchmark: from descriptions, and made by rule.
 */

#ifndef SoftShadowsBenchmark_BenchmarkScenes_h
#define SoftShadowsBenchmark_BenchmarkScenes_h

#include "BenchmarkRunner.h"
#include "ModelStore.h"
#include "SceneDescription.h"

#include <memory> // For the models
#include <string> // For names
#include <vector> // For lists

namespace softshadows
{

/// A scene that is built anew for every contestant, of the description's size.
BenchmarkScene MakeScene(const std::string& name, const SceneDescription& description,
  const std::shared_ptr<ModelStore>& models);

/// actors-10 to -1000 (boxes over a ground), triangles-1000 to -1000000 (a sphere over a ground).
std::vector<BenchmarkScene> MakeGrowingScenes();

/**
 * Bars parallel to a floor that reaches to the horizon, under a lamp that is nearly a point: shadows
 * finer than pixels (Shen et al. 2011, figure 11).
 */
BenchmarkScene MakeGridScene();

/**
 * A plant of 625 units with pipes between them, 1.7 million triangles, seen over its near edge to
 * the horizon, in the place of the published models of 1.5 and 2 million (Shen et al. 2011).
 */
BenchmarkScene MakePlantScene();

}

#endif
