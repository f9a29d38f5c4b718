// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the kinds of models allow: nothing of it is lost, unless it is counted and named.

#include "ModelStore.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataWriter.h"

using namespace softshadows;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{

/// A folder of its own for each test, empty at its start.
class ModelKinds : public testing::Test
{
protected:
  fs::path Folder;
  ModelStore Models;

  void SetUp() override
  {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    this->Folder = fs::path(SOFTSHADOWS_TEST_OUTPUT_DIR) / ("ModelKinds-" + name);
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  vtkSmartPointer<vtkPolyData> Load(const std::string& name)
  {
    return this->Models.Load(ModelShape{ name, {} }, this->Folder.string());
  }

  vtkSmartPointer<vtkPolyData> Load(const std::string& name, const std::string& bytes)
  {
    std::ofstream(this->Folder / name, std::ios::binary) << bytes;
    return this->Load(name);
  }

  std::string ErrorOf(const std::string& name, const std::string& bytes)
  {
    try
    {
      this->Load(name, bytes);
    }
    catch (const SceneError& error)
    {
      return error.what();
    }
    return "";
  }

  /// What the last of the files does not show.
  std::string NotShown() const
  {
    return this->Models.GetNotShown().empty() ? "" : this->Models.GetNotShown().back();
  }
};

const std::string Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The six sides of a box, of numbers after the given one.
std::string BoxOfObj(int first, const std::string& afterCorner)
{
  std::string text;
  for (int i = 0; i < 8; ++i)
  {
    text += "v " + std::to_string(first + (i & 1)) + " " + std::to_string((i >> 1) & 1) + " " +
      std::to_string(i >> 2) + "\n";
  }
  for (const char* side : { "1342", "5687", "1265", "3784", "1573", "2486" })
  {
    text += "f";
    for (const char* corner = side; *corner != '\0'; ++corner)
    {
      text += " " + std::to_string(first + *corner - '0') + afterCorner;
    }
    text += "\n";
  }
  return text;
}

/// Every normal is an axis, and every corner of the unit box is there once for each of its sides.
void ExpectHardEdges(vtkPolyData* box)
{
  EXPECT_EQ(box->GetNumberOfPolys(), 12);
  vtkDataArray* normals = box->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < box->GetNumberOfCells(); ++cell)
  {
    box->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const double* normal = normals->GetTuple(corners->GetId(i));
      const double largest =
        std::max({ std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2]) });
      EXPECT_NEAR(largest, 1.0, 1e-6) << "cell " << cell << ", corner " << i;
    }
  }
}

}

TEST_F(ModelKinds, ObjFacesMayBeNumberedInAnyWay)
{
  const auto mesh = this->Load("a.obj",
    "vt 0 0\nvn 0 0 1\nvn 0 1 0\n" + BoxOfObj(0, "") + BoxOfObj(8, "/1/2") + BoxOfObj(16, "//2"));
  EXPECT_EQ(mesh->GetNumberOfPolys(), 18);
  EXPECT_THAT(this->NotShown(), HasSubstr("2 normals, which not all faces have"));
  EXPECT_EQ(this->Load("b.obj", Square + "vn 0 0 -1\nf -4//-1 -3//-1 -2//-1 -1/9/1\n")
              ->GetPointData()
              ->GetNormals()
              ->GetTuple(3)[2],
    -1.0)
    << "the file's own, though it is not the face's";
}

TEST_F(ModelKinds, ObjMayHaveWhatEditorsWrite)
{
  const auto mesh = this->Load("a.obj",
    "\xef\xbb\xbf# mark\r\nmtllib\r\n" + Square +
      "usemtl\r\nusemtl red\r\n  f 1 2 \\\r\n 3 4 # all four\r\ns off\r\ng\r\n\tf 1 2 3");
  ASSERT_EQ(mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(mesh->GetPolys()->GetNumberOfConnectivityIds(), 7) << "a continued line is one line";
  EXPECT_THAT(this->NotShown(), HasSubstr("a.obj' has what is not shown: 1 materials"));
}

TEST_F(ModelKinds, LinesMayEndAsOnAnySystem)
{
  const std::string ply =
    "\xef\xbb\xbfply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string obj = Square + "f 1 2 3\nf 1 3 4\n";
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    EXPECT_EQ(
      this->Load("a.ply", std::regex_replace(ply, std::regex("\n"), end))->GetNumberOfPolys(), 1);
    EXPECT_EQ(
      this->Load("a.obj", std::regex_replace(obj, std::regex("\n"), end))->GetNumberOfPolys(), 2);
  }
}

TEST_F(ModelKinds, TextIsNotRounded)
{
  EXPECT_EQ(this->Load("a.obj", "v 5403210.123 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")->GetPoint(0)[0],
    5403210.123);
  EXPECT_EQ(this
              ->Load("a.stl",
                "solid\nfacet normal 0 0 1\nouter loop\nvertex 5403210.123 0 0\nvertex 1 0 0\n"
                "vertex 0 1 0\nendloop\nendfacet\nendsolid\n")
              ->GetPoint(0)[0],
    5403210.123);
}

TEST_F(ModelKinds, ObjErrorsNameTheLine)
{
  EXPECT_THAT(this->ErrorOf("a.obj", "v 0 0\n"), HasSubstr("line 1: a number is missing"));
  EXPECT_THAT(this->ErrorOf("b.obj", "#\nv 0 x 0\n"), HasSubstr("line 2: 'x' is no number"));
  EXPECT_THAT(this->ErrorOf("c.obj", Square + "f 1 2 5\n"),
    HasSubstr("line 5: the face has a corner that does not exist, 5 of 4"));
  EXPECT_THAT(this->ErrorOf("d.obj", Square + "f 1 2 0\n"), HasSubstr("does not exist"));
  EXPECT_THAT(this->ErrorOf("e.obj", Square + "f 1 2 -5\n"), HasSubstr("does not exist"));
  EXPECT_THAT(this->ErrorOf("f.obj", Square + "f 1 2 3//1\n"), HasSubstr("normal that does not"));
  EXPECT_THAT(this->ErrorOf("g.obj", Square + "f 1 2 3x\n"), HasSubstr("'3x' is no corner"));
}

TEST_F(ModelKinds, WhatIsNotShownIsCountedAndNamed)
{
  EXPECT_EQ(this->Load("a.obj", Square + "f 1 2 3\n")->GetNumberOfPolys(), 1);
  EXPECT_EQ(this->NotShown(), "");
  this->Load("b.obj",
    Square + "f 1 2 3\nf 1 2\nf 1 1 1\nf 1 2 2 1\nl 1 2\nl 2 3\np 1\ncurv 0 1 1 2\nwhat\n");
  EXPECT_THAT(this->NotShown(),
    HasSubstr("3 faces of fewer than three corners, 1 free-form curves and surfaces, 2 lines, "
              "1 points, 1 statements of unknown kinds"));
  this->Load("c.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_index\n"
    "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n0 1\n");
  EXPECT_THAT(
    this->NotShown(), HasSubstr("1 faces of fewer than three corners, 1 of the element 'edge'"));
}

TEST_F(ModelKinds, StlInTextMayBeInCapitalsAndIndented)
{
  const std::string facet = "  FACET NORMAL 0 0 1\n    OUTER LOOP\n      VERTEX 0 0 0\n"
                            "      VERTEX 1 0 0\n      VERTEX 0 1 0\n    ENDLOOP\n  ENDFACET\n";
  EXPECT_EQ(this->Load("a.stl", "SOLID a b\n" + facet + "ENDSOLID a b\n")->GetNumberOfPolys(), 1);
  EXPECT_EQ(this->Load("b.stl", "\n  solid\n" + facet + " endsolid\n")->GetNumberOfPolys(), 1);
  const std::string solid = "solid x\n" + facet + "endsolid x\n";
  EXPECT_EQ(this->Load("c.stl", solid + solid)->GetNumberOfPolys(), 2) << "two solids";
  EXPECT_THAT(this->ErrorOf("d.stl", "solid x\n" + facet), HasSubstr("truncated"));
  EXPECT_THAT(this->ErrorOf("e.stl", "solid x\n" + facet.substr(0, 80)), HasSubstr("truncated"));
  std::string bad = solid;
  bad.replace(bad.find("1 0 0"), 1, "?");
  EXPECT_THAT(this->ErrorOf("f.stl", bad), HasSubstr("line 5: '?' is not a number"));
}

TEST_F(ModelKinds, BinaryStlMayBeginLikeText)
{
  std::string bytes =
    "solid of a program that says so in binary files, too, up to the 80th byte ...";
  bytes.resize(80, ' ');
  bytes += std::string("\1\1\1\0", 4);
  bytes.replace(80, 4, std::string("\1\0\0\0", 4));
  const float corners[12] = { 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0 };
  bytes.append(reinterpret_cast<const char*>(corners), sizeof(corners));
  bytes += std::string(2, '\0');
  EXPECT_EQ(this->Load("a.stl", bytes)->GetNumberOfPolys(), 1);
}

TEST_F(ModelKinds, PlyElementsMayStandInAnyOrder)
{
  const std::string bytes =
    "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(this->Load("a.ply", bytes)->GetNumberOfPolys(), 1);
  std::string bad = bytes;
  bad.replace(bad.find("3 0 1 2"), 7, "3 0 1 3");
  EXPECT_THAT(this->ErrorOf("b.ply", bad), HasSubstr("face 0 has a corner that does not exist"));
}

TEST_F(ModelKinds, PlyStripsAreTriangles)
{
  const auto mesh = this->Load("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 2 1 0\n");
  EXPECT_EQ(mesh->GetNumberOfPolys(), 3);
  EXPECT_EQ(this->NotShown(), "");
}

TEST_F(ModelKinds, EdgesStayHardBesideLinesVerticesAndStrips)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkCleanPolyData> shared;
  shared->SetInputConnection(triangles->GetOutputPort());
  shared->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(shared->GetOutput()->GetPoints());
  mesh->SetPolys(shared->GetOutput()->GetPolys());
  ASSERT_EQ(mesh->GetNumberOfPoints(), 8);
  const auto load = [&](const char* name, vtkPolyData* data)
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName((this->Folder / name).c_str());
    writer->SetInputData(data);
    writer->Write();
    return this->Load(name);
  };
  ExpectHardEdges(load("plain.vtp", mesh));

  const vtkIdType two[2] = { 0, 7 };
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, two);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, two);
  lines->InsertNextCell(2, two);
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  ExpectHardEdges(load("lines.vtp", mesh));
  EXPECT_THAT(this->NotShown(), HasSubstr("2 lines, 1 points"));

  vtkNew<vtkStripper> strips;
  strips->SetInputData(mesh);
  strips->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  ExpectHardEdges(load("strips.vtp", strips->GetOutput()));
}

TEST_F(ModelKinds, NormalsOfCellsStayWithThem)
{
  vtkNew<vtkPoints> points;
  for (const auto& p : { std::array<double, 3>{ { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } })
  {
    points->InsertNextPoint(p.data());
  }
  const vtkIdType ids[3] = { 0, 1, 2 };
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, ids);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell(3, ids);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(1, 0, 0);
  normals->InsertNextTuple3(0, 0, -1);
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  mesh->SetPolys(triangles);
  mesh->GetCellData()->SetNormals(normals);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName((this->Folder / "a.vtp").c_str());
  writer->SetInputData(mesh);
  writer->Write();
  const auto read = this->Load("a.vtp");
  ASSERT_EQ(read->GetNumberOfCells(), 1);
  ASSERT_EQ(read->GetCellData()->GetNormals()->GetNumberOfTuples(), 1);
  EXPECT_EQ(read->GetCellData()->GetNormals()->GetTuple(0)[2], -1.0);
}
