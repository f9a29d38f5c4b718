// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// softshadow: the command-line tool. A command is one file and one line here.

#include "CommandHelp.h"
#include "CompareCommand.h"
#include "RenderCommand.h"

#ifdef SOFTSHADOWS_HAVE_RAY_TRACING
#include "BenchmarkCommand.h"
#include "ReferenceCommand.h"
#endif

#ifdef SOFTSHADOWS_HAVE_VIEWER
#include "ViewCommand.h"
#endif

#include "Technique.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

namespace
{

int Run(int argc, char** argv)
{
  CLI::App app("Soft shadows of area lights.", "softshadow");
  bool asJson = false; // read before the next, wherever it stands
  app.add_flag("--json", asJson, "With --list-techniques: for programs");
  app.add_flag_callback(
    "--list-techniques",
    [&asJson]
    {
      asJson ? softshadows::PrintTechniquesAsJson(std::cout)
             : softshadows::PrintTechniques(std::cout);
      throw CLI::Success();
    },
    "Print the techniques and their options, and end");
  softshadows::AddRenderCommand(app);
#ifdef SOFTSHADOWS_HAVE_VIEWER
  softshadows::AddViewCommand(app);
#endif
  softshadows::AddCompareCommand(app);
#ifdef SOFTSHADOWS_HAVE_RAY_TRACING
  softshadows::AddReferenceCommand(app);
  softshadows::AddBenchmarkCommand(app);
#endif
  softshadows::AddHelp(app);
  app.require_subcommand(0, 1);
  try
  {
    app.parse(argc, argv); // runs the command
  }
  catch (const CLI::RuntimeError& ended)
  {
    return ended.get_exit_code(); // a command's own verdict, which it has printed
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == EXIT_SUCCESS ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  if (app.get_subcommands().empty())
  {
    std::cerr << app.help();
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}

int main(int argc, char** argv)
{
#ifdef SIGXFSZ
  std::signal(
    SIGXFSZ, SIG_IGN); // a file too large for the user's limit is an error like a full disk
#endif
  try
  {
    return Run(argc, argv);
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    // Its own words are for programmers.
    std::cerr << "softshadow: " << error.path1().string() << ": " << error.code().message() << '\n';
    return EXIT_FAILURE;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "softshadow: there is not enough memory\n";
    return EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << "softshadow: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
