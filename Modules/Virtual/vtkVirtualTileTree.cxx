// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualTileTree.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int LeastResolution = 32;

// Every cell of to takes the least of the cells of from up to reach steps away, along one axis.
void TakeLeast(const vtkVirtualTileTree::Level& from, vtkVirtualTileTree::Level& to, int reach,
  int step, int across)
{
  const int last = vtkVirtualTileTree::GridSize - 1;
  for (int line = 0; line <= last; ++line)
  {
    for (int i = 0; i <= last; ++i)
    {
      vtkVirtualTileTree::Cell& cell = to[static_cast<size_t>(line * across + i * step)];
      for (int k = std::max(i - reach, 0); k <= std::min(i + reach, last); ++k)
      {
        const vtkVirtualTileTree::Cell& other = from[static_cast<size_t>(line * across + k * step)];
        cell.R0 = std::min(cell.R0, other.R0);
        cell.R1 = std::min(cell.R1, other.R1);
      }
    }
  }
}
} // namespace

// A square of a pyramid's level, or the half of one.
struct vtkVirtualTileTree::Node
{
  int Level; // of the square's, or, for a half, of the two squares it consists of
  int X;     // of its first square on that level
  int Y;
  int Columns; // 1 or 2
  int Rows;
};

struct vtkVirtualTileTree::Plan
{
  double Cost = 0.0;
  std::vector<vtkVirtualTile> Tiles;
};

//------------------------------------------------------------------------------
vtkVirtualTileTree::Pyramid vtkVirtualTileTree::MakePyramid(const Level& grid)
{
  Pyramid pyramid(1, grid);
  for (int size = GridSize / 2; size >= 1; size /= 2)
  {
    const Level& fine = pyramid.back();
    Level coarse(static_cast<size_t>(size) * size);
    for (int y = 0; y < 2 * size; ++y)
    {
      for (int x = 0; x < 2 * size; ++x)
      {
        const Cell& from = fine[static_cast<size_t>(y) * 2 * size + x];
        Cell& to = coarse[static_cast<size_t>(y / 2) * size + x / 2];
        to.R0 = std::min(to.R0, from.R0);
        to.R1 = std::min(to.R1, from.R1);
      }
    }
    pyramid.push_back(coarse);
  }
  return pyramid;
}

//------------------------------------------------------------------------------
vtkVirtualTileTree::Level vtkVirtualTileTree::Widen(const Level& grid, float coarsest, int reach)
{
  Level rows(grid.size(), Cell{ coarsest, coarsest });
  Level wide(grid.size(), Cell{ coarsest, coarsest });
  TakeLeast(grid, rows, reach, 1, GridSize);
  TakeLeast(rows, wide, reach, GridSize, 1);
  return wide;
}

//------------------------------------------------------------------------------
double vtkVirtualTileTree::GetExcess(const Level& grid) const
{
  Level sizes(grid.size()); // of the texels that there are
  for (const vtkVirtualTile& tile : this->Tiles)
  {
    const float r0 = static_cast<float>(tile.Width) / GridSize / tile.Resolution;
    const float r1 = static_cast<float>(tile.Height) / GridSize / tile.Resolution;
    for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
    {
      std::fill_n(sizes.begin() + y * GridSize + tile.X, tile.Width, Cell{ r0, r1 });
    }
  }
  double excess = 1.0;
  for (size_t i = 0; i < grid.size(); ++i)
  {
    if (std::min(grid[i].R0, grid[i].R1) < Unused)
    {
      const double worst = std::max(sizes[i].R0 / grid[i].R0, sizes[i].R1 / grid[i].R1);
      excess = std::max(excess, std::min(worst, static_cast<double>(Unused)));
    }
  }
  return excess;
}

//------------------------------------------------------------------------------
int vtkVirtualTileTree::GetResolution(double texels, int largestTile)
{
  // 32, 48, 64, 96, 128, ...: never more than half as fine again as need be.
  for (int size = LeastResolution; size < largestTile; size *= 2)
  {
    for (const int candidate : { size, size + size / 2 })
    {
      if (candidate >= texels && candidate <= largestTile)
      {
        return candidate;
      }
    }
  }
  return largestTile;
}

//------------------------------------------------------------------------------
vtkVirtualTileTree::Cell vtkVirtualTileTree::GetLeast(const Node& node) const
{
  const Level& level = (*this->Input)[node.Level];
  const int size = GridSize >> node.Level;
  Cell least;
  for (int y = node.Y; y < node.Y + node.Rows; ++y)
  {
    for (int x = node.X; x < node.X + node.Columns; ++x)
    {
      const Cell& cell = level[static_cast<size_t>(y) * size + x];
      least.R0 = std::min(least.R0, cell.R0);
      least.R1 = std::min(least.R1, cell.R1);
    }
  }
  return least;
}

//------------------------------------------------------------------------------
double vtkVirtualTileTree::GetNeed(const Node& node) const
{
  const Cell least = this->GetLeast(node);
  const double size = static_cast<double>(1 << node.Level) / GridSize;
  return std::max(node.Columns * size / least.R0, node.Rows * size / least.R1) / this->Factor;
}

//------------------------------------------------------------------------------
bool vtkVirtualTileTree::CutInto(const Node& node, bool horizontally, Node parts[2]) const
{
  const bool square = node.Columns == node.Rows;
  if (square ? node.Level == 0 : (node.Columns == 2) != horizontally)
  {
    return false;
  }
  parts[0] = node;
  if (square)
  {
    // Half a square is two squares of the level below.
    parts[0] = { node.Level - 1, 2 * node.X, 2 * node.Y, 2, 2 };
  }
  (horizontally ? parts[0].Columns : parts[0].Rows) = 1;
  parts[1] = parts[0];
  (horizontally ? parts[1].X : parts[1].Y) += 1;
  return true;
}

//------------------------------------------------------------------------------
vtkVirtualTileTree::Plan vtkVirtualTileTree::PlanNode(const Node& node, const Limits& limits)
{
  Plan best;
  const Cell least = this->GetLeast(node);
  if (std::min(least.R0, least.R1) >= Unused)
  {
    return best;
  }
  const double need = this->GetNeed(node);
  const bool isCell = node.Level == 0 && node.Columns == 1 && node.Rows == 1;
  if (isCell)
  {
    this->Largest = std::max(this->Largest, need);
  }
  const bool fits = need <= limits.LargestTile || isCell;
  if (fits)
  {
    const int resolution = GetResolution(need, limits.LargestTile);
    best.Cost = limits.TileCost + static_cast<double>(resolution) * resolution;
    best.Tiles.push_back({ node.X << node.Level, node.Y << node.Level, node.Columns << node.Level,
      node.Rows << node.Level, resolution });
    // Two tiles of the least size are dearer than this one.
    if (best.Cost <= 2.0 * limits.TileCost)
    {
      return best;
    }
  }
  bool found = fits;
  for (const bool horizontally : { true, false })
  {
    Node parts[2];
    if (!this->CutInto(node, horizontally, parts))
    {
      continue;
    }
    Plan first = this->PlanNode(parts[0], limits);
    const Plan second = this->PlanNode(parts[1], limits);
    const double cost = first.Cost + second.Cost;
    if (!found || cost < best.Cost)
    {
      found = true;
      best.Cost = cost;
      best.Tiles.swap(first.Tiles);
      best.Tiles.insert(best.Tiles.end(), second.Tiles.begin(), second.Tiles.end());
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void vtkVirtualTileTree::Collect(const Limits& limits)
{
  this->Largest = 0.0;
  this->Tiles = this->PlanNode({ GridLevels - 1, 0, 0, 1, 1 }, limits).Tiles;
  this->Texels = 0.0;
  for (const vtkVirtualTile& tile : this->Tiles)
  {
    this->Texels += static_cast<double>(tile.Resolution) * tile.Resolution;
  }
}

//------------------------------------------------------------------------------
void vtkVirtualTileTree::Build(const Pyramid& pyramid, const Limits& limits)
{
  this->Input = &pyramid;
  this->Factor = 1.0;
  this->Collect(limits);
  double worst = std::max(this->Largest / limits.LargestTile, 1.0);
  while ((this->Texels > limits.MostTexels ||
           this->Tiles.size() > static_cast<size_t>(limits.MostTiles)) &&
    this->Factor < 1e6)
  {
    // Cells beyond the largest tile stay as they are until the rest has come down to them.
    this->Factor *= 1.189207115; // the fourth root of 2
    this->Collect(limits);
    worst = std::max(worst, this->Factor);
  }
  this->Coarsening = worst;
  this->Input = nullptr;
}

//------------------------------------------------------------------------------
void vtkVirtualTileTree::BuildUniform(int count, const Limits& limits)
{
  const auto most = static_cast<int>(std::sqrt(limits.MostTexels));
  const int resolution = std::max(std::min(limits.LargestTile, most) / count, LeastResolution);
  const int cells = GridSize / count;
  this->Tiles.clear();
  for (int i = 0; i < count * count; ++i)
  {
    this->Tiles.push_back({ i % count * cells, i / count * cells, cells, cells, resolution });
  }
  this->Texels = static_cast<double>(resolution) * resolution * count * count;
  this->Coarsening = static_cast<double>(limits.LargestTile) / (resolution * count);
}
VTK_ABI_NAMESPACE_END
