// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tracing what was, in another thread, while the renderer goes on.
#include "ReferenceSnapshot.h"
#include "ReferenceTracer.h"
#include "Scenes.h"

#include "vtkAreaLight.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <thread>

using softshadows::ReferenceSnapshot;
using softshadows::ReferenceTracer;
using softshadows::ReferenceVisibility;
using SoftShadowsTesting::MakeQuadActor;

namespace
{

constexpr int Width = 32;
constexpr int Height = 16;
constexpr int PerAxis = 4;

//--------------------------------------------------------------------------------------------------
/// NaN equals NaN: bit by bit.
bool AreEqual(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

//--------------------------------------------------------------------------------------------------
/// A lamp over a square in the air over a floor, seen from the side.
class ReferenceSnapshots : public testing::Test
{
protected:
  ReferenceSnapshots()
  {
    this->Blocker =
      MakeQuadActor({ { { { -0.5, -0.5, 1.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } } } });
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddActor(
      MakeQuadActor({ { { { -4.0, -4.0, 0.0 } }, { { 8.0, 0.0, 0.0 } }, { { 0.0, 8.0, 0.0 } } } }));
    this->Renderer->AddActor(this->Blocker);
    this->Lamp->SetPosition(0.0, 0.0, 4.0);
    this->Lamp->SetSize(1.0, 1.0);
    this->Renderer->AddLight(this->Lamp);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, -8.0, 5.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }

  ReferenceVisibility TraceNow() const
  {
    return softshadows::Trace(this->Renderer, Width, Height, PerAxis);
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAreaLight> Lamp;
  vtkSmartPointer<vtkActor> Blocker;
};

}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceSnapshots, KeepWhatWasWhenTheyWereMade)
{
  const ReferenceVisibility before = this->TraceNow();
  const ReferenceSnapshot snapshot(this->Renderer, Width, Height, false);
  this->Lamp->SetPosition(2.0, 0.0, 4.0);
  this->Blocker->SetPosition(1.0, 0.0, 0.0);
  this->Renderer->GetActiveCamera()->Azimuth(20.0);
  ASSERT_FALSE(AreEqual(this->TraceNow().Visibility[0], before.Visibility[0]));

  ReferenceVisibility traced;
  std::thread background([&] { traced = ReferenceTracer(Width, Height, PerAxis).Trace(snapshot); });
  background.join();
  EXPECT_TRUE(traced.Complete);
  EXPECT_TRUE(AreEqual(traced.Visibility[0], before.Visibility[0]));
  EXPECT_TRUE(AreEqual(traced.Depth, before.Depth));
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceSnapshots, ShareSurfacesButNotCameraAndLights)
{
  const ReferenceSnapshot first(this->Renderer, Width, Height, false);
  this->Lamp->SetPosition(2.0, 0.0, 4.0);
  this->Renderer->GetActiveCamera()->Azimuth(20.0);
  const ReferenceSnapshot second(this->Renderer, Width, Height, false, first);
  EXPECT_EQ(&first.GetCaster(), &second.GetCaster());
  const ReferenceVisibility traced = ReferenceTracer(Width, Height, PerAxis).Trace(second);
  EXPECT_TRUE(AreEqual(traced.Visibility[0], this->TraceNow().Visibility[0]));
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceSnapshots, EndEarlyWhenCancelled)
{
  std::atomic<bool> cancelled{ true };
  const ReferenceSnapshot snapshot(this->Renderer, Width, Height, false);
  ReferenceTracer tracer(Width, Height, 1 << 15); // would take hours
  tracer.SetCancelled(&cancelled);
  const ReferenceVisibility traced = tracer.Trace(snapshot);
  EXPECT_FALSE(traced.Complete);
  const std::vector<float>& values = traced.Visibility[0];
  EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](float v) { return std::isnan(v); }));
}

//--------------------------------------------------------------------------------------------------
TEST_F(ReferenceSnapshots, AreTracedInTheirOwnSizeOnly)
{
  const ReferenceSnapshot snapshot(this->Renderer, Width, Height, false);
  EXPECT_THROW(ReferenceTracer(Width + 1, Height, PerAxis).Trace(snapshot), std::invalid_argument);
}
