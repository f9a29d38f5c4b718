// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BakingScene.h"

#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkLineSource.h"
#include "vtkPlaneSource.h"
#include "vtkProperty.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
// A box over a plane in local coordinates, seen from above; the closed form of every texel's depth.
struct Placing
{
  const char* Name;
  bool Directional;
  double Scale;
  double Shift;
};

class BoxOverPlane : public testing::TestWithParam<Placing>
{
};

constexpr double LIGHT_HEIGHT = 4.0;
constexpr double BOX_TOP = 1.5;
constexpr double BOX_BOTTOM = 1.0;
constexpr int RESOLUTION = 64;

// The distance from the light's plane to what the light sees along (u, v).
double ExpectedDistance(double u, double v, bool directional)
{
  const double toTop = LIGHT_HEIGHT - BOX_TOP;
  const double x = directional ? u : u * toTop;
  const double y = directional ? v : v * toTop;
  return std::abs(x) < 0.5 && std::abs(y) < 0.25 ? toTop : LIGHT_HEIGHT;
}

// Texels whose square the box's edge crosses have no single answer.
bool IsNearEdge(double u, double v, double texel, bool directional)
{
  const double toTop = LIGHT_HEIGHT - BOX_TOP;
  const double size = directional ? texel : texel * toTop;
  const double x = std::abs(directional ? u : u * toTop);
  const double y = std::abs(directional ? v : v * toTop);
  return (std::abs(x - 0.5) < size && y < 0.25 + size) ||
    (std::abs(y - 0.25) < size && x < 0.5 + size);
}
}

//------------------------------------------------------------------------------
TEST_P(BoxOverPlane, HasTheDepthOfItsClosedForm)
{
  const Placing placing = GetParam();
  BakingScene scene;
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-0.5, 0.5, -0.25, 0.25, BOX_BOTTOM, BOX_TOP);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-9.0, -9.0, 0.0);
  plane->SetPoint1(9.0, -9.0, 0.0);
  plane->SetPoint2(-9.0, 9.0, 0.0);
  vtkNew<vtkTransform> place;
  place->Translate(placing.Shift, -placing.Shift, placing.Shift);
  place->Scale(placing.Scale, placing.Scale, placing.Scale);
  scene.AddActor(box)->SetUserTransform(place);
  scene.AddActor(plane)->SetUserTransform(place);

  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(placing.Shift, -placing.Shift,
    placing.Shift + LIGHT_HEIGHT * placing.Scale, placing.Directional);
  const double unit = placing.Directional ? placing.Scale : 1.0;
  view.Window = { { -0.3 * unit, 0.7 * unit, -0.5 * unit, 0.5 * unit } };
  view.Near = 1.0 * placing.Scale;
  view.Far = 5.0 * placing.Scale;

  scene.Bake({ view }, RESOLUTION);
  const auto image = scene.Maps->ReadDepth(0);
  const double texel = 1.0 / RESOLUTION;
  int compared = 0;
  int boxes = 0;
  for (int j = 0; j < RESOLUTION; ++j)
  {
    for (int i = 0; i < RESOLUTION; ++i)
    {
      const double u = (image->GetOrigin()[0] + i * image->GetSpacing()[0]) / unit;
      const double v = (image->GetOrigin()[1] + j * image->GetSpacing()[1]) / unit;
      if (IsNearEdge(u, v, texel, placing.Directional))
      {
        continue;
      }
      const double expected = ExpectedDistance(u, v, placing.Directional);
      const double found = image->GetScalarComponentAsDouble(i, j, 0, 0) / placing.Scale;
      ASSERT_NEAR(found, expected, 2e-5) << "texel " << i << ", " << j;
      ++compared;
      boxes += expected < LIGHT_HEIGHT ? 1 : 0;
    }
  }
  EXPECT_GT(compared, RESOLUTION * RESOLUTION / 2);
  EXPECT_GT(boxes, RESOLUTION * RESOLUTION / 20);
}

INSTANTIATE_TEST_SUITE_P(ShadowDepthMaps, BoxOverPlane,
  testing::Values(Placing{ "Perspective", false, 1.0, 0.0 }, Placing{ "Parallel", true, 1.0, 0.0 },
    Placing{ "PerspectiveFarAway", false, 1.0, 1e7 }, Placing{ "ParallelFarAway", true, 1.0, 1e7 },
    Placing{ "PerspectiveTiny", false, 1e-4, 0.0 }, Placing{ "ParallelTiny", true, 1e-4, 0.0 },
    Placing{ "PerspectiveLarge", false, 1e6, 0.0 }),
  [](const testing::TestParamInfo<Placing>& test) { return std::string(test.param.Name); });

//------------------------------------------------------------------------------
TEST(ShadowDepthMaps, SphereHasTheDepthOfItsClosedForm)
{
  BakingScene scene;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  scene.AddActor(sphere);
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.0, 0.0, 5.0, true);
  view.Window = { { -1.5, 1.5, -1.5, 1.5 } };
  view.Near = 3.0;
  view.Far = 7.0;
  scene.Bake({ view }, 64);
  const auto image = scene.Maps->ReadDepth(0);
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      const double x = image->GetOrigin()[0] + i * image->GetSpacing()[0];
      const double y = image->GetOrigin()[1] + j * image->GetSpacing()[1];
      const double r2 = x * x + y * y;
      const double found = image->GetScalarComponentAsDouble(i, j, 0, 0);
      if (r2 < 0.8)
      {
        // The mesh lies within the sphere, no deeper than its sagitta.
        EXPECT_NEAR(found, 5.0 - std::sqrt(1.0 - r2), 1e-3);
      }
      else if (r2 > 1.0)
      {
        EXPECT_TRUE(std::isinf(found));
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowDepthMaps, BakesOnlyWhatIsNew)
{
  BakingScene scene;
  vtkNew<vtkCubeSource> box;
  auto actor = scene.AddActor(box);
  vtkShadowMapView view;
  view.Emitter = MakeDownwardEmitter(0.0, 0.0, 5.0, false);
  view.Near = 3.0;
  view.Far = 7.0;
  vtkShadowMapView other = view;
  other.Emitter.Center[0] = 0.5;

  EXPECT_EQ(scene.Bake({ view, other }, 32), 2);
  const auto time = scene.Maps->GetBakeTime();
  EXPECT_EQ(scene.Bake({ view, other }, 32), 0);
  EXPECT_EQ(scene.Maps->GetBakeTime(), time);
  other.Emitter.Center[0] = 0.75;
  EXPECT_EQ(scene.Bake({ view, other }, 32), 1) << "one view moved";
  EXPECT_GT(scene.Maps->GetBakeTime(), time);
  EXPECT_EQ(scene.Bake({ view }, 32), 0) << "fewer views";
  EXPECT_EQ(scene.Bake({ view }, 64), 1) << "another resolution";
  EXPECT_EQ(scene.Bake({ view }, 64, true), 1) << "conservative now";
  actor->SetPosition(0.1, 0.0, 0.0);
  EXPECT_EQ(scene.Bake({ view }, 64, true), 1) << "a caster moved";
  EXPECT_EQ(scene.Maps->GetNumberOfBakes(), 6);
}

//------------------------------------------------------------------------------
TEST(ShadowDepthMaps, WhatLiesBeforeTheNearPlaneIsNotLost)
{
  BakingScene scene;
  vtkNew<vtkCubeSource> box; // from -0.5 to 0.5
  scene.AddActor(box);
  for (const bool directional : { false, true })
  {
    for (const bool conservative : { false, true })
    {
      vtkShadowMapView view;
      view.Emitter = MakeDownwardEmitter(0.0, 0.0, 5.0, directional);
      view.Window = { { -0.4, 0.4, -0.4, 0.4 } };
      view.Near = 7.0;
      view.Far = 9.0;
      const auto depths = scene.BakeDepths(view, 32, conservative);
      EXPECT_EQ(depths[16 * 32 + 16], 0.0f) << directional << conservative;
      view.Near = 1.0;
      view.Far = 3.0; // and what lies behind the far one is not there
      EXPECT_EQ(scene.BakeDepths(view, 32, conservative)[16 * 32 + 16], 1.0f);
    }
  }
}

namespace
{
// From above, each from another place and through another window; the last from inside the sphere.
std::vector<vtkShadowMapView> MakeViews(int count)
{
  std::vector<vtkShadowMapView> views(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    vtkShadowMapView& view = views[static_cast<std::size_t>(i)];
    const double x = 0.11 * i - 1.0;
    const bool inside = i > count - 3;
    view.Emitter = MakeDownwardEmitter(inside ? 0.0 : x, 0.05 * i, inside ? 1.0 : 4.0, i % 4 == 3);
    view.Window = { { -1.0 - 0.01 * i, 0.8, -0.9, 1.0 } };
    view.Near = inside ? 0.1 : 1.0;
    view.Far = 5.0;
  }
  return views;
}

// A closed sphere, of which one side is drawn, and an open plane of which both are; a box that few
// views show.
void AddCasters(BakingScene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.0, 0.0, 1.0);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.0, -2.0, 0.0);
  plane->SetPoint1(2.0, -2.0, 0.0);
  plane->SetPoint2(-2.0, 2.0, 0.2);
  vtkNew<vtkCubeSource> box;
  box->SetCenter(3.5, 0.0, 1.0);
  scene.AddActor(sphere);
  scene.AddActor(plane);
  scene.AddActor(box);
}
}

//------------------------------------------------------------------------------
// Views drawn with a layer per instance hold what each holds that is drawn alone: more of them than
// one draw takes, and some more, and one anew.
TEST(ShadowDepthMapsOfManyViews, AreThoseOfOneViewEach)
{
  BakingScene scene;
  AddCasters(scene);
  BakingScene alone;
  AddCasters(alone);
  constexpr int size = 48;
  std::vector<vtkShadowMapView> views = MakeViews(21);
  const auto compare = [&](int expectedBakes)
  {
    EXPECT_EQ(scene.Bake(views, size), expectedBakes);
    std::vector<std::vector<float>> together;
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      together.push_back(scene.Maps->GetTexture()->ReadLayer(static_cast<int>(i)));
    }
    for (std::size_t i = 0; i < views.size(); ++i)
    {
      alone.Bake({ views[i] }, size); // another window's context
      EXPECT_EQ(together[i], alone.Maps->GetTexture()->ReadLayer(0)) << "view " << i;
      EXPECT_GT(*std::max_element(together[i].begin(), together[i].end()), 0.0f) << "view " << i;
    }
  };
  compare(21);
  if (scene.Casters->CanDrawLayers(scene.Renderer))
  {
    EXPECT_LT(scene.Maps->GetNumberOfDrawCalls(), 2 * 3 * 2) << "two draws of at most three sides";
  }
  views[5].Window[0] -= 0.3;
  compare(1);
  views = MakeViews(23);
  views[2].Window[1] += 0.2;
  compare(23); // the texture grows
  views.resize(18);
  compare(0);
  EXPECT_EQ(glGetError(), static_cast<unsigned int>(GL_NO_ERROR));
}

//------------------------------------------------------------------------------
// Strokes need shaders of their own: then maps are drawn one by one.
TEST(ShadowDepthMapsOfManyViews, AreDrawnOneByOneWithStrokes)
{
  BakingScene scene;
  AddCasters(scene);
  scene.Bake(MakeViews(4), 32);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-1.0, 0.0, 2.0);
  line->SetPoint2(1.0, 0.0, 2.0);
  vtkActor* actor = scene.AddActor(line);
  actor->GetProperty()->SetLineWidth(5.0f);
  scene.Window.Render();
  scene.Bake(MakeViews(4), 32);
  EXPECT_FALSE(scene.Casters->CanDrawLayers(scene.Renderer));
}
