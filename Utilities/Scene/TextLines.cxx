// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextLines.h"

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
bool TextLines::Next(std::string& line)
{
  if (this->End == '\0')
  {
    return this->First(line);
  }
  if (!std::getline(this->Stream, line, this->End))
  {
    return false;
  }
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return true;
}

//--------------------------------------------------------------------------------------------------
bool TextLines::First(std::string& line)
{
  line.clear();
  this->End = '\n';
  char character = '\0';
  bool found = false;
  while (this->Stream.get(character))
  {
    found = true;
    if (character == '\n')
    {
      break;
    }
    if (character == '\r')
    {
      if (this->Stream.peek() == '\n')
      {
        this->Stream.get();
      }
      else
      {
        this->End = '\r';
      }
      break;
    }
    line += character;
  }
  if (line.compare(0, 3, "\xef\xbb\xbf") == 0)
  {
    line.erase(0, 3); // the byte-order mark
  }
  return found;
}

}
