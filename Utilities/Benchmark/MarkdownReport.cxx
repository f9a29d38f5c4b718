// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkdownReport.h"

#include "BenchmarkCharts.h"
#include "HtmlReport.h"

#include <algorithm> // For the front
#include <cmath>     // For what was not measured
#include <ostream>   // For the text

namespace softshadows
{
namespace
{

using Pictures = std::map<std::string, ColorImage>;

//--------------------------------------------------------------------------------------------------
void WriteRow(std::ostream& os, const ContestantResult& contestant, bool isOnFront)
{
  const char* bold = isOnFront ? "**" : "";
  os << "| " << bold << contestant.Name << bold << " |";
  if (!contestant.Failure.empty())
  {
    os << ' ' << contestant.Failure << " | | | | | | | | |\n";
    return;
  }
  for (Motion motion : { Motion::Light, Motion::Camera, Motion::Still })
  {
    os << ' ' << FormatNumber(contestant.Times[static_cast<size_t>(motion)].Median()) << " |";
  }
  const double picture =
    contestant.PictureErrors.Pixels > 0 ? contestant.PictureErrors.Rmse : std::nan("");
  if (!contestant.HasErrors())
  {
    os << " - | - | - | " << FormatNumber(picture) << " | - | - |\n";
    return;
  }
  const VisibilityErrors& first = contestant.Errors.front();
  os << ' ' << FormatNumber(contestant.Rmse) << " | " << FormatNumber(first.Penumbra.Rmse) << " | "
     << FormatNumber(first.All.Ssim) << " | " << FormatNumber(picture) << " | " << first.LightLeaks
     << " | " << first.FalseShadows << " |\n";
}

//--------------------------------------------------------------------------------------------------
void WriteChart(std::ostream& os, const ChartDescription& chart, const std::string& name,
  const std::string& folder, Pictures& pictures)
{
  if (!chart.IsEmpty())
  {
    pictures[name] = DrawChart(chart);
    os << "![" << chart.Title << "](" << folder << '/' << name << ")\n\n";
  }
}

//--------------------------------------------------------------------------------------------------
// Hard shadows against the hard truth: how right they are as what they are.
void WriteHardErrors(std::ostream& os, const SceneResult& scene)
{
  std::string text;
  for (const ContestantResult& contestant : scene.Contestants)
  {
    if (std::isfinite(contestant.RmseToHard))
    {
      text +=
        (text.empty() ? "" : ", ") + contestant.Name + ' ' + FormatNumber(contestant.RmseToHard);
    }
  }
  if (!text.empty())
  {
    os << "\nRMSE against ray-traced *hard* shadows: " << text << ".\n";
  }
}

//--------------------------------------------------------------------------------------------------
void WriteScene(
  std::ostream& os, const SceneResult& scene, const std::string& folder, Pictures& pictures)
{
  os << "## " << scene.Name << "\n\n";
  if (!scene.Failure.empty())
  {
    os << "Broken: " << scene.Failure << "\n\n";
    return;
  }
  os << scene.Width << " x " << scene.Height << " pixels, " << scene.Actors << " actors, "
     << scene.Triangles << " triangles, " << scene.Lights << " lights.\n\n";
  WriteChart(os, SpeedAgainstError(scene), "speed-" + scene.Name + ".png", folder, pictures);
  os << "| contestant | light | camera | still | RMSE | in penumbra | SSIM | picture | leaks | "
        "false "
        "shadows |\n| :--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  const std::vector<const ContestantResult*> front = ParetoFront(scene);
  for (const ContestantResult& contestant : scene.Contestants)
  {
    WriteRow(os, contestant, std::find(front.begin(), front.end(), &contestant) != front.end());
  }
  WriteHardErrors(os, scene);
  os << '\n';
}

//--------------------------------------------------------------------------------------------------
// Of the scene in which most settings were varied.
void WriteSweeps(
  std::ostream& os, const BenchmarkResults& results, const std::string& folder, Pictures& pictures)
{
  const auto most = std::max_element(results.Scenes.begin(), results.Scenes.end(),
    [](const SceneResult& a, const SceneResult& b)
    { return a.Contestants.size() < b.Contestants.size(); });
  os << "## Time against settings and sizes\n\n";
  for (const std::string option : { "filter_width", "map_size", "samples" })
  {
    if (most != results.Scenes.end())
    {
      WriteChart(os, TimeAgainstOption(*most, option), "time-" + option + ".png", folder, pictures);
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
Pictures WriteMarkdown(
  std::ostream& os, const BenchmarkResults& results, const std::string& imageFolder)
{
  Pictures pictures;
  const BenchmarkContext& context = results.Context;
  os
    << "Measured on " << context.Processor << ", " << context.Processors << " processors, "
    << context.Renderer << ", VTK " << context.VtkVersion << ", SoftShadows " << context.Version
    << ", " << context.Date.substr(0, 10)
    << ".\n\nTimes are medians of frames in milliseconds: with all lights moving (every map is "
       "baked anew), with the camera moving, with nothing moving. RMSE is over the visibilities of "
       "all lights against ray tracing, silhouettes of the view left out; picture is the RMSE of "
       "the "
       "lit picture's luminance; the other errors are of the first light. Bold: no other "
       "contestant is both faster (lights moving) and closer.\n\n";
  WriteChart(os, SpeedAgainstErrorOfAll(results), "speed-against-error.png", imageFolder, pictures);
  for (const SceneResult& scene : results.Scenes)
  {
    WriteScene(os, scene, imageFolder, pictures);
  }
  WriteSweeps(os, results, imageFolder, pictures);
  for (const std::string family : { "actors", "triangles" })
  {
    WriteChart(os, TimeAgainstSize(results, family), family + ".png", imageFolder, pictures);
  }
  return pictures;
}

}
