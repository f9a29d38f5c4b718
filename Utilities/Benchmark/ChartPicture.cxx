// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartPicture.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkFloatArray.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm> // For ranges
#include <array>     // For colours
#include <cmath>     // For powers
#include <limits>    // For ranges

namespace softshadows
{
namespace
{

// Okabe and Ito's colours, told apart by the colour-blind too, then darker ones of them.
constexpr std::array<std::array<unsigned char, 3>, 12> Colors = { { { { 0, 114, 178 } },
  { { 213, 94, 0 } }, { { 0, 158, 115 } }, { { 204, 121, 167 } }, { { 230, 159, 0 } },
  { { 86, 180, 233 } }, { { 0, 0, 0 } }, { { 120, 60, 0 } }, { { 0, 80, 60 } }, { { 110, 50, 90 } },
  { { 150, 150, 0 } }, { { 30, 60, 110 } } } };

struct Range
{
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();

  void Add(double value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }
};

//--------------------------------------------------------------------------------------------------
bool IsDrawn(const ChartDescription& chart, double x, double y)
{
  return std::isfinite(x) && std::isfinite(y) && (!chart.LogX || x > 0.0) &&
    (!chart.LogY || y > 0.0);
}

//--------------------------------------------------------------------------------------------------
void SetUpAxis(vtkAxis* axis, const std::string& title, bool isLog, const Range& range)
{
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(15);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(13);
  axis->SetLogScale(isLog);
  const double factor = 1.25;
  const double margin = 0.05 * (range.High - range.Low);
  axis->SetUnscaledMinimum(isLog ? range.Low / factor : std::min(0.0, range.Low));
  axis->SetUnscaledMaximum(isLog ? range.High * factor : range.High + std::max(margin, 1e-12));
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetNotation(vtkAxis::PRINTF_NOTATION);
  axis->SetLabelFormat("%g");
}

//--------------------------------------------------------------------------------------------------
void AddSeries(vtkChartXY* chart, const ChartDescription& description, const ChartSeries& series,
  size_t index, Range& xRange, Range& yRange)
{
  vtkNew<vtkFloatArray> x;
  x->SetName("x");
  vtkNew<vtkFloatArray> y;
  y->SetName(series.Name.c_str());
  for (size_t i = 0; i < series.X.size(); ++i)
  {
    if (IsDrawn(description, series.X[i], series.Y[i]))
    {
      xRange.Add(series.X[i]);
      yRange.Add(series.Y[i]);
      x->InsertNextValue(static_cast<float>(series.X[i]));
      y->InsertNextValue(static_cast<float>(series.Y[i]));
    }
  }
  if (x->GetNumberOfTuples() == 0 || (series.IsFront && x->GetNumberOfTuples() == 1))
  {
    return;
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  auto* plot = vtkPlotPoints::SafeDownCast(
    chart->AddPlot(x->GetNumberOfTuples() > 1 ? vtkChart::LINE : vtkChart::POINTS));
  plot->SetInputData(table, 0, 1);
  if (series.IsFront)
  {
    plot->SetMarkerStyle(vtkPlotPoints::NONE);
    plot->SetColor(170, 170, 170, 255);
    plot->SetWidth(6.0F);
    return;
  }
  const auto& color = Colors[index % Colors.size()];
  plot->SetColor(color[0], color[1], color[2], 255);
  plot->SetWidth(1.5F);
  plot->SetMarkerStyle(vtkPlotPoints::CIRCLE);
  plot->SetMarkerSize(9.0F);
}

}

//--------------------------------------------------------------------------------------------------
bool ChartDescription::IsEmpty() const
{
  return std::none_of(this->Series.begin(), this->Series.end(),
    [this](const ChartSeries& series)
    {
      for (size_t i = 0; i < series.X.size(); ++i)
      {
        if (IsDrawn(*this, series.X[i], series.Y[i]))
        {
          return true;
        }
      }
      return false;
    });
}

//--------------------------------------------------------------------------------------------------
ColorImage DrawChart(const ChartDescription& description, int width, int height)
{
  vtkNew<vtkContextView> view;
  vtkRenderWindow* window = view->GetRenderWindow();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkChartXY> chart;
  view->GetScene()->AddItem(chart);
  chart->SetTitle(description.Title);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetInline(false);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  Range x;
  Range y;
  for (size_t i = 0; i < description.Series.size(); ++i)
  {
    AddSeries(chart, description, description.Series[i], i, x, y);
  }
  SetUpAxis(chart->GetAxis(vtkAxis::BOTTOM), description.XLabel, description.LogX, x);
  SetUpAxis(chart->GetAxis(vtkAxis::LEFT), description.YLabel, description.LogY, y);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, width - 1, height - 1, 1, pixels);
  ColorImage image{ width, height, {} };
  for (int row = height - 1; row >= 0; --row)
  {
    const unsigned char* first = pixels->GetPointer(3 * static_cast<vtkIdType>(row) * width);
    image.Pixels.insert(image.Pixels.end(), first, first + 3 * static_cast<size_t>(width));
  }
  return image;
}

}
