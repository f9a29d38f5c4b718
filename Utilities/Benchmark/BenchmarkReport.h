// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkReport.h
 * @brief A run's results as JSON and CSV.
 *
 * The JSON document has the form of Google Benchmark's, so that its compare.py reads it: every timed
 * frame is a repetition of "scene/contestant/motion", followed by the aggregates mean, median, stddev
 * and cv. Under the key soft_shadows it holds everything else: scenes, errors, steps and counts.
 */

#ifndef SoftShadowsBenchmark_BenchmarkReport_h
#define SoftShadowsBenchmark_BenchmarkReport_h

#include "BenchmarkResults.h"

#include <nlohmann/json.hpp>

#include <iosfwd> // For the table

namespace softshadows
{

nlohmann::ordered_json ToJson(const BenchmarkResults& results);

/// The part "context" of that.
nlohmann::ordered_json ToJson(const BenchmarkContext& context);

/**
 * One line per scene, contestant and light (contestants without a visibility have one line). Median
 * and quartiles of the times in milliseconds; fields without a value are empty.
 */
void WriteCsv(std::ostream& os, const BenchmarkResults& results);

}

#endif
