// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BakingScene.h
 * @brief A small window, casters and depth maps, and views to look through.
 */

#ifndef BakingScene_h
#define BakingScene_h

#include "OffscreenWindow.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthMaps.h"
#include "vtkShadowMapView.h"
#include "vtkShadowTextureArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

class BakingScene
{
public:
  BakingScene()
    : Window(16, 16)
  {
    this->Casters->EffectiveOnlyOff(); // depths of whatever a test likes to see
    this->Window.Add(this->Renderer);
    this->Window.Render();
  }

  ~BakingScene()
  {
    this->Window.GetOpenGL()->MakeCurrent();
    this->Release();
  }

  void Release()
  {
    this->Maps->ReleaseGraphicsResources(this->Window.Get());
    this->Casters->ReleaseGraphicsResources(this->Window.Get());
  }

  vtkSmartPointer<vtkActor> AddActor(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  /// Brings casters and maps up to date; the number of layers baked.
  int Bake(const std::vector<vtkShadowMapView>& views, int resolution, bool conservative = false)
  {
    this->Window.GetOpenGL()->MakeCurrent();
    this->Casters->Update(this->Renderer);
    return this->Maps->Bake(this->Renderer, this->Casters, views, resolution, conservative);
  }

  /// The depths of one map, bottom row first, from 0 on the near plane to 1 where nothing is.
  std::vector<float> BakeDepths(
    const vtkShadowMapView& view, int resolution, bool conservative = false)
  {
    this->Bake({ view }, resolution, conservative);
    std::vector<float> depths = this->Maps->GetTexture()->ReadLayer(0);
    std::transform(
      depths.begin(), depths.end(), depths.begin(), [](float held) { return 1.0f - held; });
    return depths;
  }

  SoftShadowsTesting::OffscreenWindow Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkShadowCasters> Casters;
  vtkNew<vtkShadowDepthMaps> Maps;
};

/// A light at a place that shines down the z axis: map x is world x, map y is world y, mirrored.
inline vtkShadowEmitter MakeDownwardEmitter(double x, double y, double z, bool directional)
{
  vtkShadowEmitter emitter;
  emitter.Directional = directional;
  emitter.Center = { { x, y, z } };
  emitter.Apex = emitter.Center;
  emitter.Direction = { { 0.0, 0.0, -1.0 } };
  emitter.AxisU = { { 1.0, 0.0, 0.0 } };
  emitter.AxisV = { { 0.0, 1.0, 0.0 } };
  return emitter;
}

#endif
