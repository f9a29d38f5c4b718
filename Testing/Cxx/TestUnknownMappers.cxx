// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers that draw elsewhere than they are told, where a warning says that nothing is received, and
// those that draw more than is seen.
#include "Faults.h"
#include "Picture.h"
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSphereSource.h"

#if __has_include("vtkOpenGLLowMemoryPolyDataMapper.h")
#include "vtkCubeSource.h"
#include "vtkOpenGLLowMemoryPolyDataMapper.h"
#include "vtkProperty.h"
#endif
#ifdef SOFTSHADOWS_HAS_SURFACE_LIC
#include "vtkSurfaceLICMapper.h"
#endif

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

#ifdef SOFTSHADOWS_HAS_SURFACE_LIC
namespace
{

//------------------------------------------------------------------------------
/// A ball with a flow around its axis.
vtkSmartPointer<vtkPolyData> MakeFlow()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 0.0, 0.9);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  ball->Update();
  const vtkSmartPointer<vtkPolyData> data = ball->GetOutput();
  vtkNew<vtkFloatArray> flow;
  flow->SetName("flow");
  flow->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double normal[3];
    data->GetPointData()->GetNormals()->GetTuple(i, normal);
    flow->InsertNextTuple3(-normal[1], normal[0], 0.1);
  }
  data->GetPointData()->SetVectors(flow);
  return data;
}

}

//------------------------------------------------------------------------------
TEST(UnknownMappers, SurfaceLICCastsAndIsTold)
{
  const BallScene scene = MakeBallScene();
  const auto pass = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
  Stage stage(scene.Renderer, pass, 120, 90);
  const Picture expected = stage.RenderVisibility(scene.Lamp);
  vtkNew<vtkSurfaceLICMapper> mapper; // does not outlive its window
  mapper->SetInputData(MakeFlow());
  mapper->SetInputArrayToProcess(0, 0, 0, 0, "flow");
  const vtkSmartPointer<vtkMapper> plain = scene.Ball->GetMapper();
  scene.Ball->SetMapper(mapper);
  Messages messages;
  const Picture actual = stage.RenderVisibility(scene.Lamp);
  stage.Render();
  EXPECT_EQ(messages.Count("No shadow falls on what vtkSurfaceLICMapper draws"), 1)
    << messages.Get();
  EXPECT_GT(CountShadowed(actual), CountShadowed(expected) / 3) << "what it casts on the ground";
  scene.Ball->SetMapper(plain);
}
#endif

#if __has_include("vtkOpenGLLowMemoryPolyDataMapper.h")
//------------------------------------------------------------------------------
// It draws wireframes as surfaces whose insides are transparent: through them the ground is seen.
TEST(UnknownMappers, HolesOfAWireframeAreNoReceivers)
{
  const BallScene scene = MakeBallScene();
  const auto pass = AllTechniques().front().Make(Effort::Quick, Weights::Mean);
  Stage stage(scene.Renderer, pass, 120, 90);
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(0.0, 0.0, 0.9);
  vtkNew<vtkOpenGLLowMemoryPolyDataMapper> mapper; // does not outlive its window
  mapper->SetInputConnection(cube->GetOutputPort());
  const vtkSmartPointer<vtkMapper> former = scene.Ball->GetMapper();
  scene.Ball->SetMapper(mapper);
  scene.Renderer->ResetCameraClippingRange();
  const auto depths = [&]
  {
    stage.Render();
    return PictureOf(pass->GetDepthImage());
  };
  const Picture filled = depths();
  scene.Ball->GetProperty()->SetRepresentationToWireframe();
  const Picture wires = depths();
  scene.Ball->VisibilityOff();
  const Picture ground = depths();
  int covered = 0;
  int seen = 0;
  for (int y = 0; y < ground.Height; ++y)
  {
    for (int x = 0; x < ground.Width; ++x)
    {
      const bool isCube = !(filled.At(x, y) == ground.At(x, y)) && !std::isnan(filled.At(x, y));
      covered += isCube ? 1 : 0;
      const bool isHole = wires.At(x, y) == ground.At(x, y) ||
        (std::isnan(wires.At(x, y)) && std::isnan(ground.At(x, y)));
      seen += isCube && isHole ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 500);
  EXPECT_GT(seen, covered / 2);
  EXPECT_LT(seen, covered) << "the wires";
  scene.Ball->SetMapper(former);
}
#endif
