// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRunner.h"

#include "SceneTrial.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <cmath>   // For rounding
#include <sstream> // For lines

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
  const BenchmarkScene& scene, SceneResult& result) const
{
  const vtkSmartPointer<vtkRenderer> renderer = scene.Make();
  CountScene(renderer, result);
  ReferenceCache cache(this->Settings.CacheFolder);
  VisibilityImage reference =
    cache.Get(renderer, scene.Width, scene.Height, this->Settings.ReferenceSamplesPerAxis,
      [&](double share)
      {
        const std::string percent = std::to_string(std::lround(100.0 * share));
        this->Report(scene.Name + ": ray tracing the reference, " + percent + " %", false);
      });
  result.Lights = static_cast<int>(reference.Visibility.size());
  return reference;
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
  VisibilityImage reference;
  try
  {
    if (result.Failure.empty())
    {
      reference = this->GetReference(scene, result);
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

  SceneTrial trial(this->Settings, scene, reference, this->MakeTechnique);
  result.Reference = this->Settings.Pictures ? trial.DrawReference() : ColorImage();
  for (size_t i = 0; i < choices.size(); ++i)
  {
    this->Report(scene.Name + ": judging " + choices[i].GetName() + " (" + std::to_string(i + 1) +
        " of " + std::to_string(choices.size()) + ")",
      false);
    trial.Add(choices[i]);
  }
  for (int round = 0; round < this->Settings.Rounds; ++round)
  {
    this->Report(scene.Name + ": timing, round " + std::to_string(round + 1) + " of " +
        std::to_string(this->Settings.Rounds),
      false);
    trial.TimeRound();
  }
  result.Contestants = trial.Finish();
  for (const ContestantResult& contestant : result.Contestants)
  {
    this->Report(Describe(result, contestant), true);
  }
  return result;
}

}
