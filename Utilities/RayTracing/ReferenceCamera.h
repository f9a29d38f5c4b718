// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReferenceCamera
 * @brief   The rays through an image's pixel centres, as a vtkCamera sees them.
 *
 * Perspective and parallel cameras with everything their matrices hold (window centre, shear, user
 * transforms). The clipping planes are ignored: a ray starts in the camera's own plane.
 */

#ifndef SoftShadowsRayTracing_ReferenceCamera_h
#define SoftShadowsRayTracing_ReferenceCamera_h

#include "ReferenceRayCaster.h"

class vtkCamera;

namespace softshadows
{

class ReferenceCamera
{
public:
  /// Rays and points are in the geometry's local coordinates. The image's pixels are square.
  ReferenceCamera(vtkCamera* camera, int width, int height, const ReferenceGeometry& geometry);

  /// Through the centre of a pixel; row 0 is the top row.
  ReferenceRayCaster::Ray GetRay(int column, int row) const;

  /// World units along the view direction from the camera's plane to a point.
  double GetDepth(const Vector& point) const;

private:
  Vector ToView(double x, double y, double z) const;

  int Width;
  int Height;
  double Scale;
  Vector Origin; ///< The camera, local coordinates.
  /// View coordinates to local directions: columns are the camera's axes, unscaled.
  std::array<Vector, 3> Axes;
  Vector DepthRow; ///< World directions to view z.
  std::array<double, 16> ClipToView;
};

}

#endif
