// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCasterGeometry
 * @brief   The triangles of one caster in model coordinates, and what is known of their shape.
 *
 * Polygons become fans and strips become triangles exactly as VTK's own mapper draws them, so both
 * ways of drawing a caster give the same depth. Triangles with a non-finite vertex are left out, and
 * so are points that no triangle uses: bounds are those of what is drawn.
 */

#ifndef vtkShadowCasterGeometry_h
#define vtkShadowCasterGeometry_h

#include "vtkDataArray.h"                        // For the points
#include "vtkRenderingSoftShadowsBakingModule.h" // For export macro
#include "vtkShadowCasterClusters.h"             // For the clusters
#include "vtkSmartPointer.h"                     // For the points
#include "vtkSoftShadowsABI.h"                   // For the ABI namespace

#include <array>   // For corners
#include <cstdint> // For indices
#include <vector>  // For indices

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkPolyData;

class VTKRENDERINGSOFTSHADOWSBAKING_EXPORT vtkShadowCasterGeometry
{
public:
  /// Takes the polygons and strips of the pieces in place of what was held.
  void Build(const std::vector<vtkPolyData*>& pieces);
  void Clear();

  std::size_t GetNumberOfVertices() const { return this->NumberOfVertices; }
  const std::vector<std::uint32_t>& GetIndices() const { return this->Indices; }

  /**
   * Writes matrix * point - origin as 3 floats per vertex (matrix: row-major, affine) and the bounds
   * of matrix * point {xmin, xmax, ymin, ymax, zmin, zmax}. False, with nothing to be drawn, if a
   * result is not finite.
   */
  bool Transform(
    const double matrix[16], const double origin[3], float* xyz, double bounds[6]) const;

  /// All vertices lie in one plane, to 1e-6 of the extent.
  bool IsFlat() const { return this->Flat; }
  /// If flat: the corners of a rectangle in that plane that holds all vertices, in order around it.
  const std::array<std::array<double, 3>, 4>& GetCorners() const { return this->Corners; }

  /// Parts of the mesh for the fit of maps, in model coordinates; none if it is best taken as a whole.
  const std::vector<vtkShadowCasterClusters::Cluster>& GetClusters() const
  {
    return this->Clusters;
  }

  /// Two texture coordinates per vertex, 0 where there are none.
  std::vector<float> GatherTextureCoordinates() const;

  /// See vtkShadowCasterOrientation.
  int FindOrientation() const;

private:
  /// The points of one piece; vertex i is point Ids[i], or point i if Ids is empty.
  struct Piece
  {
    vtkSmartPointer<vtkDataArray> Points;
    vtkSmartPointer<vtkDataArray> TextureCoordinates; // null if there are none
    std::vector<vtkIdType> Ids;
    std::size_t NumberOfVertices = 0;
  };

  void AddPiece(vtkPolyData* data);
  void AddPolygons(vtkCellArray* cells, vtkIdType numberOfPoints);
  void AddStrips(vtkCellArray* cells, vtkIdType numberOfPoints);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c);
  void RenumberPiece(Piece& piece, std::size_t firstIndex, vtkIdType numberOfPoints);
  void FindPlane();
  void FindClusters();
  std::vector<double> GatherPoints() const;
  bool FindNormal(std::array<double, 3>& base, std::array<double, 3>& axis,
    std::array<double, 3>& normal, double& extent) const;
  void FindCorners(const std::array<double, 3>& base, const std::array<double, 3>& axis,
    const std::array<double, 3>& normal);

  template <typename Functor>
  void ForEachVertex(Functor&& functor) const;

  std::vector<Piece> Pieces;
  std::vector<std::uint32_t> Indices;
  std::vector<char> Finite;             // of the piece's points; empty if all are
  std::vector<std::uint32_t> NewNumber; // of the piece's points
  std::size_t NumberOfVertices = 0;
  bool Flat = false;
  std::array<std::array<double, 3>, 4> Corners{};
  std::vector<vtkShadowCasterClusters::Cluster> Clusters;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCasterGeometry.h
