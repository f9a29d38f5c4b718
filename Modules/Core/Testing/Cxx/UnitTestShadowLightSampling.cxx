// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Points that integrate the light: weights, moments, spread.

#include "vtkMath.h"
#include "vtkShadowEmitter.h"
#include "vtkShadowLightSampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace
{
using Sampling = vtkShadowLightSampling;
using Samples = std::vector<Sampling::Sample>;

vtkShadowEmitter Lamp(int shape)
{
  vtkShadowEmitter emitter;
  emitter.Shape = shape;
  emitter.HalfSize = { { 0.5, 0.25 } };
  return emitter;
}

const char* NameOf(int pattern)
{
  const char* names[] = { "Grid", "Stratified", "Hammersley", "Sobol", "Lattice" };
  return names[pattern];
}

// Shape, pattern, number of points: squares, near squares, and counts that are neither.
using Parameters = std::tuple<int, int, int>;

class ShadowLightSampling : public testing::TestWithParam<Parameters>
{
protected:
  int Shape = std::get<0>(this->GetParam());
  int Pattern = std::get<1>(this->GetParam());
  int Count = std::get<2>(this->GetParam());
  Samples Generate(int weights = Sampling::MEAN) const
  {
    return Sampling::Generate(Lamp(this->Shape), this->Count, this->Pattern, weights);
  }
};

// Every elementary interval of 2^k points, 2^a x 2^(k - a) cells, holds exactly one.
void ExpectNet(const Samples& samples, int exponent)
{
  const size_t count = size_t(1) << exponent;
  for (int a = 0; a <= exponent; ++a)
  {
    const double columns = std::ldexp(1.0, a);
    const double rows = std::ldexp(1.0, exponent - a);
    std::set<std::pair<int, int>> cells;
    for (size_t i = 0; i < count; ++i)
    {
      cells.emplace(static_cast<int>(0.5 * (samples[i].U + 1.0) * columns),
        static_cast<int>(0.5 * (samples[i].V + 1.0) * rows));
    }
    EXPECT_EQ(cells.size(), count)
      << count << " points in " << columns << " x " << rows << " cells";
  }
}
} // namespace

INSTANTIATE_TEST_SUITE_P(Patterns, ShadowLightSampling,
  testing::Combine(testing::Values(int(vtkShadowEmitter::RECTANGLE), int(vtkShadowEmitter::DISK)),
    testing::Values(int(Sampling::GRID), int(Sampling::STRATIFIED), int(Sampling::HAMMERSLEY),
      int(Sampling::SOBOL), int(Sampling::LATTICE)),
    testing::Values(256, 240, 251, 100)),
  [](const testing::TestParamInfo<Parameters>& instance)
  {
    return std::string(
             std::get<0>(instance.param) == vtkShadowEmitter::DISK ? "Disk" : "Rectangle") +
      NameOf(std::get<1>(instance.param)) + std::to_string(std::get<2>(instance.param));
  });

//------------------------------------------------------------------------------
TEST_P(ShadowLightSampling, PointsAreOnTheLightAndWeightsSumToOne)
{
  for (const int weights : { Sampling::MEAN, Sampling::GAUSSIAN })
  {
    const Samples samples = this->Generate(weights);
    ASSERT_EQ(samples.size(), size_t(this->Count));
    double sum = 0.0;
    for (const Sampling::Sample& sample : samples)
    {
      EXPECT_LE(std::abs(sample.U), 1.0);
      EXPECT_LE(std::abs(sample.V), 1.0);
      if (this->Shape == vtkShadowEmitter::DISK)
      {
        EXPECT_LE(std::hypot(sample.U, sample.V), 1.0 + 1e-12);
      }
      EXPECT_GT(sample.Weight, 0.0);
      sum += sample.Weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

//------------------------------------------------------------------------------
TEST_P(ShadowLightSampling, MomentsAreThoseOfTheShape)
{
  // Closed forms: mean 0, variance 1/3 along an edge of [-1, 1], 1/4 along a diameter.
  const double second = this->Shape == vtkShadowEmitter::DISK ? 0.25 : 1.0 / 3.0;
  double mean[2] = { 0.0, 0.0 };
  double square[2] = { 0.0, 0.0 };
  double product = 0.0;
  for (const Sampling::Sample& sample : this->Generate())
  {
    mean[0] += sample.Weight * sample.U;
    mean[1] += sample.Weight * sample.V;
    square[0] += sample.Weight * sample.U * sample.U;
    square[1] += sample.Weight * sample.V * sample.V;
    product += sample.Weight * sample.U * sample.V;
  }
  // Independent random points would be off by 1 / sqrt(n), 0.06 to 0.1.
  const double tolerance = 2.0 / this->Count;
  for (int axis = 0; axis < 2; ++axis)
  {
    EXPECT_NEAR(mean[axis], 0.0, tolerance) << "axis " << axis;
    EXPECT_NEAR(square[axis], second, tolerance) << "axis " << axis;
  }
  // Of 2^k Hammersley points it is k / (2 n), the order of their discrepancy.
  EXPECT_NEAR(product, 0.0, (0.5 * std::log2(this->Count) + 1.0) / this->Count);
}

//------------------------------------------------------------------------------
TEST_P(ShadowLightSampling, IsTheSameEveryTime)
{
  const Samples first = this->Generate();
  const Samples second = this->Generate();
  for (size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_EQ(first[i].U, second[i].U) << "point " << i;
    EXPECT_EQ(first[i].V, second[i].V) << "point " << i;
  }
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, GridHasItsCellCentres)
{
  // Of a count with nearly square factors: 6 = 3 x 2.
  const Samples samples =
    Sampling::Generate(Lamp(vtkShadowEmitter::RECTANGLE), 6, Sampling::GRID, Sampling::MEAN);
  ASSERT_EQ(samples.size(), 6u);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(samples[i].U, (i % 3 - 1) * 2.0 / 3.0, 1e-14) << "point " << i;
    EXPECT_NEAR(samples[i].V, i / 3 - 0.5, 1e-14) << "point " << i;
  }
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, StratifiedHasOnePointInEachCell)
{
  const Samples samples =
    Sampling::Generate(Lamp(vtkShadowEmitter::RECTANGLE), 64, Sampling::STRATIFIED, Sampling::MEAN);
  bool jittered = false;
  for (int i = 0; i < 64; ++i)
  {
    const double column = 4.0 * (samples[i].U + 1.0);
    const double row = 4.0 * (samples[i].V + 1.0);
    EXPECT_EQ(static_cast<int>(column), i % 8) << "point " << i;
    EXPECT_EQ(static_cast<int>(row), i / 8) << "point " << i;
    jittered = jittered || std::abs(column - std::floor(column) - 0.5) > 0.1;
  }
  EXPECT_TRUE(jittered);
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, CountsWithoutAGridAreHammersleys)
{
  for (const int count : { 2, 7, 10, 251 })
  {
    const vtkShadowEmitter lamp = Lamp(vtkShadowEmitter::DISK);
    const Samples grid = Sampling::Generate(lamp, count, Sampling::GRID, Sampling::MEAN);
    const Samples other = Sampling::Generate(lamp, count, Sampling::HAMMERSLEY, Sampling::MEAN);
    ASSERT_EQ(grid.size(), other.size());
    for (size_t i = 0; i < grid.size(); ++i)
    {
      EXPECT_EQ(grid[i].U, other[i].U) << "point " << i << " of " << count;
      EXPECT_EQ(grid[i].V, other[i].V) << "point " << i << " of " << count;
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, PrefixesOfSobolAreNets)
{
  for (const int count : { 256, 200 })
  {
    const Samples samples =
      Sampling::Generate(Lamp(vtkShadowEmitter::RECTANGLE), count, Sampling::SOBOL, Sampling::MEAN);
    for (int exponent = 0; (1 << exponent) <= count; ++exponent)
    {
      ExpectNet(samples, exponent);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, HammersleysPointsAreANet)
{
  ExpectNet(
    Sampling::Generate(Lamp(vtkShadowEmitter::RECTANGLE), 64, Sampling::HAMMERSLEY, Sampling::MEAN),
    6);
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, GaussianWeightsAreThoseOfTheWholeLight)
{
  vtkShadowEmitter part = Lamp(vtkShadowEmitter::RECTANGLE);
  part.WindowCenter = { { 0.5, -0.5 } };
  part.WindowHalfSize = { { 0.5, 0.5 } };
  const Samples samples = Sampling::Generate(part, 4, Sampling::GRID, Sampling::GAUSSIAN);
  ASSERT_EQ(samples.size(), 4u);
  const auto gaussian = [](const Sampling::Sample& sample)
  {
    const double x = 0.5 + 0.5 * sample.U;
    const double y = -0.5 + 0.5 * sample.V;
    return std::exp(-(x * x + y * y) / (2.0 * 0.5 * 0.5));
  };
  for (const Sampling::Sample& sample : samples)
  {
    EXPECT_NEAR(sample.Weight / samples[0].Weight, gaussian(sample) / gaussian(samples[0]), 1e-12);
  }
  EXPECT_GT(samples[2].Weight, samples[0].Weight) << "nearer to the light's centre";
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, SunsAreUniformInSolidAngle)
{
  constexpr int count = 1024;
  for (const double degrees : { 0.53, 5.0, 60.0, 170.0 })
  {
    const double half = vtkMath::RadiansFromDegrees(0.5 * degrees);
    vtkShadowEmitter sun;
    sun.Directional = true;
    sun.Shape = vtkShadowEmitter::DISK;
    sun.HalfSize = { { std::tan(half), std::tan(half) } };
    // Rings of a cap of equal heights hold equal solid angles: Archimedes.
    std::array<double, 8> rings = { {} };
    double mean = 0.0;
    for (const Sampling::Sample& sample :
      Sampling::Generate(sun, count, Sampling::SOBOL, Sampling::MEAN))
    {
      const double angle = std::atan(std::hypot(sample.U, sample.V) * std::tan(half));
      const double height = std::pow(std::sin(0.5 * angle) / std::sin(0.5 * half), 2.0);
      ASSERT_LE(height, 1.0 + 1e-12) << degrees << " degrees";
      rings[std::min(static_cast<int>(8.0 * height), 7)] += sample.Weight;
      mean += sample.Weight * height;
    }
    EXPECT_NEAR(mean, 0.5, 2.0 / count) << degrees << " degrees";
    for (const double weight : rings)
    {
      EXPECT_NEAR(weight, 1.0 / 8.0, 0.01) << degrees << " degrees";
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, WithoutExtentOnePointIsEnough)
{
  for (const int pattern : { Sampling::GRID, Sampling::STRATIFIED, Sampling::HAMMERSLEY,
         Sampling::SOBOL, Sampling::LATTICE })
  {
    const Samples samples = Sampling::Generate(vtkShadowEmitter(), 64, pattern, Sampling::MEAN);
    ASSERT_EQ(samples.size(), 1u) << NameOf(pattern);
    EXPECT_EQ(samples[0].Weight, 1.0) << NameOf(pattern);
    EXPECT_EQ(
      Sampling::Generate(Lamp(vtkShadowEmitter::DISK), 0, pattern, Sampling::MEAN).size(), 1u);
  }
}

//------------------------------------------------------------------------------
TEST(ShadowLightSamplingPatterns, OnePointIsTheCentre)
{
  for (const int pattern :
    { Sampling::GRID, Sampling::HAMMERSLEY, Sampling::SOBOL, Sampling::LATTICE })
  {
    for (const int shape : { vtkShadowEmitter::RECTANGLE, vtkShadowEmitter::DISK })
    {
      const Samples samples = Sampling::Generate(Lamp(shape), 1, pattern, Sampling::MEAN);
      EXPECT_NEAR(samples[0].U, 0.0, 1e-15) << NameOf(pattern);
      EXPECT_NEAR(samples[0].V, 0.0, 1e-15) << NameOf(pattern);
    }
  }
}

//------------------------------------------------------------------------------
// Every aligned run of 2^k points of the endless sequence is a net, and no two runs are the same.
TEST(ShadowLightSequence, AlignedRunsAreNets)
{
  const vtkShadowEmitter lamp = Lamp(vtkShadowEmitter::RECTANGLE);
  for (const unsigned int first : { 0u, 64u, 4096u, 65472u })
  {
    Samples run;
    for (unsigned int i = 0; i < 64; ++i)
    {
      run.push_back(Sampling::PointOfSequence(lamp, first + i, Sampling::MEAN));
    }
    ExpectNet(run, 6);
    EXPECT_EQ(run[5].Weight, 1.0);
    EXPECT_NE(run[5].U, Sampling::PointOfSequence(lamp, first + 69, Sampling::MEAN).U);
  }
}

//------------------------------------------------------------------------------
TEST(ShadowLightSequence, HasTheMomentsOfTheLight)
{
  for (const int shape : { int(vtkShadowEmitter::RECTANGLE), int(vtkShadowEmitter::DISK) })
  {
    double mean = 0.0;
    double square = 0.0;
    for (unsigned int i = 0; i < 1024; ++i)
    {
      const Sampling::Sample point = Sampling::PointOfSequence(Lamp(shape), i, Sampling::MEAN);
      mean += point.U / 1024.0;
      square += point.V * point.V / 1024.0;
    }
    EXPECT_NEAR(mean, 0.0, 2e-3);
    EXPECT_NEAR(square, shape == vtkShadowEmitter::DISK ? 0.25 : 1.0 / 3.0, 2e-3);
  }
  vtkShadowEmitter point = Lamp(vtkShadowEmitter::POINT);
  point.HalfSize = { { 0.0, 0.0 } };
  EXPECT_EQ(Sampling::PointOfSequence(point, 7, Sampling::GAUSSIAN).U, 0.0);
}
