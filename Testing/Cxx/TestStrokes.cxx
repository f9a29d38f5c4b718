// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Points drawn as spheres and lines drawn as tubes receive and cast what spheres and tubes of triangles
// do at the same places, as wide as the camera shows them, whatever the size of the maps.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"
#include "WorldPositions.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSoftShadowPass.h"
#include "vtkTubeFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 160;
const int Height = 120;
const float PointSize = 17.0f; // pixels
const float LineWidth = 9.0f;
const int Resolution = 48;

// Some shade others, and they are at distances of 4 to 7 from the camera.
const std::vector<Point> Places = { { { -0.7, -1.6, 0.5 } }, { { 0.5, -1.2, 0.9 } },
  { { -0.2, 0.1, 0.5 } }, { { 0.9, 0.9, 1.1 } }, { { -1.0, 1.2, 0.8 } }, { { 0.25, 0.3, 1.35 } } };

//------------------------------------------------------------------------------
/// Half of what so many pixels are at a place in the world.
double RadiusAt(vtkRenderer* renderer, const Point& place, double pixels)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    return pixels * camera->GetParallelScale() / Height;
  }
  const double homogeneous[4] = { place[0], place[1], place[2], 1.0 };
  double view[4];
  camera->GetModelViewTransformMatrix()->MultiplyPoint(homogeneous, view);
  const double halfAngle = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
  return pixels * std::tan(halfAngle) * -view[2] / Height;
}

//------------------------------------------------------------------------------
/// The places as vertices, or as one line.
vtkSmartPointer<vtkPolyData> MakeData(bool line)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Point& place : Places)
  {
    const vtkIdType id = points->InsertNextPoint(place.data());
    if (!line)
    {
      cells->InsertNextCell({ id });
    }
    else if (id % 2 == 1)
    {
      cells->InsertNextCell({ id - 1, id });
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  if (line)
  {
    data->SetLines(cells);
  }
  else
  {
    data->SetVerts(cells);
  }
  return data;
}

//------------------------------------------------------------------------------
void AddStrokes(vtkRenderer* renderer, bool lines, bool round = true)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeData(lines));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetPointSize(PointSize);
  actor->GetProperty()->SetLineWidth(LineWidth);
  actor->GetProperty()->SetRenderPointsAsSpheres(round);
  actor->GetProperty()->SetRenderLinesAsTubes(round);
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
void AddSpheres(vtkRenderer* renderer)
{
  for (const Point& place : Places)
  {
    renderer->AddActor(MakeSphereActor(place, RadiusAt(renderer, place, PointSize), Resolution));
  }
}

//------------------------------------------------------------------------------
void AddTubes(vtkRenderer* renderer)
{
  const auto data = MakeData(true);
  vtkNew<vtkDoubleArray> radii;
  for (const Point& place : Places)
  {
    radii->InsertNextValue(RadiusAt(renderer, place, LineWidth));
  }
  data->GetPointData()->SetScalars(radii);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(data);
  tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tubes->SetNumberOfSides(Resolution);
  tubes->CappingOn();
  const auto actor = MakeActor(tubes);
  actor->GetMapper()->ScalarVisibilityOff();
  renderer->AddActor(actor);
}

struct Case
{
  std::string Name;
  bool Lines;
  bool Parallel; // the camera
  bool Sun;
  bool Flat = false;
};

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Case& parameter)
{
  return os << parameter.Name;
}

//------------------------------------------------------------------------------
/// The ball scene without its ball, under a lamp or a sun, before a camera of either kind.
BallScene MakeScene(bool parallel, bool sun)
{
  BallScene scene = MakeBallScene(0.2);
  scene.Renderer->RemoveActor(scene.Ball);
  scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.7);
  if (sun)
  {
    scene.Renderer->RemoveLight(scene.Lamp);
    scene.Lamp = MakeSun({ { 1.5, -1.0, 4.0 } }, 2.0);
    scene.Renderer->AddLight(scene.Lamp);
  }
  return scene;
}

//------------------------------------------------------------------------------
struct Result
{
  Picture Visibility;
  Picture Depth; // of the receivers
};

//------------------------------------------------------------------------------
Result Draw(const Case& what, bool strokes, const Technique& technique, int mapSize)
{
  const BallScene scene = MakeScene(what.Parallel, what.Sun);
  if (strokes)
  {
    AddStrokes(scene.Renderer, what.Lines, !what.Flat);
  }
  else if (what.Lines)
  {
    AddTubes(scene.Renderer);
  }
  else
  {
    AddSpheres(scene.Renderer);
  }
  scene.Renderer->ResetCameraClippingRange();
  const auto pass = technique.Make(Effort::Quick, Weights::Mean);
  pass->SetMapSize(mapSize);
  Stage stage(scene.Renderer, pass, Width, Height);
  Result result;
  result.Visibility = stage.RenderVisibility(scene.Lamp);
  result.Depth = PictureOf(pass->GetDepthImage());
  return result;
}

//------------------------------------------------------------------------------
/// How far the ground is, in view coordinates.
std::vector<double> GroundDepths(vtkRenderer* renderer)
{
  std::vector<double> depths;
  for (const Point& place : PlanePositions(renderer, Width, Height, Plane()))
  {
    const double homogeneous[4] = { place[0], place[1], place[2], 1.0 };
    double view[4];
    renderer->GetActiveCamera()->GetModelViewTransformMatrix()->MultiplyPoint(homogeneous, view);
    depths.push_back(-view[2]);
  }
  return depths;
}

//------------------------------------------------------------------------------
/// Strokes beside bodies of triangles, where both show the same.
struct Comparison
{
  double LitMean = 0.0; // the strokes' visibility where the bodies are lit
  int LitPixels = 0;
  double Shadow = 0.0; // on the ground, in pixels
  double PlainShadow = 0.0;
  double GroundError = 0.0; // root mean square
};

//------------------------------------------------------------------------------
Comparison CompareToPlain(const Result& strokes, const Result& plain, vtkRenderer* renderer)
{
  const std::vector<double> ground = GroundDepths(renderer);
  const auto at = [](const Picture& picture, int x, int y) { return picture.At(x, y); };
  // Whether a pixel and its neighbours are all on bodies, or all on the ground.
  const auto shows = [&](int x, int y, bool body)
  {
    for (int k = 0; k < 9; ++k)
    {
      const int i = x - 1 + k % 3;
      const int j = y - 1 + k / 3;
      const double limit = ground[j * Width + i] - 0.1;
      if ((at(strokes.Depth, i, j) < limit) != body || (at(plain.Depth, i, j) < limit) != body)
      {
        return false;
      }
    }
    return true;
  };
  // A pixel off the terminator, where a body's facets turn from light to dark.
  const auto isLit = [&plain](int x, int y)
  {
    for (int k = 0; k < 9; ++k)
    {
      if (!(plain.Visibility.At(x - 1 + k % 3, y - 1 + k / 3) > 0.999))
      {
        return false;
      }
    }
    return true;
  };
  Comparison result;
  int groundPixels = 0;
  for (int y = 1; y + 1 < Height; ++y)
  {
    for (int x = 1; x + 1 < Width; ++x)
    {
      const double own = strokes.Visibility.At(x, y);
      const double expected = plain.Visibility.At(x, y);
      if (shows(x, y, true) && isLit(x, y))
      {
        result.LitMean += own;
        ++result.LitPixels;
      }
      else if (shows(x, y, false) && !std::isnan(own))
      {
        result.Shadow += 1.0 - own;
        result.PlainShadow += 1.0 - expected;
        result.GroundError += (own - expected) * (own - expected);
        ++groundPixels;
      }
    }
  }
  result.LitMean /= std::max(result.LitPixels, 1);
  result.GroundError = std::sqrt(result.GroundError / std::max(groundPixels, 1));
  return result;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Comparison& comparison)
{
  return os << "lit " << comparison.LitMean << " of " << comparison.LitPixels << ", shadow "
            << comparison.Shadow << " and " << comparison.PlainShadow << ", error "
            << comparison.GroundError;
}

class Strokes : public testing::TestWithParam<Case>
{
};

class StrokesWith : public testing::TestWithParam<Technique>
{
};

//------------------------------------------------------------------------------
void ExpectAsPlain(const Case& what, const Technique& technique, int mapSize)
{
  const Result plain = Draw(what, false, technique, mapSize);
  const Result strokes = Draw(what, true, technique, mapSize);
  const Comparison comparison =
    CompareToPlain(strokes, plain, MakeScene(what.Parallel, what.Sun).Renderer);
  std::cout << technique.Name << ' ' << mapSize << ": " << comparison << '\n';
  EXPECT_GT(comparison.LitPixels, 200);
  EXPECT_GE(comparison.LitMean, 0.99);
  EXPECT_GT(comparison.PlainShadow, 400.0);
  EXPECT_NEAR(comparison.Shadow / comparison.PlainShadow, 1.0, 0.01);
  EXPECT_LE(comparison.GroundError, 0.02);
}

}

//------------------------------------------------------------------------------
// A technique of one map and one of many.
TEST_P(Strokes, ReceiveAndCastAsBodies)
{
  for (const int mapSize : { 512, 2048 })
  {
    for (const int technique : { 0, 1 })
    {
      SCOPED_TRACE(mapSize);
      ExpectAsPlain(this->GetParam(), AllTechniques()[technique], mapSize);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Strokes,
  testing::Values(Case{ "Spheres", false, false, false }, Case{ "SpheresSun", false, false, true },
    Case{ "SpheresParallel", false, true, true }, Case{ "Tubes", true, false, false },
    Case{ "TubesParallel", true, true, true }),
  [](const testing::TestParamInfo<Case>& parameter) { return parameter.param.Name; });

//------------------------------------------------------------------------------
// What is drawn flat casts a band or a square as wide as it is drawn, which faces the light. Without
// normals VTK does not light it, and it receives nothing.
TEST(FlatStrokes, CastAsWideAsTheyAreDrawn)
{
  for (const bool lines : { false, true })
  {
    const Case what{ "Flat", lines, true, true, true };
    const Result plain = Draw(what, false, AllTechniques()[1], 1024);
    const Result strokes = Draw(what, true, AllTechniques()[1], 1024);
    const Comparison comparison =
      CompareToPlain(strokes, plain, MakeScene(what.Parallel, what.Sun).Renderer);
    std::cout << comparison << '\n';
    const double expected = lines ? 0.93 : 4.0 / vtkMath::Pi(); // no lids, and no corners cut
    EXPECT_NEAR(comparison.Shadow / comparison.PlainShadow, expected, 0.05) << lines;
  }
}

//------------------------------------------------------------------------------
TEST_P(StrokesWith, ReceiveAndCastAsBodies)
{
  ExpectAsPlain({ "Spheres", false, false, true }, this->GetParam(), 512);
}

//------------------------------------------------------------------------------
// Their width in the world is what the camera makes of it.
TEST_P(StrokesWith, FollowTheCamera)
{
  const BallScene scene = MakeScene(false, true);
  AddStrokes(scene.Renderer, false);
  AddStrokes(scene.Renderer, true);
  scene.Renderer->ResetCameraClippingRange();
  const auto baked = [this](Stage& stage)
  {
    const char* made = this->GetParam().HasMaps ? "maps_baked" : "scenes_built";
    const vtkTypeInt64 before = stage.GetPass()->GetCount(made);
    stage.Render();
    return stage.GetPass()->GetCount(made) - before;
  };
  Picture moved;
  {
    Stage stage(scene.Renderer, this->GetParam().Make(Effort::Quick, Weights::Mean), 80, 60);
    EXPECT_GT(baked(stage), 0);
    EXPECT_EQ(baked(stage), 0) << "at rest";
    scene.Renderer->GetActiveCamera()->Dolly(0.8);
    scene.Renderer->ResetCameraClippingRange();
    EXPECT_GT(baked(stage), 0) << "the camera moved";
    EXPECT_EQ(baked(stage), 0) << "at rest again";
    moved = stage.RenderVisibility(scene.Lamp);
  }
  Stage fresh(scene.Renderer, this->GetParam().Make(Effort::Quick, Weights::Mean), 80, 60);
  EXPECT_TRUE(Matches(moved, fresh.RenderVisibility(scene.Lamp), SameToRounding));
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, StrokesWith, testing::ValuesIn(AllTechniques()), NameOfTechnique);

namespace
{

//------------------------------------------------------------------------------
/// The receivers' depths of a ground that is changed.
template <typename Functor>
Picture DrawGround(vtkRenderer* renderer, Functor change)
{
  const auto ground = MakeGroundActor(6.0);
  change(ground.Get());
  renderer->AddActor(ground);
  renderer->AddActor(MakeSphereActor({ { 0.0, 0.0, 5.0 } }, 0.3));
  const auto sun = MakeSun({ { 1.5, -1.0, 4.0 } }, 2.0);
  renderer->AddLight(sun);
  renderer->GetActiveCamera()->SetClippingRange(2.0, 30.0);
  const auto pass = AllTechniques()[1].Make(Effort::Quick, Weights::Mean);
  Stage stage(renderer, pass, Width, Height);
  stage.Render();
  return PictureOf(pass->GetDepthImage());
}

}

//------------------------------------------------------------------------------
// A shader that replaces the depth puts the receiver there.
TEST(DrawnDepth, IsWhereTheReceiverIs)
{
  for (const bool parallel : { false, true })
  {
    const auto renderer = MakeRenderer({ { 0.0, -5.0, 4.0 } }, { { 0.0, 0.0, 0.2 } });
    renderer->GetActiveCamera()->SetParallelProjection(parallel);
    const Picture depth = DrawGround(renderer,
      [](vtkActor* ground)
      {
        ground->GetShaderProperty()->AddFragmentShaderReplacement(
          "//VTK::Depth::Impl", true, "  gl_FragDepth = gl_FragCoord.z - 0.01;\n", false);
      });
    const std::vector<double> ground = GroundDepths(renderer);
    const double near = 2.0;
    const double far = 30.0;
    for (const int pixel : { 20 * Width + 30, 60 * Width + 80, 70 * Width + 120 })
    {
      const double inverse = 1.0 / ground[pixel] + 0.01 * (1.0 / near - 1.0 / far);
      const double expected = parallel ? ground[pixel] - 0.01 * (far - near) : 1.0 / inverse;
      EXPECT_NEAR(depth.Values[pixel], expected, 1e-4 * expected) << pixel << ' ' << parallel;
    }
  }
}

//------------------------------------------------------------------------------
// An offset that settles which of two surfaces is seen moves neither of them.
TEST(DrawnDepth, StaysWithOffsetsForCoincidentTopology)
{
  const auto renderer = MakeRenderer({ { 0.0, -5.0, 4.0 } }, { { 0.0, 0.0, 0.2 } });
  const Picture depth = DrawGround(renderer,
    [](vtkActor* ground)
    {
      ground->GetProperty()->EdgeVisibilityOn();
      ground->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 500.0);
    });
  const std::vector<double> ground = GroundDepths(renderer);
  for (const int pixel : { 20 * Width + 30, 60 * Width + 60, 70 * Width + 120 })
  {
    // VTK draws triangles with edges half a pixel larger. The offset would be 0.1.
    EXPECT_NEAR(depth.Values[pixel], ground[pixel], 0.02) << pixel;
  }
}
