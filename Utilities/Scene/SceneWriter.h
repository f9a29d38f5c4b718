// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes a scene file.
 */

#ifndef SceneWriter_h
#define SceneWriter_h

#include "SceneDescription.h"

#include <string>

namespace softshadows
{

/**
 * The text of a scene file that ParseScene reads as the same description: every key, numbers to the
 * last bit. Models are named as in the description. Throws SceneError where a name is not UTF-8.
 */
std::string WriteScene(const SceneDescription& scene);

}

#endif
