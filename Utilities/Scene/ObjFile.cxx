// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ObjFile.h"

#include "FaceCorners.h"
#include "TextLines.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace softshadows
{
namespace
{

/// Lines without comments, those that a backslash continues as one.
class ObjLines
{
public:
  explicit ObjLines(const std::string& path)
    : Stream(path, std::ios::binary)
    , Lines(this->Stream)
  {
  }

  bool Next(std::string& line)
  {
    line.clear();
    std::string part;
    bool goesOn = true;
    bool found = false;
    for (; goesOn && this->Lines.Next(part); found = true)
    {
      this->Number++;
      part.erase(std::min(part.find('#'), part.size()));
      part.erase(part.find_last_not_of(" \t") + 1);
      goesOn = !part.empty() && part.back() == '\\';
      if (goesOn)
      {
        part.back() = ' ';
      }
      line += part;
    }
    return found;
  }

  [[noreturn]] void Fail(const std::string& what) const
  {
    throw std::runtime_error("damaged: line " + std::to_string(this->Number) + ": " + what);
  }

private:
  std::ifstream Stream;
  TextLines Lines;
  std::int64_t Number = 0;
};

/// Corner of a face: numbers of its point and its normal from 0; -1 is none.
using Corner = std::pair<std::int64_t, std::int64_t>;

class ObjReader
{
public:
  explicit ObjReader(const std::string& path)
    : Lines(path)
  {
  }

  ModelFile Read()
  {
    std::string line;
    while (this->Lines.Next(line))
    {
      std::istringstream words(line);
      std::string keyword;
      if (words >> keyword)
      {
        this->ReadStatement(keyword, words);
      }
    }
    if (!this->Materials.empty())
    {
      this->File.NotShown["materials"] = static_cast<std::int64_t>(this->Materials.size());
    }
    this->MakeMesh();
    return std::move(this->File);
  }

private:
  void ReadStatement(const std::string& keyword, std::istream& words)
  {
    static const std::set<std::string> withoutMeaning = { "vt", "vp", "g", "o", "s", "mg", "mtllib",
      "lod", "bevel", "c_interp", "d_interp", "cstype", "deg", "bmat", "step", "parm", "trim",
      "hole", "scrv", "sp", "end", "con", "maplib", "usemap", "shadow_obj", "trace_obj", "ctech",
      "stech" };
    if (keyword == "v")
    {
      this->ReadNumbers(words, this->Points);
      std::string color;
      if (words >> color >> color) // one more number is a weight
      {
        this->File.NotShown["vertex colours"] += 1;
      }
    }
    else if (keyword == "vn")
    {
      this->ReadNumbers(words, this->Normals);
    }
    else if (keyword == "f" || keyword == "fo")
    {
      this->ReadFace(words);
    }
    else if (keyword == "l" || keyword == "p")
    {
      this->File.NotShown[keyword == "l" ? LineCells : PointCells] += 1;
    }
    else if (keyword == "usemtl")
    {
      std::string name;
      if (words >> name)
      {
        this->Materials.insert(name);
      }
    }
    else if (keyword == "curv" || keyword == "curv2" || keyword == "surf")
    {
      this->File.NotShown["free-form curves and surfaces"] += 1;
    }
    else if (withoutMeaning.count(keyword) == 0)
    {
      this->File.NotShown["statements of unknown kinds"] += 1;
    }
  }

  void ReadNumbers(std::istream& words, std::vector<std::array<double, 3>>& all)
  {
    std::array<double, 3> numbers;
    for (double& number : numbers)
    {
      std::string word;
      words >> word;
      char* end = nullptr;
      number = std::strtod(word.c_str(), &end);
      if (word.empty() || *end != '\0')
      {
        this->Lines.Fail(
          word.empty() ? "a number is missing" : "'" + word.substr(0, 40) + "' is no number");
      }
    }
    all.push_back(numbers);
  }

  void ReadFace(std::istream& words)
  {
    std::vector<Corner> corners;
    std::string word;
    while (words >> word)
    {
      corners.push_back(this->ReadCorner(word));
    }
    if (!HasThreePoints(corners, [](const Corner& corner) { return corner.first; }))
    {
      this->File.NotShown["faces of fewer than three corners"] += 1;
      return;
    }
    for (const Corner& corner : corners)
    {
      this->HasAllNormals = this->HasAllNormals && corner.second >= 0;
      this->HasNormals = this->HasNormals || corner.second >= 0;
    }
    this->Faces.push_back(std::move(corners));
  }

  Corner ReadCorner(const std::string& word)
  {
    std::array<std::int64_t, 3> numbers{ { 0, 0, 0 } };
    const char* at = word.c_str();
    for (std::int64_t& number : numbers)
    {
      char* end = nullptr;
      number = std::strtoll(at, &end, 10);
      if (end == at && &number == numbers.data())
      {
        this->Lines.Fail("'" + word.substr(0, 40) + "' is no corner");
      }
      at = end;
      if (*at != '/')
      {
        break;
      }
      ++at;
    }
    if (*at != '\0')
    {
      this->Lines.Fail("'" + word.substr(0, 40) + "' is no corner");
    }
    return { this->Resolve(numbers[0], this->Points.size(), "corner"),
      numbers[2] == 0 ? -1 : this->Resolve(numbers[2], this->Normals.size(), "normal") };
  }

  /// Numbers count from 1, negative ones back from the last.
  std::int64_t Resolve(std::int64_t number, std::size_t count, const char* what) const
  {
    const auto all = static_cast<std::int64_t>(count);
    const std::int64_t index = number > 0 ? number - 1 : all + number;
    if (number == 0 || index < 0 || index >= all)
    {
      this->Lines.Fail(std::string("the face has a ") + what + " that does not exist, " +
        std::to_string(number) + " of " + std::to_string(all));
    }
    return index;
  }

  /// Points that no face uses are left out; those of several normals are there several times.
  void MakeMesh()
  {
    const bool withNormals = this->HasNormals && this->HasAllNormals;
    if (this->HasNormals && !withNormals)
    {
      this->File.NotShown["normals, which not all faces have"] =
        static_cast<std::int64_t>(this->Normals.size());
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> polygons;
    std::map<Corner, vtkIdType> known;
    for (const std::vector<Corner>& face : this->Faces)
    {
      polygons->InsertNextCell(static_cast<int>(face.size()));
      for (const Corner& corner : face)
      {
        const Corner key(corner.first, withNormals ? corner.second : -1);
        const auto [place, isNew] = known.emplace(key, points->GetNumberOfPoints());
        if (isNew)
        {
          points->InsertNextPoint(this->Points[static_cast<std::size_t>(key.first)].data());
          if (withNormals)
          {
            normals->InsertNextTuple(this->Normals[static_cast<std::size_t>(key.second)].data());
          }
        }
        polygons->InsertCellPoint(place->second);
      }
    }
    this->File.Mesh->SetPoints(points);
    this->File.Mesh->SetPolys(polygons);
    if (withNormals)
    {
      this->File.Mesh->GetPointData()->SetNormals(normals);
    }
  }

  ObjLines Lines;
  ModelFile File;
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<double, 3>> Normals;
  std::vector<std::vector<Corner>> Faces;
  std::set<std::string> Materials;
  bool HasNormals = false;
  bool HasAllNormals = true;
};

}

//--------------------------------------------------------------------------------------------------
ModelFile ReadObj(const std::string& path)
{
  return ObjReader(path).Read();
}

}
