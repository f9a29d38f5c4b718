// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProgressLine.h"

#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace softshadows
{
namespace
{

bool IsTerminal()
{
#ifdef _WIN32
  static const bool isTerminal = _isatty(2) != 0;
#else
  static const bool isTerminal = isatty(2) != 0;
#endif
  return isTerminal;
}

}

//--------------------------------------------------------------------------------------------------
void ShowLine(const std::string& line, bool isFinal)
{
  if (IsTerminal())
  {
    std::cerr << "\r\x1b[K" << line << (isFinal ? "\n" : "") << std::flush;
  }
  else if (isFinal)
  {
    std::cerr << line << std::endl;
  }
}

//--------------------------------------------------------------------------------------------------
void ShowBar(double share)
{
  constexpr int width = 50;
  const int percent = static_cast<int>(100.0 * share);
  const int full = width * percent / 100;
  if (IsTerminal())
  {
    ShowLine("[" + std::string(full, '#') + std::string(width - full, '.') + "] " +
        std::to_string(percent) + " %",
      share >= 1.0);
  }
}

}
