// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RawVisibility.h
 * @brief Visibilities as plain floats, for programs without an image library.
 *
 * A line "softshadows-visibility WIDTH HEIGHT LIGHTS", then light after light as 32-bit floats in the
 * machine's byte order, top row first. NaN where nothing is compared: without a surface, and at
 * silhouettes (see Silhouettes.h), so that depths need not be kept.
 */

#ifndef SoftShadowsCardCheck_RawVisibility_h
#define SoftShadowsCardCheck_RawVisibility_h

#include "VisibilityFile.h"

#include <string> // For paths

namespace softshadows
{

/// Without depths. Throws std::runtime_error with the path and the reason.
VisibilityImage ReadRawVisibility(const std::string& path);

/// Throws std::runtime_error with the path and the reason; a file that could not be written whole is
/// removed.
void WriteRawVisibility(const std::string& path, const VisibilityImage& image);

}

#endif
