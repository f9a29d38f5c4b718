// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StlFile.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace softshadows
{
namespace
{

constexpr std::size_t HeaderBytes = 84;
constexpr std::size_t TriangleBytes = 50;

using Corners = std::array<std::array<double, 3>, 3>;

/// Puts triangles together whose corners are equal to the last digit.
class TriangleMesh
{
public:
  explicit TriangleMesh(int pointType) { this->Points->SetDataType(pointType); }

  void Add(const Corners& corners)
  {
    vtkIdType ids[3];
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = this->IdOf(corners[static_cast<std::size_t>(i)]);
    }
    if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
    {
      this->File.NotShown[DegenerateFaces] += 1;
      return;
    }
    this->Triangles->InsertNextCell(3, ids);
  }

  ModelFile Finish()
  {
    this->File.Mesh->SetPoints(this->Points);
    this->File.Mesh->SetPolys(this->Triangles);
    return this->File;
  }

private:
  vtkIdType IdOf(const std::array<double, 3>& corner)
  {
    // What is no number is equal to nothing, and no key of a map.
    const bool isKey = std::none_of(
      corner.begin(), corner.end(), [](double coordinate) { return std::isnan(coordinate); });
    const vtkIdType next = this->Points->GetNumberOfPoints();
    const vtkIdType id = isKey ? this->Known.emplace(corner, next).first->second : next;
    if (id == next)
    {
      this->Points->InsertNextPoint(corner.data());
    }
    return id;
  }

  ModelFile File;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  std::map<std::array<double, 3>, vtkIdType> Known;
};

/// The words of a text in lower case, with their lines.
class StlWords
{
public:
  explicit StlWords(std::istream& stream)
    : Stream(stream)
  {
  }

  bool Next(std::string& word)
  {
    word.clear();
    int c = this->Stream.get();
    for (; std::isspace(c) != 0; c = this->Stream.get())
    {
      this->Line += c == '\n' ? 1 : 0;
    }
    for (; c != EOF && std::isspace(c) == 0; c = this->Stream.get())
    {
      word += static_cast<char>(std::tolower(c));
    }
    this->Stream.unget(); // the end of the line is counted with the next word
    return !word.empty();
  }

  void SkipLine()
  {
    for (int c = this->Stream.get(); c != EOF; c = this->Stream.get())
    {
      if (c == '\n')
      {
        ++this->Line;
        return;
      }
    }
  }

  double NextNumber()
  {
    std::string word;
    this->Next(word);
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0')
    {
      this->Fail(word, "a number");
    }
    return value;
  }

  [[noreturn]] void Fail(const std::string& found, const std::string& expected) const
  {
    throw std::runtime_error(found.empty() ? "truncated: it ends where " + expected + " should be"
                                           : "damaged: line " + std::to_string(this->Line) + ": '" +
          found.substr(0, 40) + "' is not " + expected);
  }

private:
  std::istream& Stream;
  std::int64_t Line = 1;
};

/// Corners up to "endloop", with "vertex" before each.
Corners ReadFacet(StlWords& words)
{
  Corners corners;
  std::size_t found = 0;
  std::string word;
  while (words.Next(word) && word != "endfacet")
  {
    if (word == "vertex")
    {
      if (found == corners.size())
      {
        words.Fail(word, "the end of a triangle");
      }
      for (double& coordinate : corners[found])
      {
        coordinate = words.NextNumber();
      }
      ++found;
    }
    else if (word == "normal")
    {
      for (int i = 0; i < 3; ++i)
      {
        words.NextNumber();
      }
    }
    else if (word != "outer" && word != "loop" && word != "endloop")
    {
      words.Fail(word, "a word of a facet");
    }
  }
  if (word.empty() || found < corners.size())
  {
    words.Fail(word, "the third corner of a facet");
  }
  return corners;
}

ModelFile ReadText(std::istream& stream)
{
  TriangleMesh mesh(VTK_DOUBLE);
  StlWords words(stream);
  std::string word;
  bool isOpen = false;
  while (words.Next(word))
  {
    if (word == "solid" || word == "endsolid")
    {
      isOpen = word == "solid";
      words.SkipLine(); // its name
    }
    else if (word == "facet")
    {
      mesh.Add(ReadFacet(words));
    }
    else
    {
      words.Fail(word, "a facet, a solid or its end");
    }
  }
  if (isOpen)
  {
    words.Fail("", "the end of the solid");
  }
  return mesh.Finish();
}

std::uint32_t LittleEndian(const unsigned char* bytes)
{
  return bytes[0] | (bytes[1] << 8U) | (bytes[2] << 16U) |
    (static_cast<std::uint32_t>(bytes[3]) << 24U);
}

ModelFile ReadBinary(std::istream& stream, std::uint32_t count)
{
  TriangleMesh mesh(VTK_FLOAT);
  stream.seekg(HeaderBytes);
  std::array<unsigned char, TriangleBytes> bytes{};
  for (std::uint32_t n = 0; n < count; ++n)
  {
    stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    const unsigned char* at = bytes.data() + 12; // after the normal
    Corners corners;
    for (std::array<double, 3>& corner : corners)
    {
      for (double& coordinate : corner)
      {
        const std::uint32_t bits = LittleEndian(at);
        float value = 0.0F;
        std::memcpy(&value, &bits, sizeof(value));
        coordinate = value;
        at += 4;
      }
    }
    mesh.Add(corners);
  }
  return mesh.Finish();
}

/// "solid" after white space. Binary files may begin so as well: their size tells.
bool BeginsAsText(const std::string& header)
{
  const std::size_t first =
    std::min(header.find_first_not_of(" \t\r\n", header.compare(0, 3, "\xef\xbb\xbf") ? 0 : 3),
      header.size());
  std::string word = header.substr(first, 5);
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word == "solid";
}

}

//--------------------------------------------------------------------------------------------------
ModelFile ReadStl(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string header(HeaderBytes, '\0');
  stream.read(&header[0], HeaderBytes);
  header.resize(static_cast<std::size_t>(stream.gcount()));
  stream.clear();
  const std::uintmax_t size = std::filesystem::file_size(path);
  std::uint32_t count = 0;
  if (header.size() == HeaderBytes)
  {
    count = LittleEndian(reinterpret_cast<const unsigned char*>(header.data()) + HeaderBytes - 4);
  }
  const std::uintmax_t announced = HeaderBytes + std::uintmax_t{ count } * TriangleBytes;
  if (BeginsAsText(header) && (header.size() < HeaderBytes || size != announced) &&
    header.find('\0') == std::string::npos)
  {
    stream.seekg(header.compare(0, 3, "\xef\xbb\xbf") ? 0 : 3);
    return ReadText(stream);
  }
  if (header.size() < HeaderBytes)
  {
    throw std::runtime_error("no STL file, or its header is truncated");
  }
  if (size < announced)
  {
    throw std::runtime_error("truncated: the header announces " + std::to_string(count) +
      " triangles, more than the file has");
  }
  return ReadBinary(stream, count);
}

}
