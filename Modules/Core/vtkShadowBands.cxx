// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowBands.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSoftShadowsOpenGL.h"

#include <algorithm>
#include <array>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double DefaultTaps = 4e9;
// Cards draw squares of pixels: bands do not cut them.
constexpr int RowsTogether = 8;

double MostTaps = DefaultTaps;
thread_local vtkTypeInt64 Draws = 0;
thread_local double TapsNotSent = 0.0; // of whole draws since the last flush
} // namespace

//------------------------------------------------------------------------------
void vtkShadowBands::SetMostTaps(double taps)
{
  MostTaps = taps > 0.0 ? taps : DefaultTaps;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkShadowBands::GetNumberOfDraws()
{
  return Draws;
}

//------------------------------------------------------------------------------
int vtkShadowBands::GetRows(int width, int height, double tapsPerPixel)
{
  const double rows = MostTaps / std::max(width * tapsPerPixel, 1.0);
  if (rows >= height)
  {
    return height;
  }
  const int whole = std::max(static_cast<int>(rows), 1);
  return whole < RowsTogether ? whole : whole - whole % RowsTogether;
}

//------------------------------------------------------------------------------
void vtkShadowBands::Draw(
  vtkOpenGLRenderWindow* window, double tapsPerPixel, const std::function<void()>& draw)
{
  vtkOpenGLState* state = window->GetState();
  std::array<GLint, 4> area;
  state->vtkglGetIntegerv(GL_VIEWPORT, area.data());
  const int rows = vtkShadowBands::GetRows(area[2], area[3], tapsPerPixel);
  if (rows >= area[3])
  {
    // Systems look at what is sent at once, which may be many draws.
    const double taps = tapsPerPixel * area[2] * area[3];
    if (TapsNotSent + taps > MostTaps)
    {
      glFlush();
      TapsNotSent = 0.0;
    }
    TapsNotSent += taps;
    draw();
    ++Draws;
    return;
  }
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglScissor scissor(state);
  if (state->GetEnumState(GL_SCISSOR_TEST))
  {
    std::array<GLint, 4> box;
    state->vtkglGetIntegerv(GL_SCISSOR_BOX, box.data());
    for (int axis = 0; axis < 2; ++axis)
    {
      const GLint low = std::max(area[axis], box[axis]);
      const GLint high = std::min(area[axis] + area[axis + 2], box[axis] + box[axis + 2]);
      area[axis] = low;
      area[axis + 2] = std::max(high - low, 0);
    }
  }
  state->vtkglEnable(GL_SCISSOR_TEST);
  for (int row = 0; row < area[3]; row += rows)
  {
    state->vtkglScissor(area[0], area[1] + row, area[2], std::min(rows, area[3] - row));
    draw();
    glFlush();
    ++Draws;
  }
  TapsNotSent = 0.0;
}
VTK_ABI_NAMESPACE_END
