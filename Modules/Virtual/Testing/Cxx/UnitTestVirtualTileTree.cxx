// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The tree of tiles over random grids, and the fitted resolutions.

#include "vtkVirtualResolution.h"
#include "vtkVirtualTileTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{
constexpr int Size = vtkVirtualTileTree::GridSize;

// A few patches that ask for something, over nothing.
vtkVirtualTileTree::Level RandomGrid(std::mt19937& random, double finest)
{
  vtkVirtualTileTree::Level grid(Size * Size);
  std::uniform_int_distribution<int> cell(0, Size - 1);
  std::uniform_real_distribution<double> exponent(std::log2(finest), -4.0);
  std::uniform_int_distribution<int> count(1, 12);
  for (int patches = count(random); patches > 0; --patches)
  {
    const int x0 = cell(random);
    const int y0 = cell(random);
    const int width = 1 + cell(random) / 3;
    const int height = 1 + cell(random) / 3;
    const float r0 = static_cast<float>(std::exp2(exponent(random)));
    const float r1 = static_cast<float>(std::exp2(exponent(random)));
    for (int y = y0; y < std::min(y0 + height, Size); ++y)
    {
      for (int x = x0; x < std::min(x0 + width, Size); ++x)
      {
        vtkVirtualTileTree::Cell& at = grid[y * Size + x];
        at.R0 = std::min(at.R0, r0);
        at.R1 = std::min(at.R1, r1);
      }
    }
  }
  return grid;
}

// How often each cell is covered, and whether a tile is fine enough for all its cells.
void CheckTiles(
  const vtkVirtualTileTree::Level& grid, const vtkVirtualTileTree& tree, int largestTile)
{
  std::vector<int> covered(Size * Size, 0);
  for (const vtkVirtualTile& tile : tree.GetTiles())
  {
    ASSERT_LE(tile.Resolution, largestTile);
    const double texel0 = static_cast<double>(tile.Width) / Size / tile.Resolution;
    const double texel1 = static_cast<double>(tile.Height) / Size / tile.Resolution;
    for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
    {
      for (int x = tile.X; x < tile.X + tile.Width; ++x)
      {
        ++covered[y * Size + x];
        const vtkVirtualTileTree::Cell& cell = grid[y * Size + x];
        ASSERT_LE(texel0, cell.R0 * tree.GetCoarsening() * 1.000001) << x << ", " << y;
        ASSERT_LE(texel1, cell.R1 * tree.GetCoarsening() * 1.000001) << x << ", " << y;
      }
    }
  }
  for (int i = 0; i < Size * Size; ++i)
  {
    const bool used = grid[i].R0 < vtkVirtualTileTree::Unused;
    ASSERT_LE(covered[i], 1) << "cell " << i;
    ASSERT_TRUE(covered[i] == 1 || !used) << "cell " << i;
  }
}
} // namespace

TEST(VirtualTileTree, CoversEveryCellOnceAndFineEnough)
{
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i)
  {
    const vtkVirtualTileTree::Level grid = RandomGrid(random, 1e-5);
    vtkVirtualTileTree tree;
    vtkVirtualTileTree::Limits limits;
    limits.LargestTile = 512 << (i % 4);
    limits.MostTexels = 1e12;
    limits.MostTiles = Size * Size;
    tree.Build(vtkVirtualTileTree::MakePyramid(grid), limits);
    CheckTiles(grid, tree, limits.LargestTile);
    EXPECT_NEAR(tree.GetCoarsening(), 1.0, 4.0 * 1e5 / Size / limits.LargestTile) << "grid " << i;
  }
}

TEST(VirtualTileTree, KeepsItsLimitsAndSaysByHowMuch)
{
  std::mt19937 random(4);
  int limited = 0;
  for (int i = 0; i < 100; ++i)
  {
    const vtkVirtualTileTree::Level grid = RandomGrid(random, 1e-5);
    vtkVirtualTileTree tree;
    vtkVirtualTileTree::Limits limits;
    limits.LargestTile = 1024;
    limits.MostTexels = 4.0 * 1024 * 1024;
    limits.MostTiles = 6;
    tree.Build(vtkVirtualTileTree::MakePyramid(grid), limits);
    EXPECT_LE(tree.GetTexels(), limits.MostTexels) << "grid " << i;
    EXPECT_LE(tree.GetTiles().size(), 6u) << "grid " << i;
    CheckTiles(grid, tree, limits.LargestTile);
    limited += tree.GetCoarsening() > 1.0 ? 1 : 0;
  }
  EXPECT_GT(limited, 20);
}

TEST(VirtualTileTree, AWideGridServesWhatMovesByACell)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> step(-1, 1);
  constexpr float Coarsest = 1.0f / 1024.0f;
  for (int i = 0; i < 60; ++i)
  {
    const vtkVirtualTileTree::Level grid = RandomGrid(random, 1e-4);
    const int reach = 1 + i % 5;
    const vtkVirtualTileTree::Level wide = vtkVirtualTileTree::Widen(grid, Coarsest, reach);
    vtkVirtualTileTree::Limits limits;
    limits.LargestTile = 4096;
    limits.MostTexels = 1e12;
    limits.MostTiles = Size * Size;
    vtkVirtualTileTree tree;
    tree.Build(vtkVirtualTileTree::MakePyramid(wide), limits);
    CheckTiles(wide, tree, limits.LargestTile); // wide has no unused cells: nothing is left out
    const int dx = reach * step(random);
    const int dy = reach * step(random);
    vtkVirtualTileTree::Level moved(Size * Size);
    for (int y = std::max(dy, 0); y < std::min(Size + dy, Size); ++y)
    {
      for (int x = std::max(dx, 0); x < std::min(Size + dx, Size); ++x)
      {
        moved[y * Size + x] = grid[(y - dy) * Size + x - dx];
      }
    }
    ASSERT_LT(tree.GetExcess(moved), 1.000001) << "grid " << i << " moved by " << dx << ", " << dy;
    // Anything else is served as by a map of 1024 texels.
    vtkVirtualTileTree::Level other(Size * Size);
    other[static_cast<size_t>(i) * 67 % (Size * Size)] = { 0.1f * Coarsest, 0.2f * Coarsest };
    ASSERT_LT(tree.GetExcess(other), 10.0001);
  }
}

TEST(VirtualTileTree, TheExcessIsThatOfTheWorstCell)
{
  vtkVirtualTileTree::Level grid(Size * Size);
  grid[3].R0 = grid[3].R1 = 1.0f / 2048.0f; // a tile of one cell: 32 texels
  vtkVirtualTileTree tree;
  tree.Build(vtkVirtualTileTree::MakePyramid(grid), vtkVirtualTileTree::Limits());
  EXPECT_EQ(tree.GetExcess(grid), 1.0);
  grid[3].R1 = 1.0f / 5120.0f;
  EXPECT_NEAR(tree.GetExcess(grid), 2.5, 1e-5);
  grid.back().R0 = grid.back().R1 = 0.5f;
  EXPECT_GT(tree.GetExcess(grid), 1e20) << "no tile";
}

TEST(VirtualTileTree, AnEmptyGridHasNoTiles)
{
  vtkVirtualTileTree tree;
  tree.Build(vtkVirtualTileTree::MakePyramid(vtkVirtualTileTree::Level(Size * Size)),
    vtkVirtualTileTree::Limits());
  EXPECT_TRUE(tree.GetTiles().empty());
  EXPECT_EQ(tree.GetCoarsening(), 1.0);
}

TEST(VirtualTileTree, OneResolutionIsOneTileIfItFits)
{
  vtkVirtualTileTree::Level grid(Size * Size);
  for (vtkVirtualTileTree::Cell& cell : grid)
  {
    cell.R0 = cell.R1 = 1.0f / 700.0f;
  }
  vtkVirtualTileTree tree;
  tree.Build(vtkVirtualTileTree::MakePyramid(grid), vtkVirtualTileTree::Limits());
  ASSERT_EQ(tree.GetTiles().size(), 1u);
  EXPECT_EQ(tree.GetTiles()[0].Resolution, 768);
}

TEST(VirtualTileTree, OneFineSpotDoesNotRefineEverything)
{
  vtkVirtualTileTree::Level grid(Size * Size);
  for (vtkVirtualTileTree::Cell& cell : grid)
  {
    cell.R0 = cell.R1 = 1.0f / 100.0f;
  }
  grid[5 * Size + 7].R0 = 1.0f / 16384.0f;
  vtkVirtualTileTree tree;
  tree.Build(vtkVirtualTileTree::MakePyramid(grid), vtkVirtualTileTree::Limits());
  EXPECT_LT(tree.GetTexels(), 2.0e6);
  CheckTiles(grid, tree, 4096);
}

TEST(VirtualTileTree, ResolutionsNeverFallShort)
{
  for (const int largest : { 32, 100, 1024, 4096 })
  {
    for (double texels = 1.0; texels <= largest; texels *= 1.07)
    {
      const int resolution = vtkVirtualTileTree::GetResolution(texels, largest);
      EXPECT_GE(resolution, std::min<double>(texels, largest));
      EXPECT_LE(resolution, largest);
      EXPECT_TRUE(resolution <= std::max(1.5 * texels + 1.0, 32.0)) << texels << " of " << largest;
    }
  }
}

TEST(VirtualResolution, FollowsTheFittedPolynomials)
{
  // Evaluated by hand: x = 3 and x = 6.
  EXPECT_NEAR(vtkVirtualResolution::GetTexels(8.0, vtkVirtualResolution::Dynamic), 5.84218, 1e-9);
  EXPECT_NEAR(vtkVirtualResolution::GetTexels(64.0, vtkVirtualResolution::Dynamic), 13.75804, 1e-9);
  EXPECT_NEAR(vtkVirtualResolution::GetTexels(8.0, vtkVirtualResolution::Static), 4.237382, 1e-9);
  EXPECT_NEAR(vtkVirtualResolution::GetTexels(64.0, vtkVirtualResolution::Static), 6.444476, 1e-9);
  // A texel at least, and nothing beyond the study.
  EXPECT_EQ(vtkVirtualResolution::GetTexels(1.0, vtkVirtualResolution::Dynamic), 1.0);
  EXPECT_EQ(vtkVirtualResolution::GetTexels(0.0, vtkVirtualResolution::Static), 1.0);
  EXPECT_EQ(vtkVirtualResolution::GetTexels(1e9, vtkVirtualResolution::Dynamic),
    vtkVirtualResolution::GetTexels(
      vtkVirtualResolution::LargestKernel, vtkVirtualResolution::Dynamic));
}

TEST(VirtualResolution, AHardShadowGetsATexelPerPixel)
{
  // Footprint 0.01 x 0.02 in half axes, no light.
  const std::array<double, 2> u = { { 0.01, 0.0 } };
  const std::array<double, 2> v = { { 0.0, 0.02 } };
  const std::array<double, 2> size = vtkVirtualResolution::GetTexelSize(
    vtkVirtualKernel::Variance(u, v), u, v, vtkVirtualResolution::Dynamic, 1.0);
  EXPECT_NEAR(size[0], 0.02, 1e-12);
  EXPECT_NEAR(size[1], 0.04, 1e-12);
}

TEST(VirtualResolution, AWidePenumbraNeedsFewTexels)
{
  const std::array<double, 2> u = { { 0.001, 0.0 } };
  const std::array<double, 2> v = { { 0.0, 0.001 } };
  const vtkVirtualVariance kernel =
    vtkVirtualKernel::Convolve({ { 0.064, 0.008 } }, false, { { 0.0, 0.0, 0.0 } });
  const std::array<double, 2> size =
    vtkVirtualResolution::GetTexelSize(kernel, u, v, vtkVirtualResolution::Dynamic, 1.0);
  EXPECT_NEAR(size[0], 0.128 / 13.75804, 1e-9);
  EXPECT_NEAR(size[1], 0.016 / 5.84218, 1e-9);
  const std::array<double, 2> finer =
    vtkVirtualResolution::GetTexelSize(kernel, u, v, vtkVirtualResolution::Dynamic, 2.0);
  EXPECT_NEAR(finer[0], 0.5 * size[0], 1e-12);
}
