// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ToolRun.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

#include <sys/wait.h>

namespace fs = std::filesystem;

void ToolTest::SetUp()
{
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  this->Folder = fs::path(SOFTSHADOWS_TEST_OUTPUT_DIR) /
    (std::string("Tool-") + test->test_suite_name() + "-" + test->name());
  fs::remove_all(this->Folder);
  fs::create_directories(this->Folder);
}

void ToolTest::TearDown()
{
  if (!this->HasFailure())
  {
    fs::remove_all(this->Folder);
  }
}

ToolResult ToolTest::Run(const std::string& arguments, const std::string& settings) const
{
  ToolResult result;
  const std::string command = "cd '" + this->Folder.string() + "' && env " + settings + " '" +
    SOFTSHADOWS_TOOL + "' " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe)
  {
    ADD_FAILURE() << "cannot run " << command;
    return result;
  }
  std::array<char, 4096> buffer;
  for (std::size_t count = 0; (count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
  {
    result.Output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  result.ExitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

void ToolTest::Write(const std::string& name, const std::string& text) const
{
  std::ofstream(this->Folder / name, std::ios::binary) << text;
}

std::string ToolTest::Read(const std::string& name) const
{
  std::ostringstream text;
  text << std::ifstream(this->Folder / name, std::ios::binary).rdbuf();
  return text.str();
}

std::set<std::string> ToolTest::Files() const
{
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(this->Folder))
  {
    names.insert(entry.path().filename().string());
  }
  return names;
}
