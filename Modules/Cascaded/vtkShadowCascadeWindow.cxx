// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCascadeWindow.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double EdgeStepsPerOctave = 8.0; // of the window's edge
constexpr double WidestAngle = 85.0;       // degrees; the fitter's limit too
constexpr double NarrowestShare = 1e-6;    // of the fit: no window is narrower
constexpr double NearestShare = 1e-3;      // of the near distance: nothing nearer bounds a window

struct Range
{
  double Low;
  double High;
};

// Along one axis of the map, the sphere's projection: center is (along the axis, along the light).
// False if it has no end.
bool Project(double across, double along, double radius, bool directional, Range& range)
{
  if (directional)
  {
    range = { across - radius, across + radius };
    return true;
  }
  const double distance = std::hypot(across, along);
  if (distance <= radius)
  {
    return false;
  }
  const double middle = std::atan2(across, along);
  const double spread = std::asin(radius / distance);
  const double widest = vtkMath::RadiansFromDegrees(WidestAngle);
  if (middle - spread <= -widest || middle + spread >= widest)
  {
    return false;
  }
  range = { std::tan(middle - spread), std::tan(middle + spread) };
  return true;
}

// Cuts both ranges to what the light sees of the corners' hull, if that is bounded by their projections.
void CutToHull(const std::vector<std::array<double, 3>>& corners, const vtkShadowMapView& view,
  Range (&ranges)[2])
{
  const auto worldToEmitter = view.Emitter.WorldToEmitter();
  const double infinity = std::numeric_limits<double>::infinity();
  Range seen[2] = { { infinity, -infinity }, { infinity, -infinity } };
  for (const auto& corner : corners)
  {
    const double world[4] = { corner[0], corner[1], corner[2], 1.0 };
    double p[4];
    vtkMatrix4x4::MultiplyPoint(worldToEmitter.data(), world, p);
    if (!view.Emitter.Directional && p[2] < NearestShare * view.Near)
    {
      return;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      const double place = view.Emitter.Directional ? p[axis] : p[axis] / p[2];
      seen[axis].Low = std::min(seen[axis].Low, place);
      seen[axis].High = std::max(seen[axis].High, place);
    }
  }
  for (int axis = 0; axis < 2 && !corners.empty(); ++axis)
  {
    const double low = std::max(ranges[axis].Low, seen[axis].Low);
    const double high = std::min(ranges[axis].High, seen[axis].High);
    // What rounding makes empty stays as it was.
    ranges[axis] = low < high ? Range{ low, high } : ranges[axis];
  }
}

// Cuts a window's edge [low, high] to the range; false if they are apart.
bool CutEdge(const Range& range, int resolution, int border, double& low, double& high)
{
  const double fitted = high - low;
  const Range needed = { std::max(range.Low, low), std::min(range.High, high) };
  const double wanted = std::max(needed.High - needed.Low, NarrowestShare * fitted) /
    (1.0 - 2.0 * (border + 1.0) / resolution);
  // In steps from the fit's own edge, so that neither the scene's scale nor its place matters.
  const double steps = std::floor(EdgeStepsPerOctave * std::log2(fitted / wanted));
  const double edge = fitted * std::exp2(-std::max(steps, 0.0) / EdgeStepsPerOctave);
  const double texel = edge / resolution;
  if (range.Low - border * texel > high || range.High + border * texel < low)
  {
    return false;
  }
  if (!(edge < fitted))
  {
    return true;
  }
  // The first texel of the window, in a grid from the fit's edge on.
  const double middle = 0.5 * (needed.Low + needed.High);
  const double last = std::ceil(fitted / texel) - resolution;
  const double first =
    std::min(std::max(std::floor((middle - low) / texel) - resolution / 2, 0.0), last);
  low += first * texel;
  high = low + edge;
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkShadowCascadeWindow::Cut(const std::array<double, 3>& center, double radius,
  const std::vector<std::array<double, 3>>& corners, int resolution, int border,
  vtkShadowMapView& view)
{
  const double world[4] = { center[0], center[1], center[2], 1.0 };
  double p[4];
  vtkMatrix4x4::MultiplyPoint(view.Emitter.WorldToEmitter().data(), world, p);
  const bool directional = view.Emitter.Directional;
  Range ranges[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    if (!Project(p[axis], p[2], radius, directional, ranges[axis]))
    {
      // The light is among the receivers, or sees them too far aside.
      return true;
    }
  }
  CutToHull(corners, view, ranges);
  return CutEdge(ranges[0], resolution, border, view.Window[0], view.Window[1]) &&
    CutEdge(ranges[1], resolution, border, view.Window[2], view.Window[3]);
}
VTK_ABI_NAMESPACE_END
