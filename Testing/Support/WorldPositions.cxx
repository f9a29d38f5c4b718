// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WorldPositions.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>
#include <limits>

namespace SoftShadowsTesting
{

//------------------------------------------------------------------------------
SightLine SightLineOf(vtkRenderer* renderer, int width, int height, double x, double y)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  Point position;
  Point focalPoint;
  Point forward;
  Point up;
  Point right;
  camera->GetPosition(position.data());
  camera->GetFocalPoint(focalPoint.data());
  vtkMath::Subtract(focalPoint.data(), position.data(), forward.data());
  vtkMath::Normalize(forward.data());
  vtkMath::Cross(forward.data(), camera->GetViewUp(), right.data());
  vtkMath::Normalize(right.data());
  vtkMath::Cross(right.data(), forward.data(), up.data());

  // Half the picture's height: a length for parallel cameras, a tangent for others.
  const bool isParallel = camera->GetParallelProjection() != 0;
  const double half = isParallel
    ? camera->GetParallelScale()
    : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  const double u = ((x + 0.5) / width * 2.0 - 1.0) * half * width / height;
  const double v = ((y + 0.5) / height * 2.0 - 1.0) * half;
  SightLine line;
  for (int c = 0; c < 3; ++c)
  {
    const double offset = u * right[c] + v * up[c];
    line.Start[c] = isParallel ? position[c] + offset : position[c];
    line.Direction[c] = isParallel ? forward[c] : forward[c] + offset;
  }
  return line;
}

//------------------------------------------------------------------------------
std::vector<Point> PlanePositions(vtkRenderer* renderer, int width, int height, const Plane& plane)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> positions;
  positions.reserve(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const SightLine line = SightLineOf(renderer, width, height, x, y);
      Point toPlane;
      vtkMath::Subtract(plane.Origin.data(), line.Start.data(), toPlane.data());
      const double t = vtkMath::Dot(toPlane.data(), plane.Normal.data()) /
        vtkMath::Dot(line.Direction.data(), plane.Normal.data());
      Point position = { { nan, nan, nan } };
      if (t > 0.0 && std::isfinite(t))
      {
        for (int c = 0; c < 3; ++c)
        {
          position[c] = line.Start[c] + t * line.Direction[c];
        }
      }
      positions.push_back(position);
    }
  }
  return positions;
}

}
