// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ModelStore.h"

#include "GltfFile.h"
#include "ObjFile.h"
#include "PlyFile.h"
#include "StlFile.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleStrip.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <stdexcept>

namespace softshadows
{
namespace
{

namespace fs = std::filesystem;

/// Takes VTK's messages in place of the terminal.
class MessageCollector : public vtkOutputWindow
{
public:
  static MessageCollector* New();
  vtkTypeMacro(MessageCollector, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Keep(text); }
  void DisplayGenericWarningText(const char* text) override { this->Keep(text); }
  void DisplayWarningText(const char*) override {}

  std::string FirstError;

private:
  void Keep(const char* text)
  {
    if (!this->FirstError.empty())
    {
      return;
    }
    // "ERROR: In file, line 7\nvtkFooReader (0x1234): what went wrong\n\n"
    std::string message = text;
    const std::size_t address = message.find("): ");
    message = address == std::string::npos ? message : message.substr(address + 3);
    message = message.substr(0, message.find('\n'));
    this->FirstError = message.empty() ? "the reader failed" : message;
  }
};
vtkStandardNewMacro(MessageCollector);

/// While it lives VTK's errors are collected, and its log does not write them to the terminal too.
class MessagesTaken
{
public:
  MessagesTaken()
    : Before(vtkOutputWindow::GetInstance())
    , VerbosityBefore(vtkLogger::GetCurrentVerbosityCutoff())
  {
    vtkOutputWindow::SetInstance(this->Collector);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~MessagesTaken()
  {
    vtkLogger::SetStderrVerbosity(this->VerbosityBefore);
    vtkOutputWindow::SetInstance(this->Before);
  }
  MessagesTaken(const MessagesTaken&) = delete;
  MessagesTaken& operator=(const MessagesTaken&) = delete;

  const std::string& GetFirstError() const { return this->Collector->FirstError; }

private:
  vtkNew<MessageCollector> Collector;
  vtkSmartPointer<vtkOutputWindow> Before;
  vtkLogger::Verbosity VerbosityBefore;
};

/// vtkXMLPolyDataReader does not miss what stands behind the data it reads.
void CheckEndOfVtp(const std::string& path)
{
  constexpr std::streamoff longestEnd = 256;
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.tellg();
  const std::streamoff length = std::min(size, longestEnd);
  std::string end(static_cast<std::size_t>(std::max<std::streamoff>(length, 0)), ' ');
  stream.seekg(size - length);
  stream.read(&end[0], length);
  if (end.find("</VTKFile>") == std::string::npos)
  {
    throw std::runtime_error("truncated, or no VTK file");
  }
}

ModelFile ReadVtp(const std::string& path)
{
  CheckEndOfVtp(path);
  const MessagesTaken messages;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!messages.GetFirstError().empty())
  {
    throw std::runtime_error("damaged or truncated: " + messages.GetFirstError());
  }
  ModelFile file;
  file.Mesh = reader->GetOutput();
  return file;
}

std::string LowerCaseEnding(const std::string& path)
{
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending.empty() ? ending : ending.substr(1);
}

ModelFile ReadByKind(const std::string& path, const std::string& kind)
{
  if (kind == "ply")
  {
    return ReadPly(path);
  }
  if (kind == "obj")
  {
    return ReadObj(path);
  }
  if (kind == "stl")
  {
    return ReadStl(path);
  }
  if (kind == "glb" || kind == "gltf")
  {
    return ReadGltf(path);
  }
  ModelFile file = ReadVtp(path);
  file.Mesh->GetPointData()->RemoveArray(ModelColors); // the file's arrays are its own affair
  return file;
}

std::string ListOfKinds()
{
  std::string list;
  for (const std::string& kind : ModelStore::GetKinds())
  {
    list += (list.empty() ? "" : ", ") + kind;
  }
  return list;
}

void CheckCorners(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(count, corners);
    if (std::any_of(corners, corners + count,
          [numberOfPoints](vtkIdType corner) { return corner < 0 || corner >= numberOfPoints; }))
    {
      throw std::runtime_error("damaged: a polygon has a corner that does not exist");
    }
  }
}

void CheckMesh(const ModelFile& file)
{
  vtkPolyData* mesh = file.Mesh;
  if (mesh->GetNumberOfPolys() == 0 && mesh->GetNumberOfStrips() == 0)
  {
    throw std::runtime_error("is empty: it has no polygon" +
      (file.NotShown.empty() ? "" : ", but what is not shown: " + file.DescribeNotShown()));
  }
  CheckCorners(mesh->GetPolys(), mesh->GetNumberOfPoints());
  CheckCorners(mesh->GetStrips(), mesh->GetNumberOfPoints());
}

/// Cells all of whose corners are finite.
vtkSmartPointer<vtkCellArray> FiniteCells(vtkCellArray* cells, const std::vector<bool>& isFinite)
{
  auto kept = vtkSmartPointer<vtkCellArray>::New();
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(count, corners);
    if (std::all_of(corners, corners + count,
          [&](vtkIdType corner) { return isFinite[static_cast<std::size_t>(corner)]; }))
    {
      kept->InsertNextCell(count, corners);
    }
  }
  return kept;
}

/// Strips as triangles, lines and vertices left out: edges are split among polygons only.
void KeepPolygons(ModelFile& file)
{
  vtkPolyData* mesh = file.Mesh;
  const vtkIdType before = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  if (before + mesh->GetNumberOfStrips() == 0)
  {
    return;
  }
  vtkDataArray* given = mesh->GetCellData()->GetNormals();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkIdType cellId = before;
  const auto keepNormal = [&](vtkIdType times)
  {
    for (vtkIdType i = 0; given && i < times; ++i)
    {
      normals->InsertNextTuple(given->GetTuple(cellId));
    }
    ++cellId;
  };
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(mesh->GetPolys());
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    keepNormal(1);
  }
  const auto strip = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (strip->GoToFirstCell(); !strip->IsDoneWithTraversal(); strip->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    strip->GetCurrentCell(count, corners);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(count), corners, polygons);
    keepNormal(count - 2);
  }
  if (mesh->GetNumberOfVerts() > 0)
  {
    file.NotShown[PointCells] += mesh->GetNumberOfVerts();
  }
  if (mesh->GetNumberOfLines() > 0)
  {
    file.NotShown[LineCells] += mesh->GetNumberOfLines();
  }
  auto kept = vtkSmartPointer<vtkPolyData>::New();
  kept->SetPoints(mesh->GetPoints());
  kept->GetPointData()->ShallowCopy(mesh->GetPointData());
  kept->SetPolys(polygons);
  if (given)
  {
    kept->GetCellData()->SetNormals(normals);
  }
  file.Mesh = kept;
}

/// Points that are no numbers would spoil every bounding box: what hangs on them is left out.
void KeepFinitePolygons(ModelFile& file)
{
  vtkPolyData* mesh = file.Mesh;
  std::vector<bool> isFinite(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  vtkIdType finite = -1;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    isFinite[static_cast<std::size_t>(i)] =
      std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    finite = isFinite[static_cast<std::size_t>(i)] ? i : finite;
  }
  if (std::find(isFinite.begin(), isFinite.end(), false) == isFinite.end())
  {
    return;
  }
  auto kept = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->DeepCopy(mesh->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints() && finite >= 0; ++i)
  {
    if (!isFinite[static_cast<std::size_t>(i)])
    {
      points->SetPoint(i, mesh->GetPoint(finite));
    }
  }
  kept->SetPoints(points);
  kept->GetPointData()->ShallowCopy(mesh->GetPointData());
  kept->SetPolys(FiniteCells(mesh->GetPolys(), isFinite));
  if (kept->GetNumberOfCells() == 0)
  {
    throw std::runtime_error("is empty: no polygon has finite corners");
  }
  if (kept->GetNumberOfPolys() < mesh->GetNumberOfPolys())
  {
    file.NotShown[FacesNotFinite] += mesh->GetNumberOfPolys() - kept->GetNumberOfPolys();
  }
  file.Mesh = kept;
}

vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* mesh)
{
  if (mesh->GetPointData()->GetNormals() || mesh->GetCellData()->GetNormals())
  {
    return mesh;
  }
  constexpr double sharpEdge = 60.0;
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetFeatureAngle(sharpEdge);
  normals->ConsistencyOff(); // the file's own orientation
  normals->Update();
  return normals->GetOutput();
}

}

//--------------------------------------------------------------------------------------------------
const std::vector<std::string>& ModelStore::GetKinds()
{
  static const std::vector<std::string> kinds = { "ply", "obj", "stl", "vtp", "glb", "gltf" };
  return kinds;
}

//--------------------------------------------------------------------------------------------------
std::string ModelStore::Find(const ModelShape& model, const std::string& sceneFolder) const
{
  const fs::path name(model.File);
  std::vector<fs::path> candidates;
  if (name.is_absolute())
  {
    candidates.push_back(name);
  }
  else
  {
    candidates.push_back(fs::path(sceneFolder) / name);
    for (const std::string& folder : this->Folders)
    {
      candidates.push_back(fs::path(folder) / name);
    }
  }
  std::string looked;
  for (const fs::path& candidate : candidates)
  {
    std::error_code error;
    if (fs::is_regular_file(candidate, error))
    {
      return candidate.string();
    }
    const std::string folder = candidate.parent_path().string();
    looked += (looked.empty() ? "" : ", ") + (folder.empty() ? "." : folder);
  }
  throw SceneError(model.Place, "no such file '" + model.File + "' in " + looked);
}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ModelStore::Load(
  const ModelShape& model, const std::string& sceneFolder)
{
  const std::string kind = LowerCaseEnding(model.File);
  const std::vector<std::string>& kinds = GetKinds();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
  {
    throw SceneError(model.Place,
      "'" + model.File + "' is no model: files of the kinds " + ListOfKinds() + " are");
  }
  const std::string path = this->Find(model, sceneFolder);
  vtkSmartPointer<vtkPolyData>& mesh = this->Meshes[path];
  if (mesh)
  {
    return mesh;
  }
  try
  {
    ModelFile file = ReadByKind(path, kind);
    CheckMesh(file);
    KeepPolygons(file);
    KeepFinitePolygons(file);
    if (!file.NotShown.empty())
    {
      this->NotShown.push_back("'" + path + "' has what is not shown: " + file.DescribeNotShown());
    }
    mesh = WithNormals(file.Mesh);
  }
  catch (const std::bad_alloc&)
  {
    throw SceneError(model.Place, "'" + path + "' does not fit into memory");
  }
  catch (const std::runtime_error& error)
  {
    throw SceneError(model.Place, "'" + path + "' " + error.what());
  }
  return mesh;
}

}
