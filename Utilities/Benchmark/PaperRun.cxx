// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTables.h"

#include "vtkAreaLight.h"

#include <vtkLightCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm> // For the scene by name
#include <cmath>     // For NaN
#include <iomanip>   // For columns
#include <limits>    // For NaN
#include <ostream>   // For the table
#include <sstream>   // For cells

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
void ScaleLights(vtkRenderer* renderer, double scale)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (auto* area = vtkAreaLight::SafeDownCast(light))
    {
      area->SetSize(scale * area->GetSize()[0], scale * area->GetSize()[1]);
      area->SetAngularDiameter(scale * area->GetAngularDiameter());
    }
  }
}

//--------------------------------------------------------------------------------------------------
// The row's scene at the table's size.
BenchmarkScene FindScene(
  const PaperTable& table, const PaperRow& row, const std::vector<BenchmarkScene>& scenes)
{
  BenchmarkScene scene;
  scene.Name = row.Scene;
  scene.Failure = "there is no scene " + row.Scene;
  const auto found = std::find_if(scenes.begin(), scenes.end(),
    [&row](const BenchmarkScene& candidate) { return candidate.Name == row.Scene; });
  if (found != scenes.end())
  {
    scene = *found;
    const SceneFactory make = found->Make;
    const double scale = row.LightScale;
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
double Measure(PaperFigure figure, const ContestantResult& result)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  switch (figure)
  {
    case PaperFigure::FramesPerSecond:
      return 1000.0 / result.Times[static_cast<size_t>(Motion::Light)].Median();
    case PaperFigure::Psnr:
      return result.HasErrors() ? result.Errors.front().All.Psnr : none;
    default:
      return result.HasErrors() ? 100.0 * result.Errors.front().All.Ssim : none;
  }
}

//--------------------------------------------------------------------------------------------------
// "1.52" for ratios, "+1.52" for differences, "-" if one is missing.
std::string Relate(PaperFigure figure, double value, double base)
{
  const bool isRatio = figure == PaperFigure::FramesPerSecond;
  const double relation = isRatio ? value / base : value - base;
  if (!std::isfinite(relation) || (isRatio && relation == 0.0))
  {
    return "-";
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << (isRatio ? std::noshowpos : std::showpos)
       << relation;
  return text.str();
}

//--------------------------------------------------------------------------------------------------
std::string ShowFigure(double value)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return std::isfinite(value) && value > 0.0 ? text.str() : "-";
}

}

//--------------------------------------------------------------------------------------------------
void RunPaperTable(std::ostream& os, const PaperTable& table,
  const std::vector<BenchmarkScene>& scenes, const BenchmarkRunner& runner)
{
  // All rows of a table are of one scene and one light, so that their frames are interleaved.
  std::vector<ContestantChoice> choices;
  for (const PaperRow& row : table.Rows)
  {
    choices.push_back(row.Choice);
  }
  const SceneResult result = runner.Run(FindScene(table, table.Rows.front(), scenes), choices);
  const bool isRatio = table.Figure == PaperFigure::FramesPerSecond;
  os << table.Title << "\n(" << table.Width << " x " << table.Height << ", scene "
     << table.Rows.front().Scene << "; " << (isRatio ? "ratio" : "difference")
     << " to the first row)\n"
     << std::left << std::setw(36) << "" << std::right << std::setw(12) << "published"
     << std::setw(12) << "measured" << std::setw(12) << "published" << std::setw(12) << "measured"
     << '\n';
  if (!result.Failure.empty())
  {
    os << "  " << result.Failure << "\n\n";
    return;
  }
  const double base = Measure(table.Figure, result.Contestants.front());
  for (size_t i = 0; i < table.Rows.size(); ++i)
  {
    const PaperRow& row = table.Rows[i];
    const ContestantResult& contestant = result.Contestants[i];
    os << "  " << std::left << std::setw(34) << row.Label << std::right << std::setw(12)
       << ShowFigure(row.Published);
    if (!contestant.Failure.empty())
    {
      os << "  " << contestant.Failure << '\n';
      continue;
    }
    const double measured = Measure(table.Figure, contestant);
    os << std::setw(12) << ShowFigure(measured) << std::setw(12)
       << Relate(table.Figure, row.Published, table.Rows.front().Published) << std::setw(12)
       << Relate(table.Figure, measured, base) << '\n';
  }
  os << '\n' << std::flush;
}

}
