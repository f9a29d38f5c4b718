// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyHeader.h"

#include "TextLines.h"

#include <sstream>
#include <stdexcept>

namespace softshadows
{
namespace
{

PlyHeader::Type TypeOf(const std::string& name)
{
  static const struct
  {
    const char* Name;
    PlyHeader::Type Is;
  } types[] = {
    { "char", PlyHeader::Type::Int8 },
    { "int8", PlyHeader::Type::Int8 },
    { "uchar", PlyHeader::Type::UInt8 },
    { "uint8", PlyHeader::Type::UInt8 },
    { "short", PlyHeader::Type::Int16 },
    { "int16", PlyHeader::Type::Int16 },
    { "ushort", PlyHeader::Type::UInt16 },
    { "uint16", PlyHeader::Type::UInt16 },
    { "int", PlyHeader::Type::Int32 },
    { "int32", PlyHeader::Type::Int32 },
    { "uint", PlyHeader::Type::UInt32 },
    { "uint32", PlyHeader::Type::UInt32 },
    { "float", PlyHeader::Type::Float32 },
    { "float32", PlyHeader::Type::Float32 },
    { "double", PlyHeader::Type::Float64 },
    { "float64", PlyHeader::Type::Float64 },
  };
  for (const auto& type : types)
  {
    if (name == type.Name)
    {
      return type.Is;
    }
  }
  throw std::runtime_error("damaged header: unknown type '" + name.substr(0, 40) + "'");
}

PlyHeader::Encoding EncodingOf(const std::string& name)
{
  if (name == "ascii")
  {
    return PlyHeader::Encoding::Ascii;
  }
  if (name == "binary_little_endian")
  {
    return PlyHeader::Encoding::LittleEndian;
  }
  if (name == "binary_big_endian")
  {
    return PlyHeader::Encoding::BigEndian;
  }
  throw std::runtime_error("damaged header: unknown format '" + name.substr(0, 40) + "'");
}

PlyHeader::Property ReadProperty(std::istream& words)
{
  PlyHeader::Property property;
  std::string type;
  words >> type;
  property.IsList = type == "list";
  if (property.IsList)
  {
    std::string countType;
    words >> countType >> type;
    property.CountType = TypeOf(countType);
  }
  property.ValueType = TypeOf(type);
  if (!(words >> property.Name))
  {
    throw std::runtime_error("damaged header: a property without a name");
  }
  return property;
}

}

//--------------------------------------------------------------------------------------------------
std::size_t PlyHeader::SizeOf(Type type)
{
  switch (type)
  {
    case Type::Int8:
    case Type::UInt8:
      return 1;
    case Type::Int16:
    case Type::UInt16:
      return 2;
    case Type::Float64:
      return 8;
    default:
      return 4;
  }
}

//--------------------------------------------------------------------------------------------------
PlyHeader ReadPlyHeader(std::istream& stream)
{
  PlyHeader header;
  std::string line;
  bool hasFormat = false;
  TextLines lines(stream);
  for (int number = 0; lines.Next(line); ++number)
  {
    std::istringstream words(line);
    std::string keyword;
    std::string name;
    words >> keyword;
    if (number == 0 && keyword != "ply")
    {
      break;
    }
    if (keyword == "format" && words >> name)
    {
      header.BodyEncoding = EncodingOf(name);
      hasFormat = true;
    }
    else if (keyword == "element")
    {
      PlyHeader::Element element;
      if (!(words >> element.Name >> element.Count) || element.Count < 0)
      {
        throw std::runtime_error("damaged header: an element without name or count");
      }
      header.Elements.push_back(element);
    }
    else if (keyword == "property" && !header.Elements.empty())
    {
      header.Elements.back().Properties.push_back(ReadProperty(words));
    }
    else if (keyword == "end_header" && hasFormat)
    {
      return header;
    }
  }
  throw std::runtime_error("no PLY file, or its header is truncated");
}

}
