// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GltfDocument.h"

#include "GltfMessages.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace softshadows
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int DeepestNesting = 100;
constexpr std::int64_t LargestWholeNumber = std::int64_t(1) << 53;
/// Rows of an accessor without data, which nothing in the file bounds.
constexpr std::int64_t MostZeros = std::int64_t(1) << 24;

std::string Shortened(const std::string& text)
{
  constexpr std::size_t longest = 80;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

/// glTF is little-endian.
std::uint64_t LittleEndian(const char* bytes, int size)
{
  std::uint64_t value = 0;
  for (int i = size - 1; i >= 0; --i)
  {
    value = (value << 8) | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

std::string ReadBytes(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  if (!stream)
  {
    throw std::runtime_error("cannot be read");
  }
  return bytes;
}

/// One of the 64 digits, or -1.
int Base64Digit(char c)
{
  static const std::string digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t place = digits.find(c);
  return place == std::string::npos ? -1 : static_cast<int>(place);
}

std::string DecodeBase64(const std::string& text, std::size_t first, const std::string& name)
{
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = first; i < text.size() && text[i] != '='; ++i)
  {
    const int digit = Base64Digit(text[i]);
    if (digit < 0)
    {
      ThrowDamaged("the data of " + name + " is not base64");
    }
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>((bits >> count) & 0xff);
    }
  }
  return bytes;
}

/// "%20" is a space.
std::string DecodePercent(const std::string& uri)
{
  const auto hexDigit = [](char c) -> int
  {
    static const std::string digits = "0123456789abcdefABCDEF";
    const std::size_t place = digits.find(c);
    return place == std::string::npos ? -1 : static_cast<int>(place < 16 ? place : place - 6);
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const bool isCode =
      uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 && hexDigit(uri[i + 2]) >= 0;
    text += isCode ? static_cast<char>(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2])) : uri[i];
    i += isCode ? 2 : 0;
  }
  return text;
}

template <typename T>
double As(const char* bytes)
{
  const std::uint64_t bits = LittleEndian(bytes, sizeof(T));
  T value;
  if constexpr (sizeof(T) == 1)
  {
    const auto part = static_cast<std::uint8_t>(bits);
    std::memcpy(&value, &part, sizeof(T));
  }
  else if constexpr (sizeof(T) == 2)
  {
    const auto part = static_cast<std::uint16_t>(bits);
    std::memcpy(&value, &part, sizeof(T));
  }
  else
  {
    const auto part = static_cast<std::uint32_t>(bits);
    std::memcpy(&value, &part, sizeof(T));
  }
  return static_cast<double>(value);
}

struct ComponentKind
{
  std::int64_t Type; ///< OpenGL's number of it.
  int Size;
  double Largest; ///< 0 for float.
  double (*Read)(const char*);
};

const ComponentKind& KindOf(std::int64_t type, const std::string& name)
{
  static const ComponentKind kinds[] = { { 5120, 1, 127.0, As<std::int8_t> },
    { 5121, 1, 255.0, As<std::uint8_t> }, { 5122, 2, 32767.0, As<std::int16_t> },
    { 5123, 2, 65535.0, As<std::uint16_t> }, { 5125, 4, 4294967295.0, As<std::uint32_t> },
    { 5126, 4, 0.0, As<float> } };
  const auto* const kind = std::find_if(std::begin(kinds), std::end(kinds),
    [type](const ComponentKind& candidate) { return candidate.Type == type; });
  if (kind == std::end(kinds))
  {
    ThrowDamaged(name + " has the unknown component type " + std::to_string(type));
  }
  return *kind;
}

int ComponentsOf(const std::string& type, const std::string& name)
{
  static const std::map<std::string, int> components = { { "SCALAR", 1 }, { "VEC2", 2 },
    { "VEC3", 3 }, { "VEC4", 4 } };
  const auto found = components.find(type);
  if (found == components.end())
  {
    ThrowDamaged(name + " is of the type '" + Shortened(type) + "', which cannot be here");
  }
  return found->second;
}

}

//--------------------------------------------------------------------------------------------------
GltfDocument::GltfDocument(const std::string& path)
  : Folder(fs::path(path).parent_path().string())
{
  const std::string bytes = ReadBytes(path);
  std::string text;
  if (bytes.compare(0, 4, "glTF") == 0)
  {
    this->SplitContainer(bytes, text);
  }
  this->Parse(text.empty() ? bytes : text);

  const std::string version = Text(Object(this->Json, "the file", "asset"), "asset", "version");
  if (version.compare(0, 2, "2.") != 0)
  {
    throw std::runtime_error(version.empty()
        ? "is no glTF: it has no asset.version"
        : "is of glTF " + Shortened(version) + ": only 2.0 can be read");
  }
}

//--------------------------------------------------------------------------------------------------
void GltfDocument::SplitContainer(const std::string& bytes, std::string& text)
{
  constexpr std::size_t headerSize = 12;
  constexpr std::size_t chunkHeaderSize = 8;
  constexpr std::uint64_t jsonChunk = 0x4E4F534A;
  constexpr std::uint64_t binaryChunk = 0x004E4942;
  if (bytes.size() < headerSize)
  {
    throw std::runtime_error("truncated: its header is cut off");
  }
  const std::uint64_t version = LittleEndian(bytes.data() + 4, 4);
  if (version != 2)
  {
    throw std::runtime_error(
      "is a .glb of version " + std::to_string(version) + ": only 2 can be read");
  }
  const std::uint64_t length = LittleEndian(bytes.data() + 8, 4);
  if (length > bytes.size())
  {
    throw std::runtime_error("truncated: it has " + std::to_string(bytes.size()) + " of its " +
      std::to_string(length) + " bytes");
  }
  for (std::size_t at = headerSize; at + chunkHeaderSize <= length;)
  {
    const std::uint64_t size = LittleEndian(bytes.data() + at, 4);
    const std::uint64_t kind = LittleEndian(bytes.data() + at + 4, 4);
    at += chunkHeaderSize;
    if (size > length - at)
    {
      ThrowDamaged("a chunk is longer than the file");
    }
    if (kind == jsonChunk && text.empty())
    {
      text = bytes.substr(at, size);
    }
    else if (kind == binaryChunk && !this->HasBinary)
    {
      this->HasBinary = true;
      this->Binary = bytes.substr(at, size);
    }
    at += size;
  }
  if (text.empty())
  {
    ThrowDamaged("it has no JSON chunk");
  }
}

//--------------------------------------------------------------------------------------------------
void GltfDocument::Parse(const std::string& text)
{
  const auto checkDepth = [](int depth, json::parse_event_t, json&)
  {
    if (depth > DeepestNesting)
    {
      ThrowDamaged("its JSON is nested too deeply");
    }
    return true;
  };
  try
  {
    this->Json = json::parse(text, checkDepth);
  }
  catch (const json::exception& error)
  {
    const std::string message = error.what();
    const std::size_t start = message.find("] ");
    throw std::runtime_error("is no glTF, or damaged: " +
      (start == std::string::npos ? message : message.substr(start + 2)));
  }
  if (!this->Json.is_object())
  {
    throw std::runtime_error("is no glTF: its JSON is not an object");
  }
}

//--------------------------------------------------------------------------------------------------
std::int64_t GltfDocument::WholeNumber(
  const json& element, const std::string& name, const char* key, std::int64_t valueIfAbsent)
{
  const auto found = element.find(key);
  if (found == element.end())
  {
    return valueIfAbsent;
  }
  const double value = found->is_number() ? found->get<double>() : -1.0;
  if (!(value >= 0.0) || value > static_cast<double>(LargestWholeNumber) ||
    value != std::floor(value))
  {
    ThrowDamaged("'" + std::string(key) + "' of " + name + " is not a whole number");
  }
  return static_cast<std::int64_t>(value);
}

//--------------------------------------------------------------------------------------------------
std::string GltfDocument::Text(const json& element, const std::string& name, const char* key)
{
  const auto found = element.find(key);
  if (found == element.end())
  {
    return "";
  }
  if (!found->is_string())
  {
    ThrowDamaged("'" + std::string(key) + "' of " + name + " is not a text");
  }
  return found->get<std::string>();
}

//--------------------------------------------------------------------------------------------------
const json& GltfDocument::List(const json& element, std::string_view name, const char* key)
{
  static const json none = json::array();
  const auto found = element.find(key);
  if (found != element.end() && !found->is_array())
  {
    ThrowDamaged("'" + std::string(key) + "' of " + std::string(name) + " is not a list");
  }
  return found == element.end() ? none : *found;
}

//--------------------------------------------------------------------------------------------------
const json& GltfDocument::Object(const json& element, std::string_view name, const char* key)
{
  static const json none = json::object();
  const auto found = element.find(key);
  if (found != element.end() && !found->is_object())
  {
    ThrowDamaged("'" + std::string(key) + "' of " + std::string(name) + " is not an object");
  }
  return found == element.end() ? none : *found;
}

//--------------------------------------------------------------------------------------------------
bool GltfDocument::Numbers(
  const json& element, const std::string& name, const char* key, int count, double* values)
{
  const json& list = List(element, name, key);
  if (list.empty() && element.find(key) == element.end())
  {
    return false;
  }
  if (list.size() != static_cast<std::size_t>(count) ||
    !std::all_of(list.begin(), list.end(), [](const json& item) { return item.is_number(); }))
  {
    ThrowDamaged(
      "'" + std::string(key) + "' of " + name + " is not " + std::to_string(count) + " numbers");
  }
  std::transform(
    list.begin(), list.end(), values, [](const json& item) { return item.get<double>(); });
  return true;
}

//--------------------------------------------------------------------------------------------------
std::int64_t GltfDocument::CountOf(const std::string& list) const
{
  return static_cast<std::int64_t>(List(this->Json, "the file", list.c_str()).size());
}

//--------------------------------------------------------------------------------------------------
const json& GltfDocument::Get(const std::string& list, std::int64_t index) const
{
  const json& elements = List(this->Json, "the file", list.c_str());
  if (index < 0 || index >= static_cast<std::int64_t>(elements.size()))
  {
    ThrowDamaged(NameOfElement(list, index) + " is asked for, but there are " +
      std::to_string(elements.size()));
  }
  const json& element = elements[static_cast<std::size_t>(index)];
  if (!element.is_object())
  {
    ThrowDamaged(NameOfElement(list, index) + " is not an object");
  }
  return element;
}

//--------------------------------------------------------------------------------------------------
const std::string& GltfDocument::GetBuffer(std::int64_t index)
{
  const auto read = this->Buffers.find(index);
  if (read != this->Buffers.end())
  {
    return read->second;
  }
  const std::string name = NameOfElement("buffers", index);
  const json& buffer = this->Get("buffers", index);
  const std::string uri = Text(buffer, name, "uri");
  std::string bytes;
  if (!uri.empty())
  {
    bytes = this->ReadFileOfBuffer(uri, name);
  }
  else if (index == 0 && this->HasBinary)
  {
    bytes = this->Binary;
  }
  else
  {
    ThrowDamaged(name + " has no data");
  }
  const std::int64_t length = WholeNumber(buffer, name, "byteLength", 0);
  if (length > static_cast<std::int64_t>(bytes.size()))
  {
    throw std::runtime_error("truncated: " + name + " has " + std::to_string(bytes.size()) +
      " of its " + std::to_string(length) + " bytes");
  }
  bytes.resize(static_cast<std::size_t>(length));
  return this->Buffers[index] = bytes;
}

//--------------------------------------------------------------------------------------------------
std::string GltfDocument::ReadFileOfBuffer(const std::string& uri, const std::string& name) const
{
  if (uri.compare(0, 5, "data:") == 0)
  {
    static const std::string mark = ";base64,";
    const std::size_t place = uri.find(mark);
    if (place == std::string::npos || place > uri.find(','))
    {
      ThrowDamaged("the data of " + name + " is not base64");
    }
    return DecodeBase64(uri, place + mark.size(), name);
  }
  if (uri.find("://") != std::string::npos)
  {
    throw std::runtime_error("needs '" + Shortened(uri) + "' (" + name + "), which is not fetched");
  }
  const std::string relative = DecodePercent(uri);
  const fs::path path = fs::path(this->Folder) / relative;
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    throw std::runtime_error(
      "needs '" + Shortened(relative) + "' (" + name + "), and there is no such file");
  }
  try
  {
    return ReadBytes(path.string());
  }
  catch (const std::runtime_error&)
  {
    throw std::runtime_error(
      "needs '" + Shortened(relative) + "' (" + name + "), which cannot be read");
  }
}

//--------------------------------------------------------------------------------------------------
std::int64_t GltfDocument::CountRows(std::int64_t index) const
{
  return WholeNumber(this->Get("accessors", index), NameOfElement("accessors", index), "count", 0);
}

//--------------------------------------------------------------------------------------------------
GltfNumbers GltfDocument::ReadAccessor(std::int64_t index, bool normalize)
{
  const std::string name = NameOfElement("accessors", index);
  const json& accessor = this->Get("accessors", index);
  const auto normalized = accessor.find("normalized");
  Layout layout;
  layout.View = WholeNumber(accessor, name, "bufferView", -1);
  layout.Offset = WholeNumber(accessor, name, "byteOffset", 0);
  layout.ComponentType = WholeNumber(accessor, name, "componentType", 0);
  layout.Components = ComponentsOf(Text(accessor, name, "type"), name);
  layout.Count = this->CountRows(index);
  layout.Normalize = normalize || (normalized != accessor.end() && *normalized == true);

  GltfNumbers numbers;
  numbers.Count = layout.Count;
  numbers.Components = layout.Components;
  if (layout.View >= 0)
  {
    numbers.Values = this->ReadView(layout, name);
  }
  else if (layout.Count <= MostZeros)
  {
    numbers.Values.resize(static_cast<std::size_t>(layout.Count * layout.Components), 0.0);
  }
  else
  {
    ThrowDamaged(name + " has no data for " + std::to_string(layout.Count) + " elements");
  }
  const json& sparse = Object(accessor, name, "sparse");
  if (!sparse.empty())
  {
    this->ReplaceSparse(sparse, name + ".sparse", layout, numbers.Values);
  }
  return numbers;
}

//--------------------------------------------------------------------------------------------------
std::vector<double> GltfDocument::ReadView(const Layout& layout, const std::string& name)
{
  const std::string viewName = NameOfElement("bufferViews", layout.View);
  const json& view = this->Get("bufferViews", layout.View);
  const std::string& buffer = this->GetBuffer(WholeNumber(view, viewName, "buffer", -1));
  const std::int64_t viewStart = WholeNumber(view, viewName, "byteOffset", 0);
  const std::int64_t viewLength = WholeNumber(view, viewName, "byteLength", 0);
  if (viewStart + viewLength > static_cast<std::int64_t>(buffer.size()))
  {
    ThrowDamaged(viewName + " ends outside of its buffer");
  }
  const ComponentKind& kind = KindOf(layout.ComponentType, name);
  const std::int64_t rowSize = std::int64_t(kind.Size) * layout.Components;
  const std::int64_t stride =
    layout.MayHaveStride ? WholeNumber(view, viewName, "byteStride", rowSize) : rowSize;
  if (stride < rowSize)
  {
    ThrowDamaged("byteStride of " + viewName + " is less than a row of " + name);
  }
  if (layout.Count == 0)
  {
    return {};
  }
  // In this order no number grows beyond what it is compared with.
  const std::int64_t room = viewLength - layout.Offset - rowSize;
  if (room < 0 || layout.Count - 1 > room / stride)
  {
    ThrowDamaged(name + " ends outside of " + viewName);
  }
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(layout.Count * layout.Components));
  for (std::int64_t row = 0; row < layout.Count; ++row)
  {
    const char* bytes = buffer.data() + viewStart + layout.Offset + row * stride;
    for (int i = 0; i < layout.Components; ++i)
    {
      const double value = kind.Read(bytes + std::size_t(i) * kind.Size);
      values.push_back(
        layout.Normalize && kind.Largest > 0.0 ? std::max(value / kind.Largest, -1.0) : value);
    }
  }
  return values;
}

//--------------------------------------------------------------------------------------------------
void GltfDocument::ReplaceSparse(
  const json& sparse, const std::string& name, Layout layout, std::vector<double>& values)
{
  const std::int64_t count = layout.Count;
  layout.Count = WholeNumber(sparse, name, "count", 0);
  layout.MayHaveStride = false;
  const auto read = [&](const char* key, Layout part)
  {
    const json& element = Object(sparse, name, key);
    const std::string partName = name + "." + key;
    part.View = WholeNumber(element, partName, "bufferView", -1);
    part.Offset = WholeNumber(element, partName, "byteOffset", 0);
    part.ComponentType = WholeNumber(element, partName, "componentType", part.ComponentType);
    return this->ReadView(part, partName);
  };
  Layout indexLayout = layout;
  indexLayout.Components = 1;
  indexLayout.Normalize = false;
  const std::vector<double> places = read("indices", indexLayout);
  const std::vector<double> replacements = read("values", layout);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (!(places[i] >= 0.0 && places[i] < static_cast<double>(count)))
    {
      ThrowDamaged(name + " replaces an element that does not exist");
    }
    std::copy_n(replacements.begin() + static_cast<std::ptrdiff_t>(i) * layout.Components,
      layout.Components,
      values.begin() + static_cast<std::ptrdiff_t>(places[i]) * layout.Components);
  }
}

}
