// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MachineContext.h
 * @brief On what a run took place.
 */

#ifndef SoftShadowsBenchmark_MachineContext_h
#define SoftShadowsBenchmark_MachineContext_h

#include "BenchmarkResults.h"

namespace softshadows
{

/// Opens a window for a moment, to ask OpenGL for its name.
BenchmarkContext DescribeMachine(const std::string& version);

}

#endif
