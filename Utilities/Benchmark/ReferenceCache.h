// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceCache.h
 * @brief Ray-traced references in files, found again by the content of their scene.
 */

#ifndef SoftShadowsBenchmark_ReferenceCache_h
#define SoftShadowsBenchmark_ReferenceCache_h

#include "ReferenceSource.h"

#include <string> // For the folder

namespace softshadows
{

/**
 * References from files of the folder, if the same scene was traced before, else traced and kept there.
 * A damaged file is traced anew and replaced. The folder is made when the first reference is kept; an
 * empty name keeps none.
 */
ReferenceSource CacheReferences(const std::string& folder);

}

#endif
