// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Coarse bodies with smooth normals are shaded as the smooth bodies that they stand for, and what is read
// stays that of their triangles.
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 120;
const int Height = 90;

/// A ball whose terminator the camera looks at, alone under a sun.
struct Ball
{
  vtkSmartPointer<vtkRenderer> Renderer;

  explicit Ball(int resolution)
  {
    const Point eye = { { 0.0, -6.0, 0.0 } };
    const Point center = { { 0.0, 0.0, 0.0 } };
    const Point toSun = { { 0.8, 0.1, 0.4 } };
    this->Renderer = MakeRenderer(eye, center, 22.0);
    this->Renderer->AddLight(MakeSun(toSun, 1.0));
    this->Renderer->AddActor(MakeSphereActor(center, 1.0, resolution));
    this->Renderer->ResetCameraClippingRange();
  }
};

/// Pixels well within the ball: where the coarse one shows too.
bool IsInside(int x, int y)
{
  const double radius = 0.88 * 0.5 * Height / std::tan(11.0 * 3.14159265358979 / 180.0) / 6.0;
  return std::hypot(x + 0.5 - 0.5 * Width, y + 0.5 - 0.5 * Height) < radius;
}

float LargestDifference(const Picture& first, const Picture& second)
{
  float largest = 0.0f;
  for (int y = 0; y < first.Height; ++y)
  {
    for (int x = 0; x < first.Width; ++x)
    {
      const float difference = std::abs(first.At(x, y) - second.At(x, y));
      largest = IsInside(x, y) ? std::max(largest, difference) : largest;
    }
  }
  return largest;
}

bool AreEqual(const Picture& first, const Picture& second)
{
  return std::equal(first.Values.begin(), first.Values.end(), second.Values.begin(),
    second.Values.end(),
    [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

class SmoothTerminator : public testing::TestWithParam<Technique>
{
protected:
  vtkSmartPointer<vtkSoftShadowPass> MakePass(bool smooth) const
  {
    vtkSmartPointer<vtkSoftShadowPass> pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    pass->SetSmoothTerminator(smooth);
    return pass;
  }

  Picture Colors(const Ball& ball, bool smooth) const
  {
    Stage stage(ball.Renderer, this->MakePass(smooth), Width, Height);
    return stage.RenderColors();
  }
};

//------------------------------------------------------------------------------
// The interpolated normals of 24 x 24 facets alone are off by 0.02 of the light, and the last row of pixels
// before the terminator is of 0.03.
TEST_P(SmoothTerminator, ShowsTheSmoothBody)
{
  const Picture truth = this->Colors(Ball(256), false);
  const Ball ball(24);
  const float blocks = LargestDifference(this->Colors(ball, false), truth);
  const float smooth = LargestDifference(this->Colors(ball, true), truth);
  EXPECT_GT(blocks, 0.07f) << "facets that turn away from the sun do not show as blocks";
  EXPECT_LT(smooth, 0.035f) << "facets: " << blocks;
}

//------------------------------------------------------------------------------
TEST_P(SmoothTerminator, LeavesTheFarSideDark)
{
  const Picture truth = this->Colors(Ball(256), false);
  const Picture smooth = this->Colors(Ball(24), true);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      if (IsInside(x, y) && truth.At(x, y) == 0.0f)
      {
        ASSERT_LT(smooth.At(x, y), 0.03f) << "at (" << x << ", " << y << ")";
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_P(SmoothTerminator, ReadsTheTrianglesOwnVisibility)
{
  const BallScene scene = MakeBallScene();
  Stage flat(scene.Renderer, this->MakePass(false), Width, Height);
  const Picture visibility = flat.RenderVisibility(scene.Lamp);
  const Picture depth = PictureOf(flat.GetPass()->GetDepthImage());
  EXPECT_EQ(flat.GetPass()->GetCount("data_frames"), 0);

  const auto pass = this->MakePass(true);
  flat.SetPass(pass);
  const Picture colors = flat.RenderColors();
  flat.Render();
  EXPECT_EQ(pass->GetCount("data_frames"), 0) << "nobody has read it";
  EXPECT_TRUE(AreEqual(PictureOf(pass->GetVisibilityImage(scene.Lamp)), visibility));
  EXPECT_TRUE(AreEqual(PictureOf(pass->GetDepthImage()), depth));
  EXPECT_TRUE(AreEqual(PictureOf(pass->GetVisibilityImage(scene.Lamp)), visibility));
  EXPECT_EQ(pass->GetCount("data_frames"), 1);

  const vtkTypeInt64 drawn = pass->GetCount("visibility_frames");
  EXPECT_TRUE(AreEqual(flat.RenderColors(), colors)) << "the picture is another after reading";
  EXPECT_EQ(pass->GetCount("visibility_frames"), drawn);
  EXPECT_TRUE(AreEqual(PictureOf(pass->GetVisibilityImage(scene.Lamp)), visibility));
  EXPECT_EQ(pass->GetCount("data_frames"), 1);
}

//------------------------------------------------------------------------------
TEST_P(SmoothTerminator, IsSwitchedWithoutBuildingOrBaking)
{
  const BallScene scene = MakeBallScene();
  const auto pass = this->MakePass(false);
  Stage stage(scene.Renderer, pass, Width, Height);
  const Picture off = stage.RenderColors();
  pass->SmoothTerminatorOn();
  const Picture on = stage.RenderColors();
  EXPECT_FALSE(AreEqual(on, off));
  const vtkTypeInt64 mappers = pass->GetCount("mapper_shader_builds");
  const vtkTypeInt64 shaders = pass->GetCount("shader_builds");
  for (const bool smooth : { false, true })
  {
    pass->SetSmoothTerminator(smooth);
    EXPECT_TRUE(AreEqual(stage.RenderColors(), smooth ? on : off)) << smooth;
  }
  EXPECT_EQ(pass->GetCount("mapper_shader_builds"), mappers);
  EXPECT_EQ(pass->GetCount("shader_builds"), shaders);
}

//------------------------------------------------------------------------------
TEST_P(SmoothTerminator, LeavesFlatShadingAsItIs)
{
  BallScene scene = MakeBallScene();
  scene.Ball->GetProperty()->SetInterpolationToFlat();
  scene.Renderer->AddActor(MakeBoxActor({ { 0.6, 1.0, -0.3, 0.3, 0.0, 0.5 } }));
  const auto pass = this->MakePass(false);
  Stage stage(scene.Renderer, pass, Width, Height);
  const Picture off = stage.RenderColors();
  pass->SmoothTerminatorOn();
  EXPECT_TRUE(AreEqual(stage.RenderColors(), off));
  EXPECT_TRUE(pass->GetVisibilityImage(scene.Lamp));
  EXPECT_EQ(pass->GetCount("data_frames"), 0) << "the picture's visibility is the triangles' own";
}

//------------------------------------------------------------------------------
// A box that stands on a hill of coarse facets: where the shadow begins it stays as dark.
TEST_P(SmoothTerminator, KeepsShadowsAtContacts)
{
  const auto renderer = MakeRenderer({ { 0.0, -6.0, 4.0 } }, { { 0.0, 0.0, 0.1 } }, 16.0);
  const auto lamp = MakeLamp({ { 2.0, 0.0, 4.0 } }, { { 0.0, 0.0, 0.0 } }, 0.2);
  renderer->AddLight(lamp);
  renderer->AddActor(MakeSphereActor({ { 0.0, 0.0, -8.0 } }, 8.0, 48));
  renderer->AddActor(MakeBoxActor({ { -0.2, 0.2, -0.2, 0.2, -0.1, 0.4 } }));
  const auto pass = this->MakePass(false);
  Stage stage(renderer, pass, Width, Height);
  const Picture off = stage.RenderColors();
  pass->SmoothTerminatorOn();
  const Picture on = stage.RenderColors();
  const auto isDark = [](float value) { return value < 0.02f; };
  const auto dark = std::count_if(off.Values.begin(), off.Values.end(), isDark);
  ASSERT_GT(dark, 300) << "there is no shadow";
  int lit = 0;
  for (size_t i = 0; i < off.Values.size(); ++i)
  {
    lit += isDark(off.Values[i]) && on.Values[i] > 0.15f ? 1 : 0;
  }
  EXPECT_LE(lit, 3 * Height / 20) << "of " << dark << " dark channels";
}

//------------------------------------------------------------------------------
TEST_P(SmoothTerminator, ReadsTheMeanOfARestingCamera)
{
  Picture means[2];
  for (const bool smooth : { false, true })
  {
    const BallScene scene = MakeBallScene();
    const auto pass = this->MakePass(smooth);
    pass->ProgressiveOn();
    pass->SetProgressivePoints(8);
    pass->SetMapMemory(1);
    Stage stage(scene.Renderer, pass, 64, 48);
    for (int frame = 0; frame < 10; ++frame)
    {
      stage.Render();
    }
    means[smooth ? 1 : 0] = PictureOf(pass->GetVisibilityImage(scene.Lamp));
  }
  EXPECT_TRUE(AreEqual(means[1], means[0]));
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, SmoothTerminator, testing::ValuesIn(AllTechniques()), NameOfTechnique);

}
