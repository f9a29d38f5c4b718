// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * JSON values that know the line they stand on. The text is read by nlohmann-json; this keeps what
 * its own values lose.
 */

#ifndef LocatedJson_h
#define LocatedJson_h

#include <string>
#include <utility>
#include <vector>

namespace softshadows
{

struct LocatedJson
{
  enum class Kind
  {
    Null,
    Flag,
    Number,
    Text,
    List,
    Object
  };

  Kind Is = Kind::Null;
  bool Flag = false;
  double Number = 0.0;
  std::string Text;
  std::vector<LocatedJson> Items;                           ///< Of a list.
  std::vector<std::pair<std::string, LocatedJson>> Members; ///< Of an object, in file order.
  int Line = 0;                                             ///< Where the value starts.
  int KeyLine = 0; ///< Where its key stands; the value's own line in lists.

  /// The member of that name or null.
  const LocatedJson* Find(const std::string& key) const;

  /// "a number", "a list", ... for messages.
  static const char* NameOf(Kind kind);
};

/**
 * Reads JSON text (RFC 8259, UTF-8, no comments). Throws SceneError with the line for anything that
 * is no JSON, for a key given twice in an object, more than 256 keys in one, and more than 64
 * levels of nesting.
 */
LocatedJson ReadLocatedJson(const std::string& text, const std::string& fileName);

}

#endif
