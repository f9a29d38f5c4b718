// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkTechniques.h
 * @brief The techniques of the project, as plans and contestants need them.
 */

#ifndef SoftShadowsBenchmark_BenchmarkTechniques_h
#define SoftShadowsBenchmark_BenchmarkTechniques_h

#include "BenchmarkPlan.h"

namespace softshadows
{

/// All there are, and the names of their options.
std::vector<KnownTechnique> ListTechniques();

/// Throws std::runtime_error for techniques and options that do not exist (see TechniqueFactory).
vtkSmartPointer<vtkSoftShadowPass> CreateContestantPass(
  const std::string& technique, const TechniqueOptions& options);

}

#endif
