// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneFrame.h"

#include "PassImages.h"

#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderStepsPass.h"
#include "vtkUnsignedCharArray.h"

#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
// A line of what VTK says of OpenGL.
std::string FindCapability(const std::string& report, const std::string& name)
{
  const std::size_t start = report.find(name);
  if (start == std::string::npos)
  {
    return "unknown";
  }
  const std::size_t first = report.find_first_not_of(' ', start + name.size());
  return report.substr(first, report.find('\n', first) - first);
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
  return FindCapability(report, "OpenGL renderer string:") + ", OpenGL " +
    FindCapability(report, "OpenGL version string:");
}

}
