// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkShadowImposters.h
 * @brief   Names of the arrays that VTK's imposters take their sizes from, which VTK's classes do not tell.
 */

#ifndef vtkShadowImposters_h
#define vtkShadowImposters_h

#include "vtkOpenGLSphereMapper.h" // For the protected members
#include "vtkOpenGLStickMapper.h"  // For the protected members
#include "vtkSoftShadowsABI.h"     // For the ABI namespace

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowSphereImposters : public vtkOpenGLSphereMapper
{
  /// Of the spheres' radii; null for the mapper's own.
  static const char* Radii(vtkOpenGLSphereMapper* mapper)
  {
    return mapper->*(&vtkShadowSphereImposters::ScaleArray);
  }
};

struct vtkShadowStickImposters : public vtkOpenGLStickMapper
{
  /// Of length and radius.
  static const char* Sizes(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&vtkShadowStickImposters::ScaleArray);
  }
  /// Of directions, which stretch the length.
  static const char* Axes(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&vtkShadowStickImposters::OrientationArray);
  }
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowImposters.h
