// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSoftShadowPass.h"

#include <algorithm>
#include <cmath>

namespace SoftShadowsTesting
{

//------------------------------------------------------------------------------
Stage::Stage(vtkRenderer* renderer, vtkSoftShadowPass* pass, int width, int height)
  : Window(width, height)
  , Renderer(renderer)
{
  this->Window.Add(renderer);
  this->SetPass(pass);
}

//------------------------------------------------------------------------------
Stage::~Stage()
{
  // As applications do: release while the context is there, the pass may outlive the window.
  if (this->Pass)
  {
    this->Pass->ReleaseGraphicsResources(this->Window.Get());
  }
  this->Renderer->SetPass(nullptr);
  this->Window.Remove(this->Renderer);
}

//------------------------------------------------------------------------------
void Stage::SetPass(vtkSoftShadowPass* pass)
{
  if (this->Pass)
  {
    this->Pass->ReleaseGraphicsResources(this->Window.Get());
  }
  this->Pass = pass;
  UsePass(this->Renderer, pass);
}

//------------------------------------------------------------------------------
void Stage::Render()
{
  this->Window.Render();
}

//------------------------------------------------------------------------------
Picture Stage::RenderVisibility(vtkLight* light)
{
  this->Window.Render();
  return PictureOf(this->Pass->GetVisibilityImage(light));
}

//------------------------------------------------------------------------------
Picture Stage::RenderColors()
{
  this->Window.Render();
  return this->Window.Read();
}

//------------------------------------------------------------------------------
int CountShadowed(const Picture& visibility)
{
  return static_cast<int>(std::count_if(
    visibility.Values.begin(), visibility.Values.end(), [](float v) { return v < 0.5f; }));
}

//------------------------------------------------------------------------------
int CountWithoutValue(const Picture& visibility)
{
  return static_cast<int>(std::count_if(
    visibility.Values.begin(), visibility.Values.end(), [](float v) { return std::isnan(v); }));
}

}
