// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutputFiles.h"

#include "UnfinishedFiles.h"

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

/// What the process has open: "/dev/stdout" may lead to a file, and is none that could be replaced.
bool IsOpenFile(const fs::path& path)
{
  std::error_code error;
  const std::string folder = fs::weakly_canonical(fs::absolute(path).parent_path(), error).string();
  return folder.rfind("/proc/", 0) == 0 || folder == "/dev/fd";
}

/// Where the file really is: what a link points at is replaced, not the link, even if it is not there
/// yet. Links end at what the process has open.
fs::path Resolve(const std::string& path)
{
  constexpr int mostLinks = 40; // as on Linux
  fs::path place = path;
  std::error_code error;
  for (int i = 0; i < mostLinks && !IsOpenFile(place) && fs::is_symlink(place, error); ++i)
  {
    const fs::path target = fs::read_symlink(place, error);
    if (error)
    {
      return place;
    }
    place = place.parent_path() / target; // an absolute target replaces it all
  }
  return place;
}

/// A device, a pipe or what is open: it is written into, never replaced.
bool IsStream(const fs::path& path)
{
  std::error_code error;
  return IsOpenFile(path) || (fs::exists(path, error) && !fs::is_regular_file(path, error));
}

void CopyInto(const std::string& file, const std::string& stream)
{
  std::ifstream from(file, std::ios::binary);
  std::ofstream to(stream, std::ios::binary | std::ios::app); // keeps what an open file holds
  to << from.rdbuf();
  to.close();
  if (!from || !to)
  {
    throw std::runtime_error(stream + ": cannot be written");
  }
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
    ForgetUnfinished(file.first);
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
  const fs::path final = Resolve(path);
  std::error_code error;
  if (fs::is_directory(final, error))
  {
    throw std::runtime_error(path + ": is a folder");
  }
  fs::path folder = final.has_parent_path() ? final.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
  {
    throw std::runtime_error(path + ": there is no folder " + folder.string());
  }
  if (IsStream(final))
  {
    folder = fs::temp_directory_path();
  }
  const fs::path temporary = folder /
    ("." + final.stem().string() + "-" + std::to_string(ProcessNumber()) + "-" +
      std::to_string(this->Files.size()) + fs::path(path).extension().string());
  RememberUnfinished(temporary.string());
  std::ofstream trial(temporary, std::ios::binary);
  trial.close();
  if (!trial)
  {
    ForgetUnfinished(temporary.string());
    throw std::runtime_error(path + ": the folder cannot be written to");
  }
  this->Files.emplace_back(temporary.string(), final.string());
  return temporary.string();
}

//--------------------------------------------------------------------------------------------------
void OutputFiles::Write(const std::function<void()>& write) const
{
  try
  {
    write();
  }
  catch (const std::runtime_error& error)
  {
    std::string message = error.what();
    for (const auto& file : this->Files)
    {
      const std::size_t place = message.find(file.first);
      if (place != std::string::npos)
      {
        message.replace(place, file.first.size(), file.second);
      }
    }
    throw std::runtime_error(message);
  }
}

//--------------------------------------------------------------------------------------------------
void OutputFiles::Commit()
{
  // Streams first: they may be full, and then nothing else is written.
  for (const auto& file : this->Files)
  {
    if (IsStream(file.second))
    {
      CopyInto(file.first, file.second);
    }
  }
  while (!this->Files.empty())
  {
    const auto& file = this->Files.back();
    std::error_code error;
    if (IsStream(file.second))
    {
      fs::remove(file.first, error);
    }
    else
    {
      fs::rename(file.first, file.second, error);
    }
    if (error)
    {
      throw std::runtime_error(file.second + ": " + error.message());
    }
    ForgetUnfinished(file.first);
    this->Files.pop_back();
  }
}

}
