// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedForms.h
 * @brief Visibilities that are known exactly: 1 sees the whole light, 0 sees none of it.
 *
 * Everything is in double and without VTK, so that a test's expected value shares no code with what
 * it tests. The formulas themselves are tested against brute-force integration.
 */

#ifndef SoftShadowsTesting_ClosedForms_h
#define SoftShadowsTesting_ClosedForms_h

#include <array> // For points

namespace SoftShadowsTesting
{

using Point = std::array<double, 3>;

/// How the points of a light count.
enum class Weights
{
  Mean,    ///< All alike.
  Gaussian ///< Normal, standard deviation 0.5, over the light's window [-1, 1] per axis.
};

/// A rectangle in a plane z = Height: its bounds in x and y.
struct Rectangle
{
  std::array<double, 2> X;
  std::array<double, 2> Y;
  double Height;
};

/// Share of the window [-1, 1] that lies in [low, high]; bounds outside the window are cut off.
double WindowShare(double low, double high, Weights weights);

/// Share of a disk of radius 1 that lies on the side x <= edge (a circular segment).
double DiskShare(double edge);

/**
 * Share of a spherical cap, uniform in solid angle, on the far side of a plane through the sphere's
 * centre: of the directions within halfAngle of an axis, those with a negative component along the
 * plane's normal. elevation is the axis's angle above the plane. Radians; halfAngle in [0, pi / 2].
 */
double CapShareBelow(double elevation, double halfAngle);

/// Receiver under a rectangle that blocks a rectangular light; all three parallel to z = 0.
double VisibilityOfRectangle(
  const Point& receiver, const Rectangle& blocker, const Rectangle& light, Weights weights);

/**
 * Receiver under a half plane that blocks a disk-shaped light, both parallel to z = 0. The half
 * plane is x <= edge at blockerHeight.
 */
double VisibilityOfDisk(const Point& receiver, double edge, double blockerHeight,
  const Point& diskCenter, double diskRadius);

/**
 * Receiver under a half plane that blocks a sun: a disk of directions of angularDiameter (radians)
 * around toSun. The half plane starts at the line through edgePoint along edgeDirection and reaches
 * to the side of blockedSide without end. Any orientation of line, sun and receiving surface.
 */
double VisibilityOfSun(const Point& receiver, const Point& edgePoint, const Point& edgeDirection,
  const Point& blockedSide, const Point& toSun, double angularDiameter);

}

#endif
