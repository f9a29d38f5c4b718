// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A quality is a promise: every technique meets its error class on the bundled scene, or says that it
// has none.
#include "ErrorMeasures.h"
#include "ModelStore.h"
#include "PassImages.h"
#include "ReferenceTracer.h"
#include "SceneBuilder.h"
#include "SceneReader.h"
#include "Silhouettes.h"
#include "Stage.h"
#include "Technique.h"

#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace
{

// Half of the scene's own size. Classes are chosen so that both meet them.
const int Width = 320;
const int Height = 240;

// The ray tracer's own error adds 0.002 to the error of the picture, and less than 0.0003 to one of
// 0.008.
const int TruthRaysPerAxis = 16;

class Qualities : public testing::TestWithParam<std::string>
{
protected:
  Qualities()
    : Truth(
        softshadows::ReferenceTracer(Width, Height, TruthRaysPerAxis).Trace(this->Scene.Renderer))
  {
  }

  double GetError(const softshadows::OptionTexts& options)
  {
    const auto pass =
      softshadows::CreatePass(softshadows::FindTechnique(this->GetParam()), options);
    SoftShadowsTesting::Stage stage(this->Scene.Renderer, pass, Width, Height);
    stage.Render();
    const std::vector<float> drawn =
      softshadows::ImageValues(pass->GetVisibilityImage(this->Scene.Lights.front()), Width, Height);
    return softshadows::MeasureErrors(Width, Height, this->Truth.Visibility.front(), drawn,
      softshadows::FindSilhouettes(Width, Height, this->Truth.Depth))
      .All.Rmse;
  }

private:
  softshadows::ModelStore Models;
  softshadows::BuiltScene Scene =
    softshadows::BuildScene(softshadows::ReadScene(SOFTSHADOWS_BUNDLED_SCENE), Models);
  softshadows::ReferenceVisibility Truth;
};

//------------------------------------------------------------------------------
std::vector<std::string> Names()
{
  std::vector<std::string> names;
  for (const softshadows::Technique& technique : softshadows::GetTechniques())
  {
    names.push_back(technique.Name);
  }
  return names;
}

}

//------------------------------------------------------------------------------
TEST_P(Qualities, AreErrorClasses)
{
  const softshadows::Technique& technique = softshadows::FindTechnique(this->GetParam());
  for (const auto& [name, largestError] : softshadows::GetQualities())
  {
    SCOPED_TRACE(name);
    const softshadows::TechniqueQuality& quality = technique.FindQuality(name);
    if (quality.Exists())
    {
      const double error = this->GetError(technique.GetQualityOptions(name));
      RecordProperty(name, std::to_string(error));
      EXPECT_LE(error, largestError);
      // The scene has shadows, and they were compared.
      EXPECT_GT(error, 0.001);
      continue;
    }
    try
    {
      technique.GetQualityOptions(name);
      ADD_FAILURE() << "no error";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(error.what(),
        "technique '" + technique.Name + "' has no quality '" + name + "': " + quality.WhyNone);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, Qualities, testing::ValuesIn(Names()),
  [](const testing::TestParamInfo<std::string>& parameter) { return parameter.param; });
