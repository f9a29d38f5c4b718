// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBilateralLattice.h"

#include "vtkMath.h"
#include "vtkShadowLattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// From this many points on the shift does not matter, and looking for it would take long.
constexpr int MostShiftedPoints = 32;

// Sum of the inverse fourth powers of the distances: the lowest has the widest spread points.
double Energy(int count, int generator, int shift)
{
  double energy = 0.0;
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      const double rows = (generator * i + shift) % count - (generator * j + shift) % count;
      const double squared = static_cast<double>(i - j) * (i - j) + rows * rows;
      energy += 1.0 / (squared * squared);
    }
  }
  return energy;
}
} // namespace

//------------------------------------------------------------------------------
vtkBilateralLattice::vtkBilateralLattice(
  const vtkShadowEmitter& emitter, int count, int weights, bool isTiled)
{
  count = emitter.HasExtent() ? std::max(count, 1) : 1;
  const bool isDisk = emitter.Shape == vtkShadowEmitter::DISK;
  if (isDisk)
  {
    this->SpreadOverDisk(count);
  }
  else
  {
    this->Spread(count);
  }
  if (isTiled)
  {
    this->Contract(isDisk ? 1.0 / 4.0 : 1.0 / 3.0);
  }
  double sum = 0.0;
  for (vtkShadowLightSampling::Sample& sample : this->Samples)
  {
    const double window[2] = { emitter.WindowCenter[0] + sample.U * emitter.WindowHalfSize[0],
      emitter.WindowCenter[1] + sample.V * emitter.WindowHalfSize[1] };
    sample.Weight = weights == vtkShadowLightSampling::GAUSSIAN
      ? std::exp(-2.0 * (window[0] * window[0] + window[1] * window[1]))
      : 1.0;
    sum += sample.Weight;
  }
  for (vtkShadowLightSampling::Sample& sample : this->Samples)
  {
    sample.Weight /= sum;
  }
}

//------------------------------------------------------------------------------
void vtkBilateralLattice::Spread(int count)
{
  int generator = 1;
  int shift = 0;
  double least = std::numeric_limits<double>::max();
  const int shifts = count < MostShiftedPoints ? count : 1;
  for (int g = 1; g < std::max(count, 2); ++g)
  {
    for (int c = 0; c < shifts && std::gcd(g, count) == 1; ++c)
    {
      const double energy = Energy(count, g, c);
      if (energy < least * (1.0 - 1e-9))
      {
        least = energy;
        generator = g;
        shift = c;
      }
    }
  }
  this->Samples.resize(count);
  for (int i = 0; i < count; ++i)
  {
    this->Samples[i].U = (2.0 * i + 1.0) / count - 1.0;
    this->Samples[i].V = (2.0 * ((generator * i + shift) % count) + 1.0) / count - 1.0;
  }
  this->FindCell(count, generator);
}

//------------------------------------------------------------------------------
void vtkBilateralLattice::SpreadOverDisk(int count)
{
  // Vogel 1979, "A better way to construct the sunflower head".
  const double goldenAngle = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  double mean[2] = { 0.0, 0.0 };
  this->Samples.resize(count);
  for (int i = 0; i < count; ++i)
  {
    const double radius = std::sqrt((i + 0.5) / count);
    this->Samples[i].U = radius * std::cos(goldenAngle * i);
    this->Samples[i].V = radius * std::sin(goldenAngle * i);
    mean[0] += this->Samples[i].U / count;
    mean[1] += this->Samples[i].V / count;
  }
  for (vtkShadowLightSampling::Sample& sample : this->Samples)
  {
    sample.U -= mean[0];
    sample.V -= mean[1];
  }
  const double edge = std::sqrt(vtkMath::Pi() / count);
  this->Cell = { { { { edge, 0.0 } }, { { 0.0, edge } } } };
}

//------------------------------------------------------------------------------
void vtkBilateralLattice::Contract(double variance)
{
  // Along both axes together; of a cell, a uniform parallelogram, a twelfth of its edges' squares.
  double sum = 0.0;
  for (const vtkShadowLightSampling::Sample& sample : this->Samples)
  {
    sum += (sample.U * sample.U + sample.V * sample.V) / this->Samples.size();
  }
  for (const std::array<double, 2>& edge : this->Cell)
  {
    sum += (edge[0] * edge[0] + edge[1] * edge[1]) / 12.0;
  }
  const double scale = std::sqrt(2.0 * variance / sum);
  for (vtkShadowLightSampling::Sample& sample : this->Samples)
  {
    sample.U *= scale;
    sample.V *= scale;
  }
  for (std::array<double, 2>& edge : this->Cell)
  {
    edge = { { scale * edge[0], scale * edge[1] } };
  }
}

//------------------------------------------------------------------------------
void vtkBilateralLattice::FindCell(int count, int generator)
{
  const vtkShadowLattice::Basis basis = vtkShadowLattice::Reduce(count, generator);
  const double unit = 2.0 / count;
  for (int i = 0; i < 2; ++i)
  {
    this->Cell[i] = { { unit * basis[i][0], unit * basis[i][1] } };
  }
}
VTK_ABI_NAMESPACE_END
