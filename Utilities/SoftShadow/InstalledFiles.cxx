// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InstalledFiles.h"

#include <filesystem>
#include <system_error>

#ifdef _WIN32
#include <windows.h>
#endif

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
// The running program's file; empty if the system does not tell.
std::filesystem::path FindProgram()
{
#ifdef _WIN32
  wchar_t name[MAX_PATH];
  const DWORD length = GetModuleFileNameW(nullptr, name, MAX_PATH);
  return length < MAX_PATH ? std::filesystem::path(name, name + length) : std::filesystem::path();
#else
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
#endif
}

}

//--------------------------------------------------------------------------------------------------
std::string FindBenchmarkScenes()
{
  const std::filesystem::path installed =
    (FindProgram().parent_path() / SOFTSHADOWS_INSTALLED_SCENES).lexically_normal();
  std::error_code error;
  return std::filesystem::is_directory(installed, error) ? installed.string()
                                                         : SOFTSHADOWS_BENCHMARK_SCENES;
}

}
