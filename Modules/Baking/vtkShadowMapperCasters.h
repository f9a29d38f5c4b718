// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowMapperCasters
 * @brief   Draws props through their own mappers as a depth map sees them.
 *
 * Mappers take their matrices from the renderer's active camera. While an object of this class lives
 * a camera of ours stands in its place, put there without events and without touching any
 * modification time, so that nothing outside can see it and no mapper rebuilds anything because of it.
 * Culling of faces is off in the same way: casters are two-sided.
 */

#ifndef vtkShadowMapperCasters_h
#define vtkShadowMapperCasters_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
class vtkProp3D;
class vtkRenderer;
class vtkShadowCamera;
struct vtkShadowMapView;

class vtkShadowMapperCasters
{
public:
  vtkShadowMapperCasters(
    vtkRenderer* renderer, vtkShadowCamera* camera, const vtkShadowMapView& view);
  ~vtkShadowMapperCasters();
  vtkShadowMapperCasters(const vtkShadowMapperCasters&) = delete;
  void operator=(const vtkShadowMapperCasters&) = delete;

  /// matrix: in place of the prop's own, for the leaf of an assembly; null otherwise.
  void Draw(vtkProp3D* prop, vtkMatrix4x4* matrix);

private:
  vtkRenderer* Renderer;
  vtkCamera* Camera;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowMapperCasters.h
