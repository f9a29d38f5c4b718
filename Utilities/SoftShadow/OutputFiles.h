// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that are written all or none.
 */

#ifndef OutputFiles_h
#define OutputFiles_h

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace softshadows
{

/**
 * Files are written under other names beside their places and moved there by Commit. Without Commit
 * nothing is left of them, and what was there before stays, also where a signal ends the process.
 * What a link points at is replaced, not the link. Devices, pipes and what the process has open (a
 * standard output that is a file) are never replaced: Commit writes at their end, before it moves
 * anything.
 */
class OutputFiles
{
public:
  /// Inputs are files that no output may overwrite.
  explicit OutputFiles(std::vector<std::string> inputs);
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /**
   * The name, of the same ending, to write the file under. No name gives no name. Throws
   * std::runtime_error if the folder does not exist or cannot be written to, if a folder stands in
   * the file's place, and if the file is an input or added already.
   */
  std::string Add(const std::string& path);

  /// Runs what writes files under the names that Add gave; its errors speak of the files' own names.
  void Write(const std::function<void()>& write) const;

  /// Moves all files to their places. Throws std::runtime_error.
  void Commit();

private:
  std::vector<std::string> Inputs;
  std::vector<std::pair<std::string, std::string>> Files; // temporary, final
};

}

#endif
