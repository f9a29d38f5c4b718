// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LocatedJson.h"

#include "SceneError.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iterator>

namespace softshadows
{
namespace
{

constexpr std::size_t DeepestJson = 64;
constexpr std::size_t MostKeys = 256; // in one object: they are searched one by one

/// How far the reader has come. JSON's tokens stand on one line each, so the line of the last
/// character that is not white space is the line of the last token, even though the reader looks
/// one character beyond a number.
struct Progress
{
  int Line = 1;
  int TokenLine = 1;

  void Pass(char character)
  {
    if (character == '\n')
    {
      ++this->Line;
    }
    else if (character != ' ' && character != '\t' && character != '\r')
    {
      this->TokenLine = this->Line;
    }
  }
};

/// Walks over the text and reports what it leaves behind.
class ObservedCharacter
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  ObservedCharacter(const char* at, Progress* progress)
    : At(at)
    , Passed(progress)
  {
  }
  reference operator*() const { return *this->At; }
  ObservedCharacter& operator++()
  {
    this->Passed->Pass(*this->At);
    ++this->At;
    return *this;
  }
  ObservedCharacter operator++(int)
  {
    ObservedCharacter before = *this;
    ++*this;
    return before;
  }
  bool operator==(const ObservedCharacter& other) const { return this->At == other.At; }
  bool operator!=(const ObservedCharacter& other) const { return this->At != other.At; }

private:
  const char* At;
  Progress* Passed;
};

/// The part of nlohmann's message that is not about positions: those are ours to tell.
std::string WithoutPosition(const std::string& message)
{
  std::size_t start = 0;
  if (!message.empty() && message[0] == '[')
  {
    start = message.find("] ");
    start = start == std::string::npos ? 0 : start + 2;
  }
  if (message.compare(start, 14, "parse error at") == 0)
  {
    const std::size_t colon = message.find(": ", start);
    start = colon == std::string::npos ? start : colon + 2;
  }
  return message.substr(start);
}

/// Builds the values from nlohmann's events, whose names are given.
class Builder
{
public:
  using json = nlohmann::json;

  Builder(const Progress& progress, std::string fileName)
    : Passed(progress)
    , FileName(std::move(fileName))
  {
  }

  LocatedJson Root;

  bool null() { return this->Add({}); }
  bool boolean(bool value)
  {
    LocatedJson node;
    node.Is = LocatedJson::Kind::Flag;
    node.Flag = value;
    return this->Add(std::move(node));
  }
  bool number_integer(json::number_integer_t value)
  {
    return this->AddNumber(static_cast<double>(value));
  }
  bool number_unsigned(json::number_unsigned_t value)
  {
    return this->AddNumber(static_cast<double>(value));
  }
  bool number_float(json::number_float_t value, const std::string&)
  {
    return this->AddNumber(value);
  }
  bool string(std::string& value)
  {
    LocatedJson node;
    node.Is = LocatedJson::Kind::Text;
    node.Text = std::move(value);
    return this->Add(std::move(node));
  }
  bool binary(json::binary_t&) { return false; } // not in JSON text
  bool start_object(std::size_t) { return this->Open(LocatedJson::Kind::Object); }
  bool start_array(std::size_t) { return this->Open(LocatedJson::Kind::List); }
  bool end_object() { return this->Close(); }
  bool end_array() { return this->Close(); }
  bool key(std::string& name)
  {
    if (this->Path.back()->Find(name))
    {
      throw SceneError({ this->FileName, this->Passed.TokenLine, name }, "key given twice");
    }
    if (this->Path.back()->Members.size() >= MostKeys)
    {
      throw SceneError({ this->FileName, this->Passed.TokenLine, name },
        "more than " + std::to_string(MostKeys) + " keys in one object");
    }
    this->Key = name;
    this->KeyLine = this->Passed.TokenLine;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error)
  {
    throw SceneError({ this->FileName, this->Passed.TokenLine, "" },
      "not valid JSON: " + WithoutPosition(error.what()));
  }

private:
  const Progress& Passed;
  std::string FileName;
  std::vector<LocatedJson*> Path; // open objects and lists, outermost first
  std::string Key;
  int KeyLine = 0;

  bool AddNumber(double value)
  {
    LocatedJson node;
    node.Is = LocatedJson::Kind::Number;
    node.Number = value;
    return this->Add(std::move(node));
  }

  bool Add(LocatedJson node)
  {
    this->Place(std::move(node));
    return true;
  }

  LocatedJson* Place(LocatedJson node)
  {
    node.Line = this->Passed.TokenLine;
    node.KeyLine = node.Line;
    if (this->Path.empty())
    {
      this->Root = std::move(node);
      return &this->Root;
    }
    LocatedJson* parent = this->Path.back();
    if (parent->Is == LocatedJson::Kind::List)
    {
      parent->Items.push_back(std::move(node));
      return &parent->Items.back();
    }
    node.KeyLine = this->KeyLine;
    parent->Members.emplace_back(std::move(this->Key), std::move(node));
    return &parent->Members.back().second;
  }

  bool Open(LocatedJson::Kind kind)
  {
    if (this->Path.size() >= DeepestJson)
    {
      throw SceneError({ this->FileName, this->Passed.TokenLine, "" },
        "lists and objects nested more than " + std::to_string(DeepestJson) + " deep");
    }
    LocatedJson node;
    node.Is = kind;
    // The pointer stays valid while it is on the path: only its own children are added until then.
    this->Path.push_back(this->Place(std::move(node)));
    return true;
  }

  bool Close()
  {
    this->Path.pop_back();
    return true;
  }
};

}

//--------------------------------------------------------------------------------------------------
const LocatedJson* LocatedJson::Find(const std::string& key) const
{
  for (const auto& member : this->Members)
  {
    if (member.first == key)
    {
      return &member.second;
    }
  }
  return nullptr;
}

//--------------------------------------------------------------------------------------------------
const char* LocatedJson::NameOf(Kind kind)
{
  switch (kind)
  {
    case Kind::Null:
      return "null";
    case Kind::Flag:
      return "true or false";
    case Kind::Number:
      return "a number";
    case Kind::Text:
      return "a text in quotes";
    case Kind::List:
      return "a list";
    case Kind::Object:
      return "an object in braces";
  }
  return "";
}

//--------------------------------------------------------------------------------------------------
LocatedJson ReadLocatedJson(const std::string& text, const std::string& fileName)
{
  Progress progress;
  Builder builder(progress, fileName);
  nlohmann::json::sax_parse(ObservedCharacter(text.data(), &progress),
    ObservedCharacter(text.data() + text.size(), &progress), &builder);
  return std::move(builder.Root);
}

}
