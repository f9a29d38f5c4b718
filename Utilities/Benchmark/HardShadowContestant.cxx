// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HardShadowContestant.h"

#include "SceneChanges.h"

#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>

#include <algorithm> // For std::min
#include <limits>    // For NaN

namespace softshadows
{
namespace
{

//--------------------------------------------------------------------------------------------------
void UseShadowMaps(vtkRenderer* renderer, int mapSize)
{
  vtkNew<vtkShadowMapBakerPass> baker;
  baker->SetResolution(mapSize);
  vtkNew<vtkShadowMapPass> shadows;
  shadows->SetShadowMapBakerPass(baker);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  renderer->SetPass(camera);
}

//--------------------------------------------------------------------------------------------------
int CountLitLights(vtkRenderer* renderer)
{
  int count = 0;
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(iterator))
  {
    count += light->GetSwitch() ? 1 : 0;
  }
  return count;
}

}

//--------------------------------------------------------------------------------------------------
HardShadowContestant::HardShadowContestant(
  const SceneFactory& makeScene, int width, int height, int mapSize)
  : WindowContestant(makeScene, width, height)
  , MakeScene(makeScene)
  , Width(width)
  , Height(height)
  , MapSize(mapSize)
{
  UseShadowMaps(this->GetRenderer(), mapSize);
}

//--------------------------------------------------------------------------------------------------
ColorImage HardShadowContestant::DrawWhite(int light, bool withShadows) const
{
  WindowContestant window(this->MakeScene, this->Width, this->Height);
  KeepOneWhiteLight(window.GetRenderer(), light);
  if (withShadows)
  {
    UseShadowMaps(window.GetRenderer(), this->MapSize);
  }
  window.Draw(Motion::Still, 0);
  return window.GetPicture();
}

//--------------------------------------------------------------------------------------------------
std::vector<std::vector<float>> HardShadowContestant::GetVisibility()
{
  std::vector<std::vector<float>> images;
  const int lights = CountLitLights(this->GetRenderer());
  for (int light = 0; light < lights; ++light)
  {
    const ColorImage lit = this->DrawWhite(light, false);
    const ColorImage shadowed = this->DrawWhite(light, true);
    std::vector<float> image(lit.Pixels.size() / 3, std::numeric_limits<float>::quiet_NaN());
    for (size_t i = 0; i < image.size(); ++i)
    {
      const int full = lit.Pixels[3 * i];
      if (full >= DarkestMeasured)
      {
        image[i] = std::min(1.0F, static_cast<float>(shadowed.Pixels[3 * i]) / full);
      }
    }
    images.push_back(std::move(image));
  }
  return images;
}

}
