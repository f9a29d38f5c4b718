// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StoredPicture.h
 * @brief Pictures in files. Apart from the picture, so that tests without files need no image library.
 */

#ifndef SoftShadowsTesting_StoredPicture_h
#define SoftShadowsTesting_StoredPicture_h

#include "Picture.h"

#include <string> // For paths

namespace SoftShadowsTesting
{

/// Reads what OpenImageIO can read; throws std::runtime_error with the path and the reason.
Picture ReadPicture(const std::string& path);

/// Writes 8-bit PNG or 32-bit float EXR, by the name's ending. Makes the folder if need be.
void WritePicture(const std::string& path, const Picture& picture);

}

#endif
