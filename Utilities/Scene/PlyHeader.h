// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The header of a PLY file: which elements follow, of which properties.
 */

#ifndef PlyHeader_h
#define PlyHeader_h

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace softshadows
{

struct PlyHeader
{
  enum class Encoding
  {
    Ascii,
    LittleEndian,
    BigEndian
  };

  enum class Type
  {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float32,
    Float64
  };

  struct Property
  {
    std::string Name;
    bool IsList = false;
    Type CountType = Type::UInt8; ///< Of lists.
    Type ValueType = Type::Float32;
  };

  struct Element
  {
    std::string Name;
    std::int64_t Count = 0;
    std::vector<Property> Properties;
  };

  Encoding BodyEncoding = Encoding::Ascii;
  std::vector<Element> Elements;

  /// In bytes.
  static std::size_t SizeOf(Type type);
};

/// Leaves the stream at the first byte of the body. Throws std::runtime_error for what is no header.
PlyHeader ReadPlyHeader(std::istream& stream);

}

#endif
