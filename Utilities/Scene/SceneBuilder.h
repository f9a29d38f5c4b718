// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a scene's description to VTK's objects.
 */

#ifndef SceneBuilder_h
#define SceneBuilder_h

#include "ModelStore.h"
#include "SceneDescription.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace softshadows
{

struct BuiltScene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  /// In the description's order.
  std::vector<vtkSmartPointer<vtkAreaLight>> Lights;
  /// In the description's order, each with a vtkPolyDataMapper and the matrix as its user matrix.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

/**
 * Builds the renderer with all lights and actors and the camera, its clipping range fitted to what
 * it sees. Needs no window. Lights shine the same at every distance and angle within their cone;
 * surfaces have a constant ambient part of 0.15, so that an umbra is not black, and a diffuse one of
 * 0.85. Colours that meshes bring along are not used. Throws SceneError for models.
 */
BuiltScene BuildScene(const SceneDescription& scene, ModelStore& models);

/// Gives a light everything that its description says; what does not change leaves no mark.
void SetUpLight(const LightDescription& description, vtkAreaLight* light);

}

#endif
