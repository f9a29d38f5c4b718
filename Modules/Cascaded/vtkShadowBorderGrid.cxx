// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowBorderGrid.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Turns a disk's points by pi / 8, half way between the axes of symmetry of their rows: straight edges
// along the light's axes, the usual ones, would else hide whole rows at a time.
void Turn(vtkShadowLightSampling::Sample& sample)
{
  constexpr double Cosine = 0.923879532511287;
  constexpr double Sine = 0.382683432365090;
  const double u = sample.U;
  sample.U = Cosine * u - Sine * sample.V;
  sample.V = Sine * u + Cosine * sample.V;
}
} // namespace

//------------------------------------------------------------------------------
vtkShadowBorderGrid vtkShadowBorderGrid::Make(
  const vtkShadowEmitter& emitter, int level, int weights)
{
  vtkShadowBorderGrid grid;
  if (!emitter.HasExtent())
  {
    grid.Keep = level == 0 ? 0.0 : 1.0;
    if (level == 0)
    {
      grid.Added.push_back({ 0.0, 0.0, 1.0 });
    }
    return grid;
  }
  const int cells = 1 << std::min(std::max(level, 0), LargestLevel);
  double sum = 0.0;
  double added = 0.0;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      vtkShadowLightSampling::Sample sample = { 2.0 * i / cells - 1.0, 2.0 * j / cells - 1.0, 1.0 };
      if (emitter.Shape == vtkShadowEmitter::DISK)
      {
        vtkShadowLightSampling::MapToDisk(sample.U, sample.V);
        Turn(sample);
      }
      sample.Weight = (i % cells == 0 ? 0.5 : 1.0) * (j % cells == 0 ? 0.5 : 1.0);
      if (weights == vtkShadowLightSampling::GAUSSIAN)
      {
        const double u = emitter.WindowCenter[0] + sample.U * emitter.WindowHalfSize[0];
        const double v = emitter.WindowCenter[1] + sample.V * emitter.WindowHalfSize[1];
        sample.Weight *= std::exp(-2.0 * (u * u + v * v));
      }
      sum += sample.Weight;
      // Points with both numbers even are the coarser level's.
      if (level == 0 || i % 2 == 1 || j % 2 == 1)
      {
        added += sample.Weight;
        grid.Added.push_back(sample);
      }
    }
  }
  for (vtkShadowLightSampling::Sample& sample : grid.Added)
  {
    sample.Weight /= sum;
  }
  grid.Keep = level == 0 ? 0.0 : 1.0 - added / sum;
  return grid;
}
VTK_ABI_NAMESPACE_END
