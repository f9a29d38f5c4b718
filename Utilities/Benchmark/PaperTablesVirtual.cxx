// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Shen, Guennebaud, Yang, Feng 2011.
#include "PaperTables.h"

#include <limits> // For what was not published

namespace softshadows
{
namespace
{

constexpr const char* VirtualScene = "foliage";
constexpr const char* Plant = "plant";
/// Published light sizes 10 and 80: a sharp and a wide light, eight times apart.
constexpr double SmallLight = 0.25;
constexpr double LargeLight = 2.0;
/// Published are 1024 x 1024 pixels. Here every pixel is computed by the processor that also draws the maps.
constexpr int Width = 200;
constexpr int Height = 150;
constexpr int Frames = 1;

//--------------------------------------------------------------------------------------------------
// Table 1: milliseconds of the steps, of the published figures 1 and 8.
PaperTable MakeStepTable()
{
  PaperTable table{ "Shen et al. 2011, table 1: milliseconds of the steps",
    "Published are the scenes of figures 1 and 8; ours, the plant, is held against the first. "
    "Compare "
    "the shares of the frame.",
    VirtualScene, SmallLight, Width, Height };
  table.HasTruth = false;
  table.Frames = 3;
  table.Rows = { { "quality 1, as published", ParseChoice("pvssm quality=1") },
    { "default quality", ParseChoice("pvssm") } };
  table.Columns = { { "geometry buffer", PaperFigure::Step, { 9.0 }, { "receivers" } },
    { "low map", PaperFigure::Step, { 15.0 }, { "maps" } },
    { "mean depth", PaperFigure::Step, { 4.5 }, { "kernel shapes" } },
    { "tiling", PaperFigure::Step, { 10.5 }, { "tile planning" } },
    { "tile maps", PaperFigure::Step, { 55.8 }, { "tile maps" } },
    { "filtering", PaperFigure::Step, { 82.5 }, { "filtering" } },
    { "frame", PaperFigure::Milliseconds, { 177.0 }, {} } };
  return table;
}

//--------------------------------------------------------------------------------------------------
// The frame and where its time goes; frames per second stand beside what was published.
std::vector<PaperColumn> MakeTimeColumns(const std::vector<double>& published)
{
  return { { "fps", PaperFigure::FramesPerSecond, published, {} },
    { "ms", PaperFigure::Milliseconds, {}, {} },
    { "geometry buffer", PaperFigure::Step, {}, { "receivers" } },
    { "low map", PaperFigure::Step, {}, { "maps" } },
    { "mean depth", PaperFigure::Step, {}, { "kernel shapes" } },
    { "tiling", PaperFigure::Step, {}, { "tile planning" } },
    { "tile maps", PaperFigure::Step, {}, { "tile maps" } },
    { "filtering", PaperFigure::Step, {}, { "filtering" } },
    { "tiles", PaperFigure::Count, {}, { "tiles" } },
    { "1000 texels", PaperFigure::Count, {}, { "tile_kilotexels" } },
    { "MB", PaperFigure::Megabytes, {}, {} } };
}

//--------------------------------------------------------------------------------------------------
// Table 2: adaptive against one fixed map.
PaperTable MakeAdaptiveTable(bool large)
{
  PaperTable table{ std::string("Shen et al. 2011, table 2: light size ") + (large ? "80" : "10"),
    "Published memory: adaptive 68, fixed 64 MB.", VirtualScene, large ? LargeLight : SmallLight,
    Width, Height };
  table.HasTruth = false;
  table.Frames = Frames;
  table.Rows = { { "one map of 4096", ParseChoice("pvssm adaptive=off map_size=4096") },
    { "adaptive, quality 1", ParseChoice("pvssm quality=1") },
    { "adaptive, default quality", ParseChoice("pvssm") } };
  const double none = std::numeric_limits<double>::quiet_NaN();
  using Values = std::vector<double>;
  table.Columns =
    MakeTimeColumns(large ? Values{ 7.30, 21.62, none } : Values{ 16.82, 12.33, none });
  return table;
}

//--------------------------------------------------------------------------------------------------
// Its last row, which does not depend on the light's size.
PaperTable MakeSampledTable()
{
  PaperTable table{ "Shen et al. 2011, table 2: 64 hard maps, light size 10", "", VirtualScene,
    SmallLight, Width, Height };
  table.HasTruth = false;
  table.Frames = Frames;
  table.Rows = { { "one map of 4096", ParseChoice("pvssm adaptive=off map_size=4096") },
    { "64 hard maps of 4096", ParseChoice("sampled samples=64 map_size=4096") } };
  table.Columns = { { "fps", PaperFigure::FramesPerSecond, { 16.82, 0.60 }, {} },
    { "MB", PaperFigure::Megabytes, { 64.0, 64.0 }, {} } };
  return table;
}

//--------------------------------------------------------------------------------------------------
// Figure 10: a soft light needs fewer texels than a hard one.
PaperTable MakeSoftTable()
{
  PaperTable table{ "Shen et al. 2011, figure 10: soft over hard, 12 000 triangles", "",
    VirtualScene, 1.0, Width, Height };
  table.HasTruth = false;
  table.Frames = Frames;
  table.Rows = { { "hard", ParseChoice("pvssm quality=1 light_scale=0") },
    { "soft", ParseChoice("pvssm quality=1 light_scale=2") } };
  table.Columns = MakeTimeColumns({ 15.0, 27.0 });
  return table;
}

//--------------------------------------------------------------------------------------------------
// The same for a model as large as the published ones, and table 2 for it.
PaperTable MakePlantTable(const std::string& quality)
{
  PaperTable table{ "Shen et al. 2011, figure 10: soft over hard, 1.7 million triangles, quality " +
      quality,
    "Hard, a small and a large light, all else equal; published is figure 10 for the first and the "
    "third.",
    Plant, 1.0, 2 * Width, 2 * Height };
  table.HasTruth = false;
  table.Frames = Frames;
  const std::string adaptive = "pvssm quality=" + quality;
  const std::string fixed = "pvssm adaptive=off map_size=4096";
  table.Rows = { { "hard, adaptive", ParseChoice(adaptive + " light_scale=0") },
    { "small light, adaptive", ParseChoice(adaptive + " light_scale=1") },
    { "large light, adaptive", ParseChoice(adaptive + " light_scale=8") },
    { "small light, one map of 4096", ParseChoice(fixed + " light_scale=1") },
    { "large light, one map of 4096", ParseChoice(fixed + " light_scale=8") } };
  const double none = std::numeric_limits<double>::quiet_NaN();
  table.Columns = MakeTimeColumns({ 15.0, none, 27.0, none, none });
  return table;
}

//--------------------------------------------------------------------------------------------------
// Figure 11: antialiasing against supersampling.
PaperTable MakeAntialiasingTable()
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  PaperTable table{ "Shen et al. 2011, figure 11: antialiasing",
    "Published: the quality of 32 x 32 samples, an order of magnitude faster than 8 x 8. Errors "
    "are "
    "against the first row.",
    "grid", 1.0, 100, 75 };
  table.HasTruth = false;
  table.Frames = Frames;
  const std::string map = "pvssm adaptive=off map_size=1024";
  table.Rows = { { "32 x 32 samples", ParseChoice(map + " supersample=32") },
    { "8 x 8 samples", ParseChoice(map + " supersample=8") },
    { "analytic antialiasing", ParseChoice(map + " antialiasing=on") },
    { "one sample", ParseChoice(map) } };
  table.Columns = { { "fps", PaperFigure::FramesPerSecond, { none, 1.0, 10.0, none }, {} },
    { "RMSE", PaperFigure::RmseToFirst, {}, {} } };
  table.Base = 1;
  return table;
}

}

//--------------------------------------------------------------------------------------------------
std::vector<PaperTable> GetPvssmTables()
{
  // The cheap ones first.
  return { MakeStepTable(), MakeAntialiasingTable(), MakeSoftTable(), MakeAdaptiveTable(false),
    MakePlantTable("1"), MakeAdaptiveTable(true), MakeSampledTable() };
}

}
