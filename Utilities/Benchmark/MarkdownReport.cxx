// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkdownReport.h"

#include "BenchmarkCharts.h"
#include "HtmlReport.h"

#include <algorithm> // For the front
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
    os << ' ' << contestant.Failure << " | | | | | | | |\n";
    return;
  }
  for (Motion motion : { Motion::Light, Motion::Camera, Motion::Still })
  {
    os << ' ' << FormatNumber(contestant.Times[static_cast<size_t>(motion)].Median()) << " |";
  }
  if (!contestant.HasErrors())
  {
    os << " - | - | - | - | - |\n";
    return;
  }
  const VisibilityErrors& first = contestant.Errors.front();
  os << ' ' << FormatNumber(contestant.Rmse) << " | " << FormatNumber(first.Penumbra.Rmse) << " | "
     << FormatNumber(first.All.Ssim) << " | " << first.LightLeaks << " | " << first.FalseShadows
     << " |\n";
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
  os << "| contestant | light | camera | still | RMSE | in penumbra | SSIM | leaks | false "
        "shadows |\n| :--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  const std::vector<const ContestantResult*> front = ParetoFront(scene);
  for (const ContestantResult& contestant : scene.Contestants)
  {
    WriteRow(os, contestant, std::find(front.begin(), front.end(), &contestant) != front.end());
  }
  os << '\n';
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
       "all lights against ray tracing, silhouettes of the view left out; the other errors are of "
       "the first light. Bold: no other contestant is both faster (lights moving) and closer.\n\n";
  for (const SceneResult& scene : results.Scenes)
  {
    WriteScene(os, scene, imageFolder, pictures);
  }
  for (const std::string family : { "actors", "triangles" })
  {
    WriteChart(os, TimeAgainstSize(results, family), family + ".png", imageFolder, pictures);
  }
  return pictures;
}

}
