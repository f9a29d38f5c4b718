// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaperTables.h
 * @brief Published figures, and the contestants that are held against them.
 *
 * The published machines are graphics cards of 2005 to 2023 and the scenes are not ours, so figures
 * are compared by their ratio to the first row of their table. Image sizes, map sizes, kernels and
 * numbers of samples are the published ones.
 */

#ifndef SoftShadowsBenchmark_PaperTables_h
#define SoftShadowsBenchmark_PaperTables_h

#include "BenchmarkRunner.h"

#include <iosfwd> // For the table

namespace softshadows
{

enum class PaperFigure
{
  FramesPerSecond, ///< With moving lights. Compared by ratio.
  Psnr,            ///< Decibels. Compared by difference.
  SsimPercent      ///< Compared by difference.
};

struct PaperRow
{
  std::string Label;
  ContestantChoice Choice;
  double Published = 0.0;
  /// Name of the scene in the place of the published one, and the factor on its lights' sizes.
  std::string Scene;
  double LightScale = 1.0;
};

/// Rows that are compared with their first.
struct PaperTable
{
  std::string Title;
  PaperFigure Figure = PaperFigure::FramesPerSecond;
  int Width = 0;
  int Height = 0;
  std::vector<PaperRow> Rows;
};

/// pcss, sssm, cascaded, sbfs, pvssm. Throws std::runtime_error that lists them for other names.
std::vector<PaperTable> GetPaperTables(const std::string& paper);

/**
 * Runs a table's rows and prints published and measured figures side by side. Rows of techniques
 * that are not built say so.
 */
void RunPaperTable(std::ostream& os, const PaperTable& table,
  const std::vector<BenchmarkScene>& scenes, const BenchmarkRunner& runner);

}

#endif
