// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HardCaseJudge.h"

#include "OffscreenWindow.h"
#include "ReferenceTracer.h"
#include "Stage.h"

#include "vtkCollection.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"
#include "vtkSoftShadowsOpenGL.h"

#include <cmath>

namespace SoftShadowsTesting
{
namespace
{

// The ray tracer's own error is then 0.3 * 16^-1.5 = 0.005 at an edge across the light.
const int RaysPerAxis = 16;

// A pixel shows the same surface if its depth is the same to this share.
const double DepthPrecision = 2e-3;

//------------------------------------------------------------------------------
Picture BottomRowFirst(const std::vector<float>& values, int width, int height)
{
  Picture picture(width, height, 1);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      picture.At(x, height - 1 - y) = values[static_cast<std::size_t>(y) * width + x];
    }
  }
  return picture;
}

//------------------------------------------------------------------------------
/// The light's number among those that are on; -1 if it is not.
int LitNumberOf(vtkRenderer* renderer, vtkLight* wanted)
{
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  int number = 0;
  while (vtkLight* light = renderer->GetLights()->GetNextLight(iterator))
  {
    if (light == wanted)
    {
      return light->GetSwitch() ? number : -1;
    }
    number += light->GetSwitch() ? 1 : 0;
  }
  return -1;
}

//------------------------------------------------------------------------------
bool IsSameDepth(float first, float second)
{
  return (std::isnan(first) && std::isnan(second)) ||
    std::abs(first - second) <= DepthPrecision * std::abs(first);
}

//------------------------------------------------------------------------------
int CountOpenGLErrors()
{
  int count = 0;
  while (count < 100 && glGetError() != GL_NO_ERROR)
  {
    ++count;
  }
  return count;
}

}

//------------------------------------------------------------------------------
HardCaseJudge::HardCaseJudge(const HardCase& hardCase)
  : Scene(hardCase.Make())
  , Settings(hardCase.Settings)
  , Window(new Stage(this->Scene.Renderer, nullptr, this->Scene.Width, this->Scene.Height))
{
  for (vtkRenderer* other : this->Scene.Others)
  {
    this->Window->GetWindow().Get()->SetNumberOfLayers(2);
    this->Window->GetWindow().Add(other);
  }
  this->Window->Render(); // lights that follow the camera have their places now
  this->Trace();
}

//------------------------------------------------------------------------------
HardCaseJudge::~HardCaseJudge() = default;

//------------------------------------------------------------------------------
void HardCaseJudge::Trace()
{
  vtkRenderer* renderer = this->Scene.Renderer;
  const int* size = renderer->GetSize();
  const softshadows::ReferenceTracer tracer(size[0], size[1], RaysPerAxis);
  const auto result = tracer.Trace(renderer);
  const int number = LitNumberOf(renderer, this->Scene.Light);
  this->Truth = BottomRowFirst(
    result.Visibility.at(static_cast<std::size_t>(number)), result.Width, result.Height);
  this->TrueDepth = BottomRowFirst(result.Depth, result.Width, result.Height);
}

//------------------------------------------------------------------------------
Judgement HardCaseJudge::Judge(const Technique& technique)
{
  const auto pass = technique.Make(this->Settings, Weights::Mean);
  for (vtkRenderer* other : this->Scene.Others)
  {
    UsePass(other, technique.Make(this->Settings, Weights::Mean));
  }
  this->Window->SetPass(pass);
  CountOpenGLErrors();
  Judgement result;
  result.Visibility = this->Window->RenderVisibility(this->Scene.Light);
  const Picture depth = PictureOf(pass->GetDepthImage());
  result.OpenGLErrors = CountOpenGLErrors();
  double squares = 0.0;
  int unlike = 0;
  for (std::size_t i = 0; i < this->Truth.Values.size(); ++i)
  {
    const float v = result.Visibility.Values[i];
    const float truth = this->Truth.Values[i];
    result.OutOfRange += v < 0.0f || v > 1.0f ? 1 : 0;
    if (!IsSameDepth(this->TrueDepth.Values[i], depth.Values[i]) ||
      std::isnan(v) != std::isnan(truth))
    {
      ++unlike;
    }
    else if (!std::isnan(v))
    {
      ++result.Compared;
      result.Shadowed += truth < 0.9f ? 1 : 0;
      result.Bias += v - truth;
      squares += (v - truth) * (v - truth);
    }
  }
  result.ShareUnlike = static_cast<double>(unlike) / this->Truth.Values.size();
  result.Rmse = std::sqrt(squares / std::max(result.Compared, 1));
  result.Bias /= std::max(result.Compared, 1);
  this->Window->SetPass(nullptr);
  return result;
}

//------------------------------------------------------------------------------
double HardCaseJudge::Distance(const Picture& first, const Picture& second)
{
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < first.Values.size() && i < second.Values.size(); ++i)
  {
    const double difference = first.Values[i] - second.Values[i];
    if (!std::isnan(difference))
    {
      squares += difference * difference;
      ++count;
    }
  }
  return std::sqrt(squares / std::max(count, 1));
}

}
