// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The visibility in scenes whose answer is known, in all modes of the technique.

#include "ClosedForms.h"
#include "OffscreenWindow.h"
#include "Picture.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVirtualSoftShadowPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SoftShadowsTesting;

namespace
{
constexpr int Width = 200;
constexpr int Height = 150;

struct Errors
{
  double RootMeanSquare = 0.0;
  double Maximum = 0.0;
};

// A scene in a window of its own.
class SceneWindow
{
public:
  explicit SceneWindow(const Scene& scene)
    : Window(Width, Height)
    , Shown(scene)
  {
    this->Window.Add(scene.Renderer);
    UsePass(scene.Renderer, this->Pass);
  }
  ~SceneWindow() { this->Window.Remove(this->Shown.Renderer); }

  Picture Visibility()
  {
    this->Window.Render();
    return PictureOf(this->Pass->GetVisibilityImage(0));
  }

  Errors AgainstClosedForm()
  {
    const Picture picture = this->Visibility();
    Errors errors;
    const std::vector<PlanePixel> pixels = GetPlanePixels(this->Shown, Width, Height);
    for (const PlanePixel& pixel : pixels)
    {
      const double error = picture.At(pixel.X, pixel.Y) - pixel.Expected;
      errors.Maximum = std::max(errors.Maximum, std::abs(error));
      errors.RootMeanSquare += error * error;
    }
    errors.RootMeanSquare = std::sqrt(errors.RootMeanSquare / pixels.size());
    return errors;
  }

  vtkNew<vtkVirtualSoftShadowPass> Pass;
  OffscreenWindow Window;

private:
  const Scene& Shown;
};
} // namespace

TEST(VirtualVisibility, IsTheClosedFormForOneBlockerDepth)
{
  for (const NamedScene& named : ClosedFormScenes())
  {
    const Scene scene = named.Make(Placement());
    SceneWindow window(scene);
    for (const bool adaptive : { false, true })
    {
      for (const bool antialiasing : { false, true })
      {
        window.Pass->SetMapSize(adaptive ? 2048 : 256);
        window.Pass->SetAdaptive(adaptive);
        window.Pass->SetAntialiasing(antialiasing);
        const Errors errors = window.AgainstClosedForm();
        // Predicted tiles hold no more texels than the eye asks for.
        EXPECT_LT(errors.RootMeanSquare, adaptive ? 0.002 : 0.001)
          << named.Name << " adaptive " << adaptive << " antialiasing " << antialiasing;
        EXPECT_LT(errors.Maximum, adaptive ? 0.01 : 0.006)
          << named.Name << " adaptive " << adaptive << " antialiasing " << antialiasing;
      }
    }
  }
}
