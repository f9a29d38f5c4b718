// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The grid drawn from kernels that are given, by a point per pixel and by one per block and cell.

#include "OffscreenWindow.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowDriver.h"
#include "vtkShadowTextureArray.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkVirtualGrid.h"
#include "vtkVirtualScreen.h"
#include "vtkVirtualTileTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{
// No multiples of a block.
constexpr int Width = 203;
constexpr int Height = 157;
constexpr int GridSize = vtkVirtualTileTree::GridSize;

struct Kernels
{
  std::vector<float> Shapes = std::vector<float>(4 * Width * Height);
  std::vector<float> Predictions = std::vector<float>(4 * Width * Height);
};

// A surface that the map sees as the screen does, turned a little, with a step in its middle and holes;
// what its pixels ask for is random. It covers a share of the map along each axis.
Kernels MakeKernels(float share)
{
  Kernels kernels;
  std::mt19937 engine(7);
  std::uniform_real_distribution<float> size(1e-4f, 1e-2f);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      float* shape = kernels.Shapes.data() + 4 * (y * Width + x);
      float* prediction = kernels.Predictions.data() + 4 * (y * Width + x);
      const bool isHole = (x / 13 + y / 17) % 4 == 0;
      shape[0] = size(engine) * size(engine);
      shape[2] = size(engine) * size(engine);
      shape[3] = static_cast<float>(isHole ? vtkVirtualScreen::LIT : vtkVirtualScreen::PENUMBRA);
      const float step = x > Width / 2 ? 0.35f : 0.0f;
      prediction[0] = share * (0.9f * x / Width + 0.1f * y / Height - step);
      prediction[1] = share * (0.8f * y / Height - 0.1f * x / Width + 0.1f);
      prediction[2] = size(engine);
      prediction[3] = size(engine);
    }
  }
  return kernels;
}

// Texel sizes, and minus the half extents of kernels.
using Wish = std::array<float, 4>;
const Wish NoWish = { { vtkVirtualTileTree::Unused, vtkVirtualTileTree::Unused, 0.0f, 0.0f } };

void TakeLeast(Wish& least, const Wish& other)
{
  for (size_t i = 0; i < least.size(); ++i)
  {
    least[i] = std::min(least[i], other[i]);
  }
}

// Cells take over the wishes that reach into them along an axis.
std::vector<Wish> Dilate(const std::vector<Wish>& cells, size_t axis)
{
  std::vector<Wish> wide(cells.size(), NoWish);
  for (int i = 0; i < GridSize * GridSize; ++i)
  {
    const int step = axis == 0 ? 1 : GridSize;
    const int place = axis == 0 ? i % GridSize : i / GridSize;
    for (int k = 0; k < GridSize; ++k)
    {
      const Wish& wish = cells[i + (k - place) * step];
      if (static_cast<float>(std::abs(k - place) - 1) < -wish[2 + axis] * GridSize)
      {
        TakeLeast(wide[i], wish);
      }
    }
  }
  return wide;
}

std::vector<float> ExpectedCells(const Kernels& kernels)
{
  std::vector<Wish> cells(GridSize * GridSize, NoWish);
  for (int i = 0; i < Width * Height; ++i)
  {
    const float* shape = kernels.Shapes.data() + 4 * i;
    const float* prediction = kernels.Predictions.data() + 4 * i;
    if (shape[3] >= vtkVirtualScreen::PENUMBRA)
    {
      int place[2];
      for (int axis = 0; axis < 2; ++axis)
      {
        const float at = std::floor(prediction[axis] * GridSize);
        place[axis] = static_cast<int>(std::min(std::max(at, 0.0f), GridSize - 1.0f));
      }
      TakeLeast(cells[place[1] * GridSize + place[0]],
        { { prediction[2], prediction[3], -std::sqrt(2.0f * shape[0]),
          -std::sqrt(2.0f * shape[2]) } });
    }
  }
  std::vector<float> sizes;
  for (const Wish& wish : Dilate(Dilate(cells, 0), 1))
  {
    sizes.insert(sizes.end(), wish.begin(), wish.begin() + 2);
  }
  return sizes;
}

class VirtualGrid : public testing::Test
{
public:
  VirtualGrid()
    : Window(32, 32)
  {
    this->Window.Render();
    this->GL = this->Window.GetOpenGL();
    this->GL->MakeCurrent();
  }
  ~VirtualGrid() override { vtkShadowDriver::Pretend(vtkShadowDriver::TOLD_BY_NAME); }

  // The finest level, and how many fragments were drawn.
  std::vector<float> Draw(const Kernels& kernels, GLuint& fragments)
  {
    vtkVirtualScreen screen;
    vtkVirtualGrid grid;
    EXPECT_TRUE(screen.AllocateShapes(this->GL, Width, Height));
    screen.GetTexture(vtkVirtualScreen::SHAPES)->WriteLayer(0, kernels.Shapes.data());
    screen.GetTexture(vtkVirtualScreen::PREDICTIONS)->WriteLayer(0, kernels.Predictions.data());
    EXPECT_TRUE(grid.Begin(this->GL));
    GLuint query = 0;
    glGenQueries(1, &query);
    this->GL->GetState()->PushFramebufferBindings();
    glBeginQuery(GL_SAMPLES_PASSED, query);
    EXPECT_TRUE(grid.Draw(this->GL, screen));
    glEndQuery(GL_SAMPLES_PASSED);
    this->GL->GetState()->PopFramebufferBindings();
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &fragments);
    glDeleteQueries(1, &query);
    return grid.GetCells()->ReadLayer(0);
  }

  OffscreenWindow Window;
  vtkOpenGLRenderWindow* GL = nullptr;
};
} // namespace

TEST_F(VirtualGrid, HoldsTheLeastWishOfEveryCell)
{
  for (const float share : { 1.0f, 0.25f })
  {
    const Kernels kernels = MakeKernels(share);
    const std::vector<float> expected = ExpectedCells(kernels);
    for (const auto kind : { vtkShadowDriver::PROCESSOR, vtkShadowDriver::CARD })
    {
      vtkShadowDriver::Pretend(kind);
      GLuint fragments = 0;
      const std::vector<float> cells = this->Draw(kernels, fragments);
      ASSERT_EQ(cells.size(), expected.size());
      for (size_t i = 0; i < cells.size(); ++i)
      {
        ASSERT_EQ(cells[i], expected[i]) << "cell " << i / 2 << ", kind " << kind;
      }
    }
  }
}

TEST_F(VirtualGrid, DrawsFewPointsOnACard)
{
  const Kernels kernels = MakeKernels(0.25f);
  GLuint all = 0;
  GLuint few = 0;
  vtkShadowDriver::Pretend(vtkShadowDriver::PROCESSOR);
  this->Draw(kernels, all);
  vtkShadowDriver::Pretend(vtkShadowDriver::CARD);
  this->Draw(kernels, few);
  // Both axes' dilation and the pyramid.
  GLuint others = 2 * GridSize * GridSize;
  for (int size = GridSize / 2; size >= 1; size /= 2)
  {
    others += static_cast<GLuint>(size * size);
  }
  EXPECT_GT(all, others + Width * Height / 2);
  EXPECT_LT(few - others, (all - others) / 16);
  EXPECT_GT(few, others);
}
