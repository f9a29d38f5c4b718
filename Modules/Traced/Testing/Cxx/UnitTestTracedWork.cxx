// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a frame does: no rays and no reading where nothing changes, and no more building than there is news.
#include "TracedStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <gtest/gtest.h>

using namespace SoftShadowsTesting;

namespace
{
struct Work
{
  vtkTypeInt64 Reads;
  vtkTypeInt64 Bodies;
  vtkTypeInt64 Refits;
  vtkTypeInt64 Scenes;
};

class TracedWork : public testing::Test
{
protected:
  Work Frame()
  {
    const Work before = this->Total();
    this->Stage.Window.Render();
    const Work now = this->Total();
    return { now.Reads - before.Reads, now.Bodies - before.Bodies, now.Refits - before.Refits,
      now.Scenes - before.Scenes };
  }

  Work Total()
  {
    return { std::max<vtkTypeInt64>(this->Stage.Count("receivers_read"), 0),
      std::max<vtkTypeInt64>(this->Stage.Count("bodies_built"), 0),
      std::max<vtkTypeInt64>(this->Stage.Count("bodies_refitted"), 0),
      std::max<vtkTypeInt64>(this->Stage.Count("scenes_built"), 0) };
  }

  Scene Drawn = MakeRectangleScene(Weights::Mean);
  TracedStage Stage{ this->Drawn };
};

void Expect(const Work& work, const Work& expected, const char* what)
{
  EXPECT_EQ(work.Reads, expected.Reads) << what;
  EXPECT_EQ(work.Bodies, expected.Bodies) << what;
  EXPECT_EQ(work.Refits, expected.Refits) << what;
  EXPECT_EQ(work.Scenes, expected.Scenes) << what;
}
}

//------------------------------------------------------------------------------
TEST_F(TracedWork, IsDoneOnceForEachChange)
{
  Expect(this->Frame(), { 1, 2, 0, 1 }, "first");
  EXPECT_GT(this->Stage.Count("rays"), 1000);
  EXPECT_EQ(this->Stage.Count("maps_baked"), 0);
  Expect(this->Frame(), { 0, 0, 0, 0 }, "at rest");

  this->Stage.Renderer->GetActiveCamera()->Azimuth(3.0);
  Expect(this->Frame(), { 1, 0, 0, 0 }, "the camera moved");
  this->Drawn.Light->SetPosition(0.3, 0.2, 4.0);
  Expect(this->Frame(), { 1, 0, 0, 0 }, "the light moved");

  vtkActor* blocker = this->Drawn.BlockerActors.front();
  blocker->AddPosition(0.1, 0.0, 0.0);
  blocker->RotateZ(10.0);
  Expect(this->Frame(), { 1, 0, 0, 1 }, "a rigid motion");

  auto* data = vtkPolyDataMapper::SafeDownCast(blocker->GetMapper())->GetInput();
  double p[3];
  data->GetPoint(0, p);
  data->GetPoints()->SetPoint(0, p[0] - 0.1, p[1], p[2] + 0.05);
  data->GetPoints()->Modified();
  Expect(this->Frame(), { 1, 0, 1, 1 }, "a point moved");
  Expect(this->Frame(), { 0, 0, 0, 0 }, "at rest again");
}

//------------------------------------------------------------------------------
TEST_F(TracedWork, MovesTheShadowWithItsCaster)
{
  const Picture first = this->Stage.Render();
  vtkActor* blocker = this->Drawn.BlockerActors.front();
  blocker->AddPosition(0.15, 0.0, 0.0);
  const Picture moved = this->Stage.Render();
  blocker->AddPosition(-0.15, 0.0, 0.0);
  const Picture back = this->Stage.Render();
  double apart = 0.0;
  for (std::size_t i = 0; i < first.Values.size(); ++i)
  {
    const double change = moved.Values[i] - first.Values[i];
    apart += std::isnan(change) ? 0.0 : std::abs(change);
    EXPECT_TRUE(std::isnan(first.Values[i]) || first.Values[i] == back.Values[i]);
  }
  EXPECT_GT(apart, 10.0);
}
