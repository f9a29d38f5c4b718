// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a frame with shadows costs beside a frame without: VTK's plain frame, VTK's vtkShadowMapPass
 * and ours, in one process, one frame of each in turn so that drift hits all alike. Prints medians in
 * milliseconds and their ratios to the plain frame as a Markdown table; for our passes also the sum of
 * the steps that timer queries measured.
 *
 * Usage: SoftShadowsFrameCost [--frames N] [--size WIDTH HEIGHT] [MODEL.ply]...
 */

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPLYReader.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSampledSoftShadowPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSphereSource.h"
#ifdef SOFTSHADOWS_HAS_TRACED
#include "vtkTracedSoftShadowPass.h"
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

VTK_MODULE_INIT(vtkRenderingOpenGL2);

namespace
{

// A window with a scene, and what is drawn in it.
struct Contestant
{
  std::string Name;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAreaLight> Light;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  vtkSmartPointer<vtkSoftShadowPass> Pass; // if it is one of ours
  std::vector<double> Milliseconds;
  std::vector<double> StepMilliseconds; // what the timer queries of a frame say
};

using Scene = std::function<void(Contestant&)>;

int WindowSize[2] = { 640, 480 };

//--------------------------------------------------------------------------------------------------
void AddActor(Contestant& contestant, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  contestant.Renderer->AddActor(actor);
  contestant.Actors.push_back(actor);
}

//--------------------------------------------------------------------------------------------------
void AddSpheres(Contestant& contestant, int count)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.3);
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(16);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const double spacing = 8.0 / columns;
  for (int i = 0; i < count; ++i)
  {
    AddActor(contestant, sphere);
    contestant.Actors.back()->SetScale(spacing);
    contestant.Actors.back()->SetPosition(
      spacing * (i % columns) - 4.0, spacing * (i / columns) - 4.0, 0.5);
  }
}

//--------------------------------------------------------------------------------------------------
void AddModel(Contestant& contestant, const std::string& file)
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  double bounds[6];
  reader->GetOutput()->GetBounds(bounds);
  AddActor(contestant, reader);
  const double scale = 4.0 / (bounds[3] - bounds[2]);
  vtkActor* actor = contestant.Actors.back();
  actor->SetScale(scale);
  actor->RotateX(90.0);
  actor->SetPosition(-0.5 * scale * (bounds[0] + bounds[1]), 0.5 * scale * (bounds[4] + bounds[5]),
    -scale * bounds[2]);
}

//--------------------------------------------------------------------------------------------------
void SetUp(Contestant& contestant, const Scene& scene)
{
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-6.0, -6.0, 0.0);
  ground->SetPoint1(6.0, -6.0, 0.0);
  ground->SetPoint2(-6.0, 6.0, 0.0);
  AddActor(contestant, ground);
  scene(contestant);
  vtkAreaLight* light = contestant.Light;
  light->SetConeAngle(40.0);
  light->SetPosition(4.0, -6.0, 12.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetSize(1.0, 1.0);
  contestant.Renderer->AddLight(light);
  vtkCamera* camera = contestant.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, -14.0, 9.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  contestant.Renderer->ResetCameraClippingRange();
  contestant.Window->SetOffScreenRendering(1);
  contestant.Window->SetMultiSamples(0);
  contestant.Window->SetSize(WindowSize);
  contestant.Window->AddRenderer(contestant.Renderer);
}

//--------------------------------------------------------------------------------------------------
void UseSoftShadows(Contestant& contestant, vtkSoftShadowPass* pass)
{
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(pass);
  contestant.Renderer->SetPass(steps);
  contestant.Pass = pass;
}

//--------------------------------------------------------------------------------------------------
// VTK's own shadows as its documentation has them.
void UseShadowMaps(Contestant& contestant, unsigned int resolution)
{
  vtkNew<vtkShadowMapBakerPass> baker;
  baker->SetResolution(resolution);
  vtkNew<vtkShadowMapPass> shadows;
  shadows->SetShadowMapBakerPass(baker);
  vtkNew<vtkSequencePass> sequence;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(shadows);
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  contestant.Renderer->SetPass(camera);
}

//--------------------------------------------------------------------------------------------------
double Time(Contestant& contestant, const std::function<void(Contestant&)>& change)
{
  change(contestant);
  const auto start = std::chrono::steady_clock::now();
  contestant.Window->Render();
  contestant.Window->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

//--------------------------------------------------------------------------------------------------
double SumOfSteps(const Contestant& contestant)
{
  double sum = 0.0;
  for (const auto& step : contestant.Pass->GetStatistics().Milliseconds)
  {
    sum += step.second;
  }
  return sum;
}

//--------------------------------------------------------------------------------------------------
double Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

//--------------------------------------------------------------------------------------------------
// Frames of all in turn, the first two of each left out; the first contestant is the unit.
void Race(const std::string& title, std::vector<Contestant>& contestants, int frames,
  const std::function<void(Contestant&)>& change)
{
  for (int frame = 0; frame < frames + 2; ++frame)
  {
    for (Contestant& contestant : contestants)
    {
      const double milliseconds = Time(contestant, change);
      if (frame >= 2)
      {
        contestant.Milliseconds.push_back(milliseconds);
        if (contestant.Pass)
        {
          contestant.StepMilliseconds.push_back(SumOfSteps(contestant));
        }
      }
    }
  }
  const double unit = Median(contestants.front().Milliseconds);
  for (Contestant& contestant : contestants)
  {
    const double median = Median(contestant.Milliseconds);
    const auto range =
      std::minmax_element(contestant.Milliseconds.begin(), contestant.Milliseconds.end());
    const std::string steps = contestant.StepMilliseconds.empty()
      ? std::string()
      : std::to_string(Median(contestant.StepMilliseconds));
    std::printf("| %s | %s | %.1f | %.1f to %.1f | %.2f | %.6s |\n", title.c_str(),
      contestant.Name.c_str(), median, *range.first, *range.second, median / unit, steps.c_str());
    contestant.Milliseconds.clear();
    contestant.StepMilliseconds.clear();
  }
  std::fflush(stdout);
}

void MoveCamera(Contestant& contestant)
{
  contestant.Renderer->GetActiveCamera()->Azimuth(0.5);
}

void MoveNothing(Contestant&) {}

void MoveActors(Contestant& contestant)
{
  for (size_t i = 1; i < contestant.Actors.size(); ++i)
  {
    contestant.Actors[i]->AddPosition(0.0, 0.0, 0.001);
  }
}

//--------------------------------------------------------------------------------------------------
void RaceStillShadows(const std::string& title, const Scene& scene, int frames)
{
  std::vector<Contestant> contestants(4);
  const char* const names[] = { "VTK plain", "VTK vtkShadowMapPass, 1024", "hard, 1024",
    "PCSS 15/21, 1024" };
  for (size_t i = 0; i < contestants.size(); ++i)
  {
    contestants[i].Name = names[i];
    SetUp(contestants[i], scene);
  }
  UseShadowMaps(contestants[1], 1024);
  vtkNew<vtkSampledSoftShadowPass> hard;
  hard->SetNumberOfSamples(1);
  hard->SetMapSize(1024);
  UseSoftShadows(contestants[2], hard);
  vtkNew<vtkPercentageCloserSoftShadowPass> soft;
  soft->SetMapSize(1024);
  UseSoftShadows(contestants[3], soft);
  Race(title + ", camera moves", contestants, frames, MoveCamera);
  Race(title + ", nothing moves", contestants, frames, MoveNothing);
}

//--------------------------------------------------------------------------------------------------
void RaceMovingActors(int frames)
{
  std::vector<Contestant> contestants(3);
  const char* const names[] = { "VTK plain", "VTK vtkShadowMapPass, 512", "25 samples, 512" };
  for (size_t i = 0; i < contestants.size(); ++i)
  {
    contestants[i].Name = names[i];
    SetUp(contestants[i], [](Contestant& contestant) { AddSpheres(contestant, 1000); });
  }
  UseShadowMaps(contestants[1], 512);
  vtkNew<vtkSampledSoftShadowPass> samples;
  samples->SetNumberOfSamples(25);
  samples->SetMapSize(512);
  UseSoftShadows(contestants[2], samples);
  Race("1000 moving actors", contestants, frames, MoveActors);
}

//--------------------------------------------------------------------------------------------------
void RaceEarlyOut(const std::string& title, const Scene& scene, int frames)
{
  std::vector<Contestant> contestants(2);
  contestants[0].Name = "PCSS 29/41, early-out";
  contestants[1].Name = "PCSS 29/41, every tap";
  for (size_t i = 0; i < contestants.size(); ++i)
  {
    SetUp(contestants[i], scene);
    vtkNew<vtkPercentageCloserSoftShadowPass> pass;
    pass->SetSearchWidth(29);
    pass->SetFilterWidth(41);
    pass->SetEarlyOut(i == 0);
    UseSoftShadows(contestants[i], pass);
  }
  Race(title + ", camera moves", contestants, frames, MoveCamera);
}

#ifdef SOFTSHADOWS_HAS_TRACED
//--------------------------------------------------------------------------------------------------
// Beside frames, what rays spend on trees: all of them first, then the one over the actors.
void RaceTraced(const std::string& title, const Scene& scene, int frames)
{
  std::vector<Contestant> contestants(2);
  contestants[0].Name = "VTK plain";
  contestants[1].Name = "traced";
  for (Contestant& contestant : contestants)
  {
    SetUp(contestant, scene);
  }
  vtkNew<vtkTracedSoftShadowPass> pass;
  UseSoftShadows(contestants[1], pass);
  contestants[1].Window->Render();
  const auto print = [&title](const char* what, double value)
  { std::printf("| %s | traced: %s | %.2f | | |\n", title.c_str(), what, value); };
  print("trees of all actors", pass->GetMilliseconds("scene"));
  print("MiB of trees and textures", pass->GetCount("bytes_held") / 1048576.0);
  Race(title + ", camera moves", contestants, frames, MoveCamera);
  std::vector<double> updates;
  Race(title + ", actors move", contestants, frames,
    [&](Contestant& contestant)
    {
      updates.push_back(pass->GetMilliseconds("scene"));
      MoveActors(contestant);
    });
  print("tree over the actors", Median(updates));
}

#endif
//--------------------------------------------------------------------------------------------------
std::string NameOfModel(const std::string& file)
{
  return file.substr(file.find_last_of('/') + 1);
}

} // namespace

//--------------------------------------------------------------------------------------------------
int main(int argc, char** argv)
{
  int frames = 15;
  std::vector<std::string> models;
  for (int i = 1; i < argc; ++i)
  {
    if (std::string(argv[i]) == "--frames" && i + 1 < argc)
    {
      frames = std::max(std::atoi(argv[++i]), 1);
    }
    else if (std::string(argv[i]) == "--size" && i + 2 < argc)
    {
      WindowSize[0] = std::max(std::atoi(argv[++i]), 1);
      WindowSize[1] = std::max(std::atoi(argv[++i]), 1);
    }
    else
    {
      models.emplace_back(argv[i]);
    }
  }
  std::printf("| scene | frame | median ms | range | ratio | steps ms |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  for (const int count : { 10, 1000 })
  {
    RaceStillShadows(
      std::to_string(count) + " spheres",
      [count](Contestant& contestant) { AddSpheres(contestant, count); }, frames);
  }
  for (const std::string& model : models)
  {
    const std::string name = NameOfModel(model);
    const Scene scene = [&model](Contestant& contestant) { AddModel(contestant, model); };
    RaceStillShadows(name, scene, frames);
    RaceEarlyOut(name, scene, std::min(frames, 5));
#ifdef SOFTSHADOWS_HAS_TRACED
    RaceTraced(name, scene, frames);
#endif
  }
  RaceMovingActors(frames);
  return 0;
}
