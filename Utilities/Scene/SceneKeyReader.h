// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The visitors of SceneKeys.h that read keys from JSON and that list them.
 */

#ifndef SceneKeyReader_h
#define SceneKeyReader_h

#include "LocatedJson.h"
#include "SceneDescription.h"
#include "SceneKeys.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace softshadows
{

/// Collects the names of the keys it is shown.
class KeyLister
{
public:
  void Add(const char* key) { this->Keys.emplace_back(key); }
  template <typename T>
  void operator()(const char* key, const T&, Range)
  {
    this->Add(key);
  }
  const std::vector<std::string>& GetKeys() const { return this->Keys; }

private:
  std::vector<std::string> Keys;
};

/// One JSON object of the file. Everything it refuses is a SceneError with file, line and key.
class KeyReader
{
public:
  /// Fails if the node is no object. The path is empty for the file's outermost object.
  KeyReader(const LocatedJson& node, const std::string& fileName, const std::string& path);

  bool Has(const char* key) const { return this->Node->Find(key) != nullptr; }

  ///@{
  /// Sets the value if the key is there; fails on wrong types, lengths and ranges.
  void operator()(const char* key, bool& value, Range) const;
  void operator()(const char* key, int& value, Range range) const;
  void operator()(const char* key, double& value, Range range) const;
  void operator()(const char* key, std::string& value, Range) const;
  void operator()(const char* key, LightShape& value, Range) const;
  template <std::size_t N>
  void operator()(const char* key, std::array<double, N>& values, Range range) const
  {
    this->ReadList(key, values.data(), N, range);
  }
  template <typename T>
  void operator()(const char* key, std::optional<T>& value, Range range) const
  {
    if (this->Has(key))
    {
      (*this)(key, value.emplace(), range);
    }
  }
  ///@}

  /// The object under the key, which must be there.
  KeyReader Object(const char* key) const;

  /// The objects of the list under the key; none if the key is absent.
  std::vector<KeyReader> List(const char* key) const;

  /// Fails if there is a key that is not among these. The text ends the words "unknown key".
  void AllowOnly(const std::vector<std::string>& known, const std::string& ofWhat = "") const;

  /// Fails if the key is absent.
  void Require(const char* key) const;

  ///@{
  /// Fails at the key, or at the object itself where the key is empty or absent.
  [[noreturn]] void Fail(const std::string& key, const std::string& message) const;
  [[noreturn]] void FailUnknown(const std::string& key, const std::string& what,
    const std::string& word, const std::vector<std::string>& known) const;
  ///@}

  ScenePlace PlaceOf(const std::string& key) const;

private:
  const LocatedJson* Node;
  std::string FileName;
  std::string Path;

  const LocatedJson* FindOfKind(const char* key, LocatedJson::Kind kind) const;
  void CheckKind(
    const std::string& path, const LocatedJson& value, LocatedJson::Kind expected) const;
  double ReadNumber(const std::string& path, const LocatedJson& value, Range range) const;
  void ReadList(const char* key, double* values, std::size_t count, Range range) const;
  std::string PathOf(const std::string& key) const;
};

}

#endif
