// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pictures in files, whole or not at all.
 */

#ifndef SoftShadowsMetrics_ImageFile_h
#define SoftShadowsMetrics_ImageFile_h

#include <OpenImageIO/imageio.h> // For specifications

#include <string> // For paths

namespace softshadows
{

/**
 * Writes a picture in the format that the name says; pixels are of the given type, channels together, top
 * row first. Throws std::runtime_error that names the file, and leaves none, also where the disk is
 * full: OpenImageIO's writers of PNG and OpenEXR do not notice that.
 */
void WriteImageFile(const std::string& path, const OIIO::ImageSpec& spec,
  const OIIO::TypeDesc& type, const void* pixels);

}

#endif
