// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CompareCommand.h
 * @brief softshadow compare: how far a visibility is from another.
 */

#ifndef SoftShadow_CompareCommand_h
#define SoftShadow_CompareCommand_h

#include <CLI/CLI.hpp>

namespace softshadows
{

/// Registers the subcommand. When it runs, errors are thrown as exceptions.
void AddCompareCommand(CLI::App& app);

}

#endif
