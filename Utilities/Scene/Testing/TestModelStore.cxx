// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Real files of every kind, and every way in which they can be missing or damaged.

#include "ModelStore.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "vtkCell.h"
#include "vtkPointData.h"

using namespace softshadows;
namespace fs = std::filesystem;

namespace
{

const std::string Data = SOFTSHADOWS_TEST_DATA_DIR;

/// A folder of its own for each test, empty at its start.
class ModelFiles : public testing::Test
{
protected:
  fs::path Folder;

  void SetUp() override
  {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    this->Folder = fs::path(SOFTSHADOWS_TEST_OUTPUT_DIR) / ("ModelFiles-" + name);
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  void Write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(this->Folder / name, std::ios::binary) << bytes;
  }

  vtkSmartPointer<vtkPolyData> Load(const std::string& name) const
  {
    ModelStore models;
    return models.Load(
      ModelShape{ name, { "scene.json", 7, "objects[0].file" } }, this->Folder.string());
  }

  /// The message, or "" if it is accepted.
  std::string ErrorOf(const std::string& name) const
  {
    try
    {
      this->Load(name);
    }
    catch (const SceneError& error)
    {
      EXPECT_EQ(error.GetPlace().Key, "objects[0].file");
      EXPECT_EQ(error.GetPlace().Line, 7);
      return error.what();
    }
    return "";
  }
};

std::string BytesOf(const std::string& path)
{
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

void ExpectError(const std::string& error, const std::string& part)
{
  EXPECT_EQ(error.find("scene.json:7: objects[0].file: "), 0u) << error;
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

const char* const AsciiTriangle = "ply\nformat ascii 1.0\nelement vertex 3\n"
                                  "property double x\nproperty float y\nproperty float z\n"
                                  "element face 1\nproperty list uchar int vertex_index\n"
                                  "end_header\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2";

}

TEST_F(ModelFiles, OfAllKindsAreRead)
{
  ModelStore models({ Data });
  const struct
  {
    const char* Name;
    vtkIdType Polygons;
    double Bounds[6];
  } files[] = {
    { "bunny.ply", 3674, { -4.958475, 4.94885, -0.003149, 9.654748, -3.729833, 3.810639 } },
    { "dragon.ply", 11948, { -0.107747, 0.095838, 0.052732, 0.196599, -0.050066, 0.040745 } },
    { "teapot.obj", 992, { -16.070313, 16.070313, -7.875, 7.875, -10, 10 } },
    { "bunny.stl", 918, { -4.96, 4.95, 0.0, 9.65, -3.73, 3.81 } },
    { "dragon.vtp", 3344, { -0.106849, 0.096824, 0.052618, 0.196981, -0.049954, 0.041509 } },
  };
  for (const auto& file : files)
  {
    const auto mesh = models.Load(ModelShape{ file.Name, {} }, this->Folder.string());
    EXPECT_EQ(mesh->GetNumberOfPolys(), file.Polygons) << file.Name;
    EXPECT_NE(mesh->GetPointData()->GetNormals(), nullptr) << file.Name;
    const double* bounds = mesh->GetBounds();
    for (int i = 0; i < 6; ++i)
    {
      const double extent = file.Bounds[1] - file.Bounds[0];
      EXPECT_NEAR(bounds[i], file.Bounds[i], 0.005 * extent) << file.Name << " " << i;
    }
    EXPECT_EQ(models.Load(ModelShape{ file.Name, {} }, this->Folder.string()), mesh);
  }
}

TEST_F(ModelFiles, AreLookedForBesideTheSceneThenInTheFolders)
{
  const fs::path first = this->Folder / "first";
  const fs::path second = this->Folder / "second";
  fs::create_directories(first);
  fs::create_directories(second);
  std::string moved = AsciiTriangle;
  moved.replace(moved.find("0.1 0 0"), 3, "0.2");
  this->Write("second/a.ply", AsciiTriangle);
  this->Write("first/a.ply", moved);
  this->Write("second/b.ply", AsciiTriangle);

  const auto xOfFirstPoint = [&](const std::string& name, const std::string& sceneFolder)
  {
    ModelStore models({ first.string(), second.string() });
    return models.Load(ModelShape{ name, {} }, sceneFolder)->GetPoint(0)[0];
  };
  EXPECT_EQ(xOfFirstPoint("a.ply", second.string()), 0.1);
  EXPECT_EQ(xOfFirstPoint("a.ply", this->Folder.string()), 0.2);
  EXPECT_EQ(xOfFirstPoint("b.ply", this->Folder.string()), 0.1);
  EXPECT_EQ(xOfFirstPoint("second/a.ply", this->Folder.string()), 0.1);
  EXPECT_EQ(xOfFirstPoint((second / "b.ply").string(), "/"), 0.1);
}

TEST_F(ModelFiles, ThatAreMissingAreNamed)
{
  ModelStore models({ "some/folder" });
  try
  {
    models.Load(ModelShape{ "no.ply", { "scene.json", 7, "objects[0].file" } }, "beside");
    FAIL();
  }
  catch (const SceneError& error)
  {
    EXPECT_STREQ(
      error.what(), "scene.json:7: objects[0].file: no such file 'no.ply' in beside, some/folder");
  }
  ExpectError(this->ErrorOf("no.ply"), "no such file 'no.ply'");
}

TEST_F(ModelFiles, OfOtherKindsAreRefused)
{
  this->Write("scan.pcd", "x");
  this->Write("scan", "x");
  ExpectError(this->ErrorOf("scan.pcd"), "'scan.pcd' is no model: files of the kinds ply, obj");
  ExpectError(this->ErrorOf("scan"), "is no model");
  fs::create_directories(this->Folder / "folder.ply");
  ExpectError(this->ErrorOf("folder.ply"), "no such file");
}

TEST_F(ModelFiles, MayHaveTheirEndingsInCapitals)
{
  this->Write("A.PLY", AsciiTriangle);
  EXPECT_EQ(this->ErrorOf("A.PLY"), "");
}

TEST_F(ModelFiles, EmptyOrOfOtherContentAreRefused)
{
  for (const std::string& kind : ModelStore::GetKinds())
  {
    this->Write("empty." + kind, "");
    EXPECT_NE(this->ErrorOf("empty." + kind), "") << kind;
    this->Write("text." + kind, "Dear reader,\nthis is no model.\n");
    EXPECT_NE(this->ErrorOf("text." + kind), "") << kind;
  }
  this->Write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  ExpectError(this->ErrorOf("points.obj"), "no polygon");
  this->Write("points.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
    "property float y\nproperty float z\nend_header\n1 2 3\n");
  ExpectError(this->ErrorOf("points.ply"), "no polygon");
}

TEST_F(ModelFiles, TruncatedAnywhereAreRefused)
{
  // The last byte missing is enough. OBJ has no end that could be
  // missing; a line that is cut can be seen only sometimes.
  for (const std::string name : { "bunny.ply", "dragon.ply", "bunny.stl", "dragon.vtp" })
  {
    const std::string bytes = BytesOf(Data + "/" + name);
    ASSERT_GT(bytes.size(), 1000u) << name;
    const std::size_t lastNewline = name == "dragon.vtp" ? 1 : 0; // ends a line of text
    for (const std::size_t length :
      { std::size_t{ 1 }, std::size_t{ 50 }, std::size_t{ 100 }, std::size_t{ 300 },
        bytes.size() / 3, bytes.size() / 2, bytes.size() - 20, bytes.size() - lastNewline - 1 })
    {
      this->Write("cut-" + name, bytes.substr(0, length));
      EXPECT_NE(this->ErrorOf("cut-" + name), "") << name << " at " << length;
    }
  }
  const std::string ascii = AsciiTriangle;
  for (std::size_t length = 0; length + 1 < ascii.size(); ++length)
  {
    this->Write("cut.ply", ascii.substr(0, length));
    EXPECT_NE(this->ErrorOf("cut.ply"), "") << "ASCII at " << length;
  }
}

TEST_F(ModelFiles, ThatAnnounceMoreThanThereCanBeAreRefusedAtOnce)
{
  std::string bytes = AsciiTriangle;
  bytes.insert(bytes.find("element face"), "element nothing 999999999999\n");
  this->Write("a.ply", bytes);
  EXPECT_EQ(this->ErrorOf("a.ply"), "");
  bytes.replace(bytes.find("vertex 3"), 8, "vertex 999999999999");
  this->Write("a.ply", bytes);
  EXPECT_NE(this->ErrorOf("a.ply"), "");
  std::string stl(84, '\0');
  stl.replace(80, 4, "\xff\xff\xff\xff");
  this->Write("a.stl", stl);
  ExpectError(this->ErrorOf("a.stl"), "announces 4294967295 triangles");
}

TEST_F(ModelFiles, WithCornersThatDoNotExistAreRefused)
{
  std::string bytes = AsciiTriangle;
  bytes.replace(bytes.rfind("0 1 2"), 5, "0 1 3");
  this->Write("a.ply", bytes);
  ExpectError(this->ErrorOf("a.ply"), "face 0 has a corner that does not exist");
  bytes.replace(bytes.rfind("0 1 3"), 5, "0 -1 2");
  this->Write("a.ply", bytes);
  ExpectError(this->ErrorOf("a.ply"), "corner that does not exist");
  this->Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  ExpectError(this->ErrorOf("a.obj"), "damaged");
}

TEST_F(ModelFiles, OfPlyAreReadInEveryEncoding)
{
  this->Write("a.ply", AsciiTriangle);
  EXPECT_EQ(this->Load("a.ply")->GetPoint(0)[0], 0.1) << "double where the file says so";

  // Three vertices and a quadrilateral as shorts, big-endian, with elements and properties between
  // that mean nothing here.
  const std::string header = "ply\r\nformat binary_big_endian 1.0\r\ncomment hello\r\n"
                             "element camera 1\r\nproperty list uchar short numbers\r\n"
                             "element vertex 4\r\nproperty uchar red\r\nproperty short x\r\n"
                             "property short y\r\nproperty short z\r\n"
                             "element face 1\r\nproperty uchar flags\r\n"
                             "property list uchar ushort vertex_indices\r\nend_header\r\n";
  std::string body("\2\0\1\0\2", 5);
  const std::int16_t corners[4][3] = { { 0, 0, -2 }, { 258, 0, 0 }, { 258, 3, 0 }, { 0, 3, 0 } };
  for (const auto& corner : corners)
  {
    body += '\xff';
    for (const std::int16_t value : corner)
    {
      body += static_cast<char>((value >> 8) & 255);
      body += static_cast<char>(value & 255);
    }
  }
  body += std::string("\7\4\0\0\0\1\0\2\0\3", 10);
  this->Write("b.ply", header + body);
  const auto mesh = this->Load("b.ply");
  ASSERT_EQ(mesh->GetNumberOfPolys(), 1);
  EXPECT_EQ(mesh->GetCell(0)->GetNumberOfPoints(), 4);
  EXPECT_EQ(mesh->GetPoint(0)[2], -2.0);
  EXPECT_EQ(mesh->GetPoint(1)[0], 258.0);
}

TEST_F(ModelFiles, MayHavePointsThatAreNoNumbers)
{
  std::string bytes = AsciiTriangle;
  bytes.replace(bytes.find("vertex 3"), 8, "vertex 4");
  bytes.replace(bytes.find("face 1"), 6, "face 2");
  bytes.replace(bytes.rfind("3 0 1 2"), 7, "nan inf 0\n3 0 1 2\n3 0 1 3\n");
  this->Write("a.ply", bytes);
  const auto mesh = this->Load("a.ply");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1) << "without the one that hangs on such a point";
  EXPECT_EQ(mesh->GetBounds()[1], 1.0);

  bytes = AsciiTriangle;
  bytes.replace(bytes.find("0.1 0 0"), 3, "nan");
  this->Write("b.ply", bytes);
  ExpectError(this->ErrorOf("b.ply"), "no polygon has finite corners");
}
