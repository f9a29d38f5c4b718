// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TracedStage.h
 * @brief A window with a scene and a pass of rays.
 */

#ifndef TracedStage_h
#define TracedStage_h

#include "OffscreenWindow.h"
#include "Picture.h"
#include "Scenes.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTracedSoftShadowPass.h"

namespace SoftShadowsTesting
{

class TracedStage
{
public:
  explicit TracedStage(const Scene& scene, int width = 120, int height = 90)
    : Renderer(scene.Renderer)
    , Window(width, height)
  {
    this->Window.Add(this->Renderer);
    UsePass(this->Renderer, this->Pass);
  }

  ~TracedStage()
  {
    UsePass(this->Renderer, nullptr);
    this->Pass->ReleaseGraphicsResources(this->Window.Get());
    this->Window.Remove(this->Renderer);
  }

  TracedStage(const TracedStage&) = delete;
  TracedStage& operator=(const TracedStage&) = delete;

  Picture Render()
  {
    this->Window.Render();
    return PictureOf(this->Pass->GetVisibilityImage(0));
  }

  vtkTypeInt64 Count(const std::string& name) { return this->Pass->GetCount(name); }

  vtkSmartPointer<vtkRenderer> Renderer;
  OffscreenWindow Window;
  vtkNew<vtkTracedSoftShadowPass> Pass;
};

}

#endif
