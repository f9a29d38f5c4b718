// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisibilityFile.h
 * @brief Visibilities as 32-bit float OpenEXR: channels V0, V1, ... per light, and depth.
 */

#ifndef SoftShadowsMetrics_VisibilityFile_h
#define SoftShadowsMetrics_VisibilityFile_h

#include <string> // For paths
#include <vector> // For pixels

namespace softshadows
{

/// Top row first. NaN where there is no value.
struct VisibilityImage
{
  int Width = 0;
  int Height = 0;
  /// Per light: 1 lit, 0 umbra.
  std::vector<std::vector<float>> Visibility;
  /// Linear view depth in world units; empty if the file has none.
  std::vector<float> Depth;
};

/**
 * Throws std::runtime_error with the path and the reason if the file cannot be read or has no
 * channel V0. Channels of other names are ignored.
 */
VisibilityImage ReadVisibility(const std::string& path);

/**
 * Throws std::runtime_error with the path and the reason; a file that could not be written whole is
 * removed. Throws std::invalid_argument if an image has another number of pixels than it should.
 */
void WriteVisibility(const std::string& path, const VisibilityImage& image);

}

#endif
