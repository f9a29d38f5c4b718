// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneTrial.h"

#include "DifferencePicture.h"
#include "Silhouettes.h"

#include <algorithm> // For std::max
#include <chrono>    // For times
#include <cmath>     // For roots
#include <cstdlib>   // For numbers in options
#include <sstream>   // For messages

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
// Visibility in grey; what has none is a light blue.
ColorImage DrawVisibility(int width, int height, const std::vector<float>& visibility)
{
  ColorImage picture{ width, height, {} };
  picture.Pixels.reserve(3 * visibility.size());
  for (float value : visibility)
  {
    if (std::isnan(value))
    {
      picture.Pixels.insert(picture.Pixels.end(), { 190, 205, 225 });
    }
    else
    {
      const float clamped = std::min(1.0F, std::max(0.0F, value));
      picture.Pixels.insert(
        picture.Pixels.end(), 3, static_cast<unsigned char>(std::lround(255.0F * clamped)));
    }
  }
  return picture;
}

//--------------------------------------------------------------------------------------------------
double TotalRmse(const std::vector<VisibilityErrors>& lights)
{
  double squares = 0.0;
  double pixels = 0.0;
  for (const VisibilityErrors& errors : lights)
  {
    if (errors.All.Pixels > 0)
    {
      const auto count = static_cast<double>(errors.All.Pixels);
      squares += errors.All.Rmse * errors.All.Rmse * count;
      pixels += count;
    }
  }
  return std::sqrt(squares / pixels);
}

//--------------------------------------------------------------------------------------------------
double GetSamples(const TechniqueOptions& options)
{
  const auto found = options.find("samples");
  return found == options.end() ? 0.0 : std::strtod(found->second.c_str(), nullptr);
}

//--------------------------------------------------------------------------------------------------
// The same options but for the number of samples.
bool AreOfOneKind(const ContestantChoice& choice, const ContestantResult& result)
{
  TechniqueOptions first = choice.Options;
  TechniqueOptions second = result.Options;
  return choice.Technique == result.Technique && first.erase("samples") == 1 &&
    second.erase("samples") == 1 && first == second;
}

}

//--------------------------------------------------------------------------------------------------
SceneTrial::SceneTrial(const BenchmarkSettings& settings, const BenchmarkScene& scene,
  const VisibilityImage& reference, const TechniqueFactory& makeTechnique)
  : Settings(settings)
  , Scene(scene)
  , Reference(reference)
  , MakeTechnique(makeTechnique)
  , Silhouettes(FindSilhouettes(reference.Width, reference.Height, reference.Depth))
{
}

//--------------------------------------------------------------------------------------------------
ColorImage SceneTrial::DrawReference() const
{
  return this->Reference.Visibility.empty()
    ? ColorImage()
    : DrawVisibility(
        this->Reference.Width, this->Reference.Height, this->Reference.Visibility.front());
}

//--------------------------------------------------------------------------------------------------
// Seconds for a frame, judged by the last of the kind; 0 if there is none.
double SceneTrial::Foresee(const ContestantChoice& choice) const
{
  double seconds = 0.0;
  for (const Entry& entry : this->Entries)
  {
    // Fewer samples never take longer, but what they save is unknown.
    const double more = GetSamples(choice.Options) / GetSamples(entry.Result.Options);
    if (AreOfOneKind(choice, entry.Result) && entry.SecondsPerFrame > 0.0 && more > 1.0)
    {
      seconds = more * entry.SecondsPerFrame;
    }
  }
  return seconds;
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::Add(const ContestantChoice& choice)
{
  this->Entries.emplace_back();
  Entry& entry = this->Entries.back();
  entry.Result.Name = choice.GetName();
  entry.Result.Technique = choice.Technique;
  entry.Result.Options = choice.Options;
  const double seconds = this->Foresee(choice);
  if (seconds > this->Settings.LongestFrame)
  {
    std::ostringstream text;
    text.precision(2);
    text << "left out: a frame would take about " << seconds << " s";
    entry.Result.Failure = text.str();
    return;
  }
  try
  {
    this->Prepare(choice, entry);
  }
  catch (const std::exception& error)
  {
    entry.Result.Failure = error.what();
    entry.Runner.reset();
  }
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::Prepare(const ContestantChoice& choice, Entry& entry)
{
  entry.Runner = MakeContestant(
    choice, this->Scene.Make, this->Scene.Width, this->Scene.Height, this->MakeTechnique);
  entry.Runner->Draw(Motion::Still, this->Frame++);
  this->Judge(entry);
  const double first = this->Time(entry, Motion::Light);
  entry.SecondsPerFrame = 1e-3 * first;
  entry.IsSlow = entry.SecondsPerFrame > this->Settings.LongestFrame;
  if (entry.IsSlow)
  {
    KeepSteps(entry); // this frame is all that is timed
    return;
  }
  // What was warm-up alone is not a time.
  entry.Result.Times = {};
  entry.SecondsUsed = 0.0;
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::Judge(Entry& entry) const
{
  const int width = this->Reference.Width;
  const int height = this->Reference.Height;
  const std::vector<std::vector<float>> images = entry.Runner->GetVisibility();
  for (size_t light = 0; light < std::min(images.size(), this->Reference.Visibility.size());
       ++light)
  {
    entry.Result.Errors.push_back(MeasureErrors(
      width, height, this->Reference.Visibility[light], images[light], this->Silhouettes));
  }
  entry.Result.Rmse = TotalRmse(entry.Result.Errors);
  const auto isShown = [&entry](const Entry& other)
  {
    const bool isOther = &other != &entry;
    return isOther && other.Runner && other.Result.Technique == entry.Result.Technique;
  };
  if (!this->Settings.Pictures || std::any_of(this->Entries.begin(), this->Entries.end(), isShown))
  {
    return;
  }
  entry.Result.Picture = entry.Runner->GetPicture();
  if (entry.Result.HasErrors())
  {
    entry.Result.Visibility = DrawVisibility(width, height, images.front());
    entry.Result.Difference = { width, height,
      DrawDifference(this->Reference.Visibility.front(), images.front()) };
  }
}

//--------------------------------------------------------------------------------------------------
double SceneTrial::Time(Entry& entry, Motion motion)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  entry.Runner->Draw(motion, this->Frame++);
  const std::chrono::duration<double, std::milli> time = Clock::now() - start;
  entry.Result.Times[static_cast<size_t>(motion)].Milliseconds.push_back(time.count());
  entry.SecondsUsed += 1e-3 * time.count();
  return time.count();
}

//--------------------------------------------------------------------------------------------------
bool SceneTrial::HasTime(const Entry& entry) const
{
  return entry.Runner && !entry.IsSlow && entry.SecondsUsed < this->Settings.SecondsPerContestant;
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::TimeRound()
{
  for (Motion motion : AllMotions)
  {
    for (Entry& entry : this->Entries)
    {
      const bool isFirst = entry.Runner && !entry.IsSlow &&
        entry.Result.Times[static_cast<size_t>(motion)].Milliseconds.empty();
      if ((isFirst || this->HasTime(entry)) && entry.Runner->Notices(motion))
      {
        this->Time(entry, motion);
        if (motion == Motion::Light)
        {
          KeepSteps(entry);
        }
      }
    }
  }
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::KeepSteps(Entry& entry)
{
  for (const auto& step : entry.Runner->GetSteps())
  {
    FrameTimes& times = entry.Steps[step.first];
    if (times.Milliseconds.empty())
    {
      entry.StepOrder.push_back(step.first);
    }
    times.Milliseconds.push_back(step.second);
  }
}

//--------------------------------------------------------------------------------------------------
std::vector<ContestantResult> SceneTrial::Finish()
{
  std::vector<ContestantResult> results;
  for (Entry& entry : this->Entries)
  {
    if (entry.Runner)
    {
      entry.Result.Counts = entry.Runner->GetCounts();
      for (const std::string& step : entry.StepOrder)
      {
        entry.Result.Steps.emplace_back(step, entry.Steps[step].Median());
      }
    }
    results.push_back(std::move(entry.Result));
  }
  this->Entries.clear();
  return results;
}

}
