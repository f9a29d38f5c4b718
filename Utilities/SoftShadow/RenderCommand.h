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

/// Adds the command; parsing its arguments runs it. Throws std::runtime_error when it fails.
void AddRenderCommand(CLI::App& app);

}

#endif
