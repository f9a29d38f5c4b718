// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A line on the standard error output that tells how far a command is.
 */

#ifndef ProgressLine_h
#define ProgressLine_h

#include <string>

namespace softshadows
{

/**
 * On a terminal a line takes the place of the one before, if that was not final. Elsewhere, in a
 * file or a pipe, only final lines are written, and nothing that moves a cursor.
 */
void ShowLine(const std::string& line, bool isFinal);

/// A bar for a share in [0, 1], on terminals only.
void ShowBar(double share);

}

#endif
