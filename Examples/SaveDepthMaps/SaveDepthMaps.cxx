// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// The depth maps of a lamp as files: the baker alone, in a chain of VTK's own passes.

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCameraPass.h"
#include "vtkConeSource.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShadowDepthBakerPass.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTIFFWriter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace
{

constexpr int NumberOfMaps = 4; // of a 2 x 2 grid of points on the lamp
constexpr int MapSize = 256;    // texels along an edge

void AddActor(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

// The plane receives; nothing lies behind it, so it casts nothing and is in no map.
void AddScene(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-10.0, -10.0, 0.0);
  plane->SetPoint1(10.0, -10.0, 0.0);
  plane->SetPoint2(-10.0, 10.0, 0.0);
  AddActor(renderer, plane);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(-0.6, 0.0, 0.5);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  AddActor(renderer, sphere);

  vtkNew<vtkConeSource> cone;
  cone->SetCenter(0.6, 0.0, 0.5);
  cone->SetDirection(0.0, 0.0, 1.0);
  cone->SetResolution(64);
  AddActor(renderer, cone);
}

// Distances for the eye: near is black, far is light grey, no caster is white.
vtkSmartPointer<vtkImageData> MakeVisible(vtkImageData* distances)
{
  const auto* in = static_cast<const float*>(distances->GetScalarPointer());
  const vtkIdType count = distances->GetNumberOfPoints();
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = 0.0f;
  for (const float* distance = in; distance != in + count; ++distance)
  {
    nearest = std::min(nearest, *distance);
    farthest = std::isfinite(*distance) ? std::max(farthest, *distance) : farthest;
  }
  const float range = std::max(farthest - nearest, std::numeric_limits<float>::min());

  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(distances->GetDimensions());
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::transform(in, in + count, static_cast<unsigned char*>(picture->GetScalarPointer()),
    [nearest, range](float distance)
    {
      return static_cast<unsigned char>(
        std::isfinite(distance) ? 200.0f * (distance - nearest) / range : 255.0f);
    });
  return picture;
}

template <class Writer>
bool Write(vtkImageData* image, const std::string& file)
{
  vtkNew<Writer> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
  std::cout << file << '\n';
  return writer->GetErrorCode() == 0;
}

// map0.tif, map0.png, map1.tif, ... False if one cannot be had.
bool SaveMaps(vtkShadowDepthBakerPass* baker, vtkLight* lamp, const std::string& folder)
{
  for (int map = 0; map < NumberOfMaps; ++map)
  {
    vtkSmartPointer<vtkImageData> distances = baker->GetDepthImage(lamp, map);
    const std::string name = folder + "/map" + std::to_string(map);
    if (!distances || !Write<vtkTIFFWriter>(distances, name + ".tif") ||
      !Write<vtkPNGWriter>(MakeVisible(distances), name + ".png"))
    {
      return false;
    }
  }
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc > 2)
  {
    std::cerr << "usage: SaveDepthMaps [FOLDER]\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkRenderer> renderer;
  AddScene(renderer);
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(3.0, 4.0, 5.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetSize(1.0, 1.0);
  renderer->AddLight(lamp);

  vtkNew<vtkShadowDepthBakerPass> baker;
  baker->SetMapSize(MapSize);
  baker->SetNumberOfSamples(NumberOfMaps);

  // No pass draws the scene: the maps do not need a picture.
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(baker);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  renderer->SetPass(camera);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(64, 64); // has no part in the maps
  window->AddRenderer(renderer);
  window->Render();
  std::cout << baker->GetLightReport() << '\n';

  return SaveMaps(baker, lamp, argc == 2 ? argv[1] : ".") ? EXIT_SUCCESS : EXIT_FAILURE;
}
