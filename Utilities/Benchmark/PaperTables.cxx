// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTables.h"

#include <sstream>   // For option texts
#include <stdexcept> // For unknown names

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
// "pcss filter_width=21"
ContestantChoice Choose(const std::string& text)
{
  std::istringstream words(text);
  ContestantChoice choice;
  words >> choice.Technique;
  std::string word;
  while (words >> word)
  {
    const size_t equals = word.find('=');
    choice.Options[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return choice;
}

//--------------------------------------------------------------------------------------------------
PaperRow Row(const std::string& label, const std::string& choice, double published,
  const std::string& scene, double lightScale = 1.0)
{
  return { label, Choose(choice), published, scene, lightScale };
}

//--------------------------------------------------------------------------------------------------
// Fernando 2005, last section: 36 samples for the search, 64 for the filter.
std::vector<PaperTable> GetPcss()
{
  return { { "Fernando 2005, percentage-closer soft shadows", PaperFigure::FramesPerSecond, 640,
    480,
    { Row("36 + 64 samples", "pcss search_width=6 filter_width=8 map_size=1024", 75.0, "bunny"),
      Row(
        "hard shadow (no figure published)", "sampled samples=1 map_size=1024", 0.0, "bunny") } } };
}

//--------------------------------------------------------------------------------------------------
// Buades, Gumbau, Chover 2015, tables 2, 4 and 6; alpha = beta.
std::vector<PaperTable> GetSssm()
{
  const std::string scene = "foliage";
  const std::string gaussian = " weights=gaussian map_size=1024";
  const std::string kernels[] = { " search_width=29 filter_width=41",
    " search_width=11 filter_width=21", " search_width=7 filter_width=15" };
  const std::string names[] = { " 29/41", " 11/21", " 7/15" };
  const std::string thresholds[] = { "0.01", "0.10", "0.15", "0.20", "0.50" };
  const double pcss[] = { 4.85, 23.90, 47.52 };
  const double ssabss[] = { 6.74, 37.55, 81.75 };
  const double sssm[][3] = { { 9.15, 17.81, 39.59 }, { 15.67, 28.80, 48.36 },
    { 17.90, 31.50, 49.34 }, { 19.20, 33.52, 49.71 }, { 21.88, 34.75, 51.12 } };

  PaperTable speed{ "Buades et al. 2015, table 4: frames per second", PaperFigure::FramesPerSecond,
    1280, 960, {} };
  for (int k = 0; k < 3; ++k)
  {
    speed.Rows.push_back(Row("PCSS" + names[k], "pcss" + gaussian + kernels[k], pcss[k], scene));
  }
  for (int k = 0; k < 3; ++k)
  {
    speed.Rows.push_back(
      Row("SSABSS" + names[k], "ssabss beta=0.01" + gaussian + kernels[k], ssabss[k], scene));
  }
  for (int t = 0; t < 5; ++t)
  {
    const std::string options = " alpha=" + thresholds[t] + " beta=" + thresholds[t];
    for (int k = 0; k < 3; ++k)
    {
      speed.Rows.push_back(Row("SSSM " + thresholds[t] + names[k],
        "sssm" + options + gaussian + kernels[k], sssm[t][k], scene));
    }
  }

  const std::string mean = " weights=mean map_size=1024" + kernels[0];
  const double psnr[][2] = { { 31.23, 30.82 }, { 28.57, 26.68 }, { 27.93, 25.89 }, { 27.79, 25.71 },
    { 27.78, 25.73 } };
  const double ssim[][2] = { { 98.05, 97.44 }, { 97.11, 95.81 }, { 96.84, 95.38 }, { 96.79, 95.31 },
    { 96.80, 95.41 } };
  std::vector<PaperTable> tables = { speed };
  for (int large = 0; large < 2; ++large)
  {
    const double scale = large ? 2.5 : 1.0;
    const std::string size = large ? ", light size 0.10" : ", light size 0.04";
    PaperTable decibels{ "Buades et al. 2015, table 6: PSNR in dB" + size, PaperFigure::Psnr, 640,
      480, { Row("PCSS", "pcss" + mean, large ? 34.30 : 35.15, scene, scale) } };
    PaperTable percent{ "Buades et al. 2015, table 6: SSIM in percent" + size,
      PaperFigure::SsimPercent, 640, 480,
      { Row("PCSS", "pcss" + mean, large ? 98.72 : 99.14, scene, scale) } };
    for (int t = 0; t < 5; ++t)
    {
      const std::string choice = "sssm alpha=" + thresholds[t] + " beta=" + thresholds[t] + mean;
      decibels.Rows.push_back(Row("SSSM " + thresholds[t], choice, psnr[t][large], scene, scale));
      percent.Rows.push_back(Row("SSSM " + thresholds[t], choice, ssim[t][large], scene, scale));
    }
    tables.push_back(decibels);
    tables.push_back(percent);
  }
  return tables;
}

//--------------------------------------------------------------------------------------------------
// Zerari et al. 2023: 44 to 51 % faster than SBFS with 25 maps; the middle of both.
std::vector<PaperTable> GetCascaded()
{
  return { { "Zerari et al. 2023: frames per second against 25 maps", PaperFigure::FramesPerSecond,
    800, 600,
    { Row("SBFS, 25 maps (published: 1)", "sbfs samples=25 map_size=1024", 1.0, "street"),
      Row("cascaded, 16 + 9 + 4 samples", "cascaded map_size=1024", 1.475, "street") } } };
}

//--------------------------------------------------------------------------------------------------
// Ali, Kolivand, Sunar 2016, table 1.
std::vector<PaperTable> GetSbfs()
{
  const std::string sizes[] = { "1024", "512", "256" };
  const std::string samples[] = { "3", "5", "15" };
  const double fps[][3] = { { 126, 94, 57 }, { 237, 181, 72 }, { 316, 223, 108 } };
  PaperTable table{ "Ali et al. 2016, table 1, bunny: frames per second",
    PaperFigure::FramesPerSecond, 640, 480, {} };
  for (int size = 0; size < 3; ++size)
  {
    for (int n = 0; n < 3; ++n)
    {
      table.Rows.push_back(Row("map " + sizes[size] + ", " + samples[n] + " samples",
        "sbfs map_size=" + sizes[size] + " samples=" + samples[n], fps[size][n], "bunny"));
    }
  }
  return { table };
}

//--------------------------------------------------------------------------------------------------
// Shen et al. 2011, table 2: light sizes 10 and 80.
std::vector<PaperTable> GetPvssm()
{
  const std::string scene = "foliage";
  std::vector<PaperTable> tables;
  for (int large = 0; large < 2; ++large)
  {
    const double scale = large ? 4.0 : 0.5; // the published lights differ by a factor of 8
    tables.push_back({ std::string("Shen et al. 2011, table 2, light size ") +
        (large ? "80" : "10") + ": frames per second",
      PaperFigure::FramesPerSecond, 1024, 1024,
      { Row("fixed 4096", "pvssm adaptive=off map_size=4096", large ? 7.30 : 16.82, scene, scale),
        Row("adaptive", "pvssm adaptive=on", large ? 21.62 : 12.33, scene, scale),
        Row("mean of 64 hard shadows, 4096", "sampled samples=64 map_size=4096",
          large ? 0.61 : 0.60, scene, scale) } });
  }
  return tables;
}

}

//--------------------------------------------------------------------------------------------------
std::vector<PaperTable> GetPaperTables(const std::string& paper)
{
  if (paper == "pcss")
  {
    return GetPcss();
  }
  if (paper == "sssm")
  {
    return GetSssm();
  }
  if (paper == "cascaded")
  {
    return GetCascaded();
  }
  if (paper == "sbfs")
  {
    return GetSbfs();
  }
  if (paper == "pvssm")
  {
    return GetPvssm();
  }
  throw std::runtime_error("no paper " + paper + "; there are cascaded pcss pvssm sbfs sssm");
}

}
