// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Zerari et al. 2023; Ali, Kolivand, Sunar 2016; the estimators that the techniques were chosen by.
#include "PaperTables.h"

#include <limits> // For what was not published

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
// Figures 5 to 11: frame time, RMSE, SSIM.
PaperTable MakeCascadedTable(const std::string& scene)
{
  PaperTable table{ "Zerari et al. 2023, figures 5 to 11: scene " + scene,
    "Published are a gain of 44 to 51 % in frames per second over SBFS with 25 maps (the mean "
    "stands "
    "here) and an RMSE below 0.01 of the rendered picture.",
    scene, 1.0, 800, 600 };
  table.Rows = { { "SBFS, 25 maps", ParseChoice("sbfs samples=25 filter=paper map_size=1024") },
    { "cascaded, 16 + 9 + 4", ParseChoice("cascaded map_size=1024") },
    { "cascaded, 25 + 9 + 4", ParseChoice("cascaded map_size=1024 edge_0=5") },
    { "cascaded, adaptive", ParseChoice("cascaded map_size=1024 adaptive=on") },
    { "FASSALSS, up to 25 maps", ParseChoice("fassalss level=2 map_size=1024") },
    { "PCSS, 16 samples", ParseChoice("pcss search_width=4 filter_width=4 map_size=1024") },
    { "25 hard maps", ParseChoice("sampled samples=25 map_size=1024") },
    { "256 hard maps", ParseChoice("sampled samples=256 map_size=1024") } };
  table.Columns = { { "fps", PaperFigure::FramesPerSecond, { 1.0, 1.475 }, {} },
    { "picture, RMSE", PaperFigure::PictureRmse, {}, {} },
    { "picture, SSIM %", PaperFigure::PictureSsimPercent, {}, {} },
    { "visibility, RMSE", PaperFigure::Rmse, {}, {} },
    { "visibility, SSIM %", PaperFigure::SsimPercent, {}, {} } };
  return table;
}

//--------------------------------------------------------------------------------------------------
// Table 1 for one model, with what the filter changes.
PaperTable MakeSbfsTable(const std::string& model, const std::vector<double>& published)
{
  PaperTable table{ "Ali et al. 2016, table 1: " + model,
    "Published is the filter of 3 x 3; ratios are to its 3 points with maps of 1024. Below stand "
    "the "
    "default filter and none, one hard map, PCSS and VTK's own pass.",
    model, 1.0, 1024, 1024 };
  const std::string sizes[] = { "1024", "512", "256" };
  const std::string samples[] = { "3", "5", "15" };
  for (const char* filter : { "paper", "adaptive", "none" })
  {
    for (const std::string& size : sizes)
    {
      for (const std::string& n : samples)
      {
        table.Rows.push_back({ "map " + size + ", " + n + " points, filter " + filter,
          ParseChoice(
            "sbfs filter=" + std::string(filter) + " map_size=" + size + " samples=" + n) });
      }
    }
  }
  for (const std::string& size : sizes)
  {
    table.Rows.push_back(
      { "one hard map, " + size, ParseChoice("sampled samples=1 map_size=" + size) });
  }
  table.Rows.push_back({ "25 hard maps, 1024", ParseChoice("sampled samples=25 map_size=1024") });
  table.Rows.push_back({ "PCSS, 1024", ParseChoice("pcss map_size=1024") });
  table.Rows.push_back({ "vtkShadowMapPass, 1024", ParseChoice("vtk map_size=1024") });
  table.Columns = { { "fps", PaperFigure::FramesPerSecond, published, {} },
    { "visibility, RMSE", PaperFigure::Rmse, {}, {} } };
  return table;
}

//--------------------------------------------------------------------------------------------------
PaperTable MakeEstimatorTable(
  const std::string& name, const std::string& scene, const std::vector<double>& expected)
{
  PaperTable table{ "Estimators: " + name,
    "Expected is the RMSE of an idealised program that ray-casts its maps, in a scene of that "
    "kind.",
    scene, 1.0, 320, 240 };
  table.Rows = { { "PCSS, 32 x 32 + 32 x 32", ParseChoice("pcss search_width=32 filter_width=32") },
    { "marched, 64 x 16", ParseChoice("marched rays=64 steps=16") },
    { "marched, 16 x 8", ParseChoice("marched rays=16 steps=8") },
    { "16 hard maps", ParseChoice("sampled samples=16") },
    { "64 hard maps", ParseChoice("sampled samples=64") },
    { "PCSS, 8 x 8 + 8 x 8, 2 x 2 parts",
      ParseChoice("pcss search_width=8 filter_width=8 split=2") },
    { "PCSS, 8 x 8 + 8 x 8, 4 x 4 parts",
      ParseChoice("pcss search_width=8 filter_width=8 split=4") },
    { "marched, 16 x 16, 2 x 2 parts", ParseChoice("marched rays=16 steps=16 split=2") } };
  table.Columns = { { "RMSE", PaperFigure::Rmse, expected, {} },
    { "milliseconds", PaperFigure::Milliseconds, {}, {} } };
  return table;
}

}

//--------------------------------------------------------------------------------------------------
std::vector<PaperTable> GetCascadedTables()
{
  return { MakeCascadedTable("street"), MakeCascadedTable("assembly") };
}

//--------------------------------------------------------------------------------------------------
std::vector<PaperTable> GetSbfsTables()
{
  return { MakeSbfsTable("bunny", { 126, 94, 57, 237, 181, 72, 316, 223, 108 }),
    MakeSbfsTable("dragon", { 143, 89, 46, 205, 144, 64, 281, 184, 96 }) };
}

//--------------------------------------------------------------------------------------------------
std::vector<PaperTable> GetEstimatorTables()
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  return { MakeEstimatorTable("a compact mesh, a medium light", "bunny",
             { 0.030, 0.016, 0.029, 0.014, 0.008, 0.015, 0.008, 0.011 }),
    MakeEstimatorTable("a deep mesh, a large light", "dragon",
      { 0.091, 0.021, 0.040, 0.021, 0.011, 0.058, 0.028, 0.015 }),
    MakeEstimatorTable("a CAD part, a close light", "assembly",
      { 0.061, 0.026, 0.049, none, none, none, none, none }),
    MakeEstimatorTable("blockers at many depths that fuse", "fused",
      { 0.159, 0.161, 0.159, 0.179, 0.077, 0.066, 0.047, 0.099 }) };
}

}
