// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneFrame.h"

#include "PassImages.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderStepsPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace softshadows
{
namespace
{

// VTK looks for each buffer that is freed among all, from the lowest address of their arrays on: in
// any other order thousands of props take a time that grows with the square of their number.
void ReleaseInOrder(const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkWindow* window)
{
  std::vector<std::pair<const void*, vtkActor*>> order;
  for (vtkActor* actor : actors)
  {
    auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    vtkPoints* points = mesh ? mesh->GetPoints() : nullptr;
    order.emplace_back(points ? points->GetData() : nullptr, actor);
  }
  std::sort(order.begin(), order.end(),
    [](const auto& a, const auto& b) { return std::less<const void*>()(a.first, b.first); });
  for (const auto& entry : order)
  {
    entry.second->ReleaseGraphicsResources(window);
  }
}

}

//--------------------------------------------------------------------------------------------------
SceneFrame::SceneFrame(const BuiltScene& scene, vtkSoftShadowPass* pass, int width, int height)
  : Scene(scene)
  , Pass(pass)
  , Window(vtkSmartPointer<vtkRenderWindow>::New())
  , Width(width)
  , Height(height)
{
  if (scene.Lights.empty())
  {
    // The pass finds visible points for its lights only; this one is for the depth.
    vtkNew<vtkAreaLight> dark;
    dark->SetPositional(0);
    dark->SetIntensity(0.0);
    scene.Renderer->AddLight(dark);
  }
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(pass);
  scene.Renderer->SetPass(steps);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0); // a pixel is its centre
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(scene.Renderer);
}

//--------------------------------------------------------------------------------------------------
SceneFrame::~SceneFrame()
{
  // While the context lives.
  this->Scene.Renderer->SetPass(nullptr);
  this->Pass->ReleaseGraphicsResources(this->Window);
  ReleaseInOrder(this->Scene.Actors, this->Window);
  this->Window->RemoveRenderer(this->Scene.Renderer);
}

//--------------------------------------------------------------------------------------------------
void SceneFrame::Render()
{
  if (!this->Window->SupportsOpenGL())
  {
    throw std::runtime_error("OpenGL 3.2 is needed, and the display does not have it");
  }
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  this->Milliseconds = taken.count();
}

//--------------------------------------------------------------------------------------------------
void SceneFrame::Converge(double tolerance, int frames)
{
  this->Pass->ProgressiveOn();
  this->Pass->SetProgressiveTolerance(tolerance);
  do
  {
    this->Render();
  } while (this->Pass->GetRefining() && --frames > 0);
}

//--------------------------------------------------------------------------------------------------
std::vector<unsigned char> SceneFrame::GetPicture() const
{
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, this->Width - 1, this->Height - 1, 1, pixels);
  return TopRowFirst(pixels->GetPointer(0), 3 * this->Width, this->Height);
}

//--------------------------------------------------------------------------------------------------
VisibilityImage SceneFrame::GetVisibility() const
{
  VisibilityImage image;
  image.Width = this->Width;
  image.Height = this->Height;
  for (const auto& light : this->Scene.Lights)
  {
    image.Visibility.push_back(
      ImageValues(this->Pass->GetVisibilityImage(light), this->Width, this->Height));
  }
  image.Depth = ImageValues(this->Pass->GetDepthImage(), this->Width, this->Height);
  return image;
}

//--------------------------------------------------------------------------------------------------
std::string SceneFrame::GetDriver() const
{
  const std::string report = this->Window->ReportCapabilities();
  const std::string name = "OpenGL renderer string:";
  const std::size_t start = report.find(name);
  if (start == std::string::npos)
  {
    return "unknown";
  }
  const std::size_t first = report.find_first_not_of(' ', start + name.size());
  return report.substr(first, report.find('\n', first) - first);
}

}
