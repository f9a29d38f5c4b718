// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HtmlReport.h
 * @brief A run's results as one page that needs no other file.
 */

#ifndef SoftShadowsBenchmark_HtmlReport_h
#define SoftShadowsBenchmark_HtmlReport_h

#include "BenchmarkResults.h"

#include <iosfwd> // For the page

namespace softshadows
{

/**
 * Per scene: the plot of time against RMSE with its Pareto front, the table of times, errors and
 * counts, milliseconds per step, pictures and difference maps; then the plots of time against the
 * options and sizes that the run varied.
 */
void WriteHtml(std::ostream& os, const BenchmarkResults& results);

/// A number as the page shows it: four digits, "-" for what is no number.
std::string FormatNumber(double value);

/// Text with the characters escaped that mean something in HTML.
std::string EscapeHtml(const std::string& text);

}

#endif
