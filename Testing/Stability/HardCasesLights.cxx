// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// All the lights that VTK knows, with and without an extent.
#include "HardCases.h"
#include "HardScenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <cmath>

namespace SoftShadowsTesting
{
namespace
{

//------------------------------------------------------------------------------
/// The basic scene under another light.
HardScene Under(vtkLight* light)
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(light);
  scene.Light = light;
  return scene;
}

//------------------------------------------------------------------------------
/// The basic scene's lamp, changed.
HardScene Changed(const std::function<void(vtkAreaLight*)>& change)
{
  BasicScene scene = MakeBasicScene();
  change(scene.Lamp);
  return scene;
}

//------------------------------------------------------------------------------
HardScene TurnedRectangle()
{
  return Changed(
    [](vtkAreaLight* lamp)
    {
      lamp->SetShapeToRectangle();
      lamp->SetSize(0.8, 0.2);
      lamp->SetViewUp(0.3, 1.0, 0.0);
    });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> MakeBulb(double coneAngle)
{
  auto bulb = vtkSmartPointer<vtkLight>::New();
  bulb->SetLightTypeToSceneLight();
  bulb->PositionalOn();
  bulb->SetConeAngle(coneAngle);
  bulb->SetPosition(0.1, 0.1, 0.9);
  bulb->SetFocalPoint(0.1, 0.5, 0.3);
  return bulb;
}

//------------------------------------------------------------------------------
HardScene Hard(bool positional)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(positional);
  light->SetConeAngle(40.0);
  light->SetPosition(1.2, 0.8, 4.0);
  light->SetFocalPoint(-0.2, 0.0, 0.2);
  return Under(light);
}

//------------------------------------------------------------------------------
/// A point without a cone in the middle of balls on all sides.
HardScene Bulb(double coneAngle)
{
  BasicScene scene = MakeBasicScene();
  const auto bulb = MakeBulb(coneAngle);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(bulb);
  scene.Light = bulb;
  return scene;
}

//------------------------------------------------------------------------------
/// A light that moves with the camera, from beside it.
HardScene WithTheCamera(bool headlight)
{
  const auto light = MakeLamp({ { 0.3, 0.4, 0.8 } }, { { 0.0, 0.0, 0.0 } }, 0.4);
  if (headlight)
  {
    light->SetLightTypeToHeadlight();
    light->SetSize(1.0, 1.0); // where the camera is, a small one would show no shadow
  }
  else
  {
    light->SetLightTypeToCameraLight(); // in the camera's own unit frame, see vtkLight
    light->SetSize(0.1, 0.1);
  }
  return Under(light);
}

//------------------------------------------------------------------------------
/// The basic lamp, brought to its place by a light's own matrix.
HardScene Transformed()
{
  BasicScene scene = MakeBasicScene();
  vtkNew<vtkTransform> move;
  move->Translate(1.2, 0.8, 4.0);
  move->RotateZ(30.0);
  const double target[3] = { -0.2, 0.0, 0.2 };
  double local[3];
  move->GetInverse()->TransformPoint(target, local);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(move->GetMatrix());
  scene.Lamp->SetTransformMatrix(matrix);
  scene.Lamp->SetPosition(0.0, 0.0, 0.0);
  scene.Lamp->SetFocalPoint(local);
  return scene;
}

//------------------------------------------------------------------------------
/// The last of sixteen lights in a ring.
HardScene Sixteen()
{
  BasicScene scene = MakeBasicScene();
  scene.Renderer->RemoveAllLights();
  for (int i = 0; i < 16; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / 16.0;
    const auto lamp = MakeLamp(
      { { 2.0 * std::cos(angle), 2.0 * std::sin(angle), 4.0 } }, { { 0.0, 0.0, 0.2 } }, 0.3);
    lamp->SetIntensity(1.0 / 16.0);
    scene.Renderer->AddLight(lamp);
    scene.Light = lamp;
  }
  return scene;
}

}

//------------------------------------------------------------------------------
const std::vector<HardCase>& LightCases()
{
  static const std::vector<HardCase> cases = {
    { "Disk", "a lamp of 0.4, 4 away", []() -> HardScene { return MakeBasicScene(); } },
    { "Rectangle", "0.8 x 0.2, turned", TurnedRectangle },
    { "Spot", "a disk with a cone of 10 degrees",
      [] { return Changed([](vtkAreaLight* lamp) { lamp->SetConeAngle(10.0); }); } },
    { "Cone89", "a disk with a cone of 89 degrees",
      [] { return Changed([](vtkAreaLight* lamp) { lamp->SetConeAngle(89.0); }); } },
    { "Line", "a rectangle 0.6 x 0",
      [] { return Changed([](vtkAreaLight* lamp) { lamp->SetSize(0.6, 0.0); }); } },
    { "NoSize", "an area light of size 0",
      [] { return Changed([](vtkAreaLight* lamp) { lamp->SetSize(0.0, 0.0); }); } },
    { "PlainSpot", "a vtkLight with a cone of 40 degrees", [] { return Hard(true); } },
    { "PlainSun", "a directional vtkLight", [] { return Hard(false); } },
    { "Sun", "5 degrees wide",
      [] {
        return Under(MakeSun({ { 0.3, 0.2, 1.0 } }, 5.0));
      } },
    { "WideSun", "40 degrees wide",
      [] {
        return Under(MakeSun({ { 0.3, 0.2, 1.0 } }, 40.0));
      } },
    { "Bulb", "a vtkLight without a cone, shining to all sides", [] { return Bulb(180.0); } },
    { "Cone90", "a vtkLight with a cone of 90 degrees", [] { return Bulb(90.0); } },
    { "Cone120", "a vtkLight with a cone of 120 degrees", [] { return Bulb(120.0); } },
    { "Headlight", "a headlight of 1", [] { return WithTheCamera(true); } },
    { "CameraLight", "a camera light of 0.1 of the camera's distance",
      [] { return WithTheCamera(false); } },
    { "LightTransform", "a lamp placed by its own matrix", Transformed },
    { "SixteenLights", "the last of sixteen", Sixteen },
  };
  return cases;
}

}
