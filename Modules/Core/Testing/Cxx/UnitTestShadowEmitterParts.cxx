// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Parts, points and faces of an emitter: together they are the whole.

#include "vtkMath.h"
#include "vtkShadowEmitter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;

vtkShadowEmitter Lamp(int shape)
{
  vtkShadowEmitter emitter;
  emitter.Shape = shape;
  emitter.Center = { { 1.0, 2.0, 3.0 } };
  emitter.Apex = emitter.Center;
  emitter.HalfSize = { { 0.5, 0.25 } };
  return emitter;
}

struct Moments
{
  double Weight = 0.0;
  double Mean[2] = { 0.0, 0.0 };
  double Second[2] = { 0.0, 0.0 }; // about the whole's centre
};

// Of the parts as the rectangles they are, in units of the whole's half extents.
Moments MomentsOf(const vtkShadowEmitter& whole, const std::vector<vtkShadowEmitter>& parts)
{
  Moments moments;
  for (const vtkShadowEmitter& part : parts)
  {
    moments.Weight += part.Weight;
    Vector offset;
    vtkMath::Subtract(part.Center.data(), whole.Center.data(), offset.data());
    const double center[2] = { vtkMath::Dot(offset.data(), whole.AxisU.data()) / whole.HalfSize[0],
      vtkMath::Dot(offset.data(), whole.AxisV.data()) / whole.HalfSize[1] };
    for (int axis = 0; axis < 2; ++axis)
    {
      const double half = part.HalfSize[axis] / whole.HalfSize[axis];
      moments.Mean[axis] += part.Weight * center[axis];
      moments.Second[axis] += part.Weight * (center[axis] * center[axis] + half * half / 3.0);
    }
  }
  return moments;
}

struct SplitCase
{
  int Shape;
  int CountU;
  int CountV;
  double SecondMoment; // closed form: 1/3 for the square [-1, 1]^2, 1/4 for the unit disk
};

std::string NameOf(const SplitCase& test)
{
  return std::string(test.Shape == vtkShadowEmitter::DISK ? "Disk" : "Rectangle") +
    std::to_string(test.CountU) + "x" + std::to_string(test.CountV);
}

// Else GoogleTest prints the bytes, padding included.
std::ostream& operator<<(std::ostream& os, const SplitCase& test)
{
  return os << NameOf(test);
}

class ShadowEmitterSplit : public testing::TestWithParam<SplitCase>
{
};
} // namespace

INSTANTIATE_TEST_SUITE_P(Shapes, ShadowEmitterSplit,
  testing::Values(SplitCase{ vtkShadowEmitter::RECTANGLE, 2, 2, 1.0 / 3.0 },
    SplitCase{ vtkShadowEmitter::RECTANGLE, 3, 1, 1.0 / 3.0 },
    SplitCase{ vtkShadowEmitter::RECTANGLE, 4, 5, 1.0 / 3.0 },
    SplitCase{ vtkShadowEmitter::DISK, 2, 2, 0.25 },
    SplitCase{ vtkShadowEmitter::DISK, 3, 3, 0.25 },
    SplitCase{ vtkShadowEmitter::DISK, 7, 4, 0.25 }),
  [](const testing::TestParamInfo<SplitCase>& instance) { return NameOf(instance.param); });

//------------------------------------------------------------------------------
TEST_P(ShadowEmitterSplit, PartsHaveTheMomentsOfTheWhole)
{
  const SplitCase test = this->GetParam();
  const vtkShadowEmitter whole = Lamp(test.Shape);
  const Moments moments = MomentsOf(whole, whole.Split(test.CountU, test.CountV));
  EXPECT_NEAR(moments.Weight, 1.0, 1e-12);
  for (int axis = 0; axis < 2; ++axis)
  {
    EXPECT_NEAR(moments.Mean[axis], 0.0, 1e-12) << "axis " << axis;
    // Rectangles are exact; a disk's rim cuts cells, which are summed numerically.
    const double tolerance = test.Shape == vtkShadowEmitter::DISK ? 1e-3 : 1e-12;
    EXPECT_NEAR(moments.Second[axis], test.SecondMoment, tolerance) << "axis " << axis;
  }
}

//------------------------------------------------------------------------------
TEST_P(ShadowEmitterSplit, PartsKnowTheirPlaceInTheWindow)
{
  const SplitCase test = this->GetParam();
  const vtkShadowEmitter whole = Lamp(test.Shape);
  for (const vtkShadowEmitter& part : whole.Split(test.CountU, test.CountV))
  {
    EXPECT_EQ(part.Shape, vtkShadowEmitter::RECTANGLE);
    EXPECT_EQ(part.Apex, whole.Apex) << "the cone is the whole light's";
    EXPECT_GT(part.Weight, 0.0);
    EXPECT_EQ(part.Direction, whole.Direction);
    for (int axis = 0; axis < 2; ++axis)
    {
      const Vector& along = axis == 0 ? whole.AxisU : whole.AxisV;
      Vector offset;
      vtkMath::Subtract(part.Center.data(), whole.Center.data(), offset.data());
      EXPECT_NEAR(vtkMath::Dot(offset.data(), along.data()),
        part.WindowCenter[axis] * whole.HalfSize[axis], 1e-12);
      EXPECT_NEAR(part.HalfSize[axis], part.WindowHalfSize[axis] * whole.HalfSize[axis], 1e-12);
      EXPECT_LE(part.WindowHalfSize[axis], 1.0 / (axis == 0 ? test.CountU : test.CountV) + 1e-12)
        << "no part is larger than its cell";
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, RectanglesWeighTheirAreas)
{
  const std::vector<vtkShadowEmitter> parts = Lamp(vtkShadowEmitter::RECTANGLE).Split(4, 3);
  ASSERT_EQ(parts.size(), 12u);
  for (const vtkShadowEmitter& part : parts)
  {
    EXPECT_NEAR(part.Weight, 1.0 / 12.0, 1e-14);
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, GaussianWeightsIntegrateTheGaussian)
{
  // N(0, 0.5) over a cell of [-1, 1]^2 is a product of differences of erf(x sqrt(2)).
  constexpr int count = 4;
  const std::vector<vtkShadowEmitter> parts =
    Lamp(vtkShadowEmitter::RECTANGLE).Split(count, count, true);
  ASSERT_EQ(parts.size(), size_t(count * count));
  const double whole = 2.0 * std::erf(std::sqrt(2.0));
  double sum = 0.0;
  for (const vtkShadowEmitter& part : parts)
  {
    double expected = 1.0;
    for (const double center : part.WindowCenter)
    {
      expected *= (std::erf((center + 1.0 / count) * std::sqrt(2.0)) -
                    std::erf((center - 1.0 / count) * std::sqrt(2.0))) /
        whole;
    }
    EXPECT_NEAR(part.Weight, expected, 1e-4)
      << "part at (" << part.WindowCenter[0] << ", " << part.WindowCenter[1] << ")";
    sum += part.Weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, CellsOutsideADiskAreLeftOut)
{
  // Cells of 1/8 in the corners of the square around the disk do not touch it.
  const std::vector<vtkShadowEmitter> parts = Lamp(vtkShadowEmitter::DISK).Split(16, 16);
  size_t touching = 0;
  for (int j = 0; j < 8; ++j)
  {
    for (int i = 0; i < 8; ++i)
    {
      touching += std::hypot(i / 8.0, j / 8.0) < 1.0 ? 4 : 0; // the corner nearest to the centre
    }
  }
  EXPECT_EQ(parts.size(), touching);
  EXPECT_LT(parts.size(), 256u);
  EXPECT_NEAR(MomentsOf(Lamp(vtkShadowEmitter::DISK), parts).Weight, 1.0, 1e-12);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, PartsOfPartsAddUp)
{
  const vtkShadowEmitter whole = Lamp(vtkShadowEmitter::RECTANGLE);
  std::vector<vtkShadowEmitter> parts;
  for (const vtkShadowEmitter& half : whole.Split(2, 1))
  {
    EXPECT_NEAR(half.Weight, 0.5, 1e-14);
    for (const vtkShadowEmitter& part : half.Split(1, 2))
    {
      parts.push_back(part);
      EXPECT_NEAR(std::abs(part.WindowCenter[0]), 0.5, 1e-12);
      EXPECT_NEAR(std::abs(part.WindowCenter[1]), 0.5, 1e-12);
    }
  }
  const Moments moments = MomentsOf(whole, parts);
  EXPECT_NEAR(moments.Weight, 1.0, 1e-12);
  EXPECT_NEAR(moments.Second[0], 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(moments.Second[1], 1.0 / 3.0, 1e-12);
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, WhatCannotBeCutIsItsOwnOnlyPart)
{
  vtkShadowEmitter point;
  point.Center = { { 1.0, 2.0, 3.0 } };
  EXPECT_EQ(point.Split(4, 4), (std::vector<vtkShadowEmitter>{ point }));
  const vtkShadowEmitter disk = Lamp(vtkShadowEmitter::DISK);
  EXPECT_EQ(disk.Split(1, 1), (std::vector<vtkShadowEmitter>{ disk })) << "still a disk";
  EXPECT_EQ(disk.Split(0, -3), (std::vector<vtkShadowEmitter>{ disk }));
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, PointsOfALampMoveItsCenter)
{
  const vtkShadowEmitter whole = Lamp(vtkShadowEmitter::RECTANGLE);
  const vtkShadowEmitter point = whole.PointAt(-1.0, 0.5, 0.125);
  EXPECT_EQ(point.Shape, vtkShadowEmitter::POINT);
  EXPECT_FALSE(point.HasExtent());
  EXPECT_EQ(point.Weight, 0.125);
  EXPECT_NEAR(point.Center[0], 1.0 - 0.5, 1e-15);
  EXPECT_NEAR(point.Center[1], 2.0 + 0.125, 1e-15);
  EXPECT_EQ(point.Center[2], 3.0);
  EXPECT_EQ(point.Direction, whole.Direction);
  EXPECT_EQ(point.Apex, whole.Apex);
  EXPECT_EQ(point.WindowCenter, (std::array<double, 2>{ { -1.0, 0.5 } }));
  EXPECT_EQ(point.WindowHalfSize, (std::array<double, 2>{ { 0.0, 0.0 } }));
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, PointsOfASunTurnItsDirection)
{
  vtkShadowEmitter sun = Lamp(vtkShadowEmitter::DISK);
  sun.Directional = true;
  const double tangent = std::tan(10.0 * vtkMath::Pi() / 180.0);
  sun.HalfSize = { { tangent, tangent } };
  for (const auto& window :
    { std::array<double, 2>{ { 1.0, 0.0 } }, { { 0.0, -1.0 } }, { { 0.6, 0.8 } } })
  {
    const vtkShadowEmitter point = sun.PointAt(window[0], window[1], 1.0);
    EXPECT_EQ(point.Center, sun.Center);
    EXPECT_NEAR(vtkMath::Norm(point.Direction.data()), 1.0, 1e-14);
    EXPECT_NEAR(vtkMath::AngleBetweenVectors(point.Direction.data(), sun.Direction.data()),
      vtkMath::RadiansFromDegrees(10.0), 1e-12)
      << "the sun's rim is half its angular diameter away";
    // The sun's part at +U is seen on that side: its light comes from there.
    EXPECT_NEAR(vtkMath::Dot(point.Direction.data(), sun.AxisU.data()),
      -window[0] * std::sin(vtkMath::RadiansFromDegrees(10.0)), 1e-12);
    EXPECT_NEAR(vtkMath::Dot(point.Direction.data(), sun.AxisV.data()),
      -window[1] * std::sin(vtkMath::RadiansFromDegrees(10.0)), 1e-12);
    Vector width;
    vtkMath::Cross(point.Direction.data(), point.AxisV.data(), width.data());
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(point.AxisU[i], width[i], 1e-12) << "AxisU = Direction x AxisV";
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, EveryDirectionBelongsToExactlyOneFace)
{
  vtkShadowEmitter lamp;
  lamp.Omni = true;
  lamp.Center = { { 1.0, 2.0, 3.0 } };
  lamp.Apex = lamp.Center;
  lamp.Weight = 0.5;
  lamp.Direction = { { 2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0 } };
  lamp.AxisV = { { 2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0 } };
  vtkMath::Cross(lamp.Direction.data(), lamp.AxisV.data(), lamp.AxisU.data());
  const std::vector<vtkShadowEmitter> faces = lamp.Faces();
  ASSERT_EQ(faces.size(), 6u);
  for (const vtkShadowEmitter& face : faces)
  {
    EXPECT_TRUE(face.Face);
    EXPECT_FALSE(face.Omni);
    EXPECT_EQ(face.Weight, 0.5) << "a receiver sees the whole lamp through one face";
    EXPECT_EQ(face.Center, lamp.Center);
    Vector width;
    vtkMath::Cross(face.Direction.data(), face.AxisV.data(), width.data());
    EXPECT_NEAR(vtkMath::Dot(width.data(), face.AxisU.data()), 1.0, 1e-12);
    EXPECT_NEAR(vtkMath::Dot(face.Direction.data(), face.AxisV.data()), 0.0, 1e-12);
  }

  std::minstd_rand engine(3);
  std::normal_distribution<double> normal;
  std::array<int, 6> directions = { {} };
  for (int trial = 0; trial < 6000; ++trial)
  {
    const Vector ray = { { normal(engine), normal(engine), normal(engine) } };
    int owners = 0;
    for (size_t i = 0; i < faces.size(); ++i)
    {
      const double x = vtkMath::Dot(ray.data(), faces[i].AxisU.data());
      const double y = vtkMath::Dot(ray.data(), faces[i].AxisV.data());
      const double z = vtkMath::Dot(ray.data(), faces[i].Direction.data());
      if (std::abs(x) <= z && std::abs(y) <= z)
      {
        ++owners;
        ++directions[i];
      }
    }
    ASSERT_EQ(owners, 1) << "direction (" << ray[0] << ", " << ray[1] << ", " << ray[2] << ")";
  }
  for (const int count : directions)
  {
    EXPECT_NEAR(count, 1000, 150) << "six equal faces; 150 is five standard deviations";
  }
}

//------------------------------------------------------------------------------
TEST(ShadowEmitterParts, WhatShinesToOneSideIsItsOwnOnlyFace)
{
  const vtkShadowEmitter lamp = Lamp(vtkShadowEmitter::RECTANGLE);
  EXPECT_EQ(lamp.Faces(), (std::vector<vtkShadowEmitter>{ lamp }));
}
