// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Every technique on every scene whose answer is known, through the whole pipeline.
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <tuple>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 160;
const int Height = 120;

using Case = std::tuple<Technique, NamedScene>;

//------------------------------------------------------------------------------
/// The slope of the least-squares line through (position, value).
double Slope(const std::vector<std::pair<double, double>>& points)
{
  double meanX = 0.0;
  double meanY = 0.0;
  for (const auto& point : points)
  {
    meanX += point.first / static_cast<double>(points.size());
    meanY += point.second / static_cast<double>(points.size());
  }
  double xy = 0.0;
  double xx = 0.0;
  for (const auto& point : points)
  {
    xy += (point.first - meanX) * (point.second - meanY);
    xx += (point.first - meanX) * (point.first - meanX);
  }
  return xy / xx;
}

class ClosedForm : public testing::TestWithParam<Case>
{
protected:
  void Draw(const Scene& drawn, Weights weights)
  {
    const auto pass = std::get<0>(this->GetParam()).Make(Effort::Accurate, weights);
    this->Pixels = GetPlanePixels(drawn, Width, Height);
    ASSERT_GT(this->Pixels.size(), static_cast<std::size_t>(Width * Height / 4));
    this->Expected = ExpectedPicture(drawn, Width, Height);
    Stage stage(drawn.Renderer, pass, Width, Height);
    this->Actual = stage.RenderVisibility(drawn.Light);
    ASSERT_EQ(this->Actual.Width, Width);
    ASSERT_EQ(this->Actual.Height, Height);
    this->Description = drawn.Description + ", light report: " + pass->GetLightReport();
  }

  double RootMeanSquareError() const
  {
    double sum = 0.0;
    for (const PlanePixel& pixel : this->Pixels)
    {
      // A NaN makes the error NaN, which no limit holds for.
      const double error = this->Actual.At(pixel.X, pixel.Y) - pixel.Expected;
      sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(this->Pixels.size()));
  }

  /// For failures: the worst pixel.
  std::string Worst() const
  {
    const PlanePixel* worst = &this->Pixels.front();
    double largest = -1.0;
    for (const PlanePixel& pixel : this->Pixels)
    {
      const double error = std::abs(this->Actual.At(pixel.X, pixel.Y) - pixel.Expected);
      if (!(error <= largest))
      {
        largest = error;
        worst = &pixel;
      }
    }
    std::ostringstream text;
    text << this->Description << "; worst at pixel (" << worst->X << ", " << worst->Y << ") world "
         << testing::PrintToString(worst->World) << ": expected " << worst->Expected << ", got "
         << this->Actual.At(worst->X, worst->Y);
    return text.str();
  }

  /// Whether the expected visibility is `limit` in a pixel and all around it.
  bool IsDeep(const PlanePixel& pixel, float limit) const
  {
    const int margin = 3;
    for (int y = pixel.Y - margin; y <= pixel.Y + margin; ++y)
    {
      for (int x = pixel.X - margin; x <= pixel.X + margin; ++x)
      {
        if (x < 0 || y < 0 || x >= Width || y >= Height || this->Expected.At(x, y) != limit)
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Dark in the umbra and lit outside the penumbra, to a step of 8 bits.
  void ExpectLimits() const
  {
    int tested[2] = { 0, 0 };
    for (const PlanePixel& pixel : this->Pixels)
    {
      for (const int limit : { 0, 1 })
      {
        if (this->IsDeep(pixel, static_cast<float>(limit)))
        {
          EXPECT_NEAR(this->Actual.At(pixel.X, pixel.Y), limit, 1.0 / 255.0)
            << this->Description << " pixel " << pixel.X << ' ' << pixel.Y;
          ++tested[limit];
        }
      }
    }
    EXPECT_GT(tested[0], 100);
    EXPECT_GT(tested[1], 100);
  }

  /// Where the closed form goes from 0.1 to 0.9, expected and actual values are fitted by a line
  /// each; the slopes are in the inverse ratio of the widths.
  void ExpectWidth()
  {
    std::vector<std::pair<double, double>> expected;
    std::vector<std::pair<double, double>> actual;
    for (const PlanePixel& pixel : this->Pixels)
    {
      if (!std::isnan(pixel.Across) && pixel.Expected > 0.1 && pixel.Expected < 0.9)
      {
        expected.emplace_back(pixel.Across, pixel.Expected);
        actual.emplace_back(pixel.Across, this->Actual.At(pixel.X, pixel.Y));
      }
    }
    ASSERT_GT(expected.size(), 100u) << this->Description;
    const double ratio = Slope(expected) / Slope(actual);
    this->RecordProperty("WidthRatio", std::to_string(ratio));
    EXPECT_NEAR(ratio, 1.0, std::get<0>(this->GetParam()).LargestWidthError) << this->Description;
  }

  std::vector<PlanePixel> Pixels;
  Picture Expected;
  Picture Actual;
  std::string Description;
};

//------------------------------------------------------------------------------
std::string NameOf(const testing::TestParamInfo<Case>& info)
{
  return std::get<0>(info.param).Name + std::get<1>(info.param).Name;
}

}

namespace SoftShadowsTesting
{

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const NamedScene& scene)
{
  return os << scene.Name;
}

}

//------------------------------------------------------------------------------
// One picture, three questions: CTest runs every test in a program of its own, and the picture is
// what takes the time.
TEST_P(ClosedForm, ErrorLimitsAndWidth)
{
  ASSERT_NO_FATAL_FAILURE(
    this->Draw(std::get<1>(this->GetParam()).Make(Placement()), Weights::Mean));
  const double error = this->RootMeanSquareError();
  this->RecordProperty("RootMeanSquareError", std::to_string(error));
  EXPECT_LE(error, std::get<0>(this->GetParam()).LargestError) << this->Worst();
  this->ExpectLimits();
  this->ExpectWidth();
}

INSTANTIATE_TEST_SUITE_P(Techniques, ClosedForm,
  testing::Combine(testing::ValuesIn(AllTechniques()), testing::ValuesIn(ClosedFormScenes())),
  NameOf);

namespace
{

class WeightedForm : public ClosedForm
{
};

}

//------------------------------------------------------------------------------
TEST_P(WeightedForm, GaussianErrorIsSmall)
{
  ASSERT_NO_FATAL_FAILURE(this->Draw(MakeRectangleScene(Weights::Gaussian), Weights::Gaussian));
  const double error = this->RootMeanSquareError();
  this->RecordProperty("RootMeanSquareError", std::to_string(error));
  // The steps between samples are as much higher as the weights are in the middle.
  const double highest = WindowShare(-1e-6, 1e-6, Weights::Gaussian) / 1e-6;
  EXPECT_LE(error, highest * std::get<0>(this->GetParam()).LargestError) << this->Worst();
}

INSTANTIATE_TEST_SUITE_P(Techniques, WeightedForm,
  testing::Combine(
    testing::ValuesIn(AllTechniques()), testing::Values(NamedScene{ "Rectangle", SceneFactory() })),
  NameOf);
