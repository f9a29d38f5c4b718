// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Published tables: their form, and that all reports of one show the same numbers.
#include "BenchmarkScenes.h"
#include "HtmlReport.h"
#include "PaperRun.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

using namespace softshadows;

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

//--------------------------------------------------------------------------------------------------
// Two rows with times and errors of both kinds, the second without a published figure.
PaperResult MakeResult()
{
  PaperResult result;
  result.Table.Title = "a table";
  result.Table.Scene = "box";
  result.Table.Width = 40;
  result.Table.Height = 30;
  result.Table.Rows = { { "first", ParseChoice("pcss filter_width=21") },
    { "second", ParseChoice("sampled samples=4") }, { "third", ParseChoice("nonsense") } };
  result.Table.Columns = { { "fps", PaperFigure::FramesPerSecond, { 75.0, NaN, 25.0 }, {} },
    { "picture, PSNR", PaperFigure::PicturePsnr, { 30.0, 31.5 }, {} },
    { "RMSE", PaperFigure::Rmse, {}, {} }, { "maps", PaperFigure::Step, {}, { "a", "b" } } };
  for (int i = 0; i < 3; ++i)
  {
    ContestantResult contestant;
    contestant.Name = result.Table.Rows[i].Choice.GetName();
    if (i == 2)
    {
      contestant.Failure = "there is no technique 'nonsense'";
      result.Scene.Contestants.push_back(contestant);
      continue;
    }
    contestant.Times[static_cast<size_t>(Motion::Light)].Milliseconds = { 20.0 * (i + 1) };
    contestant.Errors.resize(1);
    contestant.Errors[0].All.Rmse = 0.0123456 / (i + 1);
    contestant.PictureErrors.Pixels = 1200;
    contestant.PictureErrors.Psnr = 40.25 - i;
    contestant.Steps = { { "a", 1.5 }, { "b", 2.0 }, { "c", 7.0 } };
    result.Scene.Contestants.push_back(contestant);
  }
  return result;
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, AllPapersHaveTablesOfOneScene)
{
  EXPECT_EQ(GetPapers().size(), 6U);
  for (const std::string& paper : GetPapers())
  {
    for (const PaperTable& table : GetPaperTables(paper))
    {
      ASSERT_GE(table.Rows.size(), 2U) << table.Title;
      ASSERT_LT(table.Base, table.Rows.size()) << table.Title;
      for (const PaperColumn& column : table.Columns)
      {
        EXPECT_LE(column.Published.size(), table.Rows.size()) << table.Title << column.Title;
        const bool isError =
          column.Figure == PaperFigure::Rmse || column.Figure == PaperFigure::Psnr;
        EXPECT_FALSE(isError && !table.HasTruth) << table.Title << column.Title;
      }
    }
  }
  EXPECT_THROW(GetPaperTables("nonsense"), std::runtime_error);
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, HaveThePublishedNumbers)
{
  const std::vector<PaperTable> sbfs = GetPaperTables("sbfs");
  ASSERT_EQ(sbfs.size(), 2U);
  // dragon, 256 x 256, 15 points of the light: 96 frames per second
  EXPECT_EQ(sbfs[1].Rows[8].Choice.GetName(), "sbfs filter=paper map_size=256 samples=15");
  EXPECT_EQ(sbfs[1].Columns[0].Published[8], 96.0);
  for (const PaperTable& table : GetPaperTables("sssm"))
  {
    if (table.Title.find("table 4") != std::string::npos)
    {
      // SSSM, 0.10, 29/41: 15.67
      EXPECT_EQ(table.Rows[9].Label, "SSSM 0.10 29/41");
      EXPECT_EQ(table.Columns[0].Published[9], 15.67);
      return;
    }
  }
  FAIL() << "there is no table 4";
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, CountsAreSummedByName)
{
  ContestantResult contestant;
  contestant.Counts = { { "tiles", 3 }, { "bytes_held", 3145728 }, { "late_grids", 4 } };
  PaperColumn column{ "", PaperFigure::Count, {}, { "tiles", "late_grids" } };
  EXPECT_EQ(MeasureFigure(column, contestant), 7.0);
  column.Steps = { "nothing" };
  EXPECT_TRUE(std::isnan(MeasureFigure(column, contestant)));
  column.Figure = PaperFigure::Megabytes;
  EXPECT_EQ(MeasureFigure(column, contestant), 3.0);
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, SlowTablesAreMeasuredWhateverTheBudget)
{
  for (const PaperTable& table : GetPaperTables("pvssm"))
  {
    EXPECT_GT(table.Frames, 0) << table.Title;
    EXPECT_LE(table.Width * table.Height, 400 * 300) << table.Title;
  }
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, ThePlantIsAsLargeAsThePublishedModels)
{
  const vtkSmartPointer<vtkRenderer> renderer = MakePlantScene().Make();
  vtkIdType triangles = 0;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator iterator;
  actors->InitTraversal(iterator);
  while (vtkActor* actor = actors->GetNextActor(iterator))
  {
    triangles += vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput())->GetNumberOfCells();
  }
  EXPECT_NEAR(triangles, 1700000, 10000);
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, MarkdownShowsTheNumbersOfTheJson)
{
  const PaperResult result = MakeResult();
  std::ostringstream stream;
  WritePaperMarkdown(stream, result);
  const std::string text = stream.str();
  const auto json = nlohmann::json::parse(ToJson(result).dump());
  ASSERT_EQ(json.at("rows").size(), 3U);
  for (const auto& row : json["rows"])
  {
    EXPECT_NE(text.find("| " + row.at("label").get<std::string>()), std::string::npos);
    for (const auto& figure : row.at("figures"))
    {
      if (!figure.at("measured").is_null())
      {
        const double measured = figure["measured"];
        EXPECT_NE(text.find(" " + FormatNumber(measured) + " |"), std::string::npos) << measured;
      }
    }
  }
  EXPECT_NE(
    text.find("| first | 75 | 50 | 1.00 | 1.00 | 30 | 40.25 | +0.00 | +0.00 | 0.01235 | 3.5 |"),
    std::string::npos)
    << text;
  EXPECT_NE(
    text.find("| second | - | 25 | - | 0.50 | 31.5 | 39.25 | +1.50 | -1.00 |"), std::string::npos)
    << text;
  EXPECT_NE(text.find("| third (there is no technique 'nonsense') | 25 | - | 0.33 | - |"),
    std::string::npos)
    << text;
  EXPECT_TRUE(json["rows"][1]["figures"][0].at("published").is_null());
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, ManyFiguresShareCells)
{
  PaperResult result = MakeResult();
  result.Table.Columns.push_back({ "ms", PaperFigure::Milliseconds, { 10.0, 30.0 }, {} });
  std::ostringstream text;
  WritePaperMarkdown(text, result);
  EXPECT_NE(text.str().find("| second | - / 25 (- / 0.50) | 31.5 / 39.25 (+1.50 / -1.00) |"),
    std::string::npos)
    << text.str();
  EXPECT_NE(text.str().find(" 30 / 40 (3.00 / 2.00) |"), std::string::npos) << text.str();
}

//--------------------------------------------------------------------------------------------------
TEST(PaperTables, MissingScenesAreReported)
{
  PaperTable table = MakeResult().Table;
  table.Scene = "nowhere";
  const BenchmarkRunner runner(BenchmarkSettings(), {}, {});
  const PaperResult result = RunPaperTable(table, {}, runner);
  std::ostringstream text;
  WritePaperMarkdown(text, result);
  EXPECT_NE(text.str().find("Not measured: there is no scene nowhere"), std::string::npos);
}

}
