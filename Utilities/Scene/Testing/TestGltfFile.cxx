// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// glTF 2.0: points where the nodes put them, base colours, and a message for all that is not as it should be.

#include "ModelFile.h"
#include "ModelStore.h"
#include "SceneBuilder.h"
#include "SceneReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "vtkActor.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkXMLPolyDataWriter.h"

using namespace softshadows;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{

std::string Base64(const std::string& bytes)
{
  static const char* const digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

/// The parts of a file; tests spoil them on purpose.
struct Asset
{
  std::string Binary;
  std::string Views;
  std::string Accessors;
  int Number = 0;
  std::string Meshes;
  std::string Nodes = R"({"mesh": 0})";
  std::string More; ///< Members of the whole, each with a comma before it.
  std::string Uri = "data";

  template <typename T>
  int Add(int componentType, const std::string& type, int count, const std::vector<T>& values,
    const std::string& more = "")
  {
    this->Binary.resize((this->Binary.size() + 3) / 4 * 4, '\0');
    const std::string comma = this->Number > 0 ? ", " : "";
    this->Views += comma + R"({"buffer": 0, "byteOffset": )" + std::to_string(this->Binary.size()) +
      R"(, "byteLength": )" + std::to_string(values.size() * sizeof(T)) + "}";
    this->Accessors += comma + R"({"bufferView": )" + std::to_string(this->Number) +
      R"(, "componentType": )" + std::to_string(componentType) + R"(, "count": )" +
      std::to_string(count) + R"(, "type": ")" + type + "\"" + more + "}";
    this->Binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return this->Number++;
  }

  int AddPoints(const std::vector<float>& values)
  {
    return this->Add(5126, "VEC3", static_cast<int>(values.size() / 3), values);
  }

  std::string Json() const
  {
    const std::string uri = this->Uri == "data"
      ? R"(, "uri": "data:application/octet-stream;base64,)" + Base64(this->Binary) + "\""
      : (this->Uri.empty() ? "" : R"(, "uri": ")" + this->Uri + "\"");
    return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": )" +
      std::to_string(this->Binary.size()) + uri + R"(}], "bufferViews": [)" + this->Views +
      R"(], "accessors": [)" + this->Accessors + R"(], "meshes": [)" + this->Meshes +
      R"(], "nodes": [)" + this->Nodes + "]" + this->More + "}";
  }

  std::string Glb() const
  {
    const auto number = [](std::size_t value)
    {
      std::string bytes;
      for (int i = 0; i < 4; ++i)
      {
        bytes += static_cast<char>(value >> (8 * i) & 0xff);
      }
      return bytes;
    };
    Asset inside = *this;
    inside.Uri = "";
    std::string json = inside.Json();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string binary = this->Binary;
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::string chunks = number(json.size()) + "JSON" + json + number(binary.size()) +
      std::string("BIN\0", 4) + binary;
    return "glTF" + number(2) + number(chunks.size() + 12) + chunks;
  }
};

const std::vector<float> Corner = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };

/// One triangle in the plane z = 0, without indices.
Asset OneTriangle()
{
  Asset asset;
  asset.AddPoints(Corner);
  asset.Meshes = R"({"primitives": [{"attributes": {"POSITION": 0}}]})";
  return asset;
}

std::string Replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), by);
}

std::vector<double> PointOf(vtkPolyData* mesh, vtkIdType cell, int corner)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  const double* p = mesh->GetPoint(ids->GetId(corner));
  return { p[0], p[1], p[2] };
}

std::vector<double> TupleOf(vtkDataArray* array, vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  const double* p = array->GetTuple(ids->GetId(0));
  return { p[0], p[1], p[2] };
}

testing::Matcher<std::vector<double>> Near(double x, double y, double z)
{
  constexpr double tolerance = 1e-6;
  return ElementsAre(testing::DoubleNear(x, tolerance), testing::DoubleNear(y, tolerance),
    testing::DoubleNear(z, tolerance));
}

/// A folder of its own for each test, empty at its start.
class GltfFile : public testing::Test
{
protected:
  fs::path Folder;
  ModelStore Models;

  void SetUp() override
  {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    this->Folder = fs::path(SOFTSHADOWS_TEST_OUTPUT_DIR) / ("GltfFile-" + name);
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  vtkSmartPointer<vtkPolyData> Load(const std::string& name, const std::string& bytes)
  {
    std::ofstream(this->Folder / name, std::ios::binary) << bytes;
    this->Models = ModelStore();
    return this->Models.Load(ModelShape{ name, {} }, this->Folder.string());
  }

  std::string ErrorOf(const std::string& bytes, const std::string& name = "a.gltf")
  {
    try
    {
      this->Load(name, bytes);
    }
    catch (const SceneError& error)
    {
      EXPECT_THAT(error.what(), HasSubstr(name));
      return error.what();
    }
    return "";
  }

  std::string NotShown() const
  {
    return this->Models.GetNotShown().empty() ? "" : this->Models.GetNotShown().back();
  }
};

}

TEST_F(GltfFile, PlacesMeshesByTheirNodes)
{
  Asset asset = OneTriangle();
  // A quarter turn about z takes x to y; matrices stand column by column.
  asset.Nodes = R"({"children": [1, 2], "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 10,20,30,1]},
    {"mesh": 0, "translation": [1, 2, 3], "rotation": [0, 0, 0.70710678118654757, 0.70710678118654757],
     "scale": [3, 4, 5]},
    {"mesh": 0, "scale": [1, 1, -1]})";
  asset.More = R"(, "scenes": [{"nodes": [0]}], "scene": 0)";
  for (const std::string name : { "a.gltf", "a.glb" })
  {
    const auto mesh = this->Load(name, name == "a.glb" ? asset.Glb() : asset.Json());
    ASSERT_EQ(mesh->GetNumberOfPolys(), 2) << name;
    EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_THAT(PointOf(mesh, 0, 0), Near(12, 24, 36));
    EXPECT_THAT(PointOf(mesh, 0, 1), Near(12, 24 + 6, 36));
    EXPECT_THAT(PointOf(mesh, 0, 2), Near(12 - 8, 24, 36));
    vtkDataArray* normals = mesh->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    EXPECT_THAT(TupleOf(normals, mesh, 0), Near(0, 0, 1));
    EXPECT_THAT(TupleOf(normals, mesh, 1), Near(0, 0, -1)) << "mirrored";
    EXPECT_EQ(this->NotShown(), "");
  }
}

TEST_F(GltfFile, NumbersStayDouble)
{
  Asset asset = OneTriangle();
  asset.Nodes = R"({"mesh": 0, "translation": [5403210.123, 0, 0]})";
  EXPECT_EQ(PointOf(this->Load("a.gltf", asset.Json()), 0, 0)[0], 5403210.123);
}

TEST_F(GltfFile, NormalsTurnWithTheirNode)
{
  Asset asset;
  asset.AddPoints(Corner);
  asset.AddPoints({ 1, 1, 0, 1, 1, 0, 1, 1, 0 });
  asset.Meshes = R"({"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}},
    {"attributes": {"POSITION": 0}}]})";
  asset.Nodes = R"({"mesh": 0, "scale": [1, 2, 1]}, {"mesh": 0, "scale": [-1, 2, 1]})";
  const auto mesh = this->Load("a.gltf", asset.Json());
  ASSERT_EQ(mesh->GetNumberOfPolys(), 4);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  const double length = std::sqrt(1.25);
  EXPECT_THAT(TupleOf(normals, mesh, 0), Near(1 / length, 0.5 / length, 0));
  EXPECT_THAT(TupleOf(normals, mesh, 1), Near(0, 0, 1)) << "without one: the triangle's";
  EXPECT_THAT(TupleOf(normals, mesh, 2), Near(-1 / length, 0.5 / length, 0));
  EXPECT_THAT(TupleOf(normals, mesh, 3), Near(0, 0, 1)) << "its front is its front again";
}

TEST_F(GltfFile, IndicesAreOfAnyTypeAndMode)
{
  Asset asset;
  asset.AddPoints({ 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 9, 9, 9 });
  asset.Add(5121, "SCALAR", 3, std::vector<std::uint8_t>{ 1, 3, 2 });
  asset.Add(5123, "SCALAR", 6, std::vector<std::uint16_t>{ 0, 1, 2, 1, 3, 2 });
  asset.Add(5125, "SCALAR", 4, std::vector<std::uint32_t>{ 0, 1, 2, 3 });
  asset.Add(5125, "SCALAR", 4, std::vector<std::uint32_t>{ 0, 1, 3, 2 });
  asset.Meshes = R"({"primitives": [{"attributes": {"POSITION": 0}, "indices": 1},
    {"attributes": {"POSITION": 0}, "indices": 2, "mode": 4},
    {"attributes": {"POSITION": 0}, "indices": 3, "mode": 5},
    {"attributes": {"POSITION": 0}, "indices": 4, "mode": 6}]})";
  const auto mesh = this->Load("a.gltf", asset.Json());
  ASSERT_EQ(mesh->GetNumberOfPolys(), 1 + 2 + 2 + 2);
  EXPECT_THAT(PointOf(mesh, 0, 1), Near(1, 1, 0));
  for (vtkIdType cell = 0; cell < 7; ++cell)
  {
    EXPECT_THAT(TupleOf(mesh->GetPointData()->GetNormals(), mesh, cell), Near(0, 0, 1))
      << cell << ": all turn the same way";
  }
  EXPECT_THAT(PointOf(mesh, 6, 2), Near(0, 0, 0)) << "a fan's triangles meet in its first point";
}

TEST_F(GltfFile, ReadsStridesAndSparseAccessorsAndWholeNumbers)
{
  Asset asset = OneTriangle();
  const std::string json = asset.Json();
  asset.Binary += std::string("\1\0", 2);
  asset.Binary.resize(40, '\0');
  const float moved[3] = { 7, 8, 9 };
  asset.Binary.append(reinterpret_cast<const char*>(moved), sizeof(moved));
  asset.Views += R"(, {"buffer": 0, "byteOffset": 36, "byteLength": 2},
    {"buffer": 0, "byteOffset": 40, "byteLength": 12})";
  Asset sparse = asset;
  sparse.Accessors = Replaced(asset.Accessors, "}", R"(, "sparse": {"count": 1,
    "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 2}}})");
  EXPECT_THAT(PointOf(this->Load("a.gltf", sparse.Json()), 0, 1), Near(7, 8, 9));
  Asset bad = sparse;
  bad.Binary[36] = 3;
  EXPECT_THAT(this->ErrorOf(bad.Json()), HasSubstr("replaces an element that does not exist"));

  Asset quantized;
  quantized.Add(5122, "VEC3", 3,
    std::vector<std::int16_t>{ 0, 0, 0, -1, 32767, 0, 0, -1, 0, 32767, 0, -1 },
    R"(, "normalized": true)");
  quantized.Meshes = asset.Meshes;
  quantized.Views = Replaced(quantized.Views, "}", R"(, "byteStride": 8})");
  const auto mesh = this->Load("b.gltf", quantized.Json());
  EXPECT_THAT(PointOf(mesh, 0, 1), Near(1, 0, 0));
  EXPECT_THAT(PointOf(mesh, 0, 2), Near(0, 1, 0));
}

TEST_F(GltfFile, HasBaseColors)
{
  Asset asset;
  asset.AddPoints(Corner);
  asset.Add(5121, "VEC4", 3, std::vector<std::uint8_t>{ 255, 51, 0, 255, 0, 0, 0, 9, 0, 0, 0, 9 });
  asset.Meshes = R"({"primitives": [{"attributes": {"POSITION": 0}, "material": 0},
    {"attributes": {"POSITION": 0}, "material": 1},
    {"attributes": {"POSITION": 0, "COLOR_0": 1}, "material": 0},
    {"attributes": {"POSITION": 0}}]})";
  asset.More = R"(, "materials": [
    {"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.2158605, 1, 1]}, "doubleSided": true},
    {"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [0, 0.001, 2, 0.5]}}])";
  const auto mesh = this->Load("a.gltf", asset.Json());
  vtkDataArray* colors = mesh->GetPointData()->GetArray(ModelColors);
  ASSERT_NE(colors, nullptr);
  EXPECT_THAT(TupleOf(colors, mesh, 0), ElementsAre(188, 128, 255)) << "linear to sRGB";
  EXPECT_THAT(TupleOf(colors, mesh, 1), ElementsAre(0, 3, 255));
  EXPECT_THAT(TupleOf(colors, mesh, 2), ElementsAre(188, 59, 0)) << "0.2 of 0.216 is 0.043";
  EXPECT_THAT(TupleOf(colors, mesh, 3), ElementsAre(255, 255, 255));
  EXPECT_THAT(this->NotShown(), HasSubstr(": 1 transparent materials (opaque here)"));
  EXPECT_FALSE(this->Load("b.gltf", OneTriangle().Json())->GetPointData()->HasArray(ModelColors));

  // A colour in the scene wins; arrays of other kinds are not taken for colours.
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName((this->Folder / "c.vtp").c_str());
  writer->SetInputData(mesh);
  writer->Write();
  const SceneDescription scene = ParseScene(
    R"({"version": 1, "lights": [], "objects": [{"file": "a.gltf"}, {"file": "a.gltf", "color": [1, 0, 0]},
       {"file": "c.vtp"}, {"file": "b.gltf"}]})",
    (this->Folder / "scene.json").string());
  const BuiltScene built = BuildScene(scene, this->Models);
  const auto shown = [&](std::size_t i)
  { return built.Actors[i]->GetMapper()->GetScalarVisibility() != 0; };
  EXPECT_TRUE(shown(0));
  EXPECT_STREQ(built.Actors[0]->GetMapper()->GetArrayName(), ModelColors);
  EXPECT_FALSE(shown(1) || shown(2) || shown(3));
}

TEST_F(GltfFile, WhatIsNotShownIsCountedAndNamed)
{
  Asset asset = OneTriangle();
  asset.Meshes = R"({"primitives": [{"attributes": {"POSITION": 0}, "targets": [{}, {}]},
    {"attributes": {"POSITION": 0}, "mode": 0}, {"attributes": {"POSITION": 0}, "mode": 2},
    {"attributes": {}}, {"attributes": {"POSITION": 0},
     "extensions": {"KHR_draco_mesh_compression": {}}}]}, {"primitives": []})";
  asset.Nodes = R"({"mesh": 0, "skin": 0})";
  asset.More = R"(, "animations": [{}], "cameras": [{}, {}], "textures": [{}],
    "scenes": [{"nodes": [0]}, {}])";
  EXPECT_EQ(this->Load("a.gltf", asset.Json())->GetNumberOfPolys(), 1);
  EXPECT_THAT(this->NotShown(),
    HasSubstr("a.gltf' has what is not shown: 1 animations, 2 cameras, 3 lines, "
              "1 meshes outside of the scene, 2 morph targets, 1 other scenes, 3 points, "
              "1 primitives compressed with KHR_draco_mesh_compression, "
              "1 primitives without positions, 1 skins, 1 textures, "
              "1 uses of KHR_draco_mesh_compression"));
  asset.Meshes = R"({"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]})";
  EXPECT_THAT(this->ErrorOf(asset.Json()), HasSubstr("is empty: it has no polygon, but"));
}

TEST_F(GltfFile, ErrorsSayWhatIsWrong)
{
  const std::string good = OneTriangle().Json();
  EXPECT_EQ(this->ErrorOf(good), "");
  EXPECT_THAT(this->ErrorOf(good.substr(0, good.size() - 9)), HasSubstr("is no glTF, or damaged"));
  EXPECT_THAT(this->ErrorOf("[]"), HasSubstr("is no glTF"));
  EXPECT_THAT(this->ErrorOf("{}"), HasSubstr("no asset.version"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "2.0", "1.0")), HasSubstr("glTF 1.0: only 2.0"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"count\": 3", "\"count\": 4")),
    HasSubstr("accessors[0] ends outside of bufferViews[0]"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"count\": 3", "\"count\": 9007199254740991")),
    HasSubstr("accessors[0] ends outside of bufferViews[0]"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"count\": 3", "\"count\": -1")),
    HasSubstr("'count' of accessors[0] is not a whole number"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"byteOffset\": 0", "\"byteOffset\": 4")),
    HasSubstr("bufferViews[0] ends outside of its buffer"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"bufferView\": 0", "\"bufferView\": 7")),
    HasSubstr("bufferViews[7] is asked for, but there are 1"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"mesh\": 0", "\"mesh\": 1")), HasSubstr("meshes[1]"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"mesh\": 0", "\"mesh\": \"x\"")),
    HasSubstr("'mesh' of nodes[0] is not a whole number"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "VEC3", "MAT4")), HasSubstr("of the type 'MAT4'"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "5126", "5124")), HasSubstr("component type 5124"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"mesh\": 0", "\"mesh\": 0, \"scale\": [1, 2]")),
    HasSubstr("'scale' of nodes[0] is not 3 numbers"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "base64,", "base64,?")), HasSubstr("is not base64"));
  EXPECT_THAT(this->ErrorOf(Replaced(good, "base64,", "base64,====")), HasSubstr("truncated"));
  const std::string deep(100000, '[');
  EXPECT_THAT(this->ErrorOf(Replaced(good, "\"2.0\"", "\"2.0\", \"x\": " + deep)),
    HasSubstr("nested too deeply"));
}

TEST_F(GltfFile, ErrorsOfFilesAndIndicesAndNodes)
{
  Asset asset;
  asset.AddPoints(Corner);
  asset.Add(5121, "SCALAR", 3, std::vector<std::uint8_t>{ 0, 1, 3 });
  asset.Meshes = R"({"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]})";
  EXPECT_THAT(this->ErrorOf(asset.Json()),
    HasSubstr("meshes[0].primitives[0] has a corner that does not exist, 3 of 3"));

  asset = OneTriangle();
  const std::string glb = asset.Glb();
  for (const std::size_t length : { 4, 11, 12, 15, 40, 300 })
  {
    EXPECT_THAT(this->ErrorOf(glb.substr(0, length), "a.glb"), HasSubstr("truncated")) << length;
  }
  EXPECT_THAT(this->ErrorOf("glTF" + std::string("\1\0\0\0", 4) + glb.substr(8), "a.glb"),
    HasSubstr("of version 1"));

  asset.Uri = "a%20b.bin";
  EXPECT_THAT(this->ErrorOf(asset.Json()),
    HasSubstr("needs 'a b.bin' (buffers[0]), and there is no such file"));
  std::ofstream(this->Folder / "a b.bin", std::ios::binary) << asset.Binary;
  EXPECT_EQ(this->ErrorOf(asset.Json()), "");
  std::ofstream(this->Folder / "a b.bin", std::ios::binary) << asset.Binary.substr(1);
  EXPECT_THAT(this->ErrorOf(asset.Json()), HasSubstr("truncated: buffers[0] has 35 of its 36"));
  asset.Uri = "https://example.org/a.bin";
  EXPECT_THAT(this->ErrorOf(asset.Json()), HasSubstr("which is not fetched"));

  asset = OneTriangle();
  asset.Nodes = R"({"mesh": 0, "children": [1]}, {"children": [0]})";
  EXPECT_THAT(this->ErrorOf(asset.Json()), HasSubstr("every node is the child of another"));
  asset.More = R"(, "scenes": [{"nodes": [0]}])";
  EXPECT_THAT(this->ErrorOf(asset.Json()), HasSubstr("nodes[0] is its own ancestor"));
}
