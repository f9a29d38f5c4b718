// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that come with the program.
 */

#ifndef InstalledFiles_h
#define InstalledFiles_h

#include <string>

namespace softshadows
{

/**
 * The folder of the benchmark's scene files: where it stands beside the installed program, wherever
 * that has been moved to, else in the sources that the program was built from.
 */
std::string FindBenchmarkScenes();

}

#endif
