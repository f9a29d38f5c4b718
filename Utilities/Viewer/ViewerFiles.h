// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Names and contents of the files that the viewer saves.
 */

#ifndef ViewerFiles_h
#define ViewerFiles_h

#include "SceneDescription.h"

#include <string>
#include <vector>

namespace softshadows
{

/// The first of folder/stem-1ending, folder/stem-2ending, ... that does not exist yet.
std::string FreeFileName(
  const std::string& folder, const std::string& stem, const std::string& ending);

/**
 * Writes a scene file whose models are found from wherever it lies: their names become absolute.
 * Throws std::runtime_error with the path and the reason; nothing is left of a file that failed.
 *
 * @param folders where models are looked for after the scene's own folder.
 */
void SaveScene(
  const std::string& path, SceneDescription scene, const std::vector<std::string>& folders);

}

#endif
