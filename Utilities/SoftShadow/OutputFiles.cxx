// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutputFiles.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif

namespace softshadows
{
namespace
{

namespace fs = std::filesystem;

int ProcessNumber()
{
#ifdef _WIN32
  return _getpid();
#else
  return static_cast<int>(getpid());
#endif
}

/// The same file under any name; a file that does not exist yet is known by its folder and name.
bool IsSameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(a), error) ==
    fs::weakly_canonical(fs::absolute(b), error);
}

}

//--------------------------------------------------------------------------------------------------
OutputFiles::OutputFiles(std::vector<std::string> inputs)
  : Inputs(std::move(inputs))
{
}

//--------------------------------------------------------------------------------------------------
OutputFiles::~OutputFiles()
{
  for (const auto& file : this->Files)
  {
    std::error_code error;
    fs::remove(file.first, error);
  }
}

//--------------------------------------------------------------------------------------------------
std::string OutputFiles::Add(const std::string& path)
{
  if (path.empty())
  {
    return path;
  }
  for (const std::string& input : this->Inputs)
  {
    if (IsSameFile(input, path))
    {
      throw std::runtime_error(path + ": would overwrite an input");
    }
  }
  for (const auto& file : this->Files)
  {
    if (IsSameFile(file.second, path))
    {
      throw std::runtime_error(path + ": is to be written twice");
    }
  }
  const fs::path final(path);
  std::error_code error;
  if (fs::is_directory(final, error))
  {
    throw std::runtime_error(path + ": is a folder");
  }
  const fs::path folder = final.has_parent_path() ? final.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
  {
    throw std::runtime_error(path + ": there is no folder " + folder.string());
  }
  const fs::path temporary = folder /
    ("." + final.stem().string() + "-" + std::to_string(ProcessNumber()) + "-" +
      std::to_string(this->Files.size()) + final.extension().string());
  std::ofstream trial(temporary, std::ios::binary);
  trial.close();
  if (!trial)
  {
    throw std::runtime_error(path + ": the folder cannot be written to");
  }
  this->Files.emplace_back(temporary.string(), path);
  return temporary.string();
}

//--------------------------------------------------------------------------------------------------
void OutputFiles::Commit()
{
  while (!this->Files.empty())
  {
    std::error_code error;
    fs::rename(this->Files.back().first, this->Files.back().second, error);
    if (error)
    {
      throw std::runtime_error(this->Files.back().second + ": " + error.message());
    }
    this->Files.pop_back();
  }
}

}
