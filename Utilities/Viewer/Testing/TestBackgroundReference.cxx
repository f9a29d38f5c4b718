// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tracing in the background: the same numbers, ever finer, and gone when cancelled.
#include "BackgroundReference.h"
#include "ErrorMeter.h"

#include "SceneBuilder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

using namespace softshadows;

namespace
{

constexpr int Width = 48;
constexpr int Height = 32;

//--------------------------------------------------------------------------------------------------
/// A box under a lamp on a ground.
BuiltScene MakeScene()
{
  SceneDescription scene;
  scene.Width = Width;
  scene.Height = Height;
  CameraDescription camera;
  camera.Position = { { 0.0, -8.0, 6.0 } };
  camera.ViewUp = { { 0.0, 0.0, 1.0 } };
  scene.Camera = camera;
  LightDescription light;
  light.Position = { { 1.0, 0.0, 4.0 } };
  light.Size = { { 1.0, 1.0 } };
  scene.Lights.push_back(light);
  scene.Objects.resize(2);
  scene.Objects[0].Shape =
    PlaneShape{ { { -4.0, -4.0, 0.0 } }, { { 4.0, -4.0, 0.0 } }, { { -4.0, 4.0, 0.0 } }, 1, 1 };
  scene.Objects[1].Shape = BoxShape{ { -0.5, 0.5, -0.5, 0.5, 0.5, 1.5 } };
  ModelStore models;
  return BuildScene(scene, models);
}

//--------------------------------------------------------------------------------------------------
void WaitFor(const BackgroundReference& reference)
{
  while (reference.IsRunning())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}

//--------------------------------------------------------------------------------------------------
TEST(BackgroundReference, EndsWithTheFinestTrace)
{
  const BuiltScene scene = MakeScene();
  BackgroundReference reference;
  reference.Start(
    std::make_shared<ReferenceSnapshot>(scene.Renderer, Width, Height, false), { 2, 4 });
  WaitFor(reference);
  const auto result = reference.GetResult();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->RaysPerPixel, 16);
  EXPECT_EQ(reference.SpellProgress(), "");
  const ReferenceVisibility direct = Trace(scene.Renderer, Width, Height, 4);
  const std::vector<float>& values = result->Images.Visibility[0];
  EXPECT_EQ(
    std::memcmp(values.data(), direct.Visibility[0].data(), values.size() * sizeof(float)), 0);
}

//--------------------------------------------------------------------------------------------------
TEST(BackgroundReference, CancellingReturnsAtOnceAndForgets)
{
  const BuiltScene scene = MakeScene();
  const auto snapshot = std::make_shared<ReferenceSnapshot>(scene.Renderer, Width, Height, false);
  BackgroundReference reference;
  reference.Start(snapshot, { 1 << 12 }); // would take minutes
  EXPECT_TRUE(reference.IsRunning());
  EXPECT_NE(reference.SpellProgress(), "");
  reference.Cancel();
  EXPECT_FALSE(reference.IsRunning());
  EXPECT_FALSE(reference.GetResult());
  // The thread is free for the next.
  reference.Start(snapshot, { 2 });
  WaitFor(reference);
  EXPECT_TRUE(reference.GetResult());
}

//--------------------------------------------------------------------------------------------------
TEST(ErrorMeter, MeasuresAgainstTheReference)
{
  const BuiltScene scene = MakeScene();
  ErrorMeter meter;
  EXPECT_FALSE(meter.IsStarted());
  EXPECT_TRUE(std::isnan(meter.Measure(0, {})));
  meter.Start(scene.Renderer, Width, Height, true);
  EXPECT_TRUE(meter.IsFor(true));
  EXPECT_FALSE(meter.IsFor(false));
  while (meter.IsRunning())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const auto reference = meter.GetReference();
  ASSERT_TRUE(reference);
  EXPECT_EQ(reference->RaysPerPixel, 32 * 32);
  std::vector<float> visibility = reference->Images.Visibility[0];
  EXPECT_EQ(meter.Measure(0, visibility), 0.0);
  for (float& value : visibility)
  {
    value += 0.125F;
  }
  EXPECT_NEAR(meter.Measure(0, visibility), 0.125, 1e-6);
  EXPECT_NE(meter.Spell(0.125).find("RMSE 0.1250"), std::string::npos) << meter.Spell(0.125);
  meter.Cancel();
  EXPECT_TRUE(std::isnan(meter.Measure(0, visibility)));
}
