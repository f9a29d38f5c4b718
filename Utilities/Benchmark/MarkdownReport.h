// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MarkdownReport.h
 * @brief A run's results as a document for the repository: tables in Markdown, plots in files.
 */

#ifndef SoftShadowsBenchmark_MarkdownReport_h
#define SoftShadowsBenchmark_MarkdownReport_h

#include "BenchmarkResults.h"

#include <iosfwd> // For the text
#include <string> // For the folder

namespace softshadows
{

/**
 * The machine, the plot of all scenes (speed-against-error.png), and per scene a table of times (lights moving, camera moving, still) and errors with
 * the Pareto front in bold, and the plot of speed against error as imageFolder/speed-<scene>.png.
 * The plots against settings (of the scene with most contestants) and sizes follow. Returns the plots by file name.
 */
std::map<std::string, ColorImage> WriteMarkdown(
  std::ostream& os, const BenchmarkResults& results, const std::string& imageFolder);

}

#endif
