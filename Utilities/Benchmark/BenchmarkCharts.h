// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkCharts.h
 * @brief Which plots a run's results give.
 */

#ifndef SoftShadowsBenchmark_BenchmarkCharts_h
#define SoftShadowsBenchmark_BenchmarkCharts_h

#include "BenchmarkResults.h"
#include "ChartPicture.h"

namespace softshadows
{

/// Time (lights moving) against RMSE: a series per technique, and the Pareto front of all.
ChartDescription SpeedAgainstError(const SceneResult& scene);

/**
 * The contestants that no other beats in both time (lights moving) and RMSE, fastest first.
 */
std::vector<const ContestantResult*> ParetoFront(const SceneResult& scene);

/**
 * The same over all scenes but growing ones: geometric means of both over the scenes, of contestants
 * that were measured in every one of them. Front: none is both faster and closer on the mean.
 */
ChartDescription SpeedAgainstErrorOfAll(const BenchmarkResults& results);

/**
 * Time (lights moving) against an option: a series per technique of contestants that differ in this
 * option alone. Empty if no technique has two values of it.
 */
ChartDescription TimeAgainstOption(const SceneResult& scene, const std::string& option);

/**
 * Time (lights moving) against actors (names "actors-...") or triangles ("triangles-...") over the
 * scenes of that family, a series per contestant. Empty if there are fewer than two.
 */
ChartDescription TimeAgainstSize(const BenchmarkResults& results, const std::string& family);

}

#endif
