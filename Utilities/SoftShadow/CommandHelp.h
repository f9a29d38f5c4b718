// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tool says of itself: version, examples, and what a mistyped word may have meant.
 */

#ifndef CommandHelp_h
#define CommandHelp_h

#include <CLI/CLI.hpp>

namespace softshadows
{

/// Adds --version, the examples below --help, and suggestions to the messages of errors. The
/// commands must have been added before.
void AddHelp(CLI::App& app);

}

#endif
