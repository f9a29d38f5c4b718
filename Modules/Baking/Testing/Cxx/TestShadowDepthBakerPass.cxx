// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLObjectCounter.h"
#include "GLStateSnapshot.h"
#include "OffscreenWindow.h"
#include "StoredPicture.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthBakerPass.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowTextureArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
// A box on a plane under a square light, with the baker in VTK's own chain of passes.
class ShadowDepthBakerPass : public testing::Test
{
protected:
  ShadowDepthBakerPass()
    : Window(64, 64)
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(-0.5, 0.5, -0.5, 0.5, 0.0, 1.0);
    this->Box = this->AddActor(box);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-100.0, -100.0, 0.0);
    plane->SetPoint1(100.0, -100.0, 0.0);
    plane->SetPoint2(-100.0, 100.0, 0.0);
    this->AddActor(plane);

    this->Renderer->AutomaticLightCreationOff();
    this->Light->SetPosition(0.0, 0.0, 5.0);
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Light->SetConeAngle(60.0);
    this->Light->SetSize(0.4, 0.4);
    this->Renderer->AddLight(this->Light);
    this->Renderer->GetActiveCamera()->SetPosition(0.0, -8.0, 5.0);
    this->Renderer->ResetCameraClippingRange();

    vtkNew<vtkLightsPass> lights;
    vtkNew<vtkOpaquePass> opaque;
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(lights);
    passes->AddItem(this->Baker);
    passes->AddItem(opaque);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    this->Baker->SetMapSize(64);
    this->Renderer->SetPass(camera);
    this->Window.Add(this->Renderer);
  }

  ~ShadowDepthBakerPass() override
  {
    this->Window.GetOpenGL()->MakeCurrent();
    this->Renderer->SetPass(nullptr);
    this->Baker->ReleaseGraphicsResources(this->Window.Get());
  }

  vtkSmartPointer<vtkActor> AddActor(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  int BakesOfAFrame()
  {
    this->Window.Render();
    return this->Baker->GetNumberOfBakes();
  }

  SoftShadowsTesting::OffscreenWindow Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAreaLight> Light;
  vtkNew<vtkShadowDepthBakerPass> Baker;
  vtkSmartPointer<vtkActor> Box;
};
}

//------------------------------------------------------------------------------
TEST_F(ShadowDepthBakerPass, SavesADepthMapAsAnImage)
{
  this->Window.Render();
  EXPECT_EQ(this->Baker->GetNumberOfLights(), 1);
  auto image = this->Baker->GetDepthImage(this->Light, 0);
  ASSERT_TRUE(image);
  // The box alone casts: its window is the top face's, half 0.5 / 4 at distance 4, and margins.
  EXPECT_NEAR(image->GetOrigin()[0], -0.125 * (1.0 + 2.0 / 30.0), 0.003);

  const std::string path = std::string(SOFTSHADOWS_TEST_OUTPUT_DIR) + "/ShadowDepthBakerPass.exr";
  SoftShadowsTesting::WritePicture(path, SoftShadowsTesting::PictureOf(image));
  const auto read = SoftShadowsTesting::ReadPicture(path);
  ASSERT_EQ(read.Width, 64);
  ASSERT_EQ(read.Height, 64);
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      const double u = image->GetOrigin()[0] + i * image->GetSpacing()[0];
      const double v = image->GetOrigin()[1] + j * image->GetSpacing()[1];
      const double beyond = std::max(std::abs(u), std::abs(v)) - 0.125;
      if (beyond < -0.01)
      {
        EXPECT_NEAR(read.At(i, j), 4.0, 1e-5) << i << ", " << j;
      }
      else if (beyond > image->GetSpacing()[0])
      {
        EXPECT_TRUE(std::isinf(read.At(i, j))) << i << ", " << j << ": the ground is no caster";
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(ShadowDepthBakerPass, BakesOnceForEachChange)
{
  EXPECT_EQ(this->BakesOfAFrame(), 1);
  EXPECT_EQ(this->BakesOfAFrame(), 0) << "still";
  this->Renderer->GetActiveCamera()->Azimuth(20.0);
  this->Renderer->ResetCameraClippingRange();
  EXPECT_EQ(this->BakesOfAFrame(), 0) << "the camera moved";
  this->Box->SetPosition(0.1, 0.0, 0.0);
  EXPECT_EQ(this->BakesOfAFrame(), 1) << "an actor moved";
  EXPECT_EQ(this->BakesOfAFrame(), 0);
  this->Light->SetPosition(0.5, 0.0, 5.0);
  EXPECT_EQ(this->BakesOfAFrame(), 1) << "the light moved";
  this->Light->SetIntensity(0.5);
  EXPECT_EQ(this->BakesOfAFrame(), 0) << "only its intensity";
  this->Baker->SetMapSize(32);
  EXPECT_EQ(this->BakesOfAFrame(), 1) << "another size";
  this->Baker->SetNumberOfSamples(9);
  EXPECT_EQ(this->BakesOfAFrame(), 9) << "nine sample points";
  EXPECT_EQ(this->BakesOfAFrame(), 0);
}

//------------------------------------------------------------------------------
TEST_F(ShadowDepthBakerPass, LightsThatDoNotCountBakeNothing)
{
  EXPECT_EQ(this->BakesOfAFrame(), 1);
  vtkNew<vtkLight> off;
  off->SwitchOff();
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  // Before the light that counts.
  vtkLightCollection* lights = this->Renderer->GetLights();
  lights->RemoveAllItems();
  this->Renderer->AddLight(off);
  this->Renderer->AddLight(this->Light);
  EXPECT_EQ(this->BakesOfAFrame(), 0) << "its maps are its own, wherever it stands";
  EXPECT_EQ(this->Baker->GetNumberOfLights(), 1);
  EXPECT_EQ(this->Baker->GetDepthMaps(off), nullptr);

  this->Renderer->AddLight(head);
  this->Window.Render();
  this->Renderer->GetActiveCamera()->Azimuth(20.0);
  this->Renderer->ResetCameraClippingRange();
  auto* maps = this->Baker->GetDepthMaps(this->Light);
  ASSERT_TRUE(maps);
  const auto time = maps->GetBakeTime();
  this->Window.Render();
  EXPECT_EQ(this->Baker->GetDepthMaps(this->Light), maps);
  EXPECT_EQ(maps->GetBakeTime(), time) << "a moving headlight is another light's business";
  this->Light->SwitchOff();
  this->Window.Render();
  EXPECT_EQ(this->Baker->GetDepthMaps(this->Light), nullptr);
  EXPECT_EQ(this->Baker->GetLightReport().find("light 1"), std::string::npos) << "one is lit";
}

//------------------------------------------------------------------------------
TEST_F(ShadowDepthBakerPass, LeavesStateAndObjectsAsTheyWere)
{
  // The same chain with nothing to bake, then with it.
  vtkShadowCasters::SetCastsShadow(this->Box, false);
  this->Window.Render();
  ASSERT_EQ(this->Baker->GetNumberOfBakes(), 0);
  vtkOpenGLRenderWindow* window = this->Window.GetOpenGL();
  const auto objects = SoftShadowsTesting::CountGLObjects(window);
  const SoftShadowsTesting::GLStateSnapshot before(window);
  vtkShadowCasters::SetCastsShadow(this->Box, true);
  this->Baker->SetNumberOfSamples(4);
  this->Window.Render();
  const SoftShadowsTesting::GLStateSnapshot after(window);
  EXPECT_EQ(before.DifferenceTo(after), "");
  EXPECT_EQ(SoftShadowsTesting::StateCacheErrors(window), "");
  EXPECT_EQ(this->Baker->GetNumberOfBakes(), 4);
  this->Baker->ReleaseGraphicsResources(window);
  auto released = SoftShadowsTesting::CountGLObjects(window);
  released.Programs = objects.Programs; // the window's shader cache keeps them
  released.Shaders = objects.Shaders;
  EXPECT_EQ(released, objects);
}
