// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a command renders: one scene file, or models without one.
 */

#ifndef SceneInput_h
#define SceneInput_h

#include "ModelScene.h"
#include "Technique.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace softshadows
{

struct SceneInput
{
  std::vector<std::string> Files;
  std::vector<std::string> ModelFolders;
  UpAxis Up = UpAxis::Y;
  int Width = 0; // 0: the scene's
  int Height = 0;

  /// Adds the arguments to a command; must outlive its parsing.
  void AddTo(CLI::App* command);

  /// Throws SceneError, and std::runtime_error if scenes and models are mixed.
  SceneDescription Read(ModelStore& models) const;
};

/// A technique and its options by name.
struct TechniqueInput
{
  std::string Name = "pcss";
  std::string Quality;              ///< None: the defaults.
  std::vector<std::string> Options; ///< NAME=VALUE

  /// Adds the arguments to a command; must outlive its parsing.
  void AddTo(CLI::App* command);

  /**
   * Those of the quality, then the options, which win. Throws std::runtime_error for unknown names,
   * qualities that the technique does not have and texts of another form.
   */
  OptionTexts GetOptions() const;
};

/// One line to the terminal for each model of which something is not shown.
void SayWhatIsNotShown(const ModelStore& models);

}

#endif
