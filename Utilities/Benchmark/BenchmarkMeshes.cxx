// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeshes.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>      // For points
#include <cmath>      // For shapes
#include <filesystem> // For the folder
#include <random>     // For the engine, which is the same everywhere
#include <stdexcept>  // For errors

namespace softshadows
{
namespace
{

using Point = std::array<double, 3>;

constexpr double Pi = 3.14159265358979323846;

//--------------------------------------------------------------------------------------------------
// Uniform numbers; the library's own distributions differ between compilers.
class Numbers
{
public:
  explicit Numbers(unsigned int seed)
    : Engine(seed)
  {
  }

  double Between(double low, double high)
  {
    constexpr double most = 4294967296.0;
    return low + (high - low) * (this->Engine() / most);
  }

private:
  std::mt19937 Engine;
};

//--------------------------------------------------------------------------------------------------
vtkIdType Insert(vtkPoints* points, const Point& base, const std::array<Point, 3>& axes,
  double along, double across, double up)
{
  Point p;
  for (int i = 0; i < 3; ++i)
  {
    p[i] = base[i] + along * axes[0][i] + across * axes[1][i] + up * axes[2][i];
  }
  return points->InsertNextPoint(p.data());
}

//--------------------------------------------------------------------------------------------------
// Two diamonds' halves along a bent midrib.
void AddLeaf(vtkPoints* points, vtkCellArray* triangles, const Point& base, double heading,
  double pitch, double length)
{
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  const double cp = std::cos(pitch);
  const double sp = std::sin(pitch);
  const std::array<Point, 3> axes = { { { { c * cp, s * cp, sp } }, { { -s, c, 0.0 } },
    { { -c * sp, -s * sp, cp } } } };
  const vtkIdType root = Insert(points, base, axes, 0.0, 0.0, 0.0);
  const vtkIdType middle = Insert(points, base, axes, 0.55 * length, 0.0, 0.0);
  const vtkIdType left = Insert(points, base, axes, 0.5 * length, 0.22 * length, 0.08 * length);
  const vtkIdType right = Insert(points, base, axes, 0.5 * length, -0.22 * length, 0.08 * length);
  const vtkIdType tip = Insert(points, base, axes, length, 0.0, -0.15 * length);
  for (const std::array<vtkIdType, 3>& triangle : { std::array<vtkIdType, 3>{ root, middle, left },
         { root, right, middle }, { middle, tip, left }, { middle, right, tip } })
  {
    triangles->InsertNextCell(3, triangle.data());
  }
}

//--------------------------------------------------------------------------------------------------
// A number in [-1, 1] for every lattice point.
double Lattice(int x, int y)
{
  unsigned int h =
    static_cast<unsigned int>(x) * 374761393U + static_cast<unsigned int>(y) * 668265263U;
  h = (h ^ (h >> 13)) * 1274126177U;
  return ((h ^ (h >> 16)) & 0xffffU) / 32767.5 - 1.0;
}

//--------------------------------------------------------------------------------------------------
// Between lattice points, with flat tangents at them.
double Noise(double x, double y)
{
  const int ix = static_cast<int>(std::floor(x));
  const int iy = static_cast<int>(std::floor(y));
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = smooth(x - ix);
  const double v = smooth(y - iy);
  const double low = Lattice(ix, iy) + u * (Lattice(ix + 1, iy) - Lattice(ix, iy));
  const double high = Lattice(ix, iy + 1) + u * (Lattice(ix + 1, iy + 1) - Lattice(ix, iy + 1));
  return low + v * (high - low);
}

//--------------------------------------------------------------------------------------------------
double Height(double x, double y)
{
  double height = 0.0;
  double size = 0.9;
  double frequency = 0.6;
  for (int octave = 0; octave < 7; ++octave)
  {
    // Ridges where the noise changes its sign.
    height += size * (0.5 - std::abs(Noise(frequency * x + 17.0 * octave, frequency * y)));
    size *= 0.5;
    frequency *= 2.03;
  }
  return height;
}

//--------------------------------------------------------------------------------------------------
void Write(vtkPolyData* data, const std::string& path)
{
  const std::string unfinished = path + ".part";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(unfinished.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (!writer->Write())
  {
    throw std::runtime_error(path + ": cannot be written");
  }
  std::filesystem::rename(unfinished, path);
}

}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFoliage(int leaves)
{
  Numbers numbers(7);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int i = 0; i < leaves; ++i)
  {
    // Stems lean outwards from the ground; leaves sit along them.
    const double stem = 2.0 * Pi * std::floor(numbers.Between(0.0, 24.0)) / 24.0;
    const double along = std::sqrt(numbers.Between(0.02, 1.0));
    const double reach = 0.9 * along * along;
    const Point base = { { reach * std::cos(stem) + numbers.Between(-0.12, 0.12),
      reach * std::sin(stem) + numbers.Between(-0.12, 0.12),
      0.1 + 1.7 * along + numbers.Between(-0.15, 0.15) } };
    AddLeaf(points, triangles, base, numbers.Between(0.0, 2.0 * Pi), numbers.Between(-0.6, 0.5),
      numbers.Between(0.08, 0.2));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

//--------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTerrain(int cells)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  const int row = cells + 1;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double x = 8.0 * i / cells - 4.0;
      const double y = 8.0 * j / cells - 4.0;
      points->InsertNextPoint(x, y, Height(x, y));
    }
  }
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const vtkIdType a = static_cast<vtkIdType>(j) * row + i;
      const vtkIdType lower[3] = { a, a + 1, a + row + 1 };
      const vtkIdType upper[3] = { a, a + row + 1, a + row };
      triangles->InsertNextCell(3, lower);
      triangles->InsertNextCell(3, upper);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

//--------------------------------------------------------------------------------------------------
void WriteBenchmarkMeshes(const std::string& folder)
{
  std::filesystem::create_directories(folder);
  const std::string foliage = folder + "/foliage.vtp";
  if (!std::filesystem::exists(foliage))
  {
    Write(MakeFoliage(3000), foliage);
  }
  const std::string terrain = folder + "/terrain.vtp";
  if (!std::filesystem::exists(terrain))
  {
    Write(MakeTerrain(708), terrain); // 1,002,528 triangles
  }
}

}
