// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// When a running mean is looked at, what is concluded, and when it ends.
#include "vtkSoftShadowSchedule.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{
using Schedule = vtkSoftShadowSchedule;
using Tiles = std::vector<float>;

// Draws up to the next look, in frames of so many points.
int DrawToLook(Schedule& schedule, int points)
{
  int drawn = 0;
  for (;;)
  {
    const int run = schedule.GetRun(points);
    drawn += run;
    if (schedule.Advance(run))
    {
      return drawn;
    }
  }
}
} // namespace

//------------------------------------------------------------------------------
TEST(SoftShadowSchedule, ComparesMapsThenHalves)
{
  for (const int points : { 1, 7, 1000 })
  {
    Schedule schedule;
    EXPECT_FALSE(schedule.IsStarted());
    schedule.Start(1024, 1024, 0.01);
    EXPECT_EQ(schedule.GetMapSize(), 512);
    EXPECT_FALSE(schedule.NeedsTiles());
    EXPECT_EQ(DrawToLook(schedule, points), Schedule::FirstPoints);
    EXPECT_EQ(schedule.Look({}), Schedule::HOLD_AND_CLEAR);
    EXPECT_EQ(schedule.GetMapSize(), 1024);
    EXPECT_EQ(schedule.GetCount(), 0);
    EXPECT_EQ(schedule.GetShare(), 0.0f);
    EXPECT_TRUE(schedule.NeedsTiles());
    schedule.Advance(16);
    EXPECT_EQ(schedule.GetShare(), 0.25f);
    EXPECT_EQ(DrawToLook(schedule, points), Schedule::FirstPoints - 16);
    EXPECT_EQ(schedule.Look({ 0.0f, 2.4e-5f }), Schedule::HOLD);
    EXPECT_EQ(schedule.GetShare(), 1.0f);
    // 1.22 times a change of 0.0049 are 0.006; with 0.008 of the points that is the tolerance.
    EXPECT_EQ(DrawToLook(schedule, points), Schedule::FirstPoints);
    EXPECT_EQ(schedule.Look({ 0.0f, 1.44e-4f }), Schedule::HOLD);
    EXPECT_NEAR(schedule.GetEstimatedError(), 0.01342, 1e-4);
    EXPECT_FALSE(schedule.IsEnded());
    EXPECT_EQ(DrawToLook(schedule, points), 2 * Schedule::FirstPoints);
    EXPECT_EQ(schedule.GetCount(), 256);
    EXPECT_EQ(schedule.GetShare(), 1.0f);
    EXPECT_EQ(schedule.Look({ 0.0f, 6.3e-5f }), Schedule::END);
    EXPECT_TRUE(schedule.IsConverged());
    EXPECT_NEAR(schedule.GetEstimatedError(), 0.00995, 1e-4);
  }
}

//------------------------------------------------------------------------------
TEST(SoftShadowSchedule, TakesFinerMapsWhileTheyAreTooCoarse)
{
  Schedule schedule;
  schedule.Start(512, 2048, 0.01);
  std::vector<int> sizes;
  for (int look = 0; look < 4; ++look)
  {
    sizes.push_back(schedule.GetMapSize());
    DrawToLook(schedule, 16);
    const bool clears = schedule.Look({ 1e-3f }) == Schedule::HOLD_AND_CLEAR;
    EXPECT_EQ(clears, look < 3) << look;
  }
  EXPECT_EQ(sizes, (std::vector<int>{ 256, 512, 1024, 2048 }));
}

//------------------------------------------------------------------------------
TEST(SoftShadowSchedule, GivesUpWhereOnlyMapsAreInTheWay)
{
  Schedule schedule;
  schedule.Start(512, 512, 0.01);
  DrawToLook(schedule, 16);
  schedule.Look({});
  DrawToLook(schedule, 16);
  schedule.Look({ 1.5e-3f });
  DrawToLook(schedule, 16);
  EXPECT_EQ(schedule.Look({ 1e-3f }), Schedule::HOLD) << "the points still count";
  DrawToLook(schedule, 16);
  EXPECT_EQ(schedule.Look({ 1e-5f }), Schedule::END);
  EXPECT_TRUE(schedule.IsEnded());
  EXPECT_FALSE(schedule.IsConverged());
  EXPECT_NEAR(schedule.GetEstimatedError(), 0.0475, 1e-3);
  EXPECT_NE(schedule.Describe().find("whose texels alone leave 0.0474"), std::string::npos)
    << schedule.Describe();
}

//------------------------------------------------------------------------------
// What is chance in one half of the points is not in the other: products may be negative.
TEST(SoftShadowSchedule, KeepsTheMeanOfHalfThePointsWhileMapsAreCompared)
{
  for (const int points : { 1, 7, 1000 })
  {
    Schedule schedule;
    schedule.Start(512, 512, 0.01);
    for (int look = 0; look < 2; ++look)
    {
      EXPECT_TRUE(schedule.ComparesMaps());
      int halves = 0;
      for (bool whole = false; !whole;)
      {
        whole = schedule.Advance(schedule.GetRun(points));
        halves += schedule.IsHalfway() ? 1 : 0;
      }
      EXPECT_EQ(halves, 1);
      schedule.Look({ -1e-3f });
    }
    EXPECT_FALSE(schedule.ComparesMaps());
    DrawToLook(schedule, points);
    EXPECT_EQ(schedule.Look({ 0.0f }), Schedule::END);
    EXPECT_EQ(schedule.GetEstimatedError(), 0.0);
    EXPECT_EQ(schedule.Describe().find("converged: "), 0u) << schedule.Describe();
  }
}

//------------------------------------------------------------------------------
TEST(SoftShadowSchedule, GoesOnWithTheLastMapsWhereFinerOnesAreLost)
{
  Schedule schedule;
  schedule.Start(512, 2048, 0.01);
  DrawToLook(schedule, 16);
  schedule.Look({});
  DrawToLook(schedule, 16);
  EXPECT_EQ(schedule.Look({ 6e-5f }), Schedule::HOLD_AND_CLEAR);
  EXPECT_EQ(schedule.GetMapSize(), 1024);
  schedule.Advance(16);
  EXPECT_TRUE(schedule.LoseMaps());
  EXPECT_EQ(schedule.GetMapSize(), 512);
  EXPECT_EQ(schedule.GetCount(), 0);
  EXPECT_EQ(schedule.GetShare(), 0.0f) << "what is held is shown";
  EXPECT_TRUE(schedule.IsHeldShown());
  schedule.Advance(32);
  EXPECT_EQ(schedule.GetShare(), 0.5f);
  // The floor of the last size, 1.22 times 0.0077, stands: no look compares its own maps with themselves.
  EXPECT_EQ(DrawToLook(schedule, 16), 2 * Schedule::FirstPoints - 32);
  EXPECT_EQ(schedule.Look({ 0.0f }), Schedule::END);
  EXPECT_NEAR(schedule.GetEstimatedError(), 0.00949, 1e-5);
  EXPECT_TRUE(schedule.IsConverged());
}

//------------------------------------------------------------------------------
TEST(SoftShadowSchedule, FailsWithoutAnyMaps)
{
  for (const int looks : { 0, 1 })
  {
    Schedule schedule;
    schedule.Start(512, 2048, 0.01);
    for (int look = 0; look < looks; ++look)
    {
      DrawToLook(schedule, 16);
      schedule.Look({});
    }
    schedule.Advance(16);
    EXPECT_FALSE(schedule.LoseMaps());
    EXPECT_TRUE(schedule.IsEnded());
    EXPECT_FALSE(schedule.IsConverged());
    EXPECT_EQ(schedule.GetEstimatedError(), 1.0);
    EXPECT_EQ(schedule.GetShare(), 0.0f) << "the technique's own picture is shown";
    EXPECT_FALSE(schedule.IsHeldShown());
  }
}
