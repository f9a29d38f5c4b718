// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Adaptive sampling: its error and its points against uniform grids, and its occlusion queries.
#include "CascadedStage.h"

#include "vtkAdaptiveSampledSoftShadowPass.h"
#include "vtkShadowQueryReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{
double ErrorOf(const Scene& scene, const Picture& visibility)
{
  std::vector<double> errors;
  for (const PlanePixel& pixel : GetPlanePixels(scene, Width, Height))
  {
    errors.push_back(visibility.At(pixel.X, pixel.Y) - pixel.Expected);
  }
  return RootMeanSquare(errors);
}

// Where there is no surface there is no number, which equals nothing.
std::vector<float> NoSurfaceIsNegative(std::vector<float> values)
{
  std::replace_if(
    values.begin(), values.end(), [](float value) { return std::isnan(value); }, -1.0f);
  return values;
}
}

class AdaptiveClosedForm : public testing::TestWithParam<NamedScene>
{
};

// It reaches its tolerance, and a uniform grid of as many points has a larger error.
TEST_P(AdaptiveClosedForm, ReachesItsToleranceWithFewerPoints)
{
  const Scene scene = GetParam().Make(Placement());
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  adaptive->EarlyOutOff();
  UsePass(scene.Renderer, adaptive);
  window.Render();
  const double error = ErrorOf(scene, PictureOf(adaptive->GetVisibilityImage(0)));
  EXPECT_LT(error, adaptive->GetTolerance());
  const double perPixel = static_cast<double>(adaptive->GetNumberOfPixelSamples()) /
    static_cast<double>(adaptive->GetStatistics().PixelsFiltered);
  adaptive->ReleaseGraphicsResources(window.Get());

  vtkNew<vtkCascadedSoftShadowPass> uniform;
  uniform->EarlyOutOff();
  uniform->SetNumberOfCascades(1);
  uniform->SetFilter(vtkCascadedSoftShadowPass::FIXED);
  uniform->SetFilterSize(0, 1);
  UsePass(scene.Renderer, uniform);
  const int edge = static_cast<int>(std::ceil(std::sqrt(perPixel)));
  uniform->SetSampleEdge(0, edge);
  window.Render();
  const double uniformError = ErrorOf(scene, PictureOf(uniform->GetVisibilityImage(0)));
  UsePass(scene.Renderer, nullptr);
  uniform->ReleaseGraphicsResources(window.Get());
  RecordProperty("Error", std::to_string(error));
  RecordProperty("PointsPerPixel", std::to_string(perPixel));
  RecordProperty("UniformError", std::to_string(uniformError));
  EXPECT_GT(perPixel, 9.0 - 1e-6);
  EXPECT_LT(error, uniformError) << perPixel << " points per pixel against " << edge * edge;
}

INSTANTIATE_TEST_SUITE_P(Scenes, AdaptiveClosedForm, testing::ValuesIn(ClosedFormScenes()),
  [](const testing::TestParamInfo<NamedScene>& parameter) { return parameter.param.Name; });

// A tolerance that nothing meets is the uniform grid of all 81 points.
TEST(AdaptiveSampledPass, ZeroToleranceTakesAllPointsInThePenumbra)
{
  const Scene scene = MakeDiskScene();
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  adaptive->EarlyOutOff();
  adaptive->SetTolerance(0.0);
  UsePass(scene.Renderer, adaptive);
  window.Render();
  EXPECT_EQ(adaptive->GetStatistics().MapsBaked, 81);
  EXPECT_LT(ErrorOf(scene, PictureOf(adaptive->GetVisibilityImage(0))), 0.02);
  UsePass(scene.Renderer, nullptr);
  adaptive->ReleaseGraphicsResources(window.Get());
}

// A hard light needs its one point; when the light moves on, levels that nobody needed are not
// baked again.
TEST(AdaptiveSampledPass, BakesTheLevelsThatWereNeeded)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  adaptive->EarlyOutOff();
  adaptive->SetTolerance(0.5);
  UsePass(scene.Renderer, adaptive);
  window.Render();
  window.Read(); // the counts are back
  const vtkTypeInt64 first = adaptive->GetStatistics().MapsBaked;
  EXPECT_EQ(first, 81);
  double position[3];
  scene.Light->GetPosition(position);
  scene.Light->SetPosition(position[0] + 1e-3, position[1], position[2]);
  window.Render();
  EXPECT_EQ(adaptive->GetStatistics().MapsBaked - first, 25);
  scene.Light->SetShapeToPoint();
  window.Render();
  EXPECT_EQ(adaptive->GetStatistics().MapsBaked - first, 26);
  UsePass(scene.Renderer, nullptr);
  adaptive->ReleaseGraphicsResources(window.Get());
}

// It is a cascaded pass but for what its comment names: no setting that nothing reads.
TEST(AdaptiveSampledPass, DiffersInFourDefaults)
{
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  vtkNew<vtkCascadedSoftShadowPass> cascaded;
  EXPECT_EQ(adaptive->GetNumberOfCascades(), 1);
  EXPECT_TRUE(adaptive->GetAdaptive());
  EXPECT_FALSE(adaptive->GetFitToView());
  EXPECT_EQ(adaptive->GetTolerance(), 0.0625);
  adaptive->SetNumberOfCascades(cascaded->GetNumberOfCascades());
  adaptive->SetAdaptive(cascaded->GetAdaptive());
  adaptive->SetFitToView(cascaded->GetFitToView());
  adaptive->SetTolerance(cascaded->GetTolerance());
  std::ostringstream settings[2];
  adaptive->vtkCascadedSoftShadowPass::PrintSelf(settings[0], vtkIndent());
  cascaded->PrintSelf(settings[1], vtkIndent());
  const auto own = [](const std::string& text)
  { return text.substr(text.find("NumberOfCascades")); };
  EXPECT_EQ(own(settings[0].str()), own(settings[1].str()));
}

// The width of the filter in the maps counts with FIXED, and only there.
TEST(AdaptiveSampledPass, FiltersMapsOnlyIfAsked)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  UsePass(scene.Renderer, adaptive);
  const auto render = [&](int filter, int size)
  {
    adaptive->SetFilter(filter);
    adaptive->SetFilterSize(0, size);
    window.Render();
    return NoSurfaceIsNegative(PictureOf(adaptive->GetVisibilityImage(0)).Values);
  };
  const auto unfiltered = render(vtkCascadedSoftShadowPass::SCREEN, 1);
  EXPECT_EQ(render(vtkCascadedSoftShadowPass::SCREEN, 9), unfiltered);
  EXPECT_EQ(render(vtkCascadedSoftShadowPass::FIXED, 1), unfiltered);
  EXPECT_NE(render(vtkCascadedSoftShadowPass::FIXED, 9), unfiltered);
  UsePass(scene.Renderer, nullptr);
  adaptive->ReleaseGraphicsResources(window.Get());
}

namespace
{
// Asks OpenGL, as if results took their time, and watches that nobody asks for one that is not there.
class WatchingReader : public vtkShadowQueryReader
{
public:
  bool IsAvailable(unsigned int query) override
  {
    ++this->Asked;
    if (!this->Back || !this->vtkShadowQueryReader::IsAvailable(query))
    {
      return false;
    }
    this->There.insert(query);
    return true;
  }
  unsigned int GetResult(unsigned int query) override
  {
    ++this->Reads;
    this->Waits += this->There.erase(query) == 0 ? 1 : 0;
    return this->vtkShadowQueryReader::GetResult(query);
  }

  bool Back = false;
  int Asked = 0;
  int Reads = 0;
  int Waits = 0;

private:
  std::set<unsigned int> There;
};

// Knows the answers without asking: they cannot be those of the frame that is drawn.
class KnowingReader : public vtkShadowQueryReader
{
public:
  bool IsAvailable(unsigned int) override { return true; }
  unsigned int GetResult(unsigned int) override { return this->Answer; }

  unsigned int Answer = 0;
};

// The maps that a frame bakes, with the light a little aside.
vtkTypeInt64 BakeAgain(const Scene& scene, OffscreenWindow& window, vtkSoftShadowPass* pass)
{
  const vtkTypeInt64 before = pass->GetStatistics().MapsBaked;
  double position[3];
  scene.Light->GetPosition(position);
  scene.Light->SetPosition(position[0] + 1e-3, position[1], position[2]);
  window.Render();
  return pass->GetStatistics().MapsBaked - before;
}
}

// However long the counts take, nobody waits for one; until they come every level is drawn.
TEST(AdaptiveSampledPass, NobodyWaitsForTheCounts)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  adaptive->EarlyOutOff();
  adaptive->SetTolerance(0.5);
  const auto reader = std::make_shared<WatchingReader>();
  adaptive->SetQueryReader(reader);
  UsePass(scene.Renderer, adaptive);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_EQ(BakeAgain(scene, window, adaptive), 81);
  }
  EXPECT_GT(reader->Asked, 0);
  EXPECT_EQ(reader->Reads, 0);
  reader->Back = true;
  window.Read();
  EXPECT_LT(BakeAgain(scene, window, adaptive), 81);
  for (int frame = 0; frame < 3; ++frame)
  {
    BakeAgain(scene, window, adaptive);
  }
  EXPECT_GT(reader->Reads, 4);
  EXPECT_EQ(reader->Waits, 0);
  UsePass(scene.Renderer, nullptr);
  adaptive->ReleaseGraphicsResources(window.Get());
}

// What a frame bakes is what the counts of the one before say, whatever its own.
TEST(AdaptiveSampledPass, FramesDecideByEarlierCounts)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  adaptive->EarlyOutOff();
  const auto reader = std::make_shared<KnowingReader>();
  adaptive->SetQueryReader(reader);
  UsePass(scene.Renderer, adaptive);
  EXPECT_EQ(BakeAgain(scene, window, adaptive), 81);
  EXPECT_EQ(BakeAgain(scene, window, adaptive), 4); // no pixel needed more
  reader->Answer = 10000;
  EXPECT_EQ(BakeAgain(scene, window, adaptive), 4); // nor did the last frame's
  EXPECT_EQ(BakeAgain(scene, window, adaptive), 9); // the second level was asked for
  EXPECT_EQ(BakeAgain(scene, window, adaptive), 25);
  EXPECT_EQ(BakeAgain(scene, window, adaptive), 81);
  UsePass(scene.Renderer, nullptr);
  adaptive->ReleaseGraphicsResources(window.Get());
}

// A light of one point has no finer grid to ask for: a still picture rests.
TEST(AdaptiveSampledPass, AHardLightRests)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  scene.Light->SetShapeToPoint();
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  adaptive->EarlyOutOff();
  UsePass(scene.Renderer, adaptive);
  window.Render();
  window.Read();
  const vtkTypeInt64 drawn = adaptive->GetStatistics().VisibilityFrames;
  for (int frame = 0; frame < 3; ++frame)
  {
    window.Render();
    window.Read(); // the counts are back
  }
  EXPECT_EQ(adaptive->GetStatistics().VisibilityFrames, drawn);
  // A point per pixel, not a grid's four.
  EXPECT_EQ(adaptive->GetNumberOfPixelSamples(), adaptive->GetStatistics().PixelsFiltered);
  UsePass(scene.Renderer, nullptr);
  adaptive->ReleaseGraphicsResources(window.Get());
}

// What a light that is gone, or a cascade, has looked at counts no more.
TEST(AdaptiveSampledPass, OnlyTheLastFramesPointsCount)
{
  const auto renderer = MakeAvenue(3.0);
  Stage stage(renderer);
  stage.Pass->AdaptiveOn();
  stage.Pass->SetMapSize(256);
  const auto count = [&]
  {
    for (int frame = 0; frame < 3; ++frame)
    {
      stage.Render();
      stage.Read(); // the counts are back
    }
    return stage.Pass->GetNumberOfPixelSamples();
  };
  stage.Pass->SetNumberOfCascades(1);
  const vtkTypeInt64 single = count();
  stage.Pass->SetNumberOfCascades(3);
  EXPECT_NE(count(), single);
  stage.Pass->SetNumberOfCascades(1);
  EXPECT_EQ(count(), single);
  vtkNew<vtkAreaLight> sun;
  sun->SetPosition(3.0, -1.0, 5.0);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetAngularDiameter(3.0);
  renderer->AddLight(sun);
  EXPECT_GT(count(), single);
  sun->SwitchOff();
  EXPECT_EQ(count(), single);
}

// Whoever reads the counts, a frame that drew too few levels is drawn anew, until it has enough.
TEST(AdaptiveSampledPass, ARestingPictureGetsTheLevelsItNeeds)
{
  const Scene scene = MakeRectangleScene(Weights::Mean);
  OffscreenWindow window(Width, Height);
  window.Add(scene.Renderer);
  vtkNew<vtkAdaptiveSampledSoftShadowPass> adaptive;
  adaptive->EarlyOutOff();
  const auto reader = std::make_shared<KnowingReader>();
  adaptive->SetQueryReader(reader);
  UsePass(scene.Renderer, adaptive);
  BakeAgain(scene, window, adaptive);
  reader->Answer = 10000;
  EXPECT_EQ(BakeAgain(scene, window, adaptive), 4); // nothing but the corners was needed
  const vtkTypeInt64 baked = adaptive->GetStatistics().MapsBaked;
  const vtkTypeInt64 drawn = adaptive->GetStatistics().VisibilityFrames;
  for (int frame = 0; frame < 6; ++frame)
  {
    adaptive->GetNumberOfPixelSamples();
    window.Render();
  }
  EXPECT_EQ(adaptive->GetStatistics().MapsBaked, baked + 81 - 4);
  EXPECT_EQ(adaptive->GetStatistics().VisibilityFrames, drawn + 3);
  UsePass(scene.Renderer, nullptr);
  adaptive->ReleaseGraphicsResources(window.Get());
}
