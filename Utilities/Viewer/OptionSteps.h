// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The next larger and the next smaller value of an option.
 */

#ifndef OptionSteps_h
#define OptionSteps_h

#include "Technique.h"

namespace softshadows
{

/**
 * The value so many steps above (below, if negative), within the option's range. Flags and choices
 * go around their end. Integers of a range of more than 256 times its least double; shorter ranges
 * advance by 2, which keeps odd widths odd, and ranges up to 32 by 1. Numbers advance by a twentieth
 * of a range from 0 up to 1, else by a quarter of themselves.
 */
double StepValue(const TechniqueOption& option, double value, int steps);

}

#endif
