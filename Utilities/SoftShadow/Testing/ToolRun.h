// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs the command-line tool in a folder of the test's own.
 */

#ifndef ToolRun_h
#define ToolRun_h

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

struct ToolResult
{
  int ExitCode = -1;
  std::string Output; ///< Standard output and errors.
};

class ToolTest : public testing::Test
{
protected:
  std::filesystem::path Folder; ///< Where the tool runs; empty at the test's start.

  void SetUp() override;
  void TearDown() override;

  /// The arguments as a shell reads them; settings such as "DISPLAY= " before the program.
  ToolResult Run(const std::string& arguments, const std::string& settings = "") const;

  void Write(const std::string& name, const std::string& text) const;
  std::string Read(const std::string& name) const;

  /// Names of all files in the folder.
  std::set<std::string> Files() const;
};

#endif
