// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The lines of the first page, copied into a program: they give a soft shadow in a scene that is lit.
#include "OffscreenWindow.h"
#include "StoredPicture.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{

#include "ReadmeSnippets.inc"

constexpr int Width = 200;
constexpr int Height = 150;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
std::vector<float> Values(vtkImageData* image)
{
  std::vector<float> values(Width * Height);
  for (int i = 0; image && i < Width * Height; ++i)
  {
    values[i] = image->GetScalarComponentAsFloat(i % Width, i / Width, 0, 0);
  }
  return values;
}

//------------------------------------------------------------------------------
struct Sum
{
  int Count = 0;
  double Brightness = 0.0;
  void Add(double brightness)
  {
    ++this->Count;
    this->Brightness += brightness;
  }
  double Mean() const { return this->Brightness / this->Count; }
};

class Snippet : public testing::TestWithParam<size_t>
{
};

}

//------------------------------------------------------------------------------
TEST_P(Snippet, GivesASoftShadowInALitScene)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-4.0, -4.0, 0.0);
  plane->SetPoint1(4.0, -4.0, 0.0);
  plane->SetPoint2(-4.0, 4.0, 0.0);
  AddActor(renderer, plane);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.0, 0.0, 0.7);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  const vtkSmartPointer<vtkActor> ball = AddActor(renderer, sphere);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(1.5, -6.0, 3.5);
  camera->SetFocalPoint(-0.2, -0.2, 0.2);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  Snippets[this->GetParam()](renderer);

  vtkAreaLight* lamp = nullptr;
  for (int i = 0; i < renderer->GetLights()->GetNumberOfItems() && !lamp; ++i)
  {
    lamp = vtkAreaLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(i));
  }
  ASSERT_NE(lamp, nullptr);
  auto* steps = vtkRenderStepsPass::SafeDownCast(renderer->GetPass());
  ASSERT_NE(steps, nullptr);
  auto* pass = vtkSoftShadowPass::SafeDownCast(steps->GetOpaquePass());
  ASSERT_NE(pass, nullptr);

  OffscreenWindow window(Width, Height);
  window.Add(renderer);
  window.Render();
  const Picture picture = window.Read();
  WritePicture(
    SOFTSHADOWS_TEST_OUTPUT_DIR "/README-" + std::to_string(this->GetParam()) + ".png", picture);
  const std::vector<float> visibility = Values(pass->GetVisibilityImage(lamp));
  const std::vector<float> depth = Values(pass->GetDepthImage());
  ball->VisibilityOff();
  window.Render();
  const std::vector<float> groundDepth = Values(pass->GetDepthImage());

  int penumbra = 0;
  Sum lit;
  Sum shadowed; // on the ball too
  for (int i = 0; i < Width * Height; ++i)
  {
    const bool isGround = depth[i] == groundDepth[i];
    const double brightness = picture.At(i % Width, i / Width, 1);
    if (visibility[i] > 0.99F && isGround)
    {
      lit.Add(brightness);
    }
    else if (visibility[i] < 0.01F)
    {
      shadowed.Add(brightness);
    }
    penumbra += isGround && visibility[i] > 0.1F && visibility[i] < 0.9F ? 1 : 0;
  }
  EXPECT_GT(penumbra, 100);
  ASSERT_GT(lit.Count, 5000);
  ASSERT_GT(shadowed.Count, 300);
  EXPECT_GT(lit.Mean(), 0.3);
  EXPECT_LT(lit.Mean(), 0.95) << "overexposed";
  EXPECT_GT(shadowed.Mean(), 0.02);
  EXPECT_LT(shadowed.Mean(), 0.5 * lit.Mean()) << "a shadow is seen";
  window.Remove(renderer);
}

INSTANTIATE_TEST_SUITE_P(
  Readme, Snippet, testing::Range(static_cast<size_t>(0), std::size(Snippets)));
