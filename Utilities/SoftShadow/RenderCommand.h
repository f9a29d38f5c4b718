// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * softshadow render: pictures, visibilities and reports of scenes and models.
 */

#ifndef RenderCommand_h
#define RenderCommand_h

#include <CLI/CLI.hpp>

namespace softshadows
{

/// The exit code of a run that wrote its files but did not meet the tolerance of --converge.
constexpr int ExitNotConverged = 2;

/// Adds the command; parsing its arguments runs it. Throws std::runtime_error when it fails, and
/// CLI::RuntimeError with ExitNotConverged.
void AddRenderCommand(CLI::App& app);

}

#endif
