// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenWindow.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace SoftShadowsTesting
{

//------------------------------------------------------------------------------
OffscreenWindow::OffscreenWindow(int width, int height)
{
  // From 9.4 on, VTK finds EGL by itself.
#if defined(__linux__) && VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    throw std::runtime_error("DISPLAY is empty. Run the tests with a display: xvfb-run -a ctest");
  }
#endif
  this->Window = vtkSmartPointer<vtkRenderWindow>::New();
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
}

//------------------------------------------------------------------------------
OffscreenWindow::~OffscreenWindow() = default;

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* OffscreenWindow::GetOpenGL()
{
  return vtkOpenGLRenderWindow::SafeDownCast(this->Window);
}

//------------------------------------------------------------------------------
void OffscreenWindow::Add(vtkRenderer* renderer)
{
  this->Window->AddRenderer(renderer);
}

//------------------------------------------------------------------------------
void OffscreenWindow::Remove(vtkRenderer* renderer)
{
  this->Window->RemoveRenderer(renderer);
}

//------------------------------------------------------------------------------
void OffscreenWindow::Resize(int width, int height)
{
  this->Window->SetSize(width, height);
}

//------------------------------------------------------------------------------
void OffscreenWindow::Render()
{
  this->Window->Render();
}

//------------------------------------------------------------------------------
Picture OffscreenWindow::Read()
{
  const int* size = this->Window->GetSize();
  Picture picture(size[0], size[1], 3);
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    picture.Values[i] = static_cast<float>(pixels->GetValue(static_cast<vtkIdType>(i)) / 255.0);
  }
  return picture;
}

//------------------------------------------------------------------------------
void UsePass(vtkRenderer* renderer, vtkRenderPass* opaquePass)
{
  if (!opaquePass)
  {
    renderer->SetPass(nullptr);
    return;
  }
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(opaquePass);
  renderer->SetPass(steps);
}

}
