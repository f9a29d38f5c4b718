// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WorldPositions.h
 * @brief Which point of a plane each pixel shows, from the camera alone and in double.
 *
 * So a test's expected visibility needs nothing from the passes it tests.
 */

#ifndef SoftShadowsTesting_WorldPositions_h
#define SoftShadowsTesting_WorldPositions_h

#include "ClosedForms.h"

#include <vector> // For positions

class vtkRenderer;

namespace SoftShadowsTesting
{

/// Points p with Normal . (p - Origin) = 0; the normal need not be a unit vector.
struct Plane
{
  Point Origin = { { 0.0, 0.0, 0.0 } };
  Point Normal = { { 0.0, 0.0, 1.0 } };
};

/// A line of sight through the middle of a pixel. Direction is not normalised.
struct SightLine
{
  Point Start;
  Point Direction;
};

/**
 * The line of sight through the centre of pixel (x, y) of a picture of width x height, bottom row
 * first, that the renderer's camera draws. Works for perspective and parallel cameras.
 */
SightLine SightLineOf(vtkRenderer* renderer, int width, int height, double x, double y);

/**
 * For each pixel, bottom row first, the point of the plane that it shows; NaN where the line of
 * sight misses the plane.
 */
std::vector<Point> PlanePositions(vtkRenderer* renderer, int width, int height, const Plane& plane);

}

#endif
