// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartPicture.h
 * @brief Lines over two axes as a picture, drawn with VTK's charts.
 */

#ifndef SoftShadowsBenchmark_ChartPicture_h
#define SoftShadowsBenchmark_ChartPicture_h

#include "BenchmarkResults.h"

#include <string> // For labels
#include <vector> // For points

namespace softshadows
{

struct ChartSeries
{
  std::string Name;
  std::vector<double> X;
  std::vector<double> Y;
  /// A thick grey line without marks, as for a front.
  bool IsFront = false;
};

struct ChartDescription
{
  std::string Title;
  std::string XLabel;
  std::string YLabel;
  bool LogX = true;
  bool LogY = true;
  std::vector<ChartSeries> Series;

  bool IsEmpty() const;
};

/// Points that are not above 0 are left out of logarithmic axes.
ColorImage DrawChart(const ChartDescription& chart, int width = 760, int height = 480);

}

#endif
