// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that must not be left behind when a signal or exit() ends the process.
 */

#ifndef UnfinishedFiles_h
#define UnfinishedFiles_h

#include <string>

namespace softshadows
{

/**
 * From now until ForgetUnfinished the file is removed if exit(), abort(), a fault or a signal ends the
 * process. At most 16 files at a time, and names shorter than 4096 bytes; others stay, as after
 * SIGKILL.
 */
void RememberUnfinished(const std::string& path);

void ForgetUnfinished(const std::string& path);

}

#endif
