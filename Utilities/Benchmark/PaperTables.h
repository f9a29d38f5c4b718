// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaperTables.h
 * @brief Published figures, and the contestants that are held against them.
 *
 * The published machines are graphics cards of 2005 to 2023 and the scenes are not ours, so figures
 * are compared by their ratio to a row of their table, decibels and percent by their difference.
 * Image sizes (but for pvssm's, which are smaller), map sizes, kernels and numbers of samples are the published ones. Columns without published
 * figures stand beside them for their own sake.
 */

#ifndef SoftShadowsBenchmark_PaperTables_h
#define SoftShadowsBenchmark_PaperTables_h

#include "BenchmarkRunner.h"

namespace softshadows
{

/// All times are of frames with moving lights; all errors are of the first light.
enum class PaperFigure
{
  FramesPerSecond,
  Milliseconds,
  Step,               ///< Milliseconds of one step of the frame.
  Rmse,               ///< Of the visibility, against ray tracing.
  RmseToFirst,        ///< Of the visibility, against the table's first row.
  Psnr,               ///< Decibels, of the visibility.
  SsimPercent,        ///< Of the visibility.
  PictureRmse,        ///< Of the lit picture's luminance.
  PicturePsnr,        ///< Decibels, of the lit picture.
  PictureSsimPercent, ///< Of the lit picture.
  Megabytes,          ///< Held by the pass.
  Count               ///< Of what the last frame did or held.
};

/// Whether figures are compared by difference; by ratio otherwise.
bool IsComparedByDifference(PaperFigure figure);

struct PaperColumn
{
  std::string Title;
  PaperFigure Figure = PaperFigure::FramesPerSecond;
  /// By row, NaN where nothing was published; empty if nothing at all was.
  std::vector<double> Published;
  /// The names of the steps or counts that PaperFigure::Step or Count adds up.
  std::vector<std::string> Steps;
};

struct PaperRow
{
  std::string Label;
  ContestantChoice Choice;
};

struct PaperTable
{
  std::string Title;
  /// What one has to know to read it; may be empty.
  std::string Remark;
  /// Name of the scene in the place of the published one, and the factor on its lights' sizes.
  std::string Scene;
  double LightScale = 1.0;
  int Width = 0;
  int Height = 0;
  /// Lights are weighted by N(0, 0.5), in the truth too.
  bool Gaussian = false;
  /// Whether anything is measured against ray tracing.
  bool HasTruth = true;
  std::vector<PaperRow> Rows = {};
  std::vector<PaperColumn> Columns = {};
  /// Frames that are timed of every row, whatever time the run has; 0: as many as it has time for.
  int Frames = 0;
  /// The row that all are compared with.
  size_t Base = 0;
};

/// cascaded, estimators, pcss, pvssm, sbfs, sssm.
const std::vector<std::string>& GetPapers();

/// Throws std::runtime_error that lists the papers for other names.
std::vector<PaperTable> GetPaperTables(const std::string& paper);

///@{
/// By paper; estimators are the figures that the choice of techniques started from.
std::vector<PaperTable> GetPcssTables();
std::vector<PaperTable> GetSssmTables();
std::vector<PaperTable> GetCascadedTables();
std::vector<PaperTable> GetSbfsTables();
std::vector<PaperTable> GetPvssmTables();
std::vector<PaperTable> GetEstimatorTables();
///@}

/// "pcss filter_width=21" as a choice.
ContestantChoice ParseChoice(const std::string& text);

}

#endif
