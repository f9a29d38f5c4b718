// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The JSON text of a glTF 2.0 file, and the numbers in its buffers.
 */

#ifndef GltfDocument_h
#define GltfDocument_h

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace softshadows
{

/// Numbers of an accessor, row by row.
struct GltfNumbers
{
  std::int64_t Count = 0; ///< Rows.
  int Components = 1;     ///< Of each row: 1 to 4.
  std::vector<double> Values;
};

/**
 * Nothing of a file is believed before it is looked at: whatever is not there, of another kind or
 * outside of its buffer throws std::runtime_error with a message that does not name the file.
 */
class GltfDocument
{
public:
  /// Reads a .glb or .gltf file, whichever it is by its content; other files only as they are asked for.
  explicit GltfDocument(const std::string& path);

  const nlohmann::json& GetJson() const { return this->Json; }

  /// How many elements a list of the file has, such as "meshes"; 0 if there is none.
  std::int64_t CountOf(const std::string& list) const;

  /// The element, which is an object.
  const nlohmann::json& Get(const std::string& list, std::int64_t index) const;

  /**
   * Of an accessor; whole numbers become 0 to 1 or -1 to 1 where the accessor says so, or all that
   * are not float if `normalize` is set.
   */
  GltfNumbers ReadAccessor(std::int64_t index, bool normalize = false);

  /// Of an accessor: how many rows there are said to be, looked at no further.
  std::int64_t CountRows(std::int64_t index) const;

  ///@{
  /// Members of an element, which `name` names in messages. Throws unless they are of that kind.
  static std::int64_t WholeNumber(const nlohmann::json& element, const std::string& name,
    const char* key, std::int64_t valueIfAbsent);
  static std::string Text(const nlohmann::json& element, const std::string& name, const char* key);
  /// An empty list if it is not there.
  static const nlohmann::json& List(
    const nlohmann::json& element, std::string_view name, const char* key);
  /// An empty object if it is not there.
  static const nlohmann::json& Object(
    const nlohmann::json& element, std::string_view name, const char* key);
  /// Returns whether they are there; as many as `count`, or fewer are an error.
  static bool Numbers(const nlohmann::json& element, const std::string& name, const char* key,
    int count, double* values);
  ///@}

private:
  std::string Folder;
  nlohmann::json Json;
  bool HasBinary = false;
  std::string Binary;                          ///< Second part of a .glb.
  std::map<std::int64_t, std::string> Buffers; ///< Those read so far.

  void SplitContainer(const std::string& bytes, std::string& text);
  void Parse(const std::string& text);
  const std::string& GetBuffer(std::int64_t index);
  std::string ReadFileOfBuffer(const std::string& uri, const std::string& name) const;

  struct Layout
  {
    std::int64_t View = -1;
    std::int64_t Offset = 0;
    std::int64_t ComponentType = 0;
    int Components = 1;
    std::int64_t Count = 0;
    bool Normalize = false;
    bool MayHaveStride = true;
  };
  std::vector<double> ReadView(const Layout& layout, const std::string& name);
  void ReplaceSparse(const nlohmann::json& sparse, const std::string& name, Layout layout,
    std::vector<double>& values);
};

}

#endif
