// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Near and far planes that fit what a camera sees.
 */

#ifndef CameraClipping_h
#define CameraClipping_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace softshadows
{

/**
 * Sets the camera's clipping range to the depths of the polygons inside its view, with a margin of
 * one percent. vtkRenderer::ResetCameraClippingRange takes bounding boxes instead: a ground plane a
 * thousand times the model's size would push its near plane behind the model. The near plane is not
 * nearer than 1e-5 of the far one. Nothing in view: the range stays.
 *
 * @param aspect width over height of the image.
 */
void FitClippingRange(
  vtkCamera* camera, const std::vector<vtkSmartPointer<vtkActor>>& actors, double aspect);

}

#endif
