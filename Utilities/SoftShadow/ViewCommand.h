// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * softshadow view: a scene or models in a window.
 */

#ifndef ViewCommand_h
#define ViewCommand_h

#include <CLI/CLI.hpp>

namespace softshadows
{

/// Adds the command; parsing its arguments runs it. Throws std::runtime_error when it fails.
void AddViewCommand(CLI::App& app);

}

#endif
