// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options of softshadow benchmark.
 */

#ifndef BenchmarkOptions_h
#define BenchmarkOptions_h

#include "BenchmarkRunner.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace softshadows
{

struct BenchmarkOptions
{
  std::string Scenes;
  std::string Output = "softshadow-benchmark";
  std::string References; ///< Empty: below Output.
  std::vector<std::string> ModelFolders;
  std::vector<std::string> Only;
  std::vector<std::string> Techniques;
  std::vector<std::string> Contestants;
  std::vector<std::string> Sweeps;
  bool Quick = false;
  bool List = false;
  bool NoPictures = false;
  bool ReferencesOnly = false;
  int Width = 0;            ///< 0: the scene's.
  int Height = 0;           ///< 0: the scene's.
  int Rounds = 0;           ///< 0: by Quick.
  double Seconds = 0.0;     ///< 0: by Quick.
  double Budget = 0.0;      ///< 0: by Quick.
  int ReferenceSamples = 0; ///< 0: by Quick.
  std::string MeshFolder;
  std::string Paper;
  double PaperScale = 1.0;
};

void AddBenchmarkOptions(CLI::App& command, BenchmarkOptions& options);

/// Seconds for all scenes or tables together; 0 for no limit.
double GetBudget(const BenchmarkOptions& options);

BenchmarkSettings GetBenchmarkSettings(const BenchmarkOptions& options);

}

#endif
