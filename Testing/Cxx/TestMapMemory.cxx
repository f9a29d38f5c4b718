// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// All lights' maps together: kept as long as a light is there, found in any order of the lights, and under
// one budget, beyond which textures are used again.
#include "ImageComparison.h"
#include "Picture.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

std::vector<Technique> TechniquesWithMaps()
{
  std::vector<Technique> techniques;
  for (const Technique& technique : AllTechniques())
  {
    if (technique.HasMaps)
    {
      techniques.push_back(technique);
    }
  }
  return techniques;
}

//------------------------------------------------------------------------------
/// The ball under many lamps on a circle.
class Chandelier
{
public:
  explicit Chandelier(int count)
    : Scene(MakeBallScene())
  {
    this->Lamps.push_back(this->Scene.Lamp);
    for (int i = 1; i < count; ++i)
    {
      const double angle = 6.283185307179586 * i / count;
      this->Lamps.push_back(
        MakeLamp({ 2.0 * std::cos(angle), 2.0 * std::sin(angle), 4.0 }, { 0.0, 0.0, 0.0 }, 0.3));
      this->Scene.Renderer->AddLight(this->Lamps.back());
    }
  }

  void AddBackwards()
  {
    this->Scene.Renderer->RemoveAllLights();
    for (auto lamp = this->Lamps.rbegin(); lamp != this->Lamps.rend(); ++lamp)
    {
      this->Scene.Renderer->AddLight(*lamp);
    }
  }

  BallScene Scene;
  std::vector<vtkSmartPointer<vtkAreaLight>> Lamps;
};

//------------------------------------------------------------------------------
/// Counts the array textures that are made while one lives.
class TextureCount
{
public:
  TextureCount()
  {
    Made = 0;
    Real = glTexImage3D;
    glTexImage3D = &TextureCount::Allocate;
  }
  ~TextureCount() { glTexImage3D = Real; }
  TextureCount(const TextureCount&) = delete;
  TextureCount& operator=(const TextureCount&) = delete;

  int GetNumber() const { return Made; }

private:
  using Function = decltype(glTexImage3D);
  static Function Real;
  static int Made;

  static void Allocate(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
    GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels)
  {
    ++Made;
    Real(target, level, internal, width, height, depth, border, format, type, pixels);
  }
};

TextureCount::Function TextureCount::Real = nullptr;
int TextureCount::Made = 0;

//------------------------------------------------------------------------------
class MapMemory : public testing::TestWithParam<Technique>
{
protected:
  vtkSmartPointer<vtkSoftShadowPass> MakePass()
  {
    auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(256);
    return pass;
  }
};

}

//------------------------------------------------------------------------------
TEST_P(MapMemory, ALightThatGoesOutAndOnAgainBakesNothing)
{
  Chandelier chandelier(3);
  const auto pass = this->MakePass();
  Stage stage(chandelier.Scene.Renderer, pass, 80, 60);
  stage.Render();
  const vtkTypeInt64 baked = pass->GetStatistics().MapsBaked;
  const Picture lit = stage.RenderVisibility(chandelier.Lamps[2]);
  EXPECT_GT(baked, 0) << "it bakes: the test can fail";
  for (const int lamp : { 0, 1 })
  {
    chandelier.Lamps[lamp]->SwitchOff();
    stage.Render();
    chandelier.Lamps[lamp]->SwitchOn();
    EXPECT_TRUE(Matches(stage.RenderVisibility(chandelier.Lamps[2]), lit, SameToRounding));
    EXPECT_EQ(pass->GetStatistics().MapsBaked, baked) << "lamp " << lamp;
  }
}

//------------------------------------------------------------------------------
TEST_P(MapMemory, AnotherOrderOfTheLightsBakesNothing)
{
  Chandelier chandelier(3);
  const auto pass = this->MakePass();
  Stage stage(chandelier.Scene.Renderer, pass, 80, 60);
  const Picture before = stage.RenderVisibility(chandelier.Lamps[0]);
  const vtkTypeInt64 baked = pass->GetStatistics().MapsBaked;
  chandelier.AddBackwards();
  EXPECT_TRUE(Matches(stage.RenderVisibility(chandelier.Lamps[0]), before, SameToRounding));
  EXPECT_EQ(pass->GetStatistics().MapsBaked, baked);
}

//------------------------------------------------------------------------------
TEST_P(MapMemory, ALightThatIsRemovedGivesItsMapsBack)
{
  Chandelier chandelier(3);
  const auto pass = this->MakePass();
  Stage stage(chandelier.Scene.Renderer, pass, 80, 60);
  stage.Render();
  const vtkTypeInt64 before = pass->GetStatistics().BytesHeld;
  chandelier.Scene.Renderer->RemoveLight(chandelier.Lamps[2]);
  stage.Render();
  EXPECT_LT(pass->GetStatistics().BytesHeld, before - 256 * 256 * 4);
}

//------------------------------------------------------------------------------
// A map of 256 texels takes 256 KiB, its pyramid less than 192.
TEST_P(MapMemory, ManyLightsShareOneBudget)
{
  constexpr vtkTypeInt64 mebibyte = 1 << 20;
  Picture pictures[2];
  vtkTypeInt64 bytes[2];
  for (const int limit : { 0, 1 })
  {
    Chandelier chandelier(24);
    const auto pass = this->MakePass();
    pass->SetMapMemory(limit == 0 ? 1024 : 4);
    Stage stage(chandelier.Scene.Renderer, pass, 80, 60);
    stage.Render();
    pass->Modified();
    stage.Render();
    pass->Modified();
    const TextureCount textures;
    pictures[limit] = stage.RenderVisibility(chandelier.Lamps[20]);
    bytes[limit] = pass->GetStatistics().BytesHeld;
    EXPECT_EQ(textures.GetNumber(), 0) << "limit " << limit;
  }
  EXPECT_GT(bytes[0], 8 * mebibyte) << "without a limit it is more: the test can fail";
  EXPECT_LT(bytes[1], 8 * mebibyte) << "maps, and what else the pass holds";
  EXPECT_TRUE(Matches(pictures[0], pictures[1], SameToRounding));
}

//------------------------------------------------------------------------------
TEST_P(MapMemory, ASmallerBudgetGivesMemoryBack)
{
  Chandelier chandelier(24);
  const auto pass = this->MakePass();
  Stage stage(chandelier.Scene.Renderer, pass, 80, 60);
  const Picture before = stage.RenderVisibility(chandelier.Lamps[20]);
  const vtkTypeInt64 bytes = pass->GetStatistics().BytesHeld;
  pass->SetMapMemory(4);
  EXPECT_TRUE(Matches(stage.RenderVisibility(chandelier.Lamps[20]), before, SameToRounding));
  EXPECT_LT(pass->GetStatistics().BytesHeld, bytes);
  EXPECT_LT(pass->GetStatistics().BytesHeld, 8 << 20);
}

//------------------------------------------------------------------------------
// Nothing changes for the picture, and a running mean goes on.
TEST_P(MapMemory, AnEqualLightTakesOver)
{
  Chandelier chandelier(1);
  const auto pass = this->MakePass();
  pass->ProgressiveOn();
  Stage stage(chandelier.Scene.Renderer, pass, 80, 60);
  stage.Render();
  stage.Render();
  const vtkSmartPointer<vtkAreaLight> first = chandelier.Lamps[0];
  const auto second = vtkSmartPointer<vtkAreaLight>::New();
  second->DeepCopy(first);
  chandelier.Scene.Renderer->RemoveLight(first);
  chandelier.Scene.Renderer->AddLight(second);
  stage.Render();
  EXPECT_GT(pass->GetStatistics().ProgressiveFrames, 1);
  const Picture visibility = stage.RenderVisibility(second);
  float least = 1.0f;
  for (const float value : visibility.Values)
  {
    least = std::isnan(value) ? least : std::min(least, value);
  }
  EXPECT_LT(least, 0.5f) << "the ball has a shadow still";
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, MapMemory, testing::ValuesIn(TechniquesWithMaps()), NameOfTechnique);
