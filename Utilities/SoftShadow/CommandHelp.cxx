// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CommandHelp.h"

#include "Suggestion.h"

#include "vtkSoftShadowsVersion.h"
#include "vtkVersionMacros.h"

#include <string>
#include <vector>

namespace softshadows
{
namespace
{

const char* const Examples = R"(Examples:
  softshadow render bunny.ply -o bunny.png
      a model on a ground plane under a square lamp
  softshadow view bunny.ply
      the same in a window; h shows what the keys do
  softshadow render scene.json -o picture.png --technique sampled --quality best
      a scene file, with an error of 0.008 or less on the bundled scene
  softshadow render scene.json --technique pcss --option split=2 --visibility v.exr
      the visibility of every light and pixel as numbers
  softshadow reference scene.json -o truth.exr && softshadow compare truth.exr v.exr --diff d.png
      how far that is from ray tracing
  softshadow benchmark --quick --output report
      speed against error of every technique on this machine
  softshadow COMMAND --help
      all options of a command)";

//--------------------------------------------------------------------------------------------------
/// The words that the command knows at the place of the given one: its options, or its commands.
std::vector<std::string> KnownWords(const CLI::App& command, bool isOption)
{
  std::vector<std::string> known;
  if (!isOption)
  {
    for (const CLI::App* child : command.get_subcommands({}))
    {
      known.push_back(child->get_name());
    }
    return known;
  }
  for (const CLI::Option* option : command.get_options())
  {
    for (const std::string& name : option->get_lnames())
    {
      known.push_back("--" + name);
    }
  }
  return known;
}

//--------------------------------------------------------------------------------------------------
/// The command whose arguments were read when the error arose.
const CLI::App& RunningCommand(const CLI::App& app)
{
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  return parsed.empty() ? app : *parsed.front();
}

//--------------------------------------------------------------------------------------------------
std::string Explain(const CLI::App* app, const CLI::Error& error)
{
  const CLI::App& command = RunningCommand(*app);
  std::string text = std::string("softshadow: ") + error.what() + "\n";
  for (const std::string& word : app->remaining(true))
  {
    const bool isOption = word.rfind("--", 0) == 0;
    const std::string near =
      NearestWord(word.substr(0, word.find('=')), KnownWords(command, isOption));
    if (!near.empty())
    {
      text += "'" + word + "': did you mean '" + near + "'?\n";
    }
  }
  const std::string name = &command == app ? "" : " " + command.get_name();
  return text + "Run softshadow" + name + " --help for more.\n";
}

//--------------------------------------------------------------------------------------------------
// Newer versions of the library would join the examples' lines.
template <typename Formatter>
auto KeepLines(Formatter& formatter, int) -> decltype(formatter.enable_footer_formatting(false))
{
  formatter.enable_footer_formatting(false);
}

template <typename Formatter>
void KeepLines(Formatter&, long)
{
}

}

//--------------------------------------------------------------------------------------------------
void AddHelp(CLI::App& app)
{
  KeepLines(*app.get_formatter(), 0);
  for (CLI::App* command : app.get_subcommands({}))
  {
    command->group("Subcommands"); // versions differ in the name they give it
  }
  app.set_version_flag(
    "--version", "softshadow " SOFTSHADOWS_VERSION " (VTK " VTK_VERSION ")", "Print the version");
  app.footer(Examples);
  app.failure_message(Explain);
}

}
