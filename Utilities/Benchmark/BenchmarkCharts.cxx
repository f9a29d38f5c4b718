// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkCharts.h"

#include <algorithm> // For sorting
#include <cmath>     // For means
#include <cstdlib>   // For numbers in options
#include <limits>    // For the front
#include <tuple>     // For points in order

namespace softshadows
{
namespace
{

const std::string TimeLabel = "ms per frame, lights moving (median)";

using Points = std::vector<std::pair<double, double>>;

//--------------------------------------------------------------------------------------------------
double TimeOf(const ContestantResult& contestant)
{
  return contestant.Times[static_cast<size_t>(Motion::Light)].Median();
}

//--------------------------------------------------------------------------------------------------
bool HasTime(const ContestantResult& contestant)
{
  return !contestant.Times[static_cast<size_t>(Motion::Light)].Milliseconds.empty();
}

//--------------------------------------------------------------------------------------------------
ChartSeries ToSeries(const std::string& name, Points points)
{
  std::sort(points.begin(), points.end());
  ChartSeries series;
  series.Name = name;
  for (const auto& point : points)
  {
    series.X.push_back(point.first);
    series.Y.push_back(point.second);
  }
  return series;
}

//--------------------------------------------------------------------------------------------------
// In the order in which names come first.
class SeriesList
{
public:
  void Add(const std::string& name, double x, double y)
  {
    auto found = std::find_if(this->List.begin(), this->List.end(),
      [&name](const std::pair<std::string, Points>& series) { return series.first == name; });
    if (found == this->List.end())
    {
      found = this->List.emplace(this->List.end(), name, Points());
    }
    found->second.emplace_back(x, y);
  }

  void MoveTo(std::vector<ChartSeries>& all, size_t fewestPoints)
  {
    for (auto& series : this->List)
    {
      if (series.second.size() >= fewestPoints)
      {
        all.push_back(ToSeries(series.first, std::move(series.second)));
      }
    }
  }

private:
  std::vector<std::pair<std::string, Points>> List;
};

//--------------------------------------------------------------------------------------------------
std::string NameWithout(const ContestantResult& contestant, const std::string& option)
{
  std::string name = contestant.Technique;
  for (const auto& other : contestant.Options)
  {
    // Uniform weights are everybody's; the widths of search and filter grow together.
    const bool isImplied =
      other.first == "weights" || (option == "filter_width" && other.first == "search_width");
    if (other.first != option && !isImplied)
    {
      name += ' ' + other.first + '=' + other.second;
    }
  }
  return name;
}

//--------------------------------------------------------------------------------------------------
// Sums of the logarithms of time and error, in the entry of the contestant's name.
void AddLogarithms(const ContestantResult& contestant, std::vector<ContestantResult>& sums)
{
  auto found = std::find_if(sums.begin(), sums.end(),
    [&contestant](const ContestantResult& sum) { return sum.Name == contestant.Name; });
  if (found == sums.end())
  {
    ContestantResult sum;
    sum.Name = contestant.Name;
    sum.Technique = contestant.Technique;
    sum.Options = contestant.Options;
    sum.Errors.resize(1);
    sum.Times[static_cast<size_t>(Motion::Light)].Milliseconds = { 0.0 };
    found = sums.insert(sums.end(), sum);
  }
  found->Times[static_cast<size_t>(Motion::Light)].Milliseconds.front() +=
    std::log(TimeOf(contestant));
  found->Rmse += std::log(contestant.Rmse);
}

}

//--------------------------------------------------------------------------------------------------
std::vector<const ContestantResult*> ParetoFront(const SceneResult& scene)
{
  std::vector<const ContestantResult*> candidates;
  for (const ContestantResult& contestant : scene.Contestants)
  {
    if (contestant.HasErrors() && HasTime(contestant))
    {
      candidates.push_back(&contestant);
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [](const ContestantResult* a, const ContestantResult* b)
    { return std::make_tuple(TimeOf(*a), a->Rmse) < std::make_tuple(TimeOf(*b), b->Rmse); });
  std::vector<const ContestantResult*> front;
  double least = std::numeric_limits<double>::infinity();
  for (const ContestantResult* candidate : candidates)
  {
    if (candidate->Rmse < least)
    {
      least = candidate->Rmse;
      front.push_back(candidate);
    }
  }
  return front;
}

//--------------------------------------------------------------------------------------------------
ChartDescription SpeedAgainstError(const SceneResult& scene)
{
  ChartDescription chart;
  chart.Title = scene.Name + ": speed against error";
  chart.XLabel = TimeLabel;
  chart.YLabel = "RMSE of the visibility";
  ChartSeries front;
  front.Name = "Pareto front";
  front.IsFront = true;
  for (const ContestantResult* contestant : ParetoFront(scene))
  {
    front.X.push_back(TimeOf(*contestant));
    front.Y.push_back(contestant->Rmse);
  }
  chart.Series.push_back(front);
  SeriesList list;
  for (const ContestantResult& contestant : scene.Contestants)
  {
    if (contestant.HasErrors() && HasTime(contestant))
    {
      list.Add(contestant.Technique, TimeOf(contestant), contestant.Rmse);
    }
  }
  list.MoveTo(chart.Series, 1);
  return chart;
}

//--------------------------------------------------------------------------------------------------
ChartDescription SpeedAgainstErrorOfAll(const BenchmarkResults& results)
{
  SceneResult mean;
  mean.Name = "all scenes, geometric means";
  std::map<std::string, int> counts;
  int scenes = 0;
  for (const SceneResult& scene : results.Scenes)
  {
    const bool grows =
      scene.Name.rfind("actors-", 0) == 0 || scene.Name.rfind("triangles-", 0) == 0;
    if (grows || !scene.Failure.empty())
    {
      continue;
    }
    ++scenes;
    for (const ContestantResult& contestant : scene.Contestants)
    {
      if (contestant.HasErrors() && HasTime(contestant) && contestant.Rmse > 0.0)
      {
        AddLogarithms(contestant, mean.Contestants);
        ++counts[contestant.Name];
      }
    }
  }
  std::vector<ContestantResult> complete;
  for (ContestantResult& contestant : mean.Contestants)
  {
    if (counts[contestant.Name] == scenes)
    {
      double& time = contestant.Times[static_cast<size_t>(Motion::Light)].Milliseconds.front();
      time = std::exp(time / scenes);
      contestant.Rmse = std::exp(contestant.Rmse / scenes);
      complete.push_back(contestant);
    }
  }
  mean.Contestants = complete;
  return SpeedAgainstError(mean);
}

//--------------------------------------------------------------------------------------------------
ChartDescription TimeAgainstOption(const SceneResult& scene, const std::string& option)
{
  ChartDescription chart;
  chart.Title = scene.Name + ": time against " + option;
  chart.XLabel = option;
  chart.YLabel = TimeLabel;
  SeriesList list;
  for (const ContestantResult& contestant : scene.Contestants)
  {
    const auto value = contestant.Options.find(option);
    if (value != contestant.Options.end() && HasTime(contestant))
    {
      list.Add(NameWithout(contestant, option), std::strtod(value->second.c_str(), nullptr),
        TimeOf(contestant));
    }
  }
  list.MoveTo(chart.Series, 2);
  return chart;
}

//--------------------------------------------------------------------------------------------------
ChartDescription TimeAgainstSize(const BenchmarkResults& results, const std::string& family)
{
  ChartDescription chart;
  chart.Title = "Time against " + family;
  chart.XLabel = family;
  chart.YLabel = TimeLabel;
  SeriesList list;
  for (const SceneResult& scene : results.Scenes)
  {
    if (scene.Name.rfind(family + "-", 0) != 0)
    {
      continue;
    }
    const double size = family == "actors" ? scene.Actors : static_cast<double>(scene.Triangles);
    for (const ContestantResult& contestant : scene.Contestants)
    {
      if (HasTime(contestant))
      {
        list.Add(contestant.Name, size, TimeOf(contestant));
      }
    }
  }
  list.MoveTo(chart.Series, 2);
  return chart;
}

}
