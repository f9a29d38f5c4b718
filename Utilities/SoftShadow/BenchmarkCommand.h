// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * softshadow benchmark: speed against error, scenes x techniques.
 */

#ifndef BenchmarkCommand_h
#define BenchmarkCommand_h

#include <CLI/CLI.hpp>

namespace softshadows
{

/// Adds the command; parsing its arguments runs it. Throws std::runtime_error when it fails.
void AddBenchmarkCommand(CLI::App& app);

}

#endif
