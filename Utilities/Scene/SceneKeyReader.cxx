// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneKeyReader.h"

#include "SceneError.h"
#include "Suggestion.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace softshadows
{
namespace
{

bool IsWithin(double value, const Range& range)
{
  return (range.WithoutLeast ? value > range.Least : value >= range.Least) &&
    (range.WithoutMost ? value < range.Most : value <= range.Most);
}

/// As short as it can be without becoming another number.
std::string Spell(double value)
{
  std::ostringstream text;
  text.precision(6);
  text << value;
  if (std::strtod(text.str().c_str(), nullptr) != value) // stod throws for the smallest numbers
  {
    text.str("");
    text.precision(std::numeric_limits<double>::max_digits10);
    text << value;
  }
  return text.str();
}

/// "greater than 0 and at most 1"
std::string Spell(const Range& range)
{
  std::string text;
  if (std::isfinite(range.Least))
  {
    text += (range.WithoutLeast ? "greater than " : "at least ") + Spell(range.Least);
  }
  if (std::isfinite(range.Most))
  {
    text += text.empty() ? "" : " and ";
    text += (range.WithoutMost ? "less than " : "at most ") + Spell(range.Most);
  }
  return text;
}

}

//--------------------------------------------------------------------------------------------------
KeyReader::KeyReader(const LocatedJson& node, const std::string& fileName, const std::string& path)
  : Node(&node)
  , FileName(fileName)
  , Path(path)
{
  this->CheckKind(path, node, LocatedJson::Kind::Object);
}

//--------------------------------------------------------------------------------------------------
void KeyReader::operator()(const char* key, bool& value, Range) const
{
  if (const LocatedJson* found = this->FindOfKind(key, LocatedJson::Kind::Flag))
  {
    value = found->Flag;
  }
}

//--------------------------------------------------------------------------------------------------
void KeyReader::operator()(const char* key, int& value, Range range) const
{
  const LocatedJson* found = this->Node->Find(key);
  if (!found)
  {
    return;
  }
  const std::string path = this->PathOf(key);
  const double number = this->ReadNumber(path, *found, range);
  if (number != std::floor(number) || std::abs(number) > std::numeric_limits<int>::max())
  {
    throw SceneError(
      { this->FileName, found->Line, path }, "must be a whole number, is " + Spell(number));
  }
  value = static_cast<int>(number);
}

//--------------------------------------------------------------------------------------------------
void KeyReader::operator()(const char* key, double& value, Range range) const
{
  if (const LocatedJson* found = this->Node->Find(key))
  {
    value = this->ReadNumber(this->PathOf(key), *found, range);
  }
}

//--------------------------------------------------------------------------------------------------
void KeyReader::operator()(const char* key, std::string& value, Range) const
{
  if (const LocatedJson* found = this->FindOfKind(key, LocatedJson::Kind::Text))
  {
    value = found->Text;
  }
}

//--------------------------------------------------------------------------------------------------
void KeyReader::operator()(const char* key, LightShape& value, Range) const
{
  const LocatedJson* found = this->FindOfKind(key, LocatedJson::Kind::Text);
  if (!found)
  {
    return;
  }
  std::vector<std::string> known;
  for (const char* name : LightShapeNames)
  {
    if (found->Text == name)
    {
      value = static_cast<LightShape>(known.size());
      return;
    }
    known.emplace_back(name);
  }
  this->FailUnknown(key, "shape", found->Text, known);
}

//--------------------------------------------------------------------------------------------------
KeyReader KeyReader::Object(const char* key) const
{
  this->Require(key);
  return KeyReader(*this->Node->Find(key), this->FileName, this->PathOf(key));
}

//--------------------------------------------------------------------------------------------------
std::vector<KeyReader> KeyReader::List(const char* key) const
{
  std::vector<KeyReader> objects;
  if (const LocatedJson* found = this->FindOfKind(key, LocatedJson::Kind::List))
  {
    for (const LocatedJson& item : found->Items)
    {
      const std::string path = this->PathOf(key) + "[" + std::to_string(objects.size()) + "]";
      objects.emplace_back(item, this->FileName, path);
    }
  }
  return objects;
}

//--------------------------------------------------------------------------------------------------
void KeyReader::AllowOnly(const std::vector<std::string>& known, const std::string& ofWhat) const
{
  for (const auto& member : this->Node->Members)
  {
    bool isKnown = false;
    for (const std::string& key : known)
    {
      isKnown = isKnown || key == member.first;
    }
    if (!isKnown)
    {
      this->Fail(member.first, "unknown key" + ofWhat + "; " + DidYouMean(member.first, known));
    }
  }
}

//--------------------------------------------------------------------------------------------------
void KeyReader::Require(const char* key) const
{
  if (!this->Has(key))
  {
    throw SceneError({ this->FileName, this->Node->Line, this->PathOf(key) }, "key is missing");
  }
}

//--------------------------------------------------------------------------------------------------
void KeyReader::Fail(const std::string& key, const std::string& message) const
{
  throw SceneError(this->PlaceOf(key), message);
}

//--------------------------------------------------------------------------------------------------
void KeyReader::FailUnknown(const std::string& key, const std::string& what,
  const std::string& word, const std::vector<std::string>& known) const
{
  this->Fail(key, "unknown " + what + " '" + word + "'; " + DidYouMean(word, known));
}

//--------------------------------------------------------------------------------------------------
ScenePlace KeyReader::PlaceOf(const std::string& key) const
{
  const LocatedJson* found = this->Node->Find(key);
  if (!found)
  {
    return { this->FileName, this->Node->Line, this->Path };
  }
  return { this->FileName, found->KeyLine, this->PathOf(key) };
}

//--------------------------------------------------------------------------------------------------
const LocatedJson* KeyReader::FindOfKind(const char* key, LocatedJson::Kind kind) const
{
  const LocatedJson* found = this->Node->Find(key);
  if (found)
  {
    this->CheckKind(this->PathOf(key), *found, kind);
  }
  return found;
}

//--------------------------------------------------------------------------------------------------
void KeyReader::CheckKind(
  const std::string& path, const LocatedJson& value, LocatedJson::Kind expected) const
{
  if (value.Is != expected)
  {
    throw SceneError({ this->FileName, value.Line, path },
      std::string("must be ") + LocatedJson::NameOf(expected) + ", is " +
        LocatedJson::NameOf(value.Is));
  }
}

//--------------------------------------------------------------------------------------------------
double KeyReader::ReadNumber(const std::string& path, const LocatedJson& value, Range range) const
{
  this->CheckKind(path, value, LocatedJson::Kind::Number);
  if (!std::isfinite(value.Number) || !IsWithin(value.Number, range))
  {
    throw SceneError({ this->FileName, value.Line, path },
      "must be " + (std::isfinite(value.Number) ? Spell(range) : "finite") + ", is " +
        Spell(value.Number));
  }
  return value.Number;
}

//--------------------------------------------------------------------------------------------------
void KeyReader::ReadList(const char* key, double* values, std::size_t count, Range range) const
{
  const LocatedJson* found = this->FindOfKind(key, LocatedJson::Kind::List);
  if (!found)
  {
    return;
  }
  const std::string path = this->PathOf(key);
  if (found->Items.size() != count)
  {
    throw SceneError({ this->FileName, found->Line, path },
      "must be a list of " + std::to_string(count) + " numbers, has " +
        std::to_string(found->Items.size()));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = this->ReadNumber(path + "[" + std::to_string(i) + "]", found->Items[i], range);
  }
}

//--------------------------------------------------------------------------------------------------
std::string KeyReader::PathOf(const std::string& key) const
{
  return this->Path.empty() || key.empty() ? this->Path + key : this->Path + "." + key;
}

}
