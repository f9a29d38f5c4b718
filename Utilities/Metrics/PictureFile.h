// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PictureFile.h
 * @brief Pictures of bytes in files.
 */

#ifndef SoftShadowsMetrics_PictureFile_h
#define SoftShadowsMetrics_PictureFile_h

#include <string> // For the path
#include <vector> // For pixels

namespace softshadows
{

/// Writes RGB bytes, top row first, in the format that the name's ending says. Throws
/// std::runtime_error with the path and the reason.
void WritePicture(
  const std::string& path, int width, int height, const std::vector<unsigned char>& rgb);

}

#endif
