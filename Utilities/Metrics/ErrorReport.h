// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorReport.h
 * @brief Errors as JSON, and as the lines that a terminal shows.
 */

#ifndef SoftShadowsMetrics_ErrorReport_h
#define SoftShadowsMetrics_ErrorReport_h

#include "ErrorMeasures.h"

#include <nlohmann/json.hpp>

#include <iosfwd> // For the terminal

namespace softshadows
{

/**
 * Keys: all and penumbra, each with pixels, rmse, mean, bias, maximum, percentile99, psnr, ssim;
 * light_leaks, false_shadows, left_out, only_in_reference, only_in_candidate. Numbers that are not
 * finite (no pixels; the PSNR of equal images) are null.
 */
nlohmann::ordered_json ToJson(const VisibilityErrors& errors);

/// A table of the same numbers.
void PrintErrors(std::ostream& os, const VisibilityErrors& errors);

}

#endif
