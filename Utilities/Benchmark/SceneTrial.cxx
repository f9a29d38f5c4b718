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
double GetNumber(const TechniqueOptions& options, const std::string& name)
{
  const auto found = options.find(name);
  return found == options.end() ? 1.0 : std::strtod(found->second.c_str(), nullptr);
}

//--------------------------------------------------------------------------------------------------
// How many maps or rays there are, beside those of one with other numbers and else the same options.
double GetSamples(const TechniqueOptions& options)
{
  const double split = GetNumber(options, "split");
  return GetNumber(options, "samples") * split * split;
}

//--------------------------------------------------------------------------------------------------
// The same options but for the number of samples and of the light's parts.
bool AreOfOneKind(const ContestantChoice& choice, const ContestantResult& result)
{
  TechniqueOptions first = choice.Options;
  TechniqueOptions second = result.Options;
  first.erase("split");
  second.erase("split");
  return choice.Technique == result.Technique &&
    first.erase("samples") == second.erase("samples") && first == second;
}

//--------------------------------------------------------------------------------------------------
// Rec. 709, in [0, 1].
std::vector<float> Luminance(const ColorImage& image)
{
  std::vector<float> values;
  for (size_t i = 0; i + 2 < image.Pixels.size(); i += 3)
  {
    const double sum =
      0.2126 * image.Pixels[i] + 0.7152 * image.Pixels[i + 1] + 0.0722 * image.Pixels[i + 2];
    values.push_back(static_cast<float>(sum / 255.0));
  }
  return values;
}

}

//--------------------------------------------------------------------------------------------------
SceneTrial::SceneTrial(const BenchmarkSettings& settings, const BenchmarkScene& scene,
  const SceneTruth& truth, const TechniqueFactory& makeTechnique)
  : Settings(settings)
  , Scene(scene)
  , Truth(truth)
  , MakeTechnique(makeTechnique)
  , Silhouettes(truth.Soft.Depth.empty()
        ? std::vector<unsigned char>()
        : FindSilhouettes(truth.Soft.Width, truth.Soft.Height, truth.Soft.Depth))
{
}

//--------------------------------------------------------------------------------------------------
ColorImage SceneTrial::DrawReference() const
{
  const VisibilityImage& soft = this->Truth.Soft;
  return soft.Visibility.empty() ? ColorImage()
                                 : DrawVisibility(soft.Width, soft.Height, soft.Visibility.front());
}

//--------------------------------------------------------------------------------------------------
double SceneTrial::LongestFrame() const
{
  const double share = this->Settings.SecondsPerScene / 15.0;
  return share > 0.0 ? std::min(share, this->Settings.LongestFrame) : this->Settings.LongestFrame;
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
void SceneTrial::LeaveOut(const ContestantChoice& choice, const std::string& reason)
{
  this->Entries.emplace_back();
  ContestantResult& result = this->Entries.back().Result;
  result.Name = choice.GetName();
  result.Technique = choice.Technique;
  result.Options = choice.Options;
  result.Failure = reason;
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::Add(const ContestantChoice& choice)
{
  const double seconds = this->Foresee(choice);
  if (seconds > this->LongestFrame())
  {
    std::ostringstream text;
    text.precision(2);
    text << "left out: a frame would take about " << seconds << " s";
    this->LeaveOut(choice, text.str());
    return;
  }
  this->LeaveOut(choice, "");
  Entry& entry = this->Entries.back();
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
  this->Judge(choice, entry);
  const double first = this->Time(entry, Motion::Light);
  entry.SecondsPerFrame = 1e-3 * first;
  entry.IsSlow = entry.SecondsPerFrame > this->LongestFrame();
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
// Over the pixels of all lights together; NaN if there are none.
double SceneTrial::CompareWith(
  const std::vector<std::vector<float>>& truth, const std::vector<std::vector<float>>& images) const
{
  double squares = 0.0;
  double pixels = 0.0;
  for (size_t light = 0; light < std::min(images.size(), truth.size()); ++light)
  {
    for (size_t i = 0; i < images[light].size(); ++i)
    {
      const double error = images[light][i] - truth[light][i];
      const bool isLeftOut = !this->Silhouettes.empty() && this->Silhouettes[i];
      if (!isLeftOut && !std::isnan(error))
      {
        squares += error * error;
        pixels += 1.0;
      }
    }
  }
  return std::sqrt(squares / pixels);
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::Judge(const ContestantChoice& choice, Entry& entry)
{
  const std::vector<std::vector<float>> images = entry.Runner->GetVisibility();
  const std::vector<std::vector<float>>& soft = this->Truth.Soft.Visibility;
  for (size_t light = 0; light < std::min(images.size(), soft.size()); ++light)
  {
    entry.Result.Errors.push_back(MeasureErrors(
      this->Scene.Width, this->Scene.Height, soft[light], images[light], this->Silhouettes));
  }
  entry.Result.Rmse = this->CompareWith(soft, images);
  if (choice.HasHardShadows())
  {
    entry.Result.RmseToHard = this->CompareWith(this->Truth.Hard.Visibility, images);
  }
  if (this->FirstVisibility.empty())
  {
    this->FirstVisibility = images;
  }
  entry.Result.RmseToFirst = this->CompareWith(this->FirstVisibility, images);
  const ColorImage picture =
    this->Truth.Picture.Pixels.empty() ? ColorImage() : entry.Runner->GetPicture();
  if (!picture.Pixels.empty())
  {
    entry.Result.PictureErrors = MeasureErrors(
      this->Scene.Width, this->Scene.Height, Luminance(this->Truth.Picture), Luminance(picture))
                                   .All;
  }
  this->KeepPictures(images, entry);
}

//--------------------------------------------------------------------------------------------------
void SceneTrial::KeepPictures(const std::vector<std::vector<float>>& images, Entry& entry) const
{
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
    const int width = this->Scene.Width;
    const int height = this->Scene.Height;
    entry.Result.Visibility = DrawVisibility(width, height, images.front());
    entry.Result.Difference = { width, height,
      DrawDifference(this->Truth.Soft.Visibility.front(), images.front()) };
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
  for (Motion motion : this->Settings.Motions)
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
