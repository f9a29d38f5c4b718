// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Each defect of VTK's own shadow passes (vtkShadowMapPass, vtkShadowMapBakerPass) as the small scene
// that shows it there, and right here. Defects that other tests are about: shadows in windows that
// are not square (Invariance), leaks at contacts (Surface), physically based materials (Material),
// programs built anew by a bake (Counts).
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLine.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 120;
const int Height = 90;

class Pitfall : public testing::TestWithParam<Technique>
{
protected:
  void SetUp() override
  {
    this->Pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    this->Scene = MakeBallScene();
  }

  vtkSmartPointer<vtkSoftShadowPass> Pass;
  BallScene Scene;
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> MakeHeadlight(bool on)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToHeadlight();
  light->SetIntensity(0.2);
  light->SetSwitch(on);
  return light;
}

//------------------------------------------------------------------------------
/// Brightest channel of any pixel that two pictures differ in by more than a step of 8 bits.
int CountDarker(const Picture& first, const Picture& second)
{
  int count = 0;
  for (std::size_t i = 0; i < first.Values.size(); i += 3)
  {
    count += first.Values[i] < second.Values[i] - 1.5f / 255.0f ? 1 : 0;
  }
  return count;
}

}

//------------------------------------------------------------------------------
// d: what lies outside the map is lit as by VTK's own frame, not eight times as bright.
TEST_P(Pitfall, OutsideTheMapIsLitAsEver)
{
  this->Scene.Lamp->SetConeAngle(12.0);
  this->Scene.Lamp->SetIntensity(0.3);
  Stage stage(this->Scene.Renderer, nullptr, Width, Height);
  const Picture plain = stage.RenderColors();
  stage.SetPass(this->Pass);
  const Picture visibility = stage.RenderVisibility(this->Scene.Lamp);
  const Picture shadowed = stage.GetWindow().Read();
  int compared = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const float v = visibility.At(x, y);
      if (std::isnan(v) || v == 1.0f)
      {
        ++compared;
        ASSERT_NEAR(shadowed.At(x, y), plain.At(x, y), 1.001 / 255.0)
          << "pixel " << x << ' ' << y << ", visibility " << v;
      }
    }
  }
  EXPECT_GT(compared, Width * Height / 2);
  EXPECT_GT(CountWithoutValue(visibility), 500) << "the picture must show points outside the cone";
}

//------------------------------------------------------------------------------
// e: a shadow follows its caster although only the mapper's input changed.
TEST_P(Pitfall, InputOfTheMapperChanges)
{
  auto* source = vtkSphereSource::SafeDownCast(this->Scene.Ball->GetMapper()->GetInputAlgorithm());
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  stage.Render();
  source->SetRadius(0.8);
  const Picture changed = stage.RenderVisibility(this->Scene.Lamp);
  const auto fresh = this->GetParam().Make(Effort::Quick, Weights::Mean);
  stage.SetPass(fresh);
  EXPECT_TRUE(Matches(changed, stage.RenderVisibility(this->Scene.Lamp), SameToRounding));
}

//------------------------------------------------------------------------------
// f: a resolution that is set after the first frame counts.
TEST_P(Pitfall, MapSizeChangesAfterTheFirstFrame)
{
  this->Pass->SetMapSize(32);
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Picture coarse = stage.RenderVisibility(this->Scene.Lamp);
  this->Pass->SetMapSize(512);
  const Picture fine = stage.RenderVisibility(this->Scene.Lamp);
  stage.SetPass(this->GetParam().Make(Effort::Quick, Weights::Mean));
  EXPECT_TRUE(Matches(fine, stage.RenderVisibility(this->Scene.Lamp), Identical));
  EXPECT_EQ(static_cast<bool>(Matches(fine, coarse, SameButForFlips)), !this->GetParam().HasMaps)
    << "32 texels make a visible difference";
}

//------------------------------------------------------------------------------
// g: a light that is off, before the one that casts, takes nothing away.
TEST_P(Pitfall, LightThatIsOffStandsFirst)
{
  Picture expected;
  {
    Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
    expected = stage.RenderVisibility(this->Scene.Lamp);
  }
  this->Scene.Renderer->RemoveAllLights();
  auto off = MakeLamp({ { -3.0, -3.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 0.5);
  off->SwitchOff();
  this->Scene.Renderer->AddLight(off);
  this->Scene.Renderer->AddLight(this->Scene.Lamp);
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  EXPECT_TRUE(Matches(expected, stage.RenderVisibility(this->Scene.Lamp), Identical));
  const Picture colors = stage.GetWindow().Read();
  stage.SetPass(nullptr);
  EXPECT_GT(CountDarker(colors, stage.RenderColors()), 100) << "the shadow is not in the picture";
}

//------------------------------------------------------------------------------
// Each light has a shadow of its own, whatever stands between them in the list.
TEST_P(Pitfall, EveryLightHasItsShadow)
{
  const auto second = MakeLamp({ { -2.0, 0.5, 3.5 } }, { { 0.0, 0.0, 0.0 } }, 0.2);
  Picture alone;
  {
    this->Scene.Renderer->RemoveAllLights();
    this->Scene.Renderer->AddLight(second);
    Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
    alone = stage.RenderVisibility(second);
  }
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.Renderer->AddLight(MakeHeadlight(true));
  this->Scene.Renderer->AddLight(this->Scene.Lamp);
  this->Scene.Renderer->AddLight(MakeHeadlight(false));
  this->Scene.Renderer->AddLight(second);
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  EXPECT_TRUE(Matches(alone, stage.RenderVisibility(second), Identical));
  EXPECT_FALSE(Matches(alone, stage.RenderVisibility(this->Scene.Lamp), SameButForEdges));
}

//------------------------------------------------------------------------------
// h: translucent actors are drawn, and cast nothing.
TEST_P(Pitfall, TranslucentActorsStay)
{
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Picture visibility = stage.RenderVisibility(this->Scene.Lamp);
  const Picture without = stage.GetWindow().Read();
  const auto veil =
    MakeQuadActor({ { { { -1.0, -1.5, 1.6 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } } } });
  veil->GetProperty()->SetOpacity(0.5);
  veil->GetProperty()->SetColor(1.0, 0.0, 0.0);
  this->Scene.Renderer->AddActor(veil);
  EXPECT_TRUE(Matches(stage.RenderVisibility(this->Scene.Lamp), visibility, Identical));
  const Picture with = stage.GetWindow().Read();
  EXPECT_GT(Compare(with, without, Identical).ShareOff, 0.03) << "the veil is not in the picture";
}

//------------------------------------------------------------------------------
// i: a translucent surface over a shadow is not black: it is drawn as VTK draws it.
TEST_P(Pitfall, TranslucentReceiverIsNotBlack)
{
  this->Scene.Renderer->RemoveActor(this->Scene.Ball);
  this->Scene.Ground->GetProperty()->SetOpacity(0.6);
  this->Scene.Renderer->SetBackground(0.1, 0.2, 0.4);
  Stage stage(this->Scene.Renderer, nullptr, Width, Height);
  const Picture plain = stage.RenderColors();
  stage.SetPass(this->Pass);
  EXPECT_TRUE(Matches(stage.RenderColors(), plain, SameToRounding));
}

//------------------------------------------------------------------------------
// i: the background's colour has no say in the depth maps: silhouettes do not darken.
TEST_P(Pitfall, BackgroundDoesNotShadow)
{
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const Picture black = stage.RenderVisibility(this->Scene.Lamp);
  this->Scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  stage.SetPass(this->GetParam().Make(Effort::Quick, Weights::Mean));
  EXPECT_TRUE(Matches(black, stage.RenderVisibility(this->Scene.Lamp), Identical));
}

//------------------------------------------------------------------------------
// j: a caster that the camera does not see shadows as before.
TEST_P(Pitfall, CasterLeavesTheView)
{
  // Close to the shadow, the ball above the picture: only its shadow is in view.
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(-0.6, -2.5, 2.0);
  camera->SetFocalPoint(-0.6, -0.35, 0.0);
  camera->SetViewAngle(14.0);
  this->Scene.Renderer->ResetCameraClippingRange();
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Picture close = stage.RenderVisibility(this->Scene.Lamp);
  EXPECT_GT(CountShadowed(close), 500);

  // The same pixels out of the middle of a picture that is as large as it must be to show the ball.
  const double half = std::tan(vtkMath::RadiansFromDegrees(7.0));
  camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(5.0 * half)));
  Stage wide(this->Scene.Renderer, this->GetParam().Make(Effort::Quick, Weights::Mean), 5 * Width,
    5 * Height);
  const Picture all = wide.RenderVisibility(this->Scene.Lamp);
  const Picture part = all.Part(2 * Width, 2 * Height, Width, Height);
  if (this->GetParam().LargestBorderError > 0.0)
  {
    EXPECT_LT(
      Compare(close, part, SameButForFlips).RootMeanSquare, this->GetParam().LargestBorderError);
  }
  else
  {
    EXPECT_TRUE(Matches(close, part, SameButForFlips));
  }
}

//------------------------------------------------------------------------------
// k: spheres that are billboards with a clever shader cast spheres' shadows.
TEST_P(Pitfall, SphereImpostersCastSpheres)
{
  const std::vector<Point> places = { { { -0.7, 0.0, 0.9 } }, { { 0.6, 0.2, 0.7 } },
    { { 0.0, -0.6, 0.5 } } };
  const double radius = 0.3;
  this->Scene.Renderer->RemoveActor(this->Scene.Ball);
  std::vector<vtkSmartPointer<vtkActor>> meshes;
  vtkNew<vtkPoints> points;
  for (const Point& place : places)
  {
    points->InsertNextPoint(place.data());
    meshes.push_back(MakeSphereActor(place, radius, 64));
    this->Scene.Renderer->AddActor(meshes.back());
  }
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Picture mesh = stage.RenderVisibility(this->Scene.Lamp);
  for (const auto& actor : meshes)
  {
    this->Scene.Renderer->RemoveActor(actor);
  }
  vtkNew<vtkPolyData> centers;
  centers->SetPoints(points);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(centers);
  mapper->SetRadius(radius);
  vtkNew<vtkActor> imposters;
  imposters->SetMapper(mapper);
  this->Scene.Renderer->AddActor(imposters);
  const Picture sphere = stage.RenderVisibility(this->Scene.Lamp);

  // On the ground alone: what a mesh and an imposter receive on their dark side is up to their facets.
  const std::vector<Point> ground = PlanePositions(this->Scene.Renderer, Width, Height, Plane());
  const Point eye = SightLineOf(this->Scene.Renderer, Width, Height, 0, 0).Start;
  int shadowed = 0;
  int wrong = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    bool hidden = false;
    for (const Point& place : places)
    {
      hidden = hidden ||
        vtkLine::DistanceToLine(place.data(), eye.data(), ground[i].data()) < 1.1 * radius * radius;
    }
    if (!hidden)
    {
      shadowed += mesh.Values[i] < 0.5f ? 1 : 0;
      wrong += std::abs(mesh.Values[i] - sphere.Values[i]) > 0.2f ? 1 : 0;
    }
  }
  EXPECT_GT(shadowed, 300);
  EXPECT_LT(wrong, shadowed / 20) << "pixels of " << shadowed << " in shadow";
}

//------------------------------------------------------------------------------
// l: headlights and camera lights move with the camera; a scene light's maps do not care.
TEST_P(Pitfall, HeadlightsBakeNothing)
{
  this->Scene.Renderer->AddLight(MakeHeadlight(true));
  this->Scene.Renderer->AddLight(MakeHeadlight(false));
  auto cameraLight = MakeHeadlight(false);
  cameraLight->SetLightTypeToCameraLight();
  cameraLight->SetPosition(1.0, 1.0, 1.0);
  this->Scene.Renderer->AddLight(cameraLight);
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  stage.Render();
  // The headlight, being on, may have a map that follows it; the lamp's must stay.
  this->Scene.Renderer->GetActiveCamera()->Azimuth(10.0);
  stage.Render();
  const vtkTypeInt64 before = this->Pass->GetStatistics().MapsBaked;
  stage.Render();
  EXPECT_EQ(this->Pass->GetStatistics().MapsBaked, before) << "a frame like the last";

  this->Scene.Renderer->RemoveAllLights();
  this->Scene.Renderer->AddLight(MakeHeadlight(false));
  this->Scene.Renderer->AddLight(this->Scene.Lamp);
  stage.Render();
  const vtkTypeInt64 lampOnly = this->Pass->GetStatistics().MapsBaked;
  this->Scene.Renderer->GetActiveCamera()->Azimuth(10.0);
  stage.Render();
  EXPECT_EQ(this->Pass->GetStatistics().MapsBaked, lampOnly) << "headlight off, camera moved";
}

//------------------------------------------------------------------------------
// n: no light is silently without a shadow.
TEST_P(Pitfall, LightsWithoutShadowAreReported)
{
  this->Scene.Lamp->SetConeAngle(180.0);
  auto headlight = MakeHeadlight(true);
  this->Scene.Renderer->AddLight(headlight);
  this->Scene.Renderer->AddLight(MakeHeadlight(false));
  Stage stage(this->Scene.Renderer, this->Pass, Width, Height);
  const Picture visibility = stage.RenderVisibility(this->Scene.Lamp);
  const std::string report = this->Pass->GetLightReport();
  int lines = 0;
  for (const char c : report)
  {
    lines += c == '\n' ? 1 : 0;
  }
  lines += !report.empty() && report.back() != '\n' ? 1 : 0;
  EXPECT_EQ(lines, 2) << "one for each light that is lit:\n" << report;
  EXPECT_GT(CountShadowed(visibility), 50) << "a light without a cone casts\n" << report;
}

//------------------------------------------------------------------------------
// n: a plain point light without a cone shines to all sides and casts to all sides.
TEST_P(Pitfall, OmniLightCastsToAllSides)
{
  vtkNew<vtkLight> bulb;
  bulb->SetLightTypeToSceneLight();
  bulb->PositionalOn();
  bulb->SetConeAngle(180.0);
  bulb->SetPosition(0.0, 0.0, 1.0);
  bulb->SetFocalPoint(1.0, 0.0, 1.0);
  const auto renderer = MakeRenderer({ { 0.0, -1.0, 8.0 } }, { { 0.0, 0.0, 0.0 } }, 40.0);
  renderer->AddLight(bulb);
  renderer->AddActor(MakeGroundActor(6.0));
  const double distance = 0.8;
  for (const int side : { 0, 1, 2, 3 })
  {
    const double angle = 0.5 * vtkMath::Pi() * side;
    renderer->AddActor(
      MakeSphereActor({ { distance * std::cos(angle), distance * std::sin(angle), 0.5 } }, 0.2));
  }
  renderer->ResetCameraClippingRange();
  Stage stage(renderer, this->Pass, Width, Width);
  const Picture visibility = stage.RenderVisibility(bulb);
  int quarters[4] = { 0, 0, 0, 0 };
  const std::vector<Point> positions = PlanePositions(renderer, Width, Width, Plane());
  for (int i = 0; i < Width * Width; ++i)
  {
    const Point& p = positions[i];
    // A shadow begins at about 1.1 from the middle; spheres themselves are nearer.
    if (std::hypot(p[0], p[1]) > 1.3 && visibility.Values[i] < 0.5f)
    {
      const double angle = std::atan2(p[1], p[0]) + 2.25 * vtkMath::Pi();
      ++quarters[static_cast<int>(angle / (0.5 * vtkMath::Pi())) % 4];
    }
  }
  for (int side = 0; side < 4; ++side)
  {
    EXPECT_GT(quarters[side], 30) << "side " << side << '\n' << this->Pass->GetLightReport();
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, Pitfall, testing::ValuesIn(AllTechniques()), NameOfTechnique);
