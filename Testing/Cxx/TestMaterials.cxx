// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// However VTK draws a surface, it receives the same visibility, and its colour is what VTK's own
// frame gives it, times that visibility.
#include "ImageComparison.h"
#include "Props.h"
#include "Scenes.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace SoftShadowsTesting;

namespace
{

using Case = std::tuple<Technique, NamedDrawing>;

class Material : public testing::TestWithParam<Case>
{
protected:
  static Scene MakeScene(bool positional)
  {
    return positional ? MakeRectangleScene(Weights::Mean) : MakeSunScene(5.0, true);
  }

  /// The same plane as the scene's own receiver, drawn in the case's way. Nothing but the blocker
  /// casts, so that the map is the same: the map of a plane that is no flat body includes it.
  void ExchangeReceiver(const Scene& scene, Drawing way) const
  {
    double b[6];
    scene.ReceiverActor->GetBounds(b);
    const Quad quad = { { { b[0], b[2], 0.0 } }, { { b[1] - b[0], 0.0, 0.0 } },
      { { 0.0, b[3] - b[2], 0.0 } } };
    scene.Renderer->RemoveActor(scene.ReceiverActor);
    const auto receiver = MakeReceiver(way, quad);
    vtkShadowCasters::SetCastsShadow(receiver, false);
    scene.Renderer->AddViewProp(receiver);
  }

  Drawing GetWay() const { return std::get<1>(this->GetParam()).Way; }

  vtkSmartPointer<vtkSoftShadowPass> MakePass() const
  {
    return std::get<0>(this->GetParam()).Make(Effort::Quick, Weights::Mean);
  }

  bool IsPhysicallyBased() const { return this->GetWay() == Drawing::PhysicallyBased; }

  /// What the colours of an unshadowed picture become.
  Picture Shadowed(Picture colors, const Picture& visibility, float attenuation) const
  {
    for (int y = 0; y < colors.Height; ++y)
    {
      for (int x = 0; x < colors.Width; ++x)
      {
        const float v = visibility.At(x, y);
        const float light = std::isnan(v) ? 1.0f : 1.0f - attenuation * (1.0f - v);
        // Physically based materials are shaded in linear colour and written with a gamma of 2.2.
        const float factor = this->IsPhysicallyBased() ? std::pow(light, 1.0f / 2.2f) : light;
        for (int c = 0; c < 3; ++c)
        {
          colors.At(x, y, c) *= factor;
        }
      }
    }
    return colors;
  }
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
std::ostream& operator<<(std::ostream& os, const NamedDrawing& drawing)
{
  return os << drawing.Name;
}

}

//------------------------------------------------------------------------------
TEST_P(Material, ReceivesTheSameVisibility)
{
  for (const bool positional : { true, false })
  {
    const Scene plain = MakeScene(positional);
    this->ExchangeReceiver(plain, Drawing::Plain);
    Stage plainStage(plain.Renderer, this->MakePass());
    const Picture expected = plainStage.RenderVisibility(plain.Light);
    const Scene scene = MakeScene(positional);
    this->ExchangeReceiver(scene, this->GetWay());
    Stage stage(scene.Renderer, this->MakePass());
    EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Light), expected, SameButForFlips))
      << (positional ? "positional" : "directional");
    EXPECT_GT(CountShadowed(expected), 500);
  }
}

//------------------------------------------------------------------------------
TEST_P(Material, ColourIsMultipliedByVisibility)
{
  for (const bool positional : { true, false })
  {
    const Scene scene = MakeScene(positional);
    this->ExchangeReceiver(scene, this->GetWay());
    Stage stage(scene.Renderer, nullptr);
    const Picture unshadowed = stage.RenderColors();
    stage.SetPass(this->MakePass());
    const Picture visibility = stage.RenderVisibility(scene.Light);
    const Picture actual = stage.GetWindow().Read();
    const Picture expected = this->Shadowed(unshadowed, visibility, 1.0f);
    EXPECT_TRUE(Matches(actual, expected, SameToRounding))
      << (positional ? "positional" : "directional");
  }
}

//------------------------------------------------------------------------------
// In the picture alone. It is a uniform: nothing is baked and no program built for it.
TEST_P(Material, ShadowAttenuationLightensTheShadow)
{
  const Scene scene = MakeScene(true);
  this->ExchangeReceiver(scene, this->GetWay());
  Stage stage(scene.Renderer, nullptr);
  const Picture unshadowed = stage.RenderColors();
  const auto pass = this->MakePass();
  stage.SetPass(pass);
  const Picture visibility = stage.RenderVisibility(scene.Light);
  const vtkSoftShadowStatistics before = pass->GetStatistics();
  for (const float attenuation : { 0.4f, 0.0f, 7.0f, -3.0f, 1.0f })
  {
    scene.Light->SetShadowAttenuation(attenuation);
    const Picture actual = stage.RenderColors();
    const Picture expected =
      this->Shadowed(unshadowed, visibility, std::min(std::max(attenuation, 0.0f), 1.0f));
    EXPECT_TRUE(Matches(actual, expected, SameToRounding)) << attenuation;
    EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Light), visibility, Identical));
  }
  const vtkSoftShadowStatistics& after = pass->GetStatistics();
  EXPECT_EQ(after.MapsBaked, before.MapsBaked);
  EXPECT_EQ(after.ShaderBuilds, before.ShaderBuilds);
  EXPECT_EQ(after.MapperShaderBuilds, before.MapperShaderBuilds);
  EXPECT_EQ(after.VisibilityFrames, before.VisibilityFrames);
}

//------------------------------------------------------------------------------
// And it casts: the same rectangle as the blocker.
TEST_P(Material, CastsTheSameShadow)
{
  const Scene plain = MakeRectangleScene(Weights::Mean);
  Stage plainStage(plain.Renderer, this->MakePass());
  const Picture expected = plainStage.RenderVisibility(plain.Light);
  const Scene scene = MakeRectangleScene(Weights::Mean);
  scene.Renderer->RemoveActor(scene.BlockerActors[0]);
  scene.Renderer->AddViewProp(MakeReceiver(this->GetWay(), scene.Blockers[0]));
  Stage stage(scene.Renderer, this->MakePass());
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Light), expected, SameButForEdges));
}

INSTANTIATE_TEST_SUITE_P(Techniques, Material,
  testing::Combine(testing::ValuesIn(AllTechniques()), testing::ValuesIn(AllDrawings())), NameOf);
