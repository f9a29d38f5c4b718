// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowStrokes
 * @brief   The points and lines of one caster, which are as wide as the picture draws them.
 *
 * VTK draws points and lines so many pixels wide. A pixel of a depth map is another size, and is so at
 * each distance. Here points and lines are kept by themselves, and drawn into a map with the width in
 * the world that they have in the picture (see vtkShadowScreen): as spheres and tubes where the
 * property says so, as flat squares and bands where it does not.
 */

#ifndef vtkShadowStrokes_h
#define vtkShadowStrokes_h

#include "vtkShadowScreen.h"   // For pixels
#include "vtkSoftShadowsABI.h" // For the ABI namespace
#include "vtkType.h"           // For ids

#include <array>  // For bounds
#include <vector> // For points

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkProperty;
class vtkShadowStrokeProgram;

class vtkShadowStrokes
{
public:
  vtkShadowStrokes() = default;
  /// Needs ReleaseGraphicsResources before.
  ~vtkShadowStrokes() = default;
  vtkShadowStrokes(const vtkShadowStrokes&) = delete;
  void operator=(const vtkShadowStrokes&) = delete;

  /// Whether a property draws points or lines of the pieces wider than a pixel.
  static bool AreWide(const std::vector<vtkPolyData*>& pieces, vtkProperty* property);

  /// Takes the points and lines of the pieces, as the property draws them, in place of what was held.
  void Build(const std::vector<vtkPolyData*>& pieces, vtkProperty* property);

  /// Row-major, affine. False if nothing is to be drawn.
  bool Place(const std::array<double, 16>& matrix);

  /// World coordinates of everything that is drawn, widths included.
  std::array<double, 6> FindBounds(const vtkShadowScreen& screen) const;

  /// With the program in use for a map; returns the number of draw calls.
  int Draw(vtkShadowStrokeProgram& program, const vtkShadowScreen& screen);

  void ReleaseGraphicsResources();

  ///@{
  /// As placed: 3 coordinates per end relative to the centre, two ends per stroke, dots before lines.
  const std::vector<float>& GetEnds() const { return this->Local; }
  const std::array<double, 3>& GetCenter() const { return this->Center; }
  int GetNumberOfDots() const { return this->NumberOfDots; }
  ///@}

  ///@{
  /// How they are drawn; sizes in pixels.
  double GetPointSize() const { return this->PointSize; }
  double GetLineWidth() const { return this->LineWidth; }
  bool HasSpheres() const { return this->Spheres; }
  bool HasTubes() const { return this->Tubes; }
  ///@}

private:
  void AddDots(vtkPoints* points, vtkCellArray* cells, std::vector<char>& isDone);
  void AddLines(vtkPoints* points, vtkCellArray* cells, bool closed, bool strips);
  void AddStroke(vtkPoints* points, vtkIdType a, vtkIdType b);
  void Upload(unsigned int location);

  std::vector<double> Ends; // in model coordinates, 3 per end, 2 ends per stroke; dots before lines
  std::vector<float> Local; // the same, relative to Center
  std::array<double, 3> Center{};
  std::array<double, 6> Bounds{}; // of the ends
  int NumberOfDots = 0;
  int NumberOfLines = 0;
  double PointSize = 1.0; // pixels
  double LineWidth = 1.0;
  bool Spheres = false;
  bool Tubes = false;
  bool IsUploaded = false;
  unsigned int VertexArray = 0;
  unsigned int VertexBuffer = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowStrokes.h
