// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GltfFile.h"

#include "GltfDocument.h"
#include "GltfMessages.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace softshadows
{
namespace
{

using nlohmann::json;
using Matrix = std::array<double, 16>; // row by row
using Triangle = std::array<std::size_t, 3>;

enum Mode : std::int64_t
{
  Points = 0,
  Lines = 1,
  LineLoop = 2,
  LineStrip = 3,
  Triangles = 4,
  TriangleStrip = 5,
  TriangleFan = 6
};

unsigned char ToSrgbByte(double linear)
{
  const double value = std::min(std::max(linear, 0.0), 1.0);
  const double encoded =
    value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * encoded));
}

/// Of the node alone, to its parent.
Matrix MatrixOf(const json& node, const std::string& name)
{
  Matrix matrix;
  if (GltfDocument::Numbers(node, name, "matrix", 16, matrix.data()))
  {
    vtkMatrix4x4::Transpose(Matrix(matrix).data(), matrix.data()); // the file's is column by column
    return matrix;
  }
  double move[3] = { 0.0, 0.0, 0.0 };
  double turn[4] = { 0.0, 0.0, 0.0, 1.0 };
  double scale[3] = { 1.0, 1.0, 1.0 };
  GltfDocument::Numbers(node, name, "translation", 3, move);
  GltfDocument::Numbers(node, name, "rotation", 4, turn);
  GltfDocument::Numbers(node, name, "scale", 3, scale);
  const double length = std::hypot(std::hypot(turn[0], turn[1]), std::hypot(turn[2], turn[3]));
  if (!(length > 0.0))
  {
    ThrowDamaged("'rotation' of " + name + " is no rotation");
  }
  const double quaternion[4] = { turn[3] / length, turn[0] / length, turn[1] / length,
    turn[2] / length };
  double rotation[3][3];
  vtkMath::QuaternionToMatrix3x3(quaternion, rotation);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = rotation[row][column] * scale[column];
    }
    matrix[4 * row + 3] = move[row];
  }
  matrix[12] = matrix[13] = matrix[14] = 0.0;
  matrix[15] = 1.0;
  return matrix;
}

/// A primitive in its mesh's own coordinates.
struct Piece
{
  GltfNumbers Positions;
  GltfNumbers Normals; ///< Empty if there are none.
  GltfNumbers Colors;  ///< Empty if there are none; linear.
  std::vector<Triangle> Corners;
  bool HasMaterial = false;
  std::array<double, 4> BaseColor{ { 1.0, 1.0, 1.0, 1.0 } };
};

class Reader
{
public:
  explicit Reader(const std::string& path)
    : Document(path)
  {
  }

  ModelFile Read()
  {
    this->File.Mesh->SetPoints(this->Points);
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Colors->SetName(ModelColors);
    this->Colors->SetNumberOfComponents(3);
    this->WalkNodes(this->Roots());
    this->CountWhatIsLeftOut();
    this->File.Mesh->SetPolys(this->Polygons);
    if (this->HasNormals)
    {
      this->File.Mesh->GetPointData()->SetNormals(this->Normals);
    }
    if (this->HasColors)
    {
      this->File.Mesh->GetPointData()->AddArray(this->Colors);
    }
    return this->File;
  }

private:
  GltfDocument Document;
  ModelFile File;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkUnsignedCharArray> Colors;
  vtkNew<vtkCellArray> Polygons;
  bool HasNormals = false;
  bool HasColors = false;
  std::map<std::int64_t, std::vector<Piece>> Meshes;
  std::set<std::int64_t> SeenMaterials;

  void Leave(const std::string& what, std::int64_t count)
  {
    if (count > 0)
    {
      this->File.NotShown[what] += count;
    }
  }

  std::vector<std::int64_t> IndicesIn(
    const json& element, const std::string& name, const char* key) const
  {
    std::vector<std::int64_t> indices;
    for (const json& item : GltfDocument::List(element, name, key))
    {
      indices.push_back(GltfDocument::WholeNumber({ { "index", item } }, name, "index", -1));
    }
    return indices;
  }

  std::vector<std::int64_t> Roots()
  {
    const std::int64_t scenes = this->Document.CountOf("scenes");
    if (scenes > 0)
    {
      const std::int64_t scene =
        GltfDocument::WholeNumber(this->Document.GetJson(), "the file", "scene", 0);
      this->Leave("other scenes", scenes - 1);
      return this->IndicesIn(
        this->Document.Get("scenes", scene), NameOfElement("scenes", scene), "nodes");
    }
    const std::int64_t nodes = this->Document.CountOf("nodes");
    std::set<std::int64_t> children;
    for (std::int64_t i = 0; i < nodes; ++i)
    {
      const auto of =
        this->IndicesIn(this->Document.Get("nodes", i), NameOfElement("nodes", i), "children");
      children.insert(of.begin(), of.end());
    }
    std::vector<std::int64_t> roots;
    for (std::int64_t i = 0; i < nodes; ++i)
    {
      if (children.count(i) == 0)
      {
        roots.push_back(i);
      }
    }
    if (roots.empty() && nodes > 0)
    {
      ThrowDamaged("every node is the child of another");
    }
    return roots;
  }

  void WalkNodes(const std::vector<std::int64_t>& roots)
  {
    Matrix identity{ { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
    std::vector<std::pair<std::int64_t, Matrix>> open;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    {
      open.emplace_back(*root, identity);
    }
    std::set<std::int64_t> seen;
    while (!open.empty())
    {
      const auto [index, parent] = open.back();
      open.pop_back();
      const std::string name = NameOfElement("nodes", index);
      const json& node = this->Document.Get("nodes", index);
      if (!seen.insert(index).second)
      {
        ThrowDamaged(name + " is its own ancestor, or has two parents");
      }
      const Matrix own = MatrixOf(node, name);
      Matrix toWorld;
      vtkMatrix4x4::Multiply4x4(parent.data(), own.data(), toWorld.data());
      const std::int64_t mesh = GltfDocument::WholeNumber(node, name, "mesh", -1);
      if (mesh >= 0)
      {
        this->Leave("skins", node.count("skin") > 0 ? 1 : 0);
        for (const Piece& piece : this->GetMesh(mesh))
        {
          this->Add(piece, toWorld);
        }
      }
      const auto children = this->IndicesIn(node, name, "children");
      for (auto child = children.rbegin(); child != children.rend(); ++child)
      {
        open.emplace_back(*child, toWorld);
      }
    }
  }

  const std::vector<Piece>& GetMesh(std::int64_t index)
  {
    const auto read = this->Meshes.find(index);
    if (read != this->Meshes.end())
    {
      return read->second;
    }
    std::vector<Piece>& pieces = this->Meshes[index];
    const json& mesh = this->Document.Get("meshes", index);
    std::int64_t number = 0;
    for (const json& primitive :
      GltfDocument::List(mesh, NameOfElement("meshes", index), "primitives"))
    {
      const std::string name =
        NameOfElement("meshes", index) + "." + NameOfElement("primitives", number++);
      if (!primitive.is_object())
      {
        ThrowDamaged(name + " is not an object");
      }
      if (!this->IsLeftOut(primitive, name))
      {
        pieces.push_back(this->ReadPiece(primitive, name));
      }
    }
    this->Leave("empty meshes", number == 0 ? 1 : 0);
    return pieces;
  }

  /// Of how the accessors of the primitive are packed, the name of what is not understood.
  std::string CompressionOf(const json& primitive, const std::string& name) const
  {
    static const char* const ofPrimitives = "KHR_draco_mesh_compression";
    if (GltfDocument::Object(primitive, name, "extensions").count(ofPrimitives) > 0)
    {
      return ofPrimitives;
    }
    std::vector<std::int64_t> accessors;
    const json& attributes = GltfDocument::Object(primitive, name, "attributes");
    for (const char* key : { "POSITION", "NORMAL", "COLOR_0" })
    {
      accessors.push_back(GltfDocument::WholeNumber(attributes, name, key, -1));
    }
    accessors.push_back(GltfDocument::WholeNumber(primitive, name, "indices", -1));
    for (const std::int64_t index : accessors)
    {
      const std::int64_t view = index < 0
        ? -1
        : GltfDocument::WholeNumber(this->Document.Get("accessors", index),
            NameOfElement("accessors", index), "bufferView", -1);
      if (view < 0)
      {
        continue;
      }
      const json& extensions = GltfDocument::Object(
        this->Document.Get("bufferViews", view), NameOfElement("bufferViews", view), "extensions");
      for (const char* ofViews : { "EXT_meshopt_compression", "KHR_meshopt_compression" })
      {
        if (extensions.count(ofViews) > 0)
        {
          return ofViews;
        }
      }
    }
    return "";
  }

  bool IsLeftOut(const json& primitive, const std::string& name)
  {
    const std::string compression = this->CompressionOf(primitive, name);
    if (!compression.empty())
    {
      this->Leave("primitives compressed with " + compression, 1);
      return true;
    }
    const std::int64_t positions = GltfDocument::WholeNumber(
      GltfDocument::Object(primitive, name, "attributes"), name, "POSITION", -1);
    const std::int64_t indices = GltfDocument::WholeNumber(primitive, name, "indices", -1);
    if (positions < 0)
    {
      this->Leave("primitives without positions", 1);
      return true;
    }
    const std::int64_t corners = this->Document.CountRows(indices < 0 ? positions : indices);
    const std::int64_t mode = GltfDocument::WholeNumber(primitive, name, "mode", Mode::Triangles);
    if (corners == 0)
    {
      this->Leave("empty primitives", 1);
      return true;
    }
    switch (mode)
    {
      case Mode::Points:
        this->Leave(PointCells, corners);
        return true;
      case Mode::Lines:
        this->Leave(LineCells, corners / 2);
        return true;
      case Mode::LineLoop:
        this->Leave(LineCells, corners);
        return true;
      case Mode::LineStrip:
        this->Leave(LineCells, corners - 1);
        return true;
      case Mode::Triangles:
      case Mode::TriangleStrip:
      case Mode::TriangleFan:
        return false;
      default:
        ThrowDamaged("'mode' of " + name + " is " + std::to_string(mode) + ", which is none");
    }
  }

  GltfNumbers ReadAttribute(const json& primitive, const std::string& name, const char* key,
    std::int64_t count, bool normalize)
  {
    const std::int64_t index =
      GltfDocument::WholeNumber(GltfDocument::Object(primitive, name, "attributes"), name, key, -1);
    if (index < 0)
    {
      return {};
    }
    GltfNumbers numbers = this->Document.ReadAccessor(index, normalize);
    if (numbers.Components != 3 && !(normalize && numbers.Components == 4))
    {
      ThrowDamaged(std::string(key) + " of " + name + " has " + std::to_string(numbers.Components) +
        " components");
    }
    if (count >= 0 && numbers.Count != count)
    {
      ThrowDamaged(std::string(key) + " of " + name + " has " + std::to_string(numbers.Count) +
        " elements for " + std::to_string(count) + " points");
    }
    return numbers;
  }

  Piece ReadPiece(const json& primitive, const std::string& name)
  {
    Piece piece;
    piece.Positions = this->ReadAttribute(primitive, name, "POSITION", -1, false);
    const std::int64_t count = piece.Positions.Count;
    piece.Normals = this->ReadAttribute(primitive, name, "NORMAL", count, false);
    piece.Colors = this->ReadAttribute(primitive, name, "COLOR_0", count, true);
    this->HasNormals = this->HasNormals || piece.Normals.Count > 0;
    this->ReadMaterial(primitive, name, piece);
    this->HasColors = this->HasColors || piece.HasMaterial || piece.Colors.Count > 0;
    this->Leave("morph targets",
      static_cast<std::int64_t>(GltfDocument::List(primitive, name, "targets").size()));

    std::vector<std::size_t> corners;
    const std::int64_t indices = GltfDocument::WholeNumber(primitive, name, "indices", -1);
    if (indices < 0)
    {
      for (std::int64_t i = 0; i < count; ++i)
      {
        corners.push_back(static_cast<std::size_t>(i));
      }
    }
    else
    {
      const GltfNumbers numbers = this->Document.ReadAccessor(indices);
      for (const double corner : numbers.Values)
      {
        if (!(corner >= 0.0 && corner < static_cast<double>(count)))
        {
          ThrowDamaged(name + " has a corner that does not exist, " +
            std::to_string(static_cast<std::int64_t>(
              std::isfinite(corner) && std::abs(corner) < 1e10 ? corner : -1.0)) +
            " of " + std::to_string(count));
        }
        corners.push_back(static_cast<std::size_t>(corner));
      }
    }
    this->MakeTriangles(
      GltfDocument::WholeNumber(primitive, name, "mode", Mode::Triangles), corners, piece.Corners);
    return piece;
  }

  void MakeTriangles(
    std::int64_t mode, const std::vector<std::size_t>& corners, std::vector<Triangle>& triangles)
  {
    const std::size_t count = corners.size();
    const std::size_t step = mode == Mode::Triangles ? 3 : 1;
    for (std::size_t i = 0; i + 3 <= count; i += step)
    {
      Triangle triangle{ { corners[i], corners[i + 1], corners[i + 2] } };
      if (mode == Mode::TriangleFan)
      {
        triangle = { { corners[i + 1], corners[i + 2], corners[0] } };
      }
      else if (mode == Mode::TriangleStrip && i % 2 == 1)
      {
        std::swap(triangle[1], triangle[2]);
      }
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      {
        this->Leave(DegenerateFaces, 1);
        continue;
      }
      triangles.push_back(triangle);
    }
    const std::size_t rest = mode == Mode::Triangles ? count % 3 : (count < 3 ? count : 0);
    this->Leave("corners without a triangle", static_cast<std::int64_t>(rest));
  }

  void ReadMaterial(const json& primitive, const std::string& name, Piece& piece)
  {
    const std::int64_t index = GltfDocument::WholeNumber(primitive, name, "material", -1);
    if (index < 0)
    {
      return;
    }
    const std::string materialName = NameOfElement("materials", index);
    const json& material = this->Document.Get("materials", index);
    piece.HasMaterial = true;
    GltfDocument::Numbers(GltfDocument::Object(material, materialName, "pbrMetallicRoughness"),
      materialName, "baseColorFactor", 4, piece.BaseColor.data());
    const std::string alpha = GltfDocument::Text(material, materialName, "alphaMode");
    if (this->SeenMaterials.insert(index).second && (alpha == "BLEND" || alpha == "MASK"))
    {
      this->Leave("transparent materials (opaque here)", 1);
    }
  }

  void Add(const Piece& piece, const Matrix& toWorld)
  {
    double linear[3][3];
    for (int row = 0; row < 3; ++row)
    {
      std::copy_n(&toWorld[4 * row], 3, linear[row]);
    }
    const bool isMirrored = vtkMath::Determinant3x3(linear) < 0.0;
    // Of triangles without normals of their own: all points apart, each with its triangle's.
    const bool isFlat = piece.Normals.Count == 0;
    const vtkIdType first = this->Points->GetNumberOfPoints();
    const auto world = [&](std::size_t i, double* point)
    {
      const double* p = &piece.Positions.Values[3 * i];
      for (int row = 0; row < 3; ++row)
      {
        const double* m = &toWorld[4 * row];
        point[row] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
      }
    };
    if (!isFlat)
    {
      for (std::size_t i = 0; i < static_cast<std::size_t>(piece.Positions.Count); ++i)
      {
        double point[3];
        double normal[3];
        world(i, point);
        TransformNormal(linear, &piece.Normals.Values[3 * i], normal);
        this->AddPoint(piece, i, point, normal);
      }
    }
    for (Triangle corners : piece.Corners)
    {
      if (isMirrored)
      {
        std::swap(corners[1], corners[2]); // their front is their front again
      }
      vtkIdType ids[3];
      if (isFlat)
      {
        this->AddFlat(piece, corners, world, ids);
      }
      else
      {
        std::transform(corners.begin(), corners.end(), ids,
          [first](std::size_t corner) { return first + static_cast<vtkIdType>(corner); });
      }
      this->Polygons->InsertNextCell(3, ids);
    }
  }

  template <typename World>
  void AddFlat(const Piece& piece, const Triangle& corners, const World& world, vtkIdType* ids)
  {
    double points[3][3];
    double edges[2][3];
    double normal[3];
    for (int i = 0; i < 3; ++i)
    {
      world(corners[i], points[i]);
    }
    vtkMath::Subtract(points[1], points[0], edges[0]);
    vtkMath::Subtract(points[2], points[0], edges[1]);
    vtkMath::Normalize(edges[0]);
    vtkMath::Normalize(edges[1]);
    vtkMath::Cross(edges[0], edges[1], normal);
    vtkMath::Normalize(normal);
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = this->AddPoint(piece, corners[i], points[i], normal);
    }
  }

  vtkIdType AddPoint(const Piece& piece, std::size_t i, const double* point, const double* normal)
  {
    this->Normals->InsertNextTuple(normal);
    double color[3];
    for (int c = 0; c < 3; ++c)
    {
      const double ofPoint =
        piece.Colors.Count > 0 ? piece.Colors.Values[piece.Colors.Components * i + c] : 1.0;
      color[c] = ToSrgbByte(piece.BaseColor[c] * ofPoint);
    }
    this->Colors->InsertNextTuple(color);
    return this->Points->InsertNextPoint(point);
  }

  /// By the cofactors: the inverse transpose without its division, of flattened nodes, too.
  static void TransformNormal(const double linear[3][3], const double* given, double* normal)
  {
    double cofactors[3][3];
    vtkMath::Cross(linear[1], linear[2], cofactors[0]);
    vtkMath::Cross(linear[2], linear[0], cofactors[1]);
    vtkMath::Cross(linear[0], linear[1], cofactors[2]);
    const double sign = vtkMath::Dot(linear[0], cofactors[0]) < 0.0 ? -1.0 : 1.0;
    for (int row = 0; row < 3; ++row)
    {
      normal[row] = sign * vtkMath::Dot(cofactors[row], given);
    }
    vtkMath::Normalize(normal);
  }

  void CountWhatIsLeftOut()
  {
    for (const char* list : { "animations", "cameras", "textures" })
    {
      this->Leave(list, this->Document.CountOf(list));
    }
    this->Leave("meshes outside of the scene",
      this->Document.CountOf("meshes") - static_cast<std::int64_t>(this->Meshes.size()));
    this->CountExtensions(this->Document.GetJson());
  }

  /// Nesting is no deeper than the document lets it be.
  void CountExtensions(const json& value)
  {
    for (const auto& item : value.items())
    {
      if (value.is_object() && item.key() == "extensions" && item.value().is_object())
      {
        for (const auto& extension : item.value().items())
        {
          this->Leave("uses of " + extension.key().substr(0, 60), 1);
        }
      }
      if (item.value().is_structured())
      {
        this->CountExtensions(item.value());
      }
    }
  }
};

}

//--------------------------------------------------------------------------------------------------
ModelFile ReadGltf(const std::string& path)
{
  return Reader(path).Read();
}

}
