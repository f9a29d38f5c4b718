// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The tools of the other tests: each must be able to say that something is wrong.
#include "GLObjectCounter.h"
#include "GLStateSnapshot.h"
#include "ImageComparison.h"
#include "OffscreenWindow.h"
#include "StoredPicture.h"
#include "WorldPositions.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTextureObject.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

using namespace SoftShadowsTesting;

namespace
{

//------------------------------------------------------------------------------
Picture Ramp(int width, int height, int channels)
{
  Picture picture(width, height, channels);
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    picture.Values[i] = static_cast<float>(i % 256) / 255.0f;
  }
  return picture;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeSphere(double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, y, z);
  source->SetRadius(radius);
  source->SetThetaResolution(32);
  source->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

}

//------------------------------------------------------------------------------
TEST(Picture, SurvivesFiles)
{
  const std::string folder = SOFTSHADOWS_TEST_OUTPUT_DIR;
  const Picture bytes = Ramp(37, 11, 3);
  WritePicture(folder + "/UnitTestSupport.png", bytes);
  const Picture read = ReadPicture(folder + "/UnitTestSupport.png");
  ASSERT_TRUE(Matches(read, bytes, SameToRounding));
  EXPECT_LT(Compare(read, bytes, Identical).Maximum, 1e-6); // exactly the same bytes
  Picture floats = Ramp(5, 7, 1);
  floats.At(2, 6) = 1e-7f;
  WritePicture(folder + "/UnitTestSupport.exr", floats);
  EXPECT_TRUE(Matches(ReadPicture(folder + "/UnitTestSupport.exr"), floats, Identical));
  EXPECT_THROW(ReadPicture(folder + "/no such picture.png"), std::runtime_error);
}

//------------------------------------------------------------------------------
TEST(ImageComparison, SeesWhatDiffers)
{
  const Picture first = Ramp(100, 100, 1);
  Picture second = first;
  EXPECT_TRUE(Matches(first, second, Identical));
  second.At(30, 40) += 0.5f;
  EXPECT_FALSE(Matches(first, second, Identical));
  const Difference d = Compare(first, second, Identical);
  EXPECT_EQ(d.X, 30);
  EXPECT_EQ(d.Y, 40);
  EXPECT_NEAR(d.Maximum, 0.5, 1e-6);
  EXPECT_NEAR(d.RootMeanSquare, 0.5 / 100.0, 1e-6);
  EXPECT_NEAR(d.ShareOff, 1e-4, 1e-9);
  EXPECT_FALSE(Matches(first, Picture(100, 99, 1), BaselinePicture));
}

//------------------------------------------------------------------------------
TEST(ImageComparison, SeesBrightnessThatHidesInEveryPixel)
{
  const Picture first(64, 64, 1, 0.5f);
  EXPECT_FALSE(Matches(first, Picture(64, 64, 1, 0.506f), BaselinePicture));
  EXPECT_TRUE(Matches(first, Picture(64, 64, 1, 0.503f), SameToRounding));
  EXPECT_FALSE(Matches(first, Picture(64, 64, 1, 0.505f), SameToRounding));
}

//------------------------------------------------------------------------------
TEST(ImageComparison, SeesNaNs)
{
  Picture first(4, 4, 1, 0.5f);
  Picture second = first;
  first.At(1, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(Matches(first, second, BaselinePicture));
  second.At(1, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Matches(first, second, Identical));
}

//------------------------------------------------------------------------------
TEST(ImageComparison, MissingBaselineFailsAndWritesThePicture)
{
  const std::string folder = SOFTSHADOWS_TEST_OUTPUT_DIR;
  const std::string written = folder + "/UnitTestSupportMissing.png";
  std::filesystem::remove(written);
  const auto result = MatchesBaseline(
    Ramp(8, 8, 3), "UnitTestSupportMissing.png", folder + "/nowhere", folder, BaselinePicture);
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find(written), std::string::npos) << result.message();
  EXPECT_TRUE(std::filesystem::exists(written));
}

//------------------------------------------------------------------------------
TEST(OffscreenWindow, SaysThatThereIsNoDisplay)
{
  const char* display = std::getenv("DISPLAY");
  const std::string before = display ? display : "";
  setenv("DISPLAY", "", 1);
  EXPECT_THROW(OffscreenWindow(8, 8), std::runtime_error);
  setenv("DISPLAY", before.c_str(), 1);
}

//------------------------------------------------------------------------------
TEST(OffscreenWindow, ReadsWhatWasDrawn)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 0.0, 51.0 / 255.0);
  OffscreenWindow window(30, 20);
  window.Add(renderer);
  window.Render();
  Picture expected(30, 20, 3);
  for (int i = 0; i < 30 * 20; ++i)
  {
    expected.Values[3 * i] = 1.0f;
    expected.Values[3 * i + 2] = 51.0f / 255.0f;
  }
  EXPECT_TRUE(Matches(window.Read(), expected, Identical));
}

//------------------------------------------------------------------------------
// A tiny sphere stands where a pixel says it looks: its picture must be at that pixel.
TEST(WorldPositions, PixelsShowThem)
{
  const int width = 64;
  const int height = 40;
  for (const bool parallel : { false, true })
  {
    vtkNew<vtkRenderer> renderer;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(3.0, -4.0, 5.0);
    camera->SetFocalPoint(0.2, 0.1, 0.0);
    camera->SetViewUp(0.1, 0.0, 1.0);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(2.0);
    const Plane plane{ { { 0.0, 0.0, 0.3 } }, { { 0.1, 0.2, 1.0 } } };
    OffscreenWindow window(width, height);
    window.Add(renderer);
    for (const auto& pixel : { std::array<int, 2>{ { 12, 31 } }, { { 55, 8 } }, { { 32, 20 } } })
    {
      const auto positions = PlanePositions(renderer, width, height, plane);
      const Point p = positions[pixel[1] * width + pixel[0]];
      auto sphere = MakeSphere(p[0], p[1], p[2], 0.06);
      renderer->AddActor(sphere);
      renderer->ResetCameraClippingRange();
      window.Render();
      const Picture picture = window.Read();
      renderer->RemoveActor(sphere);
      double sum[3] = { 0.0, 0.0, 0.0 };
      for (int y = 0; y < height; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          sum[0] += picture.At(x, y);
          sum[1] += picture.At(x, y) * x;
          sum[2] += picture.At(x, y) * y;
        }
      }
      ASSERT_GT(sum[0], 0.0) << "pixel " << pixel[0] << ' ' << pixel[1];
      EXPECT_NEAR(sum[1] / sum[0], pixel[0], 0.51) << (parallel ? "parallel" : "perspective");
      EXPECT_NEAR(sum[2] / sum[0], pixel[1], 0.51) << (parallel ? "parallel" : "perspective");
    }
  }
}

//------------------------------------------------------------------------------
TEST(GLObjectCounter, SeesATexture)
{
  OffscreenWindow window(16, 16);
  vtkNew<vtkRenderer> renderer;
  window.Add(renderer);
  window.Render();
  const GLObjectCounts before = CountGLObjects(window.GetOpenGL());
  {
    vtkNew<vtkTextureObject> texture;
    texture->SetContext(window.GetOpenGL());
    ASSERT_TRUE(texture->Allocate2D(4, 4, 4, VTK_FLOAT));
    texture->Activate();
    const GLObjectCounts during = CountGLObjects(window.GetOpenGL());
    EXPECT_EQ(during.Textures, before.Textures + 1) << during;
    EXPECT_EQ(during.TextureUnits, before.TextureUnits + 1) << during;
    texture->Deactivate();
    texture->ReleaseGraphicsResources(window.GetOpenGL());
  }
  const GLObjectCounts after = CountGLObjects(window.GetOpenGL());
  EXPECT_EQ(before, after);
}

//------------------------------------------------------------------------------
TEST(GLStateSnapshot, SeesAViewport)
{
  OffscreenWindow window(16, 16);
  vtkNew<vtkRenderer> renderer;
  window.Add(renderer);
  window.Render();
  const GLStateSnapshot before(window.GetOpenGL());
  EXPECT_EQ(before.DifferenceTo(GLStateSnapshot(window.GetOpenGL())), "");
  EXPECT_EQ(StateCacheErrors(window.GetOpenGL()), "");
  vtkOpenGLState* state = window.GetOpenGL()->GetState();
  state->vtkglViewport(1, 2, 3, 4);
  const GLStateSnapshot after(window.GetOpenGL());
  const std::string difference = before.DifferenceTo(after);
  EXPECT_NE(difference.find("viewport"), std::string::npos) << difference;
}
