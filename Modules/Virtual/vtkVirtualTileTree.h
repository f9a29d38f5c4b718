// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVirtualTileTree
 * @brief   Cuts the map's plane into tiles that are as fine as the cells they cover ask for.
 *
 * L. Shen et al. 2011, section 5.2, after Giegl and Wimmer 2007. The grid holds, per cell and axis,
 * the texel size that is asked for (in units of the whole map, infinite where nothing is). Its
 * pyramid of minima is walked from the top: a node is a square of cells, or half a square, and is
 * cut along either axis. The paper stops at the first node that fits the largest tile; here a node
 * is also cut where its parts need fewer texels, so that one fine spot does not refine all of its
 * tile. Parts that nobody looks at cost nothing and are no tiles.
 *
 * Tiles have one of a few resolutions, so that they may share textures and stay the same while the
 * camera moves a little.
 */

#ifndef vtkVirtualTileTree_h
#define vtkVirtualTileTree_h

#include "vtkRenderingSoftShadowsVirtualModule.h" // For export macro
#include "vtkSoftShadowsABI.h"                    // For the ABI namespace

#include <cstddef> // For size_t
#include <vector>  // For tiles

VTK_ABI_NAMESPACE_BEGIN

/// A rectangle of cells, and the texels along each edge of its map.
struct VTKRENDERINGSOFTSHADOWSVIRTUAL_EXPORT vtkVirtualTile
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;
  int Resolution = 0;

  bool operator==(const vtkVirtualTile& other) const
  {
    return this->X == other.X && this->Y == other.Y && this->Width == other.Width &&
      this->Height == other.Height && this->Resolution == other.Resolution;
  }
};

class VTKRENDERINGSOFTSHADOWSVIRTUAL_EXPORT vtkVirtualTileTree
{
public:
  /// Cells along an edge of the grid, and levels of its pyramid: 64, 32, ... 1.
  static constexpr int GridSize = 64;
  static constexpr int GridLevels = 7;
  /// What stands for infinity in a grid.
  static constexpr float Unused = 1e30f;

  /// The texel sizes (r0, r1) of a cell; a level is a row-major square of them.
  struct Cell
  {
    float R0 = Unused;
    float R1 = Unused;
  };
  using Level = std::vector<Cell>;
  /// Level 0 first.
  using Pyramid = std::vector<Level>;

  struct Limits
  {
    /// Texels along the edge of the largest tile, at least 32.
    int LargestTile = 4096;
    /// Texels of all tiles together, and their number.
    double MostTexels = 268435456.0;
    int MostTiles = 256;
    /// What every tile costs beside its texels, in texels: draw calls and a pass over the screen.
    double TileCost = 512.0 * 512.0;
  };

  /// Minima over 2 x 2 cells, up to a single one. The GPU does the same.
  static Pyramid MakePyramid(const Level& grid);

  /**
   * A grid that serves for another picture than it was drawn for, a frame later: every cell asks for
   * the least of the texel sizes of the cells around it, up to reach cells away, and none, not even the
   * unused ones, for more than coarsest.
   */
  static Level Widen(const Level& grid, float coarsest, int reach = 1);

  /// The least resolution a tile may have that is no less than this; at most the largest tile.
  static int GetResolution(double texels, int largestTile);

  /**
   * Cuts the plane. Every cell that is not Unused lies in exactly one tile. Where the limits do not
   * allow what is asked for, all texels grow by the same factor until they do.
   */
  void Build(const Pyramid& pyramid, const Limits& limits);

  /**
   * One map of the largest size over everything, within the limit of texels, cut into count x count
   * tiles; count is a power of two up to GridSize.
   */
  void BuildUniform(int count, const Limits& limits);

  const std::vector<vtkVirtualTile>& GetTiles() const { return this->Tiles; }
  double GetTexels() const { return this->Texels; }

  /// By how much texels of the tiles are larger than this grid asks for, at worst, and at least 1;
  /// Unused if a tile is missing.
  double GetExcess(const Level& grid) const;

  /// By how much texels are larger than asked for: 1 if the limits were kept without.
  double GetCoarsening() const { return this->Coarsening; }

private:
  struct Node;
  struct Plan;
  Plan PlanNode(const Node& node, const Limits& limits);
  bool CutInto(const Node& node, bool horizontally, Node parts[2]) const;
  Cell GetLeast(const Node& node) const;
  double GetNeed(const Node& node) const;
  void Collect(const Limits& limits);

  const Pyramid* Input = nullptr;
  double Factor = 1.0;
  double Largest = 0.0; // what a single cell asks for
  std::vector<vtkVirtualTile> Tiles;
  double Texels = 0.0;
  double Coarsening = 1.0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkVirtualTileTree.h
