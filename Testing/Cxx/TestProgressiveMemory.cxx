// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A resting camera: what it holds while it works, what afterwards, and what is shown where memory ends.
#include "ImageComparison.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkStringOutputWindow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace SoftShadowsTesting;

namespace
{

const int Width = 96;
const int Height = 64;

//------------------------------------------------------------------------------
/// While one lives, depth maps of at least so many texels along an edge meet the end of the memory: the
/// driver is asked for far more than there is, and says so itself.
class ScarceMemory
{
public:
  explicit ScarceMemory(int smallest)
  {
    Smallest = smallest;
    Refused = 0;
    Real = glTexImage3D;
    glTexImage3D = &ScarceMemory::Allocate;
    this->Before = vtkOutputWindow::GetInstance();
    vtkOutputWindow::SetInstance(this->Messages);
  }
  ~ScarceMemory()
  {
    glTexImage3D = Real;
    vtkOutputWindow::SetInstance(this->Before);
  }
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;

  std::string GetMessages() { return this->Messages->GetOutput(); }
  int GetRefused() const { return Refused; }

private:
  using Function = decltype(glTexImage3D);
  static Function Real;
  static int Smallest;
  static int Refused;
  vtkNew<vtkStringOutputWindow> Messages;
  vtkSmartPointer<vtkOutputWindow> Before;

  static void Allocate(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
    GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels)
  {
    const bool refuses = internal == GL_DEPTH_COMPONENT32F && width >= Smallest;
    Refused += refuses ? 1 : 0;
    const GLsizei edge = refuses ? 16384 : width;
    Real(target, level, internal, edge, refuses ? edge : height, refuses ? 2048 : depth, border,
      format, type, pixels);
  }
};

ScarceMemory::Function ScarceMemory::Real = nullptr;
int ScarceMemory::Smallest = 0;
int ScarceMemory::Refused = 0;

//------------------------------------------------------------------------------
class ProgressiveMemory : public testing::TestWithParam<Technique>
{
protected:
  void SetUp() override
  {
    this->Pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    this->Pass->ProgressiveOn();
    this->Pass->SetProgressivePoints(64);
    this->Pass->SetMapSize(128);
    this->Pass->SetMapMemory(1); // maps of at most 512 texels
  }

  vtkTypeInt64 GetBytes() { return this->Pass->GetStatistics().BytesHeld; }

  /// Renders until there is nothing to gain; the most bytes held after a frame.
  vtkTypeInt64 Rest(Stage& stage)
  {
    vtkTypeInt64 most = 0;
    for (int frame = 0; frame < 200; ++frame)
    {
      stage.Render();
      most = std::max(most, this->GetBytes());
      if (!this->Pass->GetRefining())
      {
        return most;
      }
    }
    ADD_FAILURE() << "does not come to rest";
    return most;
  }

  vtkSmartPointer<vtkSoftShadowPass> Pass;
};

/// What a light's sums take: three floats per pixel and one per tile.
constexpr vtkTypeInt64 SumBytes = 3 * 4 * Width * Height + 4 * (Width / 32) * (Height / 32);
/// And the means of half the points, while maps are compared.
constexpr vtkTypeInt64 HalfBytes = 2 * 4 * Width * Height;

//------------------------------------------------------------------------------
vtkTypeInt64 MapBytes(int size)
{
  return vtkTypeInt64(4) * size * size;
}

}

//------------------------------------------------------------------------------
TEST_P(ProgressiveMemory, HoldsMapsOfOneSizeAndNothingOnceAtRest)
{
  const BallScene scene = MakeBallScene(0.8);
  this->Pass->SetProgressiveTolerance(0.005);
  Stage stage(scene.Renderer, this->Pass, Width, Height);
  const Picture first = stage.RenderVisibility(scene.Lamp);
  const vtkTypeInt64 alone = this->GetBytes();
  EXPECT_EQ(this->Rest(stage), alone + SumBytes + MapBytes(512)) << "maps of one size at a time";
  EXPECT_EQ(this->GetBytes(), alone) << "at rest";
  const Picture mean = stage.RenderVisibility(scene.Lamp);
  EXPECT_FALSE(Matches(mean, first, Identical)) << "the mean is shown, and stays";
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), mean, Identical));

  // A change begins all anew, but builds no program again.
  const vtkTypeInt64 builds = this->Pass->GetStatistics().ShaderBuilds;
  scene.Lamp->SetPosition(scene.Lamp->GetPosition()[0] + 0.01, 0.0, 4.0);
  EXPECT_GT(this->Rest(stage), this->GetBytes());
  EXPECT_EQ(this->Pass->GetStatistics().ShaderBuilds, builds);
}

//------------------------------------------------------------------------------
TEST_P(ProgressiveMemory, IsGivenBackWhenSwitchedOff)
{
  const BallScene scene = MakeBallScene(0.8);
  Stage stage(scene.Renderer, this->Pass, Width, Height);
  const Picture first = stage.RenderVisibility(scene.Lamp);
  const vtkTypeInt64 alone = this->GetBytes();
  stage.Render();
  EXPECT_EQ(this->GetBytes(), alone + SumBytes + HalfBytes + MapBytes(64));
  EXPECT_TRUE(this->Pass->GetRefining());
  this->Pass->ProgressiveOff();
  EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), first, SameToRounding));
  EXPECT_EQ(this->GetBytes(), alone);
}

//------------------------------------------------------------------------------
// The light is never lost: the mean goes on with the maps that there are.
TEST_P(ProgressiveMemory, GoesOnWithCoarserMapsWhereItEnds)
{
  const BallScene scene = MakeBallScene(0.8);
  this->Pass->SetProgressiveTolerance(0.005);
  this->Pass->SetProgressivePoints(16);
  Stage stage(scene.Renderer, this->Pass, Width, Height);
  const Picture first = stage.RenderVisibility(scene.Lamp);
  const vtkTypeInt64 alone = this->GetBytes();
  ScarceMemory scarce(512);
  for (int frame = 0; frame < 400 && this->Pass->GetRefining(); ++frame)
  {
    const Picture shown = stage.RenderVisibility(scene.Lamp);
    ASSERT_LT(Compare(shown, first, Identical).RootMeanSquare, 0.1) << "frame " << frame;
  }
  EXPECT_EQ(scarce.GetRefused(), 1) << "asked for again and again, or not at all";
  EXPECT_FALSE(this->Pass->GetRefining());
  EXPECT_LT(this->Pass->GetEstimatedError(), 1.0) << "it knows its error all the same";
  EXPECT_NE(scarce.GetMessages().find("the mean goes on with 256"), std::string::npos)
    << scarce.GetMessages();
  EXPECT_EQ(this->GetBytes(), alone);
}

//------------------------------------------------------------------------------
TEST_P(ProgressiveMemory, TheTechniquesPictureStaysWithoutAny)
{
  const BallScene scene = MakeBallScene(0.8);
  for (const int smallest : { 64, 128 })
  {
    const auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    pass->SetMapSize(128);
    pass->ProgressiveOn();
    pass->SetProgressivePoints(48);
    Stage stage(scene.Renderer, pass, Width, Height);
    const Picture first = stage.RenderVisibility(scene.Lamp);
    ScarceMemory scarce(smallest);
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(Matches(stage.RenderVisibility(scene.Lamp), first, SameToRounding)) << frame;
    }
    EXPECT_FALSE(pass->GetRefining());
    EXPECT_FALSE(pass->GetConverged());
    EXPECT_EQ(pass->GetEstimatedError(), 1.0);
    EXPECT_NE(scarce.GetMessages().find("the picture stays"), std::string::npos);
  }
}

// All of this is the base class's: one technique with a map from the light's centre, and one without.
INSTANTIATE_TEST_SUITE_P(Techniques, ProgressiveMemory,
  testing::Values(AllTechniques()[0], AllTechniques()[1]), NameOfTechnique);
