// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// What must change no visibility: place, size, window, order, and what has no say.
#include "HardCases.h"
#include "HardScenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>
#include <ostream>

namespace SoftShadowsTesting
{
namespace
{

//------------------------------------------------------------------------------
std::function<HardScene()> Placed(double scale, double translation)
{
  return [scale, translation]() -> HardScene {
    return MakeBasicScene({ scale, { { translation, -translation, translation } } });
  };
}

//------------------------------------------------------------------------------
/// A window of another shape that shows the same rows in the same size.
std::function<HardScene()> InWindow(int width, int height)
{
  return [width, height]() -> HardScene
  {
    BasicScene scene = MakeBasicScene();
    const double half = std::tan(vtkMath::RadiansFromDegrees(15.0)) * height / scene.Height;
    scene.Renderer->GetActiveCamera()->SetViewAngle(
      vtkMath::DegreesFromRadians(2.0 * std::atan(half)));
    scene.Width = width;
    scene.Height = height;
    return scene;
  };
}

//------------------------------------------------------------------------------
HardScene TwoViewports()
{
  BasicScene scene = MakeBasicScene();
  const BasicScene other = MakeBasicScene();
  other.Ball->AddPosition(0.4, 0.0, 0.3);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  other.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.Others.push_back(other.Renderer);
  scene.Width *= 2;
  return scene;
}

//------------------------------------------------------------------------------
HardScene Layers()
{
  BasicScene scene = MakeBasicScene();
  const BasicScene other = MakeBasicScene();
  other.Renderer->RemoveActor(other.Ground);
  other.Renderer->SetLayer(1);
  scene.Others.push_back(other.Renderer);
  return scene;
}

//------------------------------------------------------------------------------
HardScene ActorsReversed()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->RemoveAllViewProps();
  for (vtkActor* actor : { scene.Box.Get(), scene.Ball.Get(), scene.Ground.Get() })
  {
    scene.Renderer->AddActor(actor);
  }
  return scene;
}

//------------------------------------------------------------------------------
/// Lights before and after the one that is judged.
HardScene AmongLights(bool on)
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->RemoveAllLights();
  const auto first = MakeLamp({ { -2.0, 1.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 0.6);
  const auto last = MakeSun({ { 0.3, -0.4, 1.0 } }, 2.0);
  first->SetSwitch(on);
  last->SetSwitch(on);
  scene.Renderer->AddLight(first);
  scene.Renderer->AddLight(scene.Lamp);
  scene.Renderer->AddLight(last);
  return scene;
}

//------------------------------------------------------------------------------
HardScene HugeGround()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->RemoveActor(scene.Ground);
  scene.Renderer->AddActor(MakeGroundActor(6e3));
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 20.0);
  return scene;
}

//------------------------------------------------------------------------------
HardScene FarPost()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->AddActor(MakeBoxActor({ { 4000.0, 4010.0, 3000.0, 3010.0, 0.0, 200.0 } }));
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 20.0);
  return scene;
}

//------------------------------------------------------------------------------
HardScene ParallelCamera()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.7);
  scene.Renderer->ResetCameraClippingRange();
  return scene;
}

//------------------------------------------------------------------------------
HardScene ClippingRange()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->GetActiveCamera()->SetClippingRange(1e-3, 1e3);
  return scene;
}

}

//------------------------------------------------------------------------------
const std::vector<HardCase>& InvarianceCases()
{
  static const std::vector<HardCase> cases = {
    { "Basic", "what the others are compared with", []() -> HardScene { return MakeBasicScene(); },
      true },
    { "ScaledBy1e-6", "scene and light scaled", Placed(1e-6, 0.0), true },
    { "ScaledBy1e-3", "", Placed(1e-3, 0.0), true },
    { "ScaledBy1e3", "", Placed(1e3, 0.0), true },
    { "ScaledBy1e6", "", Placed(1e6, 0.0), true },
    { "MovedBy1e5", "moved diagonally, points in double", Placed(1.0, 1e5), true },
    { "MovedBy1e7", "", Placed(1.0, 1e7), true },
    { "Window4To3", "128 x 96 pixels", InWindow(128, 96) },
    { "WindowWide", "192 x 80 pixels", InWindow(192, 80) },
    { "WindowTall", "40 x 160 pixels", InWindow(40, 160) },
    { "TwoViewports", "the right half of a window, another scene in the left", TwoViewports, true },
    { "Layers", "another renderer in a layer above", Layers, true },
    { "ActorsReversed", "the props in another order", ActorsReversed, true },
    { "AmongOtherLights", "the second of three lights", [] { return AmongLights(true); }, true },
    { "OtherLightsOff", "two other lights, switched off", [] { return AmongLights(false); }, true },
    { "HugeGround", "a ground a thousand times as large", HugeGround, true },
    { "FarPost", "a post 5000 away, out of view", FarPost, true },
    { "ParallelCamera", "", ParallelCamera },
    { "ClippingRange", "clipping planes at 1e-3 and 1e3", ClippingRange, true },
  };
  return cases;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const HardCase& hardCase)
{
  return os << hardCase.Name;
}

}
