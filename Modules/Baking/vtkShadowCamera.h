// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowCamera
 * @brief   A camera that sees what a depth map sees.
 *
 * The window of a depth map need not be centred on the light's direction, which no parameter of a
 * vtkCamera can say; so the matrices are given to the mappers as they are.
 */

#ifndef vtkShadowCamera_h
#define vtkShadowCamera_h

#include "vtkMatrix3x3.h" // For members
#include "vtkMatrix4x4.h" // For members
#include "vtkNew.h"       // For members
#include "vtkOpenGLCamera.h"
#include "vtkSoftShadowsABI.h" // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
struct vtkShadowMapView;

class vtkShadowCamera : public vtkOpenGLCamera
{
public:
  static vtkShadowCamera* New();
  vtkTypeMacro(vtkShadowCamera, vtkOpenGLCamera);

  void SetView(const vtkShadowMapView& view);

  void GetKeyMatrices(vtkRenderer* renderer, vtkMatrix4x4*& worldToView, vtkMatrix3x3*& normals,
    vtkMatrix4x4*& viewToClip, vtkMatrix4x4*& worldToClip) override;

protected:
  vtkShadowCamera() = default;
  ~vtkShadowCamera() override = default;

private:
  vtkShadowCamera(const vtkShadowCamera&) = delete;
  void operator=(const vtkShadowCamera&) = delete;

  // Transposed, as VTK keeps them for OpenGL.
  vtkNew<vtkMatrix4x4> WorldToView;
  vtkNew<vtkMatrix4x4> ViewToClip;
  vtkNew<vtkMatrix4x4> WorldToClip;
  vtkNew<vtkMatrix3x3> Normals;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCamera.h
