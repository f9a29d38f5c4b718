// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewCommand.h"

#include "SceneInput.h"
#include "VirtualDisplay.h"

#include "ViewerWindow.h"

#include <filesystem>
#include <memory>
#include <stdexcept>

namespace softshadows
{
namespace
{

struct ViewOptions
{
  SceneInput Scene;
  TechniqueInput Technique;
  std::string Output = ".";
};

//--------------------------------------------------------------------------------------------------
void View(const ViewOptions& options)
{
  // A menu and a scene beside it.
  constexpr int defaultWidth = 1200;
  constexpr int defaultHeight = 800;

  if (!std::filesystem::is_directory(options.Output))
  {
    throw std::runtime_error("--output " + options.Output + ": there is no such folder");
  }
  ModelStore models(options.Scene.ModelFolders);
  SceneInput input = options.Scene;
  input.Width = 0; // of the window, not of the scene's image
  input.Height = 0;
  ViewerState state(input.Read(models), options.Technique.Name, options.Technique.GetOptions());
  if (!HasDisplay())
  {
    throw std::runtime_error("view opens a window, and there is no display: set DISPLAY, or make "
                             "pictures without one with softshadow render");
  }
  ViewerPaths paths;
  paths.Output = options.Output;
  paths.Stem = std::filesystem::path(options.Scene.Files.front()).stem().string();
  paths.ModelFolders = options.Scene.ModelFolders;
  ViewerWindow window(state, models, paths,
    options.Scene.Width > 0 ? options.Scene.Width : defaultWidth,
    options.Scene.Height > 0 ? options.Scene.Height : defaultHeight);
  SayWhatIsNotShown(models);
  window.Run();
}

}

//--------------------------------------------------------------------------------------------------
void AddViewCommand(CLI::App& app)
{
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view",
    "Show a scene file or models (ply, obj, stl, vtp, glb, gltf) in a window: techniques, "
    "settings, "
    "light and views by keys and a menu. h shows what the keys do.");
  options->Scene.AddTo(command);
  options->Technique.AddTo(command);
  command->add_option("--output", options->Output, "Folder in which the window's keys save")
    ->type_name("DIR")
    ->capture_default_str();
  command->get_option("--width")->description("Pixels of the window; 1200 by default");
  command->get_option("--height")->description("Pixels of the window; 800 by default");
  command->callback([options] { View(*options); });
}

}
