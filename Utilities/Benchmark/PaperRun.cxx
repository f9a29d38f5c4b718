// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PaperRun.h"

#include "HtmlReport.h"
#include "SceneChanges.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm> // For the scene by name
#include <cmath>     // For NaN
#include <iomanip>   // For differences
#include <limits>    // For NaN
#include <ostream>   // For the table
#include <sstream>   // For cells

namespace softshadows
{
namespace
{

/// Seconds; a frame that takes longer is timed once, of a table that says how many frames it wants.
constexpr double LongestOfFew = 1.0;
constexpr double None = std::numeric_limits<double>::quiet_NaN();

//--------------------------------------------------------------------------------------------------
// The table's scene at the table's size.
BenchmarkScene FindScene(const PaperTable& table, const std::vector<BenchmarkScene>& scenes)
{
  BenchmarkScene scene;
  scene.Name = table.Scene;
  scene.Failure = "there is no scene " + table.Scene;
  const auto found = std::find_if(scenes.begin(), scenes.end(),
    [&table](const BenchmarkScene& candidate) { return candidate.Name == table.Scene; });
  if (found != scenes.end())
  {
    scene = *found;
    const SceneFactory make = found->Make;
    const double scale = table.LightScale;
    scene.Make = [make, scale]
    {
      vtkSmartPointer<vtkRenderer> renderer = make();
      ScaleLights(renderer, scale);
      return renderer;
    };
  }
  scene.Width = table.Width;
  scene.Height = table.Height;
  return scene;
}

//--------------------------------------------------------------------------------------------------
BenchmarkRunner MakeRunner(const PaperTable& table, const BenchmarkRunner& runner)
{
  BenchmarkSettings settings = runner.GetSettings();
  settings.Motions = { Motion::Light };
  settings.HasTruth = table.HasTruth;
  settings.Gaussian = table.Gaussian;
  settings.Pictures = false;
  if (table.Frames > 0)
  {
    settings.Rounds = table.Frames;
    settings.SecondsPerScene = 0.0;
    settings.LongestFrame = LongestOfFew;
  }
  settings.JudgesPictures = std::any_of(table.Columns.begin(), table.Columns.end(),
    [](const PaperColumn& column)
    {
      return column.Figure == PaperFigure::PictureRmse ||
        column.Figure == PaperFigure::PicturePsnr ||
        column.Figure == PaperFigure::PictureSsimPercent;
    });
  BenchmarkRunner own = runner;
  own.SetSettings(settings);
  return own;
}

//--------------------------------------------------------------------------------------------------
std::vector<ContestantChoice> GetChoices(const PaperTable& table)
{
  std::vector<ContestantChoice> choices;
  for (const PaperRow& row : table.Rows)
  {
    choices.push_back(row.Choice);
  }
  return choices;
}

//--------------------------------------------------------------------------------------------------
double SumSteps(const PaperColumn& column, const ContestantResult& contestant)
{
  double sum = 0.0;
  bool hasAny = false;
  for (const auto& step : contestant.Steps)
  {
    if (std::find(column.Steps.begin(), column.Steps.end(), step.first) != column.Steps.end())
    {
      sum += step.second;
      hasAny = true;
    }
  }
  return hasAny ? sum : None;
}

//--------------------------------------------------------------------------------------------------
double SumCounts(const std::vector<std::string>& names, const ContestantResult& contestant)
{
  double sum = 0.0;
  bool hasAny = false;
  for (const auto& count : contestant.Counts)
  {
    if (std::find(names.begin(), names.end(), count.first) != names.end())
    {
      sum += static_cast<double>(count.second);
      hasAny = true;
    }
  }
  return hasAny ? sum : None;
}

//--------------------------------------------------------------------------------------------------
double PublishedIn(const PaperColumn& column, size_t row)
{
  return row < column.Published.size() ? column.Published[row] : None;
}

//--------------------------------------------------------------------------------------------------
// "1.52" for ratios, "+1.52" for differences, "-" if one is missing.
std::string Relate(PaperFigure figure, double value, double base)
{
  const bool isDifference = IsComparedByDifference(figure);
  const double relation = isDifference ? value - base : value / base;
  if (!std::isfinite(relation))
  {
    return "-";
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << (isDifference ? std::showpos : std::noshowpos)
       << relation;
  return text.str();
}

//--------------------------------------------------------------------------------------------------
// With many figures each has one cell: "published / measured (ratio / ratio)".
bool IsCompact(const PaperTable& table)
{
  return std::count_if(table.Columns.begin(), table.Columns.end(),
           [](const PaperColumn& column) { return !column.Published.empty(); }) > 2;
}

//--------------------------------------------------------------------------------------------------
void WriteHeads(std::ostream& os, const PaperTable& table)
{
  os << "| |";
  std::string rule = "| :--- |";
  for (const PaperColumn& column : table.Columns)
  {
    os << ' ' << column.Title;
    rule += " ---: |";
    if (!column.Published.empty() && !IsCompact(table))
    {
      const std::string relation = IsComparedByDifference(column.Figure) ? "difference" : "ratio";
      os << ": published | measured | " << relation << " published | " << relation << " measured";
      rule += " ---: | ---: | ---: |";
    }
    os << " |";
  }
  os << '\n' << rule << '\n';
}

//--------------------------------------------------------------------------------------------------
void WriteRow(std::ostream& os, const PaperResult& result, size_t row)
{
  const PaperTable& table = result.Table;
  const ContestantResult& contestant = result.Scene.Contestants[row];
  const ContestantResult& base = result.Scene.Contestants[table.Base];
  os << "| " << table.Rows[row].Label;
  if (!contestant.Failure.empty())
  {
    os << " (" << contestant.Failure << ')';
  }
  os << " |";
  for (const PaperColumn& column : table.Columns)
  {
    const double measured = MeasureFigure(column, contestant);
    if (!column.Published.empty())
    {
      const double published = PublishedIn(column, row);
      const bool isCompact = IsCompact(table);
      os << ' ' << FormatNumber(published) << (isCompact ? " / " : " | ") << FormatNumber(measured)
         << (isCompact ? " (" : " | ")
         << Relate(column.Figure, published, PublishedIn(column, table.Base))
         << (isCompact ? " / " : " | ")
         << Relate(column.Figure, measured, MeasureFigure(column, base))
         << (isCompact ? ") |" : " |");
    }
    else
    {
      os << ' ' << FormatNumber(measured) << " |";
    }
  }
  os << '\n';
}

}

//--------------------------------------------------------------------------------------------------
double WorkOf(const PaperTable& table)
{
  double pixels = 0.0;
  for (const PaperRow& row : table.Rows)
  {
    const auto factor = row.Choice.Options.find("supersample");
    const double edge = factor == row.Choice.Options.end() ? 1.0 : std::stod(factor->second);
    pixels += edge * edge * table.Width * table.Height;
  }
  // Maps cost whatever the size of the picture is.
  return pixels + 2e5 * static_cast<double>(table.Rows.size());
}

//--------------------------------------------------------------------------------------------------
double MeasureFigure(const PaperColumn& column, const ContestantResult& contestant)
{
  const double frame = contestant.Times[static_cast<size_t>(Motion::Light)].Median();
  const bool hasPicture = contestant.PictureErrors.Pixels > 0;
  const ErrorMeasures* first = contestant.HasErrors() ? &contestant.Errors.front().All : nullptr;
  switch (column.Figure)
  {
    case PaperFigure::FramesPerSecond:
      return 1000.0 / frame;
    case PaperFigure::Milliseconds:
      return frame;
    case PaperFigure::Step:
      return SumSteps(column, contestant);
    case PaperFigure::Rmse:
      return first ? first->Rmse : None;
    case PaperFigure::RmseToFirst:
      return contestant.RmseToFirst;
    case PaperFigure::Psnr:
      return first ? first->Psnr : None;
    case PaperFigure::SsimPercent:
      return first ? 100.0 * first->Ssim : None;
    case PaperFigure::PictureRmse:
      return hasPicture ? contestant.PictureErrors.Rmse : None;
    case PaperFigure::PicturePsnr:
      return hasPicture ? contestant.PictureErrors.Psnr : None;
    case PaperFigure::PictureSsimPercent:
      return hasPicture ? 100.0 * contestant.PictureErrors.Ssim : None;
    case PaperFigure::Megabytes:
      return SumCounts({ "bytes_held" }, contestant) / (1024.0 * 1024.0);
    case PaperFigure::Count:
      return SumCounts(column.Steps, contestant);
  }
  return None;
}

//--------------------------------------------------------------------------------------------------
PaperResult RunPaperTable(
  const PaperTable& table, const std::vector<BenchmarkScene>& scenes, const BenchmarkRunner& runner)
{
  return { table, MakeRunner(table, runner).Run(FindScene(table, scenes), GetChoices(table)) };
}

//--------------------------------------------------------------------------------------------------
bool PreparePaperTable(
  const PaperTable& table, const std::vector<BenchmarkScene>& scenes, const BenchmarkRunner& runner)
{
  return !table.HasTruth ||
    MakeRunner(table, runner).Prepare(FindScene(table, scenes), GetChoices(table));
}

//--------------------------------------------------------------------------------------------------
void WritePaperMarkdown(std::ostream& os, const PaperResult& result)
{
  const PaperTable& table = result.Table;
  os << "### " << table.Title << "\n\n"
     << table.Width << " x " << table.Height << " pixels, scene " << table.Scene << ".";
  if (table.Rows.size() > 1)
  {
    os << " Ratios and differences are to \"" << table.Rows[table.Base].Label << "\".";
  }
  os << (IsCompact(table) ? " Cells: published / measured (ratio published / measured)." : "")
     << (table.Remark.empty() ? "" : " ") << table.Remark << "\n\n";
  if (!result.Scene.Failure.empty())
  {
    os << "Not measured: " << result.Scene.Failure << "\n\n";
    return;
  }
  WriteHeads(os, table);
  for (size_t row = 0; row < table.Rows.size(); ++row)
  {
    WriteRow(os, result, row);
  }
  os << '\n';
}

//--------------------------------------------------------------------------------------------------
nlohmann::ordered_json ToJson(const PaperResult& result)
{
  const PaperTable& table = result.Table;
  nlohmann::ordered_json json = { { "title", table.Title }, { "scene", table.Scene },
    { "width", table.Width }, { "height", table.Height },
    { "rows", nlohmann::ordered_json::array() } };
  if (!result.Scene.Failure.empty())
  {
    json["failure"] = result.Scene.Failure;
    return json;
  }
  for (size_t row = 0; row < table.Rows.size(); ++row)
  {
    const ContestantResult& contestant = result.Scene.Contestants[row];
    nlohmann::ordered_json entry = { { "label", table.Rows[row].Label },
      { "contestant", contestant.Name },
      { "frames", contestant.Times[static_cast<size_t>(Motion::Light)].Milliseconds.size() } };
    if (!contestant.Failure.empty())
    {
      entry["failure"] = contestant.Failure;
    }
    for (const PaperColumn& column : table.Columns)
    {
      // Numbers that are not finite become null.
      entry["figures"].push_back(
        { { "column", column.Title }, { "published", PublishedIn(column, row) },
          { "measured", MeasureFigure(column, contestant) } });
    }
    json["rows"].push_back(entry);
  }
  return json;
}

}
