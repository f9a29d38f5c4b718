// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneChanges.h"

#include "vtkAreaLight.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
void ScaleLights(vtkRenderer* renderer, double scale)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    vtkAreaLight* area = vtkAreaLight::SafeDownCast(light);
    if (area && area->GetPositional())
    {
      area->SetSize(scale * area->GetSize()[0], scale * area->GetSize()[1]);
    }
    else if (area)
    {
      area->SetAngularDiameter(scale * area->GetAngularDiameter());
    }
  }
}

//--------------------------------------------------------------------------------------------------
void KeepOneWhiteLight(vtkRenderer* renderer, int litLight)
{
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->GradientBackgroundOff();
  renderer->SetAmbient(0.0, 0.0, 0.0);
  vtkCollectionSimpleIterator iterator;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(iterator);
  int lit = 0;
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      light->SetSwitch(lit == litLight ? 1 : 0);
      light->SetColor(1.0, 1.0, 1.0);
      light->SetIntensity(1.0);
      ++lit;
    }
  }
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal(iterator);
  while (vtkActor* actor = actors->GetNextActor(iterator))
  {
    vtkProperty* property = actor->GetProperty();
    property->SetColor(1.0, 1.0, 1.0);
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.0);
  }
}

}
