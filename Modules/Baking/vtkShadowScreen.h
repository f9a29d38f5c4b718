// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowScreen
 * @brief   How large a pixel of the picture is in the world.
 *
 * It is a linear function of the place: it grows with the distance from a perspective camera and is
 * the same everywhere for a parallel one.
 */

#ifndef vtkShadowScreen_h
#define vtkShadowScreen_h

#include "vtkSoftShadowsABI.h" // For the ABI namespace

#include <array> // For the plane

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

struct vtkShadowScreen
{
  /// Size at p: Plane[0] p[0] + Plane[1] p[1] + Plane[2] p[2] + Plane[3], in world coordinates.
  std::array<double, 4> Plane{};
  /// Not less than this, which it has at the camera's near plane: behind the camera there is no picture.
  double Least = 0.0;

  /// Of the renderer's camera and a picture of so many pixels in height.
  static vtkShadowScreen Of(vtkRenderer* renderer, int height);

  /// The largest size in a box {xmin, xmax, ymin, ymax, zmin, zmax}.
  double FindLargest(const std::array<double, 6>& box) const;

  bool operator==(const vtkShadowScreen& other) const
  {
    return this->Plane == other.Plane && this->Least == other.Least;
  }
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowScreen.h
