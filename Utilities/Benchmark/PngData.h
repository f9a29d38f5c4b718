// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PngData.h
 * @brief Pictures as PNG, in bytes and in text.
 */

#ifndef SoftShadowsBenchmark_PngData_h
#define SoftShadowsBenchmark_PngData_h

#include "BenchmarkResults.h"

#include <string> // For text

namespace softshadows
{

/// The bytes of a PNG file.
std::string EncodePng(const ColorImage& image);

/// "data:image/png;base64,...", for the src of an img element.
std::string EncodePngUrl(const ColorImage& image);

}

#endif
