// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyFile.h"

#include "PlyHeader.h"

#include "vtkCellArray.h"
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

void ReadFaces(PlyBody& body, const PlyHeader::Element& element, vtkPolyData* mesh)
{
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  vtkNew<vtkCellArray> faces;
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
        if (!(corner >= 0.0 && corner < static_cast<double>(numberOfPoints)))
        {
          throw std::runtime_error(
            "damaged: face " + std::to_string(n) + " has a corner that does not exist");
        }
        corners.push_back(static_cast<vtkIdType>(corner));
      }
      if (corners.size() >= 3)
      {
        faces->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
      }
    }
  }
  mesh->SetPolys(faces);
}

}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadPly(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  const PlyHeader header = ReadPlyHeader(stream);
  PlyBody body(stream, header.BodyEncoding);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  for (const PlyHeader::Element& element : header.Elements)
  {
    if (element.Properties.empty())
    {
      continue; // nothing in the file, however many there are said to be
    }
    if (element.Name == "vertex")
    {
      ReadVertices(body, element, mesh);
    }
    else if (element.Name == "face")
    {
      ReadFaces(body, element, mesh);
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
    }
  }
  return mesh;
}

}
