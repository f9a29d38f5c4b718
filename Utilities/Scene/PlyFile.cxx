// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyFile.h"

#include "FaceCorners.h"
#include "PlyHeader.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <vector>

namespace softshadows
{
namespace
{

/// The values after the header, one by one.
class PlyBody
{
public:
  PlyBody(std::istream& stream, PlyHeader::Encoding encoding)
    : Stream(stream)
    , Encoding(encoding)
  {
  }

  double Next(PlyHeader::Type type)
  {
    const double value =
      this->Encoding == PlyHeader::Encoding::Ascii ? this->NextWord() : this->NextBytes(type);
    if (!this->Stream)
    {
      throw std::runtime_error("truncated: the header announces more than the file has");
    }
    return value;
  }

  /// A length of a list: whole, not negative.
  std::int64_t NextCount(PlyHeader::Type type)
  {
    const double count = this->Next(type);
    if (!(count >= 0.0) || count != std::floor(count) ||
      count > std::numeric_limits<std::int32_t>::max())
    {
      throw std::runtime_error("damaged: a list has a length that is none");
    }
    return static_cast<std::int64_t>(count);
  }

private:
  std::istream& Stream;
  PlyHeader::Encoding Encoding;
  std::string Word;

  double NextWord()
  {
    // Streams read no "nan" and "inf", which meshes do contain.
    if (!(this->Stream >> this->Word))
    {
      return 0.0;
    }
    char* end = nullptr;
    const double value = std::strtod(this->Word.c_str(), &end);
    if (end == this->Word.c_str() || *end != '\0')
    {
      throw std::runtime_error("damaged: '" + this->Word.substr(0, 40) + "' is no number");
    }
    return value;
  }

  template <typename T>
  static double As(const std::array<unsigned char, 8>& bytes)
  {
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<double>(value);
  }

  double NextBytes(PlyHeader::Type type)
  {
    std::array<unsigned char, 8> bytes{};
    const std::size_t size = PlyHeader::SizeOf(type);
    this->Stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    const std::uint16_t one = 1;
    const bool isLittleHere = *reinterpret_cast<const unsigned char*>(&one) == 1;
    if (isLittleHere != (this->Encoding == PlyHeader::Encoding::LittleEndian))
    {
      std::reverse(bytes.begin(), bytes.begin() + size);
    }
    switch (type)
    {
      case PlyHeader::Type::Int8:
        return As<std::int8_t>(bytes);
      case PlyHeader::Type::UInt8:
        return As<std::uint8_t>(bytes);
      case PlyHeader::Type::Int16:
        return As<std::int16_t>(bytes);
      case PlyHeader::Type::UInt16:
        return As<std::uint16_t>(bytes);
      case PlyHeader::Type::Int32:
        return As<std::int32_t>(bytes);
      case PlyHeader::Type::UInt32:
        return As<std::uint32_t>(bytes);
      case PlyHeader::Type::Float32:
        return As<float>(bytes);
      case PlyHeader::Type::Float64:
        return As<double>(bytes);
    }
    return 0.0;
  }
};

void SkipProperty(PlyBody& body, const PlyHeader::Property& property)
{
  const std::int64_t count = property.IsList ? body.NextCount(property.CountType) : 1;
  for (std::int64_t i = 0; i < count; ++i)
  {
    body.Next(property.ValueType);
  }
}

void ReadVertices(PlyBody& body, const PlyHeader::Element& element, vtkPolyData* mesh)
{
  static const char* const names[6] = { "x", "y", "z", "nx", "ny", "nz" };
  std::vector<int> role(element.Properties.size(), -1);
  int found = 0;
  bool isDouble = false;
  for (std::size_t i = 0; i < role.size(); ++i)
  {
    for (int k = 0; k < 6 && !element.Properties[i].IsList; ++k)
    {
      if (element.Properties[i].Name == names[k])
      {
        role[i] = k;
        found |= 1 << k;
        isDouble =
          isDouble || (k < 3 && element.Properties[i].ValueType == PlyHeader::Type::Float64);
      }
    }
  }
  if ((found & 7) != 7)
  {
    throw std::runtime_error("has no x, y, z of its vertices");
  }

  // Grown as the values come: the header's count is not to be believed.
  vtkNew<vtkPoints> points;
  points->SetDataType(isDouble ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  double values[6] = { 0, 0, 0, 0, 0, 0 };
  for (std::int64_t n = 0; n < element.Count; ++n)
  {
    for (std::size_t i = 0; i < role.size(); ++i)
    {
      if (role[i] < 0)
      {
        SkipProperty(body, element.Properties[i]);
      }
      else
      {
        values[role[i]] = body.Next(element.Properties[i].ValueType);
      }
    }
    points->InsertNextPoint(values);
    normals->InsertNextTuple(values + 3);
  }
  mesh->SetPoints(points);
  if (found == 63)
  {
    mesh->GetPointData()->SetNormals(normals);
  }
}

/// Faces may stand before the vertices: their corners are looked at in the end.
struct PlyCells
{
  vtkNew<vtkCellArray> Faces;
  vtkNew<vtkCellArray> Strips;
  std::vector<std::int64_t> FaceNumbers; ///< In the file.
};

/// Strips are one list, with -1 between them.
void AddStrips(const std::vector<vtkIdType>& corners, ModelFile& file, vtkCellArray* strips)
{
  for (auto first = corners.begin(); first != corners.end();)
  {
    const auto last = std::find(first, corners.end(), -1);
    if (last - first >= 3)
    {
      strips->InsertNextCell(static_cast<vtkIdType>(last - first), &*first);
    }
    else if (last != first)
    {
      file.NotShown["strips of fewer than three corners"] += 1;
    }
    first = last == corners.end() ? last : last + 1;
  }
}

void ReadFaces(
  PlyBody& body, const PlyHeader::Element& element, bool isStrips, PlyCells& cells, ModelFile& file)
{
  std::vector<vtkIdType> corners;
  for (std::int64_t n = 0; n < element.Count; ++n)
  {
    for (const PlyHeader::Property& property : element.Properties)
    {
      if (!property.IsList ||
        (property.Name != "vertex_indices" && property.Name != "vertex_index"))
      {
        SkipProperty(body, property);
        continue;
      }
      corners.clear();
      for (std::int64_t i = body.NextCount(property.CountType); i > 0; --i)
      {
        const double corner = body.Next(property.ValueType);
        if (!(std::abs(corner) <= std::numeric_limits<std::uint32_t>::max()))
        {
          throw std::runtime_error(
            "damaged: face " + std::to_string(n) + " has a corner that does not exist");
        }
        corners.push_back(static_cast<vtkIdType>(corner));
      }
      if (isStrips)
      {
        AddStrips(corners, file, cells.Strips);
      }
      else if (HasThreePoints(corners, [](vtkIdType corner) { return corner; }))
      {
        cells.Faces->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
        cells.FaceNumbers.push_back(n);
      }
      else
      {
        file.NotShown["faces of fewer than three corners"] += 1;
      }
    }
  }
}

void CheckFaces(const PlyCells& cells, vtkIdType numberOfPoints)
{
  const auto cell = vtk::TakeSmartPointer(cells.Faces->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(count, corners);
    if (std::any_of(corners, corners + count,
          [numberOfPoints](vtkIdType corner) { return corner < 0 || corner >= numberOfPoints; }))
    {
      const auto place = static_cast<std::size_t>(cell->GetCurrentCellId());
      throw std::runtime_error("damaged: face " + std::to_string(cells.FaceNumbers[place]) +
        " has a corner that does not exist");
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
ModelFile ReadPly(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  const PlyHeader header = ReadPlyHeader(stream);
  PlyBody body(stream, header.BodyEncoding);
  ModelFile file;
  PlyCells cells;
  for (const PlyHeader::Element& element : header.Elements)
  {
    if (element.Properties.empty())
    {
      continue; // nothing in the file, however many there are said to be
    }
    if (element.Name == "vertex")
    {
      ReadVertices(body, element, file.Mesh);
    }
    else if (element.Name == "face" || element.Name == "tristrips")
    {
      ReadFaces(body, element, element.Name == "tristrips", cells, file);
    }
    else
    {
      for (std::int64_t n = 0; n < element.Count; ++n)
      {
        for (const PlyHeader::Property& property : element.Properties)
        {
          SkipProperty(body, property);
        }
      }
      if (element.Count > 0)
      {
        file.NotShown["of the element '" + element.Name.substr(0, 40) + "'"] += element.Count;
      }
    }
  }
  CheckFaces(cells, file.Mesh->GetNumberOfPoints());
  file.Mesh->SetPolys(cells.Faces);
  file.Mesh->SetStrips(cells.Strips);
  return file;
}

}
