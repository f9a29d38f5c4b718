// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which numbers an option of the command line takes. CLI11's own ranges let "nan" through, and write
 * their limits out with all digits.
 */

#ifndef NumberRange_h
#define NumberRange_h

#include <CLI/CLI.hpp>

#include <string>

namespace softshadows
{

/// "must be a whole number from 1 to 4096, is '0'".
CLI::Validator WholeNumber(long long least, long long most);

/// "must be a number from 0.1 to 1, is 'nan'".
CLI::Validator Number(double least, double most);

/// "must be a number above 0, is 'inf'".
CLI::Validator NumberAboveZero();

}

#endif
