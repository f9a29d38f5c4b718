// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRunner.h"

#include "GivenVisibilityPass.h"
#include "SceneChanges.h"
#include "SceneTrial.h"
#include "WindowContestant.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm> // For choices
#include <chrono>    // For the scene's time
#include <cmath>     // For rounding
#include <sstream>   // For lines

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
void CountScene(vtkRenderer* renderer, SceneResult& result)
{
  vtkActorCollection* actors = renderer->GetActors();
  result.Actors = actors->GetNumberOfItems();
  vtkCollectionSimpleIterator iterator;
  actors->InitTraversal(iterator);
  while (vtkActor* actor = actors->GetNextActor(iterator))
  {
    auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    for (vtkCellArray* cells :
      { data ? data->GetPolys() : nullptr, data ? data->GetStrips() : nullptr })
    {
      // A polygon of n corners is drawn as n - 2 triangles, and so is a strip.
      result.Triangles +=
        cells ? cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells() : 0;
    }
  }
}

//--------------------------------------------------------------------------------------------------
std::string Describe(const SceneResult& scene, const ContestantResult& contestant)
{
  std::ostringstream line;
  line.precision(3);
  line << scene.Name << ": " << contestant.Name << ": ";
  if (!contestant.Failure.empty())
  {
    line << contestant.Failure;
    return line.str();
  }
  for (Motion motion : AllMotions)
  {
    const FrameTimes& times = contestant.Times[static_cast<size_t>(motion)];
    if (!times.Milliseconds.empty())
    {
      line << NameOf(motion) << ' ' << times.Median() << " ms, ";
    }
  }
  if (contestant.HasErrors())
  {
    line << "RMSE " << contestant.Rmse;
  }
  else
  {
    line << "no visibility";
  }
  return line.str();
}

//--------------------------------------------------------------------------------------------------
// The picture with the exact visibility.
ColorImage DrawLit(const BenchmarkScene& scene, const VisibilityImage& visibility)
{
  if (visibility.Visibility.empty())
  {
    return {};
  }
  vtkNew<GivenVisibilityPass> pass;
  pass->SetVisibility(scene.Width, scene.Height, visibility.Visibility);
  TechniqueContestant window(scene.Make, scene.Width, scene.Height, pass.Get());
  window.Draw(Motion::Still, 0);
  return window.GetPicture();
}

}

//--------------------------------------------------------------------------------------------------
void BenchmarkRunner::Report(const std::string& line, bool isFinal) const
{
  if (this->Progress)
  {
    this->Progress(line, isFinal);
  }
}

//--------------------------------------------------------------------------------------------------
VisibilityImage BenchmarkRunner::GetReference(
  vtkRenderer* renderer, const BenchmarkScene& scene, int samplesPerAxis, bool gaussian) const
{
  return this->FindReference(renderer,
    { scene.Name, scene.Width, scene.Height, samplesPerAxis, gaussian },
    [&](double share)
    {
      const std::string percent = std::to_string(std::lround(100.0 * share));
      this->Report(scene.Name + ": ray tracing the reference, " + percent + " %", false);
    });
}

//--------------------------------------------------------------------------------------------------
SceneTruth BenchmarkRunner::GetTruth(const BenchmarkScene& scene,
  const std::vector<ContestantChoice>& choices, SceneResult& result) const
{
  const vtkSmartPointer<vtkRenderer> renderer = scene.Make();
  CountScene(renderer, result);
  SceneTruth truth;
  if (!this->Settings.HasTruth)
  {
    return truth;
  }
  truth.Soft = this->GetReference(
    renderer, scene, this->Settings.ReferenceSamplesPerAxis, this->Settings.Gaussian);
  result.Lights = static_cast<int>(truth.Soft.Visibility.size());
  if (std::any_of(choices.begin(), choices.end(),
        [](const ContestantChoice& choice) { return choice.HasHardShadows(); }))
  {
    ScaleLights(renderer, 0.0);
    truth.Hard = this->GetReference(renderer, scene, 1, false);
  }
  return truth;
}

//--------------------------------------------------------------------------------------------------
bool BenchmarkRunner::Prepare(
  const BenchmarkScene& scene, const std::vector<ContestantChoice>& choices) const
{
  std::string failure = scene.Failure;
  try
  {
    if (failure.empty())
    {
      SceneResult result;
      this->GetTruth(scene, choices, result);
    }
  }
  catch (const std::exception& error)
  {
    failure = error.what();
  }
  this->Report(scene.Name + ": " + (failure.empty() ? "reference is there" : failure), true);
  return failure.empty();
}

//--------------------------------------------------------------------------------------------------
void BenchmarkRunner::TimeRounds(
  SceneTrial& trial, const std::string& name, double secondsUsed) const
{
  const auto start = std::chrono::steady_clock::now();
  const double limit = this->Settings.SecondsPerScene;
  for (int round = 0; round < this->Settings.Rounds; ++round)
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const double share = limit > 0.0 ? (secondsUsed + seconds.count()) / limit : 0.0;
    if (share > (round < BenchmarkSettings::LeastRounds ? 1.5 : 1.0) && round > 0)
    {
      return;
    }
    this->Report(name + ": timing, round " + std::to_string(round + 1) + " of " +
        std::to_string(this->Settings.Rounds),
      false);
    trial.TimeRound();
  }
}

//--------------------------------------------------------------------------------------------------
SceneResult BenchmarkRunner::Run(
  const BenchmarkScene& scene, const std::vector<ContestantChoice>& choices) const
{
  SceneResult result;
  result.Name = scene.Name;
  result.Failure = scene.Failure;
  result.Width = scene.Width;
  result.Height = scene.Height;
  result.ReferenceSamples =
    this->Settings.ReferenceSamplesPerAxis * this->Settings.ReferenceSamplesPerAxis;
  SceneTruth truth;
  try
  {
    if (result.Failure.empty())
    {
      truth = this->GetTruth(scene, choices, result);
      truth.Picture = this->Settings.JudgesPictures ? DrawLit(scene, truth.Soft) : ColorImage();
    }
  }
  catch (const std::exception& error)
  {
    result.Failure = error.what();
  }
  if (!result.Failure.empty())
  {
    this->Report(scene.Name + ": " + result.Failure, true);
    return result;
  }

  const auto start = std::chrono::steady_clock::now();
  const auto secondsUsed = [start]
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const double limit = BenchmarkSettings::JudgingShare * this->Settings.SecondsPerScene;
  SceneTrial trial(this->Settings, scene, truth, this->MakeTechnique);
  result.Reference = this->Settings.Pictures ? trial.DrawReference() : ColorImage();
  for (size_t i = 0; i < choices.size(); ++i)
  {
    this->Report(scene.Name + ": judging " + choices[i].GetName() + " (" + std::to_string(i + 1) +
        " of " + std::to_string(choices.size()) + ")",
      false);
    if (limit > 0.0 && secondsUsed() > limit && !choices[i].IsEssential)
    {
      trial.LeaveOut(choices[i], "left out: the scene's time was used up");
      continue;
    }
    trial.Add(choices[i]);
  }
  this->TimeRounds(trial, scene.Name, secondsUsed());
  result.Contestants = trial.Finish();
  for (const ContestantResult& contestant : result.Contestants)
  {
    this->Report(Describe(result, contestant), true);
  }
  return result;
}

}
