// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * softshadow reference: the exact visibility of a scene, by ray tracing.
 */

#ifndef ReferenceCommand_h
#define ReferenceCommand_h

#include <CLI/CLI.hpp>

namespace softshadows
{

/// Adds the command; parsing its arguments runs it. Throws std::runtime_error when it fails.
void AddReferenceCommand(CLI::App& app);

}

#endif
