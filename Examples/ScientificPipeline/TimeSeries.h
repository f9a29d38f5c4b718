// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeSeries_h
#define TimeSeries_h

#include <string>

/// Number of time steps.
constexpr int NumberOfSteps = 4;

/// The file of a time step.
std::string StepFile(int step);

/**
 * Writes the series into the current folder: 41 x 41 x 25 points of [-2, 2]^2 x [0, 2.4] with a density (two
 * drops that circle each other, point scalars "density") and a rising whirl ("velocity"). False if a
 * file cannot be written.
 */
bool WriteTimeSeries();

#endif
