// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReport.h"

#include "ErrorReport.h"

#include <cmath>   // For std::isfinite
#include <ostream> // For the table

namespace softshadows
{
namespace
{

using Json = nlohmann::ordered_json;

//--------------------------------------------------------------------------------------------------
// What every entry of Google Benchmark's list has.
Json NewEntry(const std::string& name, size_t family, int repetitions)
{
  return { { "name", name }, { "family_index", family }, { "per_family_instance_index", 0 },
    { "run_name", name }, { "run_type", "iteration" }, { "repetitions", repetitions },
    { "threads", 1 } };
}

//--------------------------------------------------------------------------------------------------
void AppendTimes(const std::string& name, const ContestantResult& contestant,
  const FrameTimes& times, size_t family, Json& list)
{
  const int repetitions = static_cast<int>(times.Milliseconds.size());
  for (int i = 0; i < repetitions; ++i)
  {
    Json entry = NewEntry(name, family, repetitions);
    entry["repetition_index"] = i;
    entry["iterations"] = 1;
    entry["real_time"] = times.Milliseconds[i];
    entry["cpu_time"] = times.Milliseconds[i];
    entry["time_unit"] = "ms";
    if (contestant.HasErrors())
    {
      entry["rmse"] = contestant.Rmse;
    }
    list.push_back(entry);
  }
  const double deviation = times.StandardDeviation();
  const std::pair<const char*, double> aggregates[] = { { "mean", times.Mean() },
    { "median", times.Median() }, { "stddev", deviation }, { "cv", deviation / times.Mean() } };
  for (const auto& aggregate : aggregates)
  {
    Json entry = NewEntry(name, family, repetitions);
    const bool isShare = std::string(aggregate.first) == "cv";
    entry["name"] = name + "_" + aggregate.first;
    entry["run_type"] = "aggregate";
    entry["aggregate_name"] = aggregate.first;
    entry["aggregate_unit"] = isShare ? "percentage" : "time";
    entry["iterations"] = repetitions;
    entry["real_time"] = aggregate.second;
    entry["cpu_time"] = aggregate.second;
    entry["time_unit"] = "ms";
    list.push_back(entry);
  }
}

//--------------------------------------------------------------------------------------------------
Json ContestantToJson(const ContestantResult& contestant)
{
  Json json = { { "name", contestant.Name }, { "technique", contestant.Technique },
    { "options", contestant.Options } };
  if (!contestant.Failure.empty())
  {
    json["failure"] = contestant.Failure;
    return json;
  }
  for (Motion motion : AllMotions)
  {
    const FrameTimes& times = contestant.Times[static_cast<size_t>(motion)];
    if (!times.Milliseconds.empty())
    {
      json["milliseconds"][NameOf(motion)] = { { "median", times.Median() },
        { "quartile1", times.Quantile(0.25) }, { "quartile3", times.Quantile(0.75) },
        { "frames", times.Milliseconds.size() } };
    }
  }
  for (const auto& step : contestant.Steps)
  {
    json["steps"][step.first] = step.second;
  }
  for (const auto& count : contestant.Counts)
  {
    json["counts"][count.first] = count.second;
  }
  if (contestant.HasErrors())
  {
    json["rmse"] = contestant.Rmse;
    if (std::isfinite(contestant.RmseToHard))
    {
      json["rmse_to_hard"] = contestant.RmseToHard;
    }
    for (const VisibilityErrors& errors : contestant.Errors)
    {
      json["lights"].push_back(ToJson(errors));
    }
  }
  if (contestant.PictureErrors.Pixels > 0)
  {
    // The PSNR of equal pictures is infinite: null.
    json["picture"] = { { "rmse", contestant.PictureErrors.Rmse },
      { "psnr", contestant.PictureErrors.Psnr }, { "ssim", contestant.PictureErrors.Ssim } };
  }
  return json;
}

//--------------------------------------------------------------------------------------------------
Json SceneToJson(const SceneResult& scene)
{
  Json json = { { "name", scene.Name } };
  if (!scene.Failure.empty())
  {
    json["failure"] = scene.Failure;
    return json;
  }
  json["width"] = scene.Width;
  json["height"] = scene.Height;
  json["lights"] = scene.Lights;
  json["actors"] = scene.Actors;
  json["triangles"] = scene.Triangles;
  json["reference_samples"] = scene.ReferenceSamples;
  json["contestants"] = Json::array();
  for (const ContestantResult& contestant : scene.Contestants)
  {
    json["contestants"].push_back(ContestantToJson(contestant));
  }
  return json;
}

//--------------------------------------------------------------------------------------------------
// A field in quotes, if it needs them (RFC 4180).
std::string Quoted(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (char c : text)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

//--------------------------------------------------------------------------------------------------
void WriteNumber(std::ostream& os, double value)
{
  os << ',';
  if (std::isfinite(value))
  {
    os << value;
  }
}

//--------------------------------------------------------------------------------------------------
void WriteMeasures(std::ostream& os, const ErrorMeasures& measures)
{
  os << ',' << measures.Pixels;
  for (double value : { measures.Rmse, measures.Mean, measures.Bias, measures.Maximum,
         measures.Percentile99, measures.Psnr, measures.Ssim })
  {
    WriteNumber(os, value);
  }
}

//--------------------------------------------------------------------------------------------------
void WriteTimes(std::ostream& os, const ContestantResult& contestant)
{
  for (const FrameTimes& times : contestant.Times)
  {
    for (double share : { 0.5, 0.25, 0.75 })
    {
      WriteNumber(os, times.Quantile(share));
    }
  }
}

}

//--------------------------------------------------------------------------------------------------
Json ToJson(const BenchmarkContext& context)
{
  return { { "date", context.Date }, { "host_name", context.Host },
    { "executable", "softshadow benchmark" }, { "num_cpus", context.Processors },
    { "cpu_scaling_enabled", false }, { "library_build_type", "release" },
    { "processor", context.Processor }, { "opengl", context.Renderer },
    { "vtk", context.VtkVersion }, { "softshadows", context.Version } };
}

//--------------------------------------------------------------------------------------------------
Json ToJson(const BenchmarkResults& results)
{
  Json list = Json::array();
  Json scenes = Json::array();
  size_t family = 0;
  for (const SceneResult& scene : results.Scenes)
  {
    scenes.push_back(SceneToJson(scene));
    for (const ContestantResult& contestant : scene.Contestants)
    {
      for (Motion motion : AllMotions)
      {
        const FrameTimes& times = contestant.Times[static_cast<size_t>(motion)];
        if (!times.Milliseconds.empty())
        {
          const std::string name = scene.Name + '/' + contestant.Name + '/' + NameOf(motion);
          AppendTimes(name, contestant, times, family++, list);
        }
      }
    }
  }
  return { { "context", ToJson(results.Context) }, { "benchmarks", list },
    { "soft_shadows", { { "scenes", scenes } } } };
}

//--------------------------------------------------------------------------------------------------
void WriteCsv(std::ostream& os, const BenchmarkResults& results)
{
  os << "scene,contestant,failure";
  for (Motion motion : AllMotions)
  {
    const std::string name = NameOf(motion);
    os << ',' << name << "_ms," << name << "_ms_q1," << name << "_ms_q3";
  }
  os << ",light";
  for (const char* set : { "", "penumbra_" })
  {
    for (const char* name : { "pixels", "rmse", "mean", "bias", "maximum", "p99", "psnr", "ssim" })
    {
      os << ',' << set << name;
    }
  }
  os << ",light_leaks,false_shadows,left_out\n";
  os.precision(9);
  for (const SceneResult& scene : results.Scenes)
  {
    if (!scene.Failure.empty())
    {
      os << Quoted(scene.Name) << ",," << Quoted(scene.Failure) << std::string(29, ',') << '\n';
    }
    for (const ContestantResult& contestant : scene.Contestants)
    {
      for (size_t light = 0; light < std::max<size_t>(1, contestant.Errors.size()); ++light)
      {
        os << Quoted(scene.Name) << ',' << Quoted(contestant.Name) << ','
           << Quoted(contestant.Failure);
        WriteTimes(os, contestant);
        if (!contestant.HasErrors())
        {
          os << std::string(20, ',') << '\n';
          continue;
        }
        const VisibilityErrors& errors = contestant.Errors[light];
        os << ',' << light;
        WriteMeasures(os, errors.All);
        WriteMeasures(os, errors.Penumbra);
        os << ',' << errors.LightLeaks << ',' << errors.FalseShadows << ',' << errors.LeftOut
           << '\n';
      }
    }
  }
}

}
