// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReferenceSnapshot
 * @brief   What a trace reads of a renderer, free of VTK's objects.
 *
 * Made in the thread that owns the renderer and read in any other: an interactive program traces
 * in the background while it goes on changing the renderer. Surfaces are the costly part; a
 * snapshot can share those of an earlier one.
 *
 * @sa ReferenceTracer
 */

#ifndef SoftShadowsRayTracing_ReferenceSnapshot_h
#define SoftShadowsRayTracing_ReferenceSnapshot_h

#include "ReferenceCamera.h"
#include "ReferenceGeometry.h"
#include "ReferenceLight.h"

#include <memory> // For the surfaces
#include <vector> // For the lights

class vtkRenderer;

namespace softshadows
{

class ReferenceSnapshot
{
public:
  /// Reads camera, lights that are switched on, and surfaces. Size in pixels.
  ReferenceSnapshot(vtkRenderer* renderer, int width, int height, bool gaussian);

  /// Reads camera and lights; the surfaces are those of the other snapshot, as they were then.
  ReferenceSnapshot(vtkRenderer* renderer, int width, int height, bool gaussian,
    const ReferenceSnapshot& sameSurfaces);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const ReferenceGeometry& GetGeometry() const;
  const ReferenceCamera& GetCamera() const { return this->Camera; }
  /// In the renderer's order.
  const std::vector<ReferenceLight>& GetLights() const { return this->Lights; }
  /// Per light.
  const std::vector<bool>& GetCastsShadow() const { return this->CastsShadow; }

  /**
   * Built when first asked for, by any thread; snapshots that share surfaces share it. Throws
   * std::runtime_error if Embree gives no device.
   */
  const ReferenceRayCaster& GetCaster() const;

private:
  struct Surfaces;

  ReferenceSnapshot(vtkRenderer* renderer, int width, int height, bool gaussian,
    std::shared_ptr<Surfaces> surfaces);

  int Width;
  int Height;
  std::shared_ptr<Surfaces> Shared;
  ReferenceCamera Camera;
  std::vector<ReferenceLight> Lights;
  std::vector<bool> CastsShadow;
};

}

#endif
