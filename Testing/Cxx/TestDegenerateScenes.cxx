// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Input that has no good answer gets a finite one, and no complaint from OpenGL.
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace SoftShadowsTesting;

namespace
{

class Degenerate : public testing::TestWithParam<Technique>
{
protected:
  void SetUp() override { this->Scene = MakeBallScene(); }

  /// Every visibility is finite or NaN for "none", and lies in [0, 1].
  Picture Draw(vtkLight* light)
  {
    const auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
    Stage stage(this->Scene.Renderer, pass, 80, 60);
    Picture visibility = stage.RenderVisibility(light);
    for (const float v : visibility.Values)
    {
      EXPECT_TRUE(std::isnan(v) || (v >= 0.0f && v <= 1.0f)) << v;
    }
    return visibility;
  }

  BallScene Scene;
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeTriangles(const std::vector<Point>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k)
    {
      ids[k] = points->InsertNextPoint(corners[i + k].data());
    }
    cells->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

}

//------------------------------------------------------------------------------
TEST_P(Degenerate, EmptyScene)
{
  this->Scene.Renderer->RemoveAllViewProps();
  const Picture visibility = this->Draw(this->Scene.Lamp);
  EXPECT_EQ(CountWithoutValue(visibility), 80 * 60);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, NoLight)
{
  this->Scene.Renderer->RemoveAllLights();
  const auto pass = this->GetParam().Make(Effort::Quick, Weights::Mean);
  Stage stage(this->Scene.Renderer, pass, 80, 60);
  stage.Render();
  EXPECT_EQ(pass->GetVisibilityImage(this->Scene.Lamp).Get(), nullptr);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, EmptyDataSet)
{
  this->Scene.Renderer->AddActor(MakeTriangles({}));
  EXPECT_GT(CountShadowed(this->Draw(this->Scene.Lamp)), 20);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, TrianglesWithoutArea)
{
  this->Scene.Renderer->AddActor(MakeTriangles({ { { 0.0, 0.0, 2.0 } }, { { 0.0, 0.0, 2.0 } },
    { { 0.0, 0.0, 2.0 } }, { { -1.0, 0.0, 2.0 } }, { { 0.0, 0.0, 2.0 } }, { { 1.0, 0.0, 2.0 } } }));
  EXPECT_GT(CountShadowed(this->Draw(this->Scene.Lamp)), 20);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, PointsThatAreNoNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Scene.Renderer->AddActor(MakeTriangles({ { { nan, 0.0, 1.0 } }, { { 1.0, nan, 1.0 } },
    { { 0.0, 1.0, nan } }, { { -0.2, 0.0, 2.0 } }, { { 0.2, 0.0, 2.0 } }, { { 0.0, 0.2, 2.0 } } }));
  EXPECT_GT(CountShadowed(this->Draw(this->Scene.Lamp)), 20);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, LightInsideTheCaster)
{
  this->Scene.Lamp->SetPosition(0.0, 0.0, 0.9);
  this->Draw(this->Scene.Lamp);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, LightOnTheReceiver)
{
  this->Scene.Lamp->SetPosition(1.0, 0.5, 0.0);
  this->Scene.Lamp->SetFocalPoint(0.0, 0.0, 0.9);
  this->Draw(this->Scene.Lamp);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, LightWithoutDirection)
{
  this->Scene.Lamp->SetFocalPoint(this->Scene.Lamp->GetPosition());
  this->Draw(this->Scene.Lamp);
}

//------------------------------------------------------------------------------
TEST_P(Degenerate, HugeLight)
{
  this->Scene.Lamp->SetSize(100.0, 100.0);
  this->Draw(this->Scene.Lamp);
}

//------------------------------------------------------------------------------
// What casts stands behind the lamp, and the ground casts nothing: no map is drawn.
TEST_P(Degenerate, NothingInFrontOfTheLamp)
{
  this->Scene.Lamp->SetPosition(0.0, 0.0, 0.4);
  this->Scene.Lamp->SetFocalPoint(0.0, 0.0, 0.0);
  this->Scene.Lamp->SetSize(0.1, 0.1);
  vtkShadowCasters::SetCastsShadow(this->Scene.Ground, false);
  this->Scene.Ball->SetPosition(0.0, 0.0, 3.0);
  const Picture visibility = this->Draw(this->Scene.Lamp);
  int lit = 0;
  for (const float v : visibility.Values)
  {
    lit += v == 1.0f ? 1 : 0;
  }
  EXPECT_GT(lit, 80 * 60 / 4);
  EXPECT_EQ(CountShadowed(visibility), 0);
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, Degenerate, testing::ValuesIn(AllTechniques()), NameOfTechnique);
