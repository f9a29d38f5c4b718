// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh that holds the ground and the things on it has the shadows of the two apart.
#include "Props.h"
#include "Stage.h"
#include "Techniques.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SoftShadowsTesting;

namespace
{

class OneMesh : public testing::TestWithParam<Technique>
{
};

// A ball of radius 0.5 over a ground of 1000 x 1000, as one actor or as two.
BallScene MakeGrounds(bool joined)
{
  BallScene scene;
  scene.Renderer = MakeRenderer({ { 0.0, -5.0, 4.0 } }, { { 0.2, 0.0, 0.2 } });
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5, 20.0);
  scene.Lamp = MakeLamp({ { -2.0, 1.0, 4.0 } }, { { 0.0, 0.0, 0.5 } }, 0.4);
  scene.Renderer->AddLight(scene.Lamp);
  scene.Ground = MakeGroundActor(500.0);
  scene.Ball = MakeSphereActor({ { 0.0, 0.0, 0.7 } }, 0.5);
  if (joined)
  {
    vtkNew<vtkAppendPolyData> all;
    for (vtkActor* actor : { scene.Ground.Get(), scene.Ball.Get() })
    {
      actor->GetMapper()->Update();
      all->AddInputData(vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()));
    }
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(all->GetOutputPort());
    scene.Ball->SetMapper(mapper);
  }
  else
  {
    scene.Renderer->AddActor(scene.Ground);
  }
  scene.Renderer->AddActor(scene.Ball);
  return scene;
}

Picture VisibilityOf(bool joined, vtkSoftShadowPass* pass)
{
  const BallScene scene = MakeGrounds(joined);
  Stage stage(scene.Renderer, pass);
  return stage.RenderVisibility(scene.Lamp);
}

double RootMeanSquare(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    if (!std::isnan(a.Values[i]) && !std::isnan(b.Values[i]))
    {
      sum += (a.Values[i] - b.Values[i]) * (a.Values[i] - b.Values[i]);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 1.0;
}

}

//------------------------------------------------------------------------------
TEST_P(OneMesh, HasTheShadowsOfItsParts)
{
  const Technique& sampled = AllTechniques().front();
  static const Picture truth = VisibilityOf(false, sampled.Make(Effort::Accurate, Weights::Mean));
  ASSERT_GT(CountShadowed(truth), 400);
  const auto make = [this] { return this->GetParam().Make(Effort::Moderate, Weights::Mean); };
  const double apart = RootMeanSquare(truth, VisibilityOf(false, make()));
  const double joined = RootMeanSquare(truth, VisibilityOf(true, make()));
  EXPECT_LE(joined, 1.1 * apart);
  this->RecordProperty("apart", std::to_string(apart));
  this->RecordProperty("joined", std::to_string(joined));
}

INSTANTIATE_TEST_SUITE_P(Techniques, OneMesh, testing::ValuesIn(AllTechniques()), NameOfTechnique);
