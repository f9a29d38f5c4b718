// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameReport.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace softshadows
{
namespace
{

using Json = nlohmann::ordered_json;

Json ReportOptions(const Technique& technique, vtkSoftShadowPass* pass)
{
  Json options = Json::object();
  for (const TechniqueOption& option : technique.Options)
  {
    const double value = option.Get(pass);
    switch (option.Is)
    {
      case TechniqueOption::Kind::Integer:
        options[option.Name] = static_cast<long long>(value);
        break;
      case TechniqueOption::Kind::Number:
        options[option.Name] = value;
        break;
      case TechniqueOption::Kind::Flag:
        options[option.Name] = value != 0.0;
        break;
      case TechniqueOption::Kind::Choice:
        options[option.Name] = option.Spell(value);
        break;
    }
  }
  return options;
}

}

//--------------------------------------------------------------------------------------------------
std::string ReportFrame(
  const std::vector<std::string>& inputs, const Technique& technique, const SceneFrame& frame)
{
  vtkSoftShadowPass* pass = frame.GetPass();
  const vtkSoftShadowStatistics& statistics = pass->GetStatistics();
  Json steps = Json::object();
  for (const auto& [name, milliseconds] : statistics.Milliseconds)
  {
    steps[name] = milliseconds;
  }
  Json counts = Json::object();
  for (const auto& [name, count] : statistics.GetCounts())
  {
    counts[name] = count;
  }
  Json lights = Json::array();
  std::istringstream lines(pass->GetLightReport());
  for (std::string line; std::getline(lines, line);)
  {
    lights.push_back(line);
  }

  Json report = {
    { "inputs", inputs },
    { "technique", technique.Name },
    { "options", ReportOptions(technique, pass) },
    { "image", { { "width", frame.GetWidth() }, { "height", frame.GetHeight() } } },
    { "frame_milliseconds", frame.GetMilliseconds() },
    { "step_milliseconds", steps },
    { "counts", counts },
    { "lights", lights },
    { "driver", frame.GetDriver() },
  };
  if (pass->GetProgressive())
  {
    report["converge"] = { { "tolerance", pass->GetProgressiveTolerance() },
      { "converged", pass->GetConverged() }, { "estimated_error", pass->GetEstimatedError() },
      { "frames", statistics.Frames }, { "points", statistics.ProgressivePoints },
      { "report", pass->GetProgressReport() } };
  }
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}
