// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HtmlReport.h"

#include "BenchmarkCharts.h"
#include "PngData.h"

#include <algorithm> // For std::find
#include <cmath>     // For std::isfinite
#include <ostream>   // For the page
#include <sstream>   // For numbers

namespace softshadows
{
namespace
{

const char* const Style = R"css(
body { font: 15px/1.5 system-ui, sans-serif; color: #1a1a1a; max-width: 76rem; margin: 2rem auto;
  padding: 0 1rem; }
h2 { margin-top: 3rem; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; margin: 1rem 0; font-size: 13px; }
th, td { padding: 0.15rem 0.6rem; text-align: right; border-bottom: 1px solid #e4e4e4;
  font-variant-numeric: tabular-nums; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
td.failure { text-align: left; color: #a03000; white-space: normal; }
tr.front td:first-child { font-weight: 600; }
.wide { overflow-x: auto; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; } figure img { display: block; max-width: 22rem; }
figcaption { font-size: 12px; color: #555; }
.spread { color: #777; }
)css";

//--------------------------------------------------------------------------------------------------
void WriteContext(std::ostream& os, const BenchmarkContext& context)
{
  os << "<p>" << EscapeHtml(context.Date) << ", " << EscapeHtml(context.Host) << ", "
     << EscapeHtml(context.Processor) << " (" << context.Processors << " processors), "
     << EscapeHtml(context.Renderer) << ", VTK " << EscapeHtml(context.VtkVersion)
     << ", SoftShadows " << EscapeHtml(context.Version) << ".</p>\n"
     << "<p>Times are medians of frames in milliseconds, quartiles in brackets: with nothing "
        "moving, "
        "with the camera moving, with all lights moving (every map is baked anew). Errors are of "
        "the visibility in [0, 1] against ray tracing, without the pixels at silhouettes; PSNR in "
        "decibels. Contestants in bold are on the Pareto front of time (lights moving) and "
        "RMSE.</p>\n";
}

//--------------------------------------------------------------------------------------------------
void WriteTimes(std::ostream& os, const FrameTimes& times)
{
  os << "<td>" << FormatNumber(times.Median());
  if (times.Milliseconds.size() > 1)
  {
    os << " <span class=\"spread\">[" << FormatNumber(times.Quantile(0.25)) << ", "
       << FormatNumber(times.Quantile(0.75)) << "]</span>";
  }
  os << "</td>";
}

//--------------------------------------------------------------------------------------------------
std::int64_t CountOf(const ContestantResult& contestant, const std::string& name)
{
  for (const auto& count : contestant.Counts)
  {
    if (count.first == name)
    {
      return count.second;
    }
  }
  return -1;
}

//--------------------------------------------------------------------------------------------------
void WriteCount(std::ostream& os, std::int64_t count)
{
  os << "<td>" << (count < 0 ? "-" : std::to_string(count)) << "</td>";
}

//--------------------------------------------------------------------------------------------------
// Errors of one light; without a visibility every field is a dash.
void WriteErrors(std::ostream& os, const VisibilityErrors* errors)
{
  if (!errors)
  {
    for (int i = 0; i < 10; ++i)
    {
      os << "<td>-</td>";
    }
    return;
  }
  for (double value :
    { errors->All.Rmse, errors->Penumbra.Rmse, errors->All.Mean, errors->All.Percentile99,
      errors->All.Maximum, errors->All.Psnr, errors->All.Ssim, errors->Penumbra.Ssim })
  {
    os << "<td>" << FormatNumber(value) << "</td>";
  }
  WriteCount(os, errors->LightLeaks);
  WriteCount(os, errors->FalseShadows);
}

//--------------------------------------------------------------------------------------------------
void WriteContestant(std::ostream& os, const ContestantResult& contestant, bool isOnFront)
{
  os << "<tr" << (isOnFront ? " class=\"front\"" : "") << "><td>" << EscapeHtml(contestant.Name)
     << "</td>";
  if (!contestant.Failure.empty())
  {
    os << "<td class=\"failure\" colspan=\"17\">" << EscapeHtml(contestant.Failure)
       << "</td></tr>\n";
    return;
  }
  for (const FrameTimes& times : contestant.Times)
  {
    WriteTimes(os, times);
  }
  const size_t lights = std::max<size_t>(1, contestant.Errors.size());
  for (size_t light = 0; light < lights; ++light)
  {
    if (light > 0)
    {
      os << "<tr><td colspan=\"4\"></td>";
    }
    os << "<td>" << (contestant.HasErrors() ? std::to_string(light) : "-") << "</td>";
    WriteErrors(os, contestant.HasErrors() ? &contestant.Errors[light] : nullptr);
    for (const char* name : { "maps_baked", "pixels_filtered", "bytes_held" })
    {
      WriteCount(os, light == 0 ? CountOf(contestant, name) : -1);
    }
    os << "</tr>\n";
  }
}

//--------------------------------------------------------------------------------------------------
void WriteTable(std::ostream& os, const SceneResult& scene)
{
  os << "<div class=\"wide\"><table>\n<tr><th>contestant</th>";
  for (const char* name :
    { "still", "camera", "light", "light no.", "RMSE", "in penumbra", "mean", "99 %", "max", "PSNR",
      "SSIM", "in penumbra", "leaks", "false shadows", "maps baked", "pixels filtered", "bytes" })
  {
    os << "<th>" << name << "</th>";
  }
  os << "</tr>\n";
  const std::vector<const ContestantResult*> front = ParetoFront(scene);
  for (const ContestantResult& contestant : scene.Contestants)
  {
    WriteContestant(
      os, contestant, std::find(front.begin(), front.end(), &contestant) != front.end());
  }
  os << "</table></div>\n";
}

//--------------------------------------------------------------------------------------------------
void WriteSteps(std::ostream& os, const SceneResult& scene)
{
  std::vector<std::string> names;
  for (const ContestantResult& contestant : scene.Contestants)
  {
    for (const auto& step : contestant.Steps)
    {
      if (std::find(names.begin(), names.end(), step.first) == names.end())
      {
        names.push_back(step.first);
      }
    }
  }
  if (names.empty())
  {
    return;
  }
  os << "<h3>Milliseconds per step, lights moving</h3>\n<div class=\"wide\"><table>\n"
        "<tr><th>contestant</th>";
  for (const std::string& name : names)
  {
    os << "<th>" << EscapeHtml(name) << "</th>";
  }
  os << "</tr>\n";
  for (const ContestantResult& contestant : scene.Contestants)
  {
    if (contestant.Steps.empty())
    {
      continue;
    }
    os << "<tr><td>" << EscapeHtml(contestant.Name) << "</td>";
    for (const std::string& name : names)
    {
      const auto found = std::find_if(contestant.Steps.begin(), contestant.Steps.end(),
        [&name](const std::pair<std::string, double>& step) { return step.first == name; });
      os << "<td>" << (found == contestant.Steps.end() ? "-" : FormatNumber(found->second))
         << "</td>";
    }
    os << "</tr>\n";
  }
  os << "</table></div>\n";
}

//--------------------------------------------------------------------------------------------------
void WriteFigure(std::ostream& os, const ColorImage& image, const std::string& caption)
{
  if (!image.Pixels.empty())
  {
    os << "<figure><img alt=\"" << EscapeHtml(caption) << "\" src=\"" << EncodePngUrl(image)
       << "\"><figcaption>" << EscapeHtml(caption) << "</figcaption></figure>\n";
  }
}

//--------------------------------------------------------------------------------------------------
void WriteChart(std::ostream& os, const ChartDescription& chart)
{
  if (!chart.IsEmpty())
  {
    os << "<figure><img style=\"max-width: 100%\" alt=\"" << EscapeHtml(chart.Title) << "\" src=\""
       << EncodePngUrl(DrawChart(chart)) << "\"></figure>\n";
  }
}

//--------------------------------------------------------------------------------------------------
void WritePictures(std::ostream& os, const SceneResult& scene)
{
  os << "<h3>Pictures</h3>\n<p>Visibility of the first light, and its difference from the "
        "reference: blue too dark, red too bright, full colour at 0.25.</p>\n"
        "<div class=\"pictures\">\n";
  WriteFigure(os, scene.Reference, "reference");
  for (const ContestantResult& contestant : scene.Contestants)
  {
    WriteFigure(os, contestant.Picture, contestant.Name + ": picture");
    WriteFigure(os, contestant.Visibility, contestant.Name + ": visibility");
    WriteFigure(os, contestant.Difference, contestant.Name + ": difference");
  }
  os << "</div>\n";
}

//--------------------------------------------------------------------------------------------------
void WriteScene(std::ostream& os, const SceneResult& scene)
{
  os << "<h2>" << EscapeHtml(scene.Name) << "</h2>\n";
  if (!scene.Failure.empty())
  {
    os << "<p class=\"failure\">Broken: " << EscapeHtml(scene.Failure) << "</p>\n";
    return;
  }
  os << "<p>" << scene.Width << " x " << scene.Height << " pixels, " << scene.Actors << " actors, "
     << scene.Triangles << " triangles, " << scene.Lights << " lights; reference with "
     << scene.ReferenceSamples << " rays per pixel and light.</p>\n";
  WriteChart(os, SpeedAgainstError(scene));
  WriteTable(os, scene);
  WriteSteps(os, scene);
  for (const char* option : { "filter_width", "map_size", "samples" })
  {
    WriteChart(os, TimeAgainstOption(scene, option));
  }
  WritePictures(os, scene);
}

}

//--------------------------------------------------------------------------------------------------
std::string FormatNumber(double value)
{
  if (!std::isfinite(value))
  {
    return "-";
  }
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

//--------------------------------------------------------------------------------------------------
std::string EscapeHtml(const std::string& text)
{
  std::string escaped;
  for (char c : text)
  {
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

//--------------------------------------------------------------------------------------------------
void WriteHtml(std::ostream& os, const BenchmarkResults& results)
{
  os << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<title>Soft shadows: speed against error</title>\n<style>"
     << Style << "</style>\n</head>\n<body>\n<h1>Soft shadows: speed against error</h1>\n";
  WriteContext(os, results.Context);
  WriteChart(os, SpeedAgainstErrorOfAll(results));
  for (const SceneResult& scene : results.Scenes)
  {
    WriteScene(os, scene);
  }
  for (const char* family : { "actors", "triangles" })
  {
    WriteChart(os, TimeAgainstSize(results, family));
  }
  os << "</body>\n</html>\n";
}

}
