// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Long work is drawn in bands: more of them the more work there is, and the same picture.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkRenderer.h"
#include "vtkShadowBands.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 100;
const int Height = 75;

class Bands : public testing::TestWithParam<Technique>
{
protected:
  ~Bands() override { vtkShadowBands::SetMostTaps(0.0); }

  /// The first frame of a new pass, and how often it drew.
  Picture Draw(vtkSoftShadowPass* pass, double mostTaps, vtkTypeInt64& draws)
  {
    vtkShadowBands::SetMostTaps(mostTaps);
    Stage stage(this->Scene.Renderer, pass, Width, Height);
    Picture visibility = stage.RenderVisibility(this->Scene.Lamp);
    draws = pass->GetCount("visibility_draws");
    return visibility;
  }

  vtkSmartPointer<vtkSoftShadowPass> MakePass() const
  {
    return this->GetParam().Make(Effort::Quick, Weights::Mean);
  }

  BallScene Scene = MakeBallScene();
};

}

//------------------------------------------------------------------------------
TEST_P(Bands, ChangeNoPixel)
{
  vtkTypeInt64 usual = 0;
  const Picture expected = this->Draw(this->MakePass(), 0.0, usual);
  vtkTypeInt64 unlimited = 0;
  this->Draw(this->MakePass(), 1e30, unlimited);
  EXPECT_EQ(usual, unlimited) << "a usual frame is cut";
  EXPECT_GT(usual, 0);
  // Of pixels of so many taps; the rays of the processor take none.
  vtkTypeInt64 most = unlimited;
  for (const double taps : { 30.0 * Width * Height, 10.0 * Width * Height })
  {
    vtkTypeInt64 draws = 0;
    EXPECT_TRUE(Matches(this->Draw(this->MakePass(), taps, draws), expected, Identical)) << taps;
    if (this->GetParam().HasMaps)
    {
      EXPECT_GT(draws, most) << taps;
    }
    most = draws;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Bands, testing::ValuesIn(EveryTechnique()), NameOfTechnique);

//------------------------------------------------------------------------------
TEST(BandsOfKernels, GrowWithTheKernels)
{
  const BallScene scene = MakeBallScene();
  const auto countDraws = [&scene](int width, double mostTaps)
  {
    vtkShadowBands::SetMostTaps(mostTaps);
    auto pass = vtkSmartPointer<vtkPercentageCloserSoftShadowPass>::New();
    pass->SetSearchWidth(width);
    pass->SetFilterWidth(width);
    Stage stage(scene.Renderer, pass, Width, Height);
    stage.Render();
    return pass->GetCount("visibility_draws");
  };
  vtkTypeInt64 before = 0;
  for (const int width : { 11, 21, 31, 61 })
  {
    // Marks and pyramids are drawn at once.
    const vtkTypeInt64 others = countDraws(width, 1e30) - 1;
    const vtkTypeInt64 bands = countDraws(width, 2.0 * 11 * 11 * Width * Height) - others;
    EXPECT_GT(bands, before) << width;
    // Bands are whole rows.
    const double work = 1.0 * width * width / (11 * 11);
    EXPECT_GE(static_cast<double>(bands), work) << width;
    EXPECT_LE(static_cast<double>(bands), 2.0 * work) << width;
    before = bands;
  }
  vtkShadowBands::SetMostTaps(0.0);
}
