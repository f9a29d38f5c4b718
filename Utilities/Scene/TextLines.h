// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lines of text as files of any system have them: ended by LF, CR LF or CR, after a byte-order mark or
 * not. The first line decides which end the others have, so that bytes after a header stay whole.
 */
#ifndef TextLines_h
#define TextLines_h

#include <istream>
#include <string>

namespace softshadows
{

class TextLines
{
public:
  /// The stream must outlive this.
  explicit TextLines(std::istream& stream)
    : Stream(stream)
  {
  }

  /// The next line, without its end. False where no line is left.
  bool Next(std::string& line);

private:
  bool First(std::string& line);

  std::istream& Stream;
  char End = '\0';
};

}

#endif
