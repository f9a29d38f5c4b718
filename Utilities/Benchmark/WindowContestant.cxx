// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WindowContestant.h"

#include "vtkSoftShadowPass.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath> // For distances

namespace softshadows
{
namespace
{

// Of the distance to what is looked at or lit: far below a texel, far above rounding in double.
constexpr double StepShare = 1e-7;

//--------------------------------------------------------------------------------------------------
void Displace(double position[3], const double focalPoint[3], int frame)
{
  double distance = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    distance += (position[i] - focalPoint[i]) * (position[i] - focalPoint[i]);
  }
  position[0] += (frame % 2 ? StepShare : -StepShare) * std::sqrt(distance);
}

//--------------------------------------------------------------------------------------------------
// Rows the other way round.
template <typename T>
std::vector<T> Flipped(const T* values, int rowLength, int rows)
{
  std::vector<T> result;
  result.reserve(static_cast<size_t>(rowLength) * rows);
  for (int row = rows - 1; row >= 0; --row)
  {
    const T* first = values + static_cast<size_t>(row) * rowLength;
    result.insert(result.end(), first, first + rowLength);
  }
  return result;
}

}

//--------------------------------------------------------------------------------------------------
void MoveALittle(vtkRenderer* renderer, Motion motion, int frame)
{
  double position[3];
  double focalPoint[3];
  if (motion == Motion::Camera)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->GetPosition(position);
    camera->GetFocalPoint(focalPoint);
    Displace(position, focalPoint, frame);
    camera->SetPosition(position);
  }
  if (motion == Motion::Light)
  {
    vtkLightCollection* lights = renderer->GetLights();
    vtkCollectionSimpleIterator iterator;
    lights->InitTraversal(iterator);
    while (vtkLight* light = lights->GetNextLight(iterator))
    {
      light->GetPosition(position);
      light->GetFocalPoint(focalPoint);
      Displace(position, focalPoint, frame);
      light->SetPosition(position);
    }
  }
}

//--------------------------------------------------------------------------------------------------
WindowContestant::WindowContestant(const SceneFactory& makeScene, int width, int height)
  : Renderer(makeScene())
  , Window(vtkSmartPointer<vtkRenderWindow>::New())
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
}

//--------------------------------------------------------------------------------------------------
WindowContestant::~WindowContestant()
{
  this->Window->MakeCurrent();
}

//--------------------------------------------------------------------------------------------------
void WindowContestant::Draw(Motion motion, int frame)
{
  MoveALittle(this->Renderer, motion, frame);
  this->Window->Render();
  this->Window->WaitForCompletion();
}

//--------------------------------------------------------------------------------------------------
ColorImage WindowContestant::GetPicture()
{
  const int* size = this->Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return { size[0], size[1], Flipped(pixels->GetPointer(0), 3 * size[0], size[1]) };
}

//--------------------------------------------------------------------------------------------------
TechniqueContestant::TechniqueContestant(const SceneFactory& makeScene, int width, int height,
  const vtkSmartPointer<vtkSoftShadowPass>& pass)
  : WindowContestant(makeScene, width, height)
  , Pass(pass)
{
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(this->Pass);
  this->GetRenderer()->SetPass(steps);
}

//--------------------------------------------------------------------------------------------------
TechniqueContestant::~TechniqueContestant()
{
  this->GetWindow()->MakeCurrent();
  this->Pass->ReleaseGraphicsResources(this->GetWindow());
  this->GetRenderer()->SetPass(nullptr);
}

//--------------------------------------------------------------------------------------------------
std::vector<std::vector<float>> TechniqueContestant::GetVisibility()
{
  this->GetWindow()->MakeCurrent();
  std::vector<std::vector<float>> images;
  for (int light = 0;; ++light)
  {
    const vtkSmartPointer<vtkImageData> image = this->Pass->GetVisibilityImage(light);
    if (!image)
    {
      return images;
    }
    const int* size = image->GetDimensions();
    images.push_back(
      Flipped(static_cast<const float*>(image->GetScalarPointer()), size[0], size[1]));
  }
}

//--------------------------------------------------------------------------------------------------
std::vector<std::pair<std::string, double>> TechniqueContestant::GetSteps()
{
  return this->Pass->GetStatistics().Milliseconds;
}

//--------------------------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::int64_t>> TechniqueContestant::GetCounts()
{
  std::vector<std::pair<std::string, std::int64_t>> counts;
  for (const auto& count : this->Pass->GetStatistics().GetCounts())
  {
    counts.emplace_back(count.first, count.second);
  }
  return counts;
}

}
