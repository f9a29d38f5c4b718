// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaperRun.h
 * @brief Published tables rerun: what was measured, as Markdown and JSON.
 */

#ifndef SoftShadowsBenchmark_PaperRun_h
#define SoftShadowsBenchmark_PaperRun_h

#include "PaperTables.h"

#include <nlohmann/json.hpp>

#include <iosfwd> // For the text

namespace softshadows
{

struct PaperResult
{
  PaperTable Table;
  /// The contestants are the table's rows.
  SceneResult Scene;
};

/**
 * Runs the rows of a table together, so that their frames are interleaved; lights move. The runner's
 * settings hold but for what the table says. Never throws.
 */
PaperResult RunPaperTable(const PaperTable& table, const std::vector<BenchmarkScene>& scenes,
  const BenchmarkRunner& runner);

/// Only traces the references of a table, into the runner's cache. False if it failed.
bool PreparePaperTable(const PaperTable& table, const std::vector<BenchmarkScene>& scenes,
  const BenchmarkRunner& runner);

/// Work of a table beside others', to share time by: its rows times its pixels.
double WorkOf(const PaperTable& table);

/// NaN if the contestant has no such figure.
double MeasureFigure(const PaperColumn& column, const ContestantResult& contestant);

///@{
/// Rows that failed say why.
void WritePaperMarkdown(std::ostream& os, const PaperResult& result);
nlohmann::ordered_json ToJson(const PaperResult& result);
///@}

}

#endif
