// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLightSampling.h"

#include "vtkMath.h"
#include "vtkShadowLattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

double RadicalInverse(unsigned int i)
{
  double result = 0.0;
  for (double digit = 0.5; i != 0; i >>= 1, digit *= 0.5)
  {
    result += (i & 1u) ? digit : 0.0;
  }
  return result;
}

// Second dimension of Sobol's sequence; with the radical inverse a (0, 2)-sequence in base 2.
double SobolSecond(unsigned int i)
{
  unsigned int bits = 0;
  for (unsigned int direction = 1u << 31; i != 0; i >>= 1, direction ^= direction >> 1)
  {
    bits ^= (i & 1u) ? direction : 0u;
  }
  return bits / 4294967296.0;
}

unsigned int ReverseBits(unsigned int bits)
{
  unsigned int reversed = 0;
  for (int i = 0; i < 32; ++i, bits >>= 1)
  {
    reversed = (reversed << 1) | (bits & 1u);
  }
  return reversed;
}

// Flips each digit of a number in [0, 1) by a hash of the digits before it.
double ScrambleDigits(double number, unsigned int seed)
{
  unsigned int bits = ReverseBits(static_cast<unsigned int>(number * 4294967296.0));
  bits += seed;
  bits ^= bits * 0x6c50b47cu;
  bits ^= bits * 0xb82f1e52u;
  bits ^= bits * 0xc7afe638u;
  bits ^= bits * 0x8d22f6e6u;
  return (ReverseBits(bits) + 0.5) / 4294967296.0;
}

// Columns of a grid of exactly count cells that is nearly square; 0 if there is none.
int FindColumns(int count)
{
  for (int rows = static_cast<int>(std::sqrt(count + 0.5)); rows >= 1; --rows)
  {
    if (count % rows == 0)
    {
      return count / rows < 2 * rows ? count / rows : 0;
    }
  }
  return 0;
}

// A point of the unit disk to one of a sun's, equal areas to equal solid angles: the height of a
// spherical cap is uniform in solid angle, and so is the square of the disk's radius.
void MapToSun(double& u, double& v, double tangentOfSun)
{
  const double squaredRadius = u * u + v * v;
  if (squaredRadius == 0.0)
  {
    return;
  }
  // 1 - cosine, written without the cancellation of small suns.
  const double root = std::sqrt(1.0 + tangentOfSun * tangentOfSun);
  const double height = squaredRadius * tangentOfSun * tangentOfSun / (root * (root + 1.0));
  const double tangent = std::sqrt(height * (2.0 - height)) / (1.0 - height);
  const double stretch = tangent / (tangentOfSun * std::sqrt(squaredRadius));
  u *= stretch;
  v *= stretch;
}

// From the square to the emitter's shape, and the weight there.
void PlaceOnEmitter(
  const vtkShadowEmitter& emitter, int weights, vtkShadowLightSampling::Sample& sample)
{
  if (emitter.Shape == vtkShadowEmitter::DISK)
  {
    vtkShadowLightSampling::MapToDisk(sample.U, sample.V);
    if (emitter.Directional)
    {
      MapToSun(sample.U, sample.V, emitter.HalfSize[0]);
    }
  }
  const double window[2] = { emitter.WindowCenter[0] + sample.U * emitter.WindowHalfSize[0],
    emitter.WindowCenter[1] + sample.V * emitter.WindowHalfSize[1] };
  sample.Weight = weights == vtkShadowLightSampling::GAUSSIAN
    ? std::exp(-2.0 * (window[0] * window[0] + window[1] * window[1]))
    : 1.0;
}

} // namespace

//------------------------------------------------------------------------------
vtkShadowLightSampling::Sample vtkShadowLightSampling::PointOfSequence(
  const vtkShadowEmitter& emitter, unsigned int index, int weights)
{
  Sample sample = { 0.0, 0.0, 1.0 };
  if (emitter.HasExtent())
  {
    sample.U = 2.0 * ScrambleDigits(SobolSecond(index), 0x3a2c5d1bu) - 1.0;
    sample.V = 2.0 * ScrambleDigits(RadicalInverse(index), 0x9e3779b9u) - 1.0;
    PlaceOnEmitter(emitter, weights, sample);
  }
  return sample;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowLightSampling::Sample> vtkShadowLightSampling::Generate(
  const vtkShadowEmitter& emitter, int count, int pattern, int weights)
{
  count = emitter.HasExtent() ? std::max(count, 1) : 1;
  const int columns = pattern >= HAMMERSLEY ? 0 : FindColumns(count);
  const vtkShadowLattice lattice(pattern == LATTICE ? count : 1);
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> jitter(0.0, 1.0);
  std::vector<Sample> samples(count);
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    Sample& sample = samples[i];
    if (columns > 0)
    {
      const double offset[2] = { pattern == STRATIFIED ? jitter(random) : 0.5,
        pattern == STRATIFIED ? jitter(random) : 0.5 };
      const int rows = count / columns;
      sample.U = 2.0 * (i % columns + offset[0]) / columns - 1.0;
      sample.V = 2.0 * (i / columns + offset[1]) / rows - 1.0;
    }
    else if (pattern == LATTICE)
    {
      const std::array<double, 2> point = lattice.GetPoint(i);
      sample.U = point[0];
      sample.V = point[1];
    }
    else
    {
      const double first = pattern == SOBOL ? SobolSecond(i) : static_cast<double>(i) / count;
      sample.U = 2.0 * (first + 0.5 / count) - 1.0;
      // Half a step of the last digit centres the radical inverse, whose mean is under 1/2.
      sample.V = 2.0 * (RadicalInverse(i) + 0.5 / count) - 1.0;
    }
    PlaceOnEmitter(emitter, weights, sample);
    sum += sample.Weight;
  }
  for (Sample& sample : samples)
  {
    sample.Weight /= sum;
  }
  return samples;
}

//------------------------------------------------------------------------------
void vtkShadowLightSampling::MapToDisk(double& u, double& v)
{
  if (u == 0.0 && v == 0.0)
  {
    return;
  }
  const double quarter = 0.25 * vtkMath::Pi();
  const bool wide = std::abs(u) > std::abs(v);
  const double radius = wide ? u : v;
  const double angle = wide ? quarter * (v / u) : 2.0 * quarter - quarter * (u / v);
  u = radius * std::cos(angle);
  v = radius * std::sin(angle);
}
VTK_ABI_NAMESPACE_END
